// SPDX-License-Identifier: BSD-3-Clause
#include "field/NearestSourceOnRanks.h"

#include "FollowOnRanks.h"

namespace geodesic
{

namespace
{

// Each round doubles the length, so that no chain of vertices needs more rounds. Origins that are
// open after these rounds are vertices at one place that name each other.
constexpr int MaximumSteps = 33;

/// The vertices, counted elsewhere, that paths to points of the part may come from, open.
Origins openOrigins(const DistanceField& field)
{
  const MeshPartition& part = field.surface();
  Origins origins;
  const auto add = [&](RayOrigin origin)
  {
    if (origin.isVertex() && part.countedVertex(origin.vertex()) == NoId)
    {
      origins[origin.vertex()] = { origin };
    }
  };
  for (Id vertex = 0; vertex < part.mesh().numberOfVertices(); ++vertex)
  {
    add(RayOrigin::vertex(part.globalId(vertex)));
    add(field.arrivals()[vertex].origin);
  }
  const Id end = TriangleMesh::halfedgeOf(part.endOfOwnFaces(), 0);
  for (Id halfedge = TriangleMesh::halfedgeOf(part.firstOwnFace(), 0); halfedge < end; ++halfedge)
  {
    RayOrigin last; // windows of one origin often stand together
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

Origins originsElsewhere(const DistanceField& field, std::vector<PathOrigin>& atVertices)
{
  const MeshPartition& part = field.surface();
  if (!part.isDistributed())
  {
    return {};
  }
  Origins elsewhere = openOrigins(field);
  const auto isOpen = [](const PathOrigin& path) { return path.origin.isVertex(); };
  // What is known elsewhere of the vertex that an open origin names.
  const auto known = [&](const PathOrigin& path)
  { return isOpen(path) ? elsewhere[path.origin.vertex()] : path; };
  std::vector<PathOrigin*> asked;
  followOnRanks<GlobalId>(
    part.exchange(), {},
    [&](Questions& questions)
    {
      asked.clear();
      for (auto& [number, path] : elsewhere)
      {
        if (isOpen(path))
        {
          const GlobalId vertex = path.origin.vertex();
          questions.ask(part.rankCounting(vertex), asked.size(), vertex);
          asked.push_back(&path);
        }
      }
      return !asked.empty();
    },
    [&](GlobalId vertex) { return known(atVertices[part.countedVertex(vertex)]); },
    [](const PathOrigin& path, Message& answer) { put(answer, path); },
    [&](std::size_t i, MessageReader& answer) { *asked[i] = answer.get<PathOrigin>(); },
    MaximumSteps);
  for (auto& [number, path] : elsewhere)
  {
    path = isOpen(path) ? PathOrigin() : path;
  }
  for (Id vertex = 0; vertex < atVertices.size(); ++vertex)
  {
    const GlobalId number = part.globalId(vertex);
    PathOrigin& path = atVertices[vertex];
    path = part.countedVertex(number) == NoId ? elsewhere[number] : known(path);
  }
  return elsewhere;
}

}
