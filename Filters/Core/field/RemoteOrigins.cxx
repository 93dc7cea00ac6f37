// SPDX-License-Identifier: BSD-3-Clause
#include "field/RemoteOrigins.h"

#include "Questions.h"

#include <algorithm>

namespace geodesic
{

namespace
{

using Origins = std::unordered_map<Id, CurveOrigin>;

// Each round doubles the length, so that no chain of vertices needs more rounds. Origins that are
// open after these rounds are vertices at one place that name each other.
constexpr int MaximumSteps = 33;

/// The vertices, counted elsewhere, that paths to points of the part may come from, open.
Origins openOrigins(const DistanceField& field, const GlobalVertices& vertices)
{
  const MeshPartition& part = field.surface();
  Origins origins;
  const auto add = [&](Id number)
  {
    if (number < part.numberOfGlobalVertices() && !vertices.isHere(number))
    {
      origins[number] = { number };
    }
  };
  for (Id vertex = 0; vertex < part.mesh().numberOfVertices(); ++vertex)
  {
    add(part.globalId(vertex));
    add(field.arrivals()[vertex].origin);
  }
  for (Id halfedge = 3 * part.firstOwnFace(); halfedge < 3 * part.endOfOwnFaces(); ++halfedge)
  {
    Id last = NoId; // windows of one origin often stand together
    for (const Window& window : field.windowsOn(halfedge))
    {
      if (window.origin != last)
      {
        add(window.origin);
        last = window.origin;
      }
    }
  }
  return origins;
}

} // anonymous namespace

Origins originsElsewhere(
  const DistanceField& field, const GlobalVertices& vertices, std::vector<CurveOrigin>& atVertices)
{
  Exchange& exchange = field.surface().exchange();
  Origins elsewhere = openOrigins(field, vertices);
  const auto isOpen = [&](const CurveOrigin& origin)
  { return origin.origin < field.surface().numberOfGlobalVertices(); };
  const auto isOpenEntry = [&](const Origins::value_type& entry) { return isOpen(entry.second); };
  for (int steps = 0; steps < MaximumSteps &&
       exchange.isTrueAnywhere(std::any_of(elsewhere.begin(), elsewhere.end(), isOpenEntry));
       ++steps)
  {
    Questions questions(exchange);
    std::vector<CurveOrigin*> asked;
    for (auto& [number, origin] : elsewhere)
    {
      if (isOpen(origin))
      {
        questions.ask(vertices.rankOf(origin.origin), asked.size(), origin.origin);
        asked.push_back(&origin);
      }
    }
    questions.exchangeAnswers(
      [&](MessageReader& question, Message& answer)
      {
        const CurveOrigin& origin = atVertices[vertices.vertexAt(question.get<Id>())];
        put(answer, isOpen(origin) ? elsewhere[origin.origin] : origin);
      },
      [&](std::size_t i, MessageReader& answer) { *asked[i] = answer.get<CurveOrigin>(); });
  }
  for (auto& [number, origin] : elsewhere)
  {
    origin = isOpen(origin) ? CurveOrigin() : origin;
  }
  for (Id vertex = 0; vertex < atVertices.size(); ++vertex)
  {
    const Id number = field.surface().globalId(vertex);
    CurveOrigin& origin = atVertices[vertex];
    origin = !vertices.isHere(number) ? elsewhere[number]
      : isOpen(origin)                ? elsewhere[origin.origin]
                                      : origin;
  }
  return elsewhere;
}

}
