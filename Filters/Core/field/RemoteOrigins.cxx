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
Origins openOrigins(const DistanceField& field)
{
  const MeshPartition& part = field.surface();
  Origins origins;
  const auto add = [&](Id number)
  {
    if (number < part.numberOfGlobalVertices() && part.countedVertex(number) == NoId)
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

Origins originsElsewhere(const DistanceField& field, std::vector<CurveOrigin>& atVertices)
{
  const MeshPartition& part = field.surface();
  Exchange& exchange = part.exchange();
  Origins elsewhere = openOrigins(field);
  const auto isOpen = [&](const CurveOrigin& origin)
  { return origin.origin < part.numberOfGlobalVertices(); };
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
        questions.ask(part.rankCounting(origin.origin), asked.size(), origin.origin);
        asked.push_back(&origin);
      }
    }
    questions.exchangeAnswers(
      [&](MessageReader& question, Message& answer)
      {
        const CurveOrigin& origin = atVertices[part.countedVertex(question.get<Id>())];
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
    const Id number = part.globalId(vertex);
    CurveOrigin& origin = atVertices[vertex];
    origin = part.countedVertex(number) == NoId ? elsewhere[number]
      : isOpen(origin)                          ? elsewhere[origin.origin]
                                                : origin;
  }
  return elsewhere;
}

}
