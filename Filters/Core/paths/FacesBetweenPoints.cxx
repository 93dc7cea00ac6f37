// SPDX-License-Identifier: BSD-3-Clause
#include "paths/FacesBetweenPoints.h"

#include "Tolerance.h"
#include "field/RetentionAround.h"
#include "mesh/SurfaceSnap.h"
#include "source/SourceWindows.h"

#include <algorithm>
#include <utility>

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
      const Id own = patch.faceOfPart(face);
      if (own != NoId && part.isOwn(own))
      {
        place = { fromBarycentric(part.mesh(), own, barycentric(patch.mesh(), point, face)) };
      }
    });
  return place;
}

using PointPair = std::pair<SurfacePoint, SurfacePoint>;

/// The pairs of places of two points that share no face.
std::vector<PointPair> farPairs(const TriangleMesh& mesh, const LocatedPolyline& polyline,
  std::size_t first, std::size_t second, double coordinatePrecision)
{
  std::vector<PointPair> pairs;
  const auto place = [&](Id face, std::size_t point)
  { return snapToFace(mesh, face, polyline.points[point], coordinatePrecision).place; };
  for (const Id a : polyline.faces[first])
  {
    for (const Id b : polyline.faces[second])
    {
      const PointPair pair = { place(a, first), place(b, second) };
      const auto isSame = [&](const PointPair& other) {
        return samePlace(mesh, pair.first, other.first) &&
          samePlace(mesh, pair.second, other.second);
      };
      if (commonFace(mesh, pair.first, pair.second) == NoId &&
        std::none_of(pairs.begin(), pairs.end(), isSame))
      {
        pairs.push_back(pair);
      }
    }
  }
  return pairs;
}

/// Adds the faces that shortest paths between two points can touch.
void addFacesBetween(const MeshPartition& part, const ReplicatedPatch& patch, const PointPair& ends,
  const Job& job, std::vector<Id>& faces)
{
  const LowerBounds fromFirst = lowerBoundsFrom(part, patch, ends.first, ends.second, job);
  if (fromFirst.length == Infinity)
  {
    return;
  }
  const LowerBounds fromSecond = lowerBoundsFrom(part, patch, ends.second, ends.first, job);
  const double length = std::min(fromFirst.length, fromSecond.length);
  const TriangleMesh& mesh = part.mesh();
  for (Id face = part.firstOwnFace(); face < part.endOfOwnFaces(); ++face)
  {
    // From a point of the path in the face to a corner it is no farther than the longest edge.
    const double most = length + 2.0 * mesh.shape(face).longest();
    const Triangle& corners = mesh.triangle(face);
    if (std::all_of(corners.begin(), corners.end(),
          [&](Id vertex)
          { return fromFirst.atLeast[vertex] + fromSecond.atLeast[vertex] <= most; }))
    {
      faces.push_back(face);
    }
  }
}

} // anonymous namespace

LowerBounds lowerBoundsFrom(const MeshPartition& part, const ReplicatedPatch& patch,
  const SurfacePoint& from, const SurfacePoint& to, const Job& job)
{
  const TriangleMesh& mesh = part.mesh();
  FrontOptions options;
  options.job = job;
  options.relativeError = tolerance::CorridorSearch;
  const std::vector<SurfacePoint> target = ownPlaceOf(part, patch, to);
  RetentionAround search(mesh, target);
  LowerBounds bounds;
  bounds.atLeast = propagate(part,
    sourceWindowsOfPartition(part, patch, makeSourceWindows(patch.mesh(), { pointCurve(from) })),
    options, search)
                     .vertexDistances;
  const double searchedTo = part.exchange().largestOf(search.neededDistance());
  bounds.length = searchedTo / (1.0 - tolerance::CorridorSearch);
  // Vertices that the front has not settled are farther than that; no way is shorter than the
  // distance in space.
  for (Id vertex = 0; vertex < mesh.numberOfVertices(); ++vertex)
  {
    bounds.atLeast[vertex] = std::max(std::min(bounds.atLeast[vertex], searchedTo),
      distanceInSpace(patch.mesh(), mesh.point(vertex), from));
  }
  return bounds;
}

std::vector<Id> facesBetweenPoints(const MeshPartition& part, const ReplicatedPatch& patch,
  const std::vector<LocatedPolyline>& polylines, double coordinatePrecision, const Job& job)
{
  std::vector<Id> faces;
  for (std::size_t line = 0; line < polylines.size(); ++line)
  {
    const LocatedPolyline& polyline = polylines[line];
    const double done = static_cast<double>(line) / static_cast<double>(polylines.size());
    const Job search = job.part(done, done);
    const std::size_t count = polyline.points.size();
    for (std::size_t i = 0; i + 1 < count + (polyline.closed && count > 1 ? 1 : 0); ++i)
    {
      for (const PointPair& pair :
        farPairs(patch.mesh(), polyline, i, (i + 1) % count, coordinatePrecision))
      {
        addFacesBetween(part, patch, pair, search, faces);
      }
    }
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

}
