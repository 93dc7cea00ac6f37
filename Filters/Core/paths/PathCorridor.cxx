// SPDX-License-Identifier: BSD-3-Clause
#include "paths/PathCorridor.h"

#include "Tolerance.h"
#include "field/RetentionAround.h"

#include <algorithm>

namespace geodesic
{

namespace
{

/// A point of the patch as one of this rank's part: none where other ranks own its faces.
std::vector<SurfacePoint> ownPlaceOf(
  const MeshPartition& part, const ReplicatedPatch& patch, const SurfacePoint& point)
{
  std::vector<SurfacePoint> place;
  forEachFace(patch.mesh(), point,
    [&](Id face)
    {
      const Id own = part.faceAt(patch.ownerOf(face));
      if (own != NoId && part.isOwn(own))
      {
        place = { fromBarycentric(part.mesh(), own, barycentric(patch.mesh(), point, face)) };
      }
    });
  return place;
}

} // anonymous namespace

std::vector<double> lowerBoundsOf(std::vector<double> distances, double searchedTo)
{
  for (double& distance : distances)
  {
    distance = (1.0 - tolerance::BoundMargin) * std::min(distance, searchedTo);
  }
  return distances;
}

Corridor corridorTo(const MeshPartition& part, const ReplicatedPatch& patch,
  const SurfacePoint& goal, const SurfacePoint& start, const Corridor* within, const Job& job)
{
  const TriangleMesh& mesh = part.mesh();
  FrontOptions options;
  options.job = job;
  options.relativeError = tolerance::CorridorSearch;
  options.corridor = within;
  RetentionAround search(mesh, ownPlaceOf(part, patch, start));
  Corridor corridor;
  corridor.lowerBounds =
    propagate(part, makeSourceWindows(part, patch, { pointCurve(goal) }), options, search)
      .vertexDistances;
  const double searchedTo = part.exchange().largestOf(search.neededDistance());
  corridor.length = searchedTo / (1.0 - tolerance::CorridorSearch);
  if (within != nullptr)
  {
    // The two points may be at one place but for roundings.
    corridor.length =
      std::min(within->length, std::max(tolerance::BoundMargin * within->length, corridor.length));
  }
  // Vertices that the front has not settled are farther than it went. Those that it has left out
  // have no path within the length: the way from the start uses up the rest of it. No way is
  // shorter than the distance in space.
  for (Id vertex = 0; vertex < mesh.numberOfVertices(); ++vertex)
  {
    double& bound = corridor.lowerBounds[vertex];
    bound = std::min(bound, searchedTo);
    bound =
      within != nullptr ? std::min(bound, within->length - within->lowerBounds[vertex]) : bound;
    bound = std::max((1.0 - tolerance::BoundMargin) * bound,
      distanceInSpace(patch.mesh(), mesh.point(vertex), goal));
  }
  return corridor;
}

std::vector<Id> facesInCorridor(const MeshPartition& part, const ReplicatedPatch& patch,
  const SurfacePoint& start, const Corridor& corridor, const Job& job)
{
  const TriangleMesh& mesh = part.mesh();
  FrontOptions options;
  options.corridor = &corridor;
  options.job = job;
  KeepFaces passed(mesh);
  const std::vector<double> fromStart =
    propagate(part, makeSourceWindows(part, patch, { pointCurve(start) }), options, passed)
      .vertexDistances;
  const WindowArchive windows = passed.release().windows;
  const auto isPassed = [&](Id halfedge)
  {
    // A path may also run along edges, from vertex to vertex, where no window goes.
    const Id vertex = mesh.origin(halfedge);
    return !windows.at(halfedge).empty() ||
      fromStart[vertex] + corridor.lowerBounds[vertex] <= corridor.length;
  };
  std::vector<Id> faces;
  for (Id face = part.firstOwnFace(); face < part.endOfOwnFaces(); ++face)
  {
    const std::array<Id, 3> halfedges = TriangleMesh::halfedgesOf(face);
    if (std::any_of(halfedges.begin(), halfedges.end(), isPassed))
    {
      faces.push_back(face);
    }
  }
  return faces;
}

}
