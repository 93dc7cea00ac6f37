// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/RefinementOutput.h"

#include "mesh/FacesWithoutArea.h"

#include <unordered_map>
#include <utility>

namespace geodesic
{

namespace
{

/// All added points, each after its parents. Points inside faces get their numbers.
std::vector<RefinedPoint> numberPoints(RefinedFaces& faces)
{
  const TriangleMesh& mesh = faces.field.mesh();
  std::vector<RefinedPoint> points;
  const auto next = [&]
  { return faces.field.surface().numberOfOwnVertices() + static_cast<Id>(points.size()); };
  for (const PointOnEdge& point : faces.edges.points())
  {
    const SurfacePoint place = faces.edges.placeOf(next());
    points.push_back({ point.parents, point.weight, place, position(mesh, place), point.distance });
  }
  for (FaceTriangles& face : faces.openFaces())
  {
    for (Id i = 0; i < face.points().size(); ++i)
    {
      FaceTriangles::Point& point = face.point(i);
      if (point.number == NoId)
      {
        point.number = next();
        const SurfacePoint place = face.placeOf(i);
        points.push_back(
          { { face.point(point.parents[0]).number, face.point(point.parents[1]).number },
            point.weight, place, position(mesh, place), point.distance });
      }
    }
  }
  return points;
}

/// Gives points the caller's numbers, where several of the caller's points may be one vertex. Added
/// points are numbered in the order in which triangles reach them.
void useCallersPoints(
  const MeshPartition& surface, const std::vector<Triangle>& atCorners, RefinedMesh& result)
{
  const std::vector<RefinedPoint> points = std::exchange(result.points, {});
  const auto pointAt = [&](Id point) { return points[point - surface.numberOfOwnVertices()]; };
  SplitPointNumbering splits(result);
  const auto add = [&](const RefinedPoint& point, Id) { return splits.numberOf(point); };
  std::unordered_map<Id, Id> numbers; // in one face, whose triangles are consecutive
  for (std::size_t i = 0; i < result.triangles.size(); ++i)
  {
    const Id face = result.faces[i];
    if (i == 0 || face != result.faces[i - 1])
    {
      numbers.clear();
      for (std::size_t k = 0; k < 3; ++k)
      {
        numbers.emplace(surface.mesh().triangle(face)[k], atCorners[face][k]);
      }
    }
    for (Id& corner : result.triangles[i])
    {
      corner = numberElsewhere(corner, numbers, pointAt, add);
    }
  }
}

/// Writes all triangles in parallel.
void writeTriangles(const RefinedFaces& faces, const Job& job, RefinedMesh& result)
{
  const MeshPartition& surface = faces.field.surface();
  const Id first = surface.firstOwnFace();
  const std::size_t count = surface.endOfOwnFaces() - first;
  struct Range
  {
    std::vector<Triangle> triangles;
    std::vector<Id> faces;
  };
  const std::vector<Range> ranges = job.resultsOfRanges(count,
    [&](std::size_t begin, std::size_t end)
    {
      Range range;
      for (std::size_t i = begin; i < end; ++i)
      {
        const Id face = first + static_cast<Id>(i);
        appendTriangles(faces, face, range.triangles);
        range.faces.resize(range.triangles.size(), face);
      }
      return range;
    });
  for (const Range& range : ranges)
  {
    result.triangles.insert(result.triangles.end(), range.triangles.begin(), range.triangles.end());
    result.faces.insert(result.faces.end(), range.faces.begin(), range.faces.end());
  }
}

} // anonymous namespace

void appendTriangles(const RefinedFaces& faces, Id face, std::vector<Triangle>& triangles)
{
  if (faces.isOpen(face))
  {
    const FaceTriangles& cut = faces.triangles(face);
    for (const FaceTriangles::Part& part : cut.parts())
    {
      const auto& [a, b, c] = part.corners;
      triangles.push_back(
        { cut.points()[a].number, cut.points()[b].number, cut.points()[c].number });
    }
    return;
  }
  const TriangleMesh& mesh = faces.field.mesh();
  std::array<std::vector<Id>, 3> splits;
  for (std::size_t k = 0; k < 3; ++k)
  {
    splits[k] = faces.edges.pointsAlong(TriangleMesh::halfedgeOf(face, k));
  }
  cutAtEdges(
    mesh.triangle(face), splits,
    [&](Id point) { return position(mesh, faces.edges.placeOf(point)); }, triangles);
}

// The last vertices of the mesh may be other ranks' only: these are no points of the caller.
RefinedMesh writeOutput(RefinedFaces& faces, const RefinementOptions& options, const Job& job)
{
  const MeshPartition& surface = faces.field.surface();
  const bool areVertices = options.cornerPoints.empty() && surface.mesh().numberOfFaces() > 0;
  RefinedMesh result;
  result.numberOfInputPoints = areVertices ? surface.numberOfOwnVertices() : options.numberOfPoints;
  result.points = numberPoints(faces);
  writeTriangles(faces, job, result);
  if (!areVertices)
  {
    useCallersPoints(surface, options.cornerPoints, result);
  }
  return result;
}

}
