// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/RefinementOutput.h"

#include "mesh/FacesWithoutArea.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace geodesic
{

namespace
{

/// The numbers of a face's points among those of all faces.
std::vector<Id> numbersIn(const FaceTriangles& face, Id firstInside)
{
  std::vector<Id> numbers;
  numbers.reserve(face.points().size());
  for (const FaceTriangles::Point& point : face.points())
  {
    numbers.push_back(point.number == NoId ? firstInside++ : point.number);
  }
  return numbers;
}

/// All added points, each after its parents, with the numbers of the mesh's vertices.
std::vector<RefinedPoint> addedPoints(const RefinedFaces& faces, const std::vector<Id>& firstInside)
{
  const TriangleMesh& mesh = faces.field.mesh();
  std::vector<RefinedPoint> points;
  for (const PointOnEdge& point : faces.edges.points())
  {
    const Id number = mesh.numberOfVertices() + static_cast<Id>(points.size());
    const SurfacePoint place = faces.edges.placeOf(number);
    points.push_back({ point.parents, point.weight, place, position(mesh, place), point.distance });
  }
  for (std::size_t i = 0; i < faces.openFaces().size(); ++i)
  {
    const FaceTriangles& face = faces.openFaces()[i];
    const std::vector<Id> numbers = numbersIn(face, firstInside[i]);
    for (const FaceTriangles::Point& point : face.points())
    {
      if (point.number == NoId)
      {
        const SurfacePoint place =
          SurfacePoint::inFace(face.face(), point.weights[1], point.weights[2]);
        points.push_back({ { numbers[point.parents[0]], numbers[point.parents[1]] }, point.weight,
          place, position(mesh, place), point.distance });
      }
    }
  }
  return points;
}

/// Gives points the caller's numbers, where several of the caller's points may be one vertex. Added
/// points are numbered in the order in which triangles reach them.
void useCallersPoints(
  const TriangleMesh& mesh, const std::vector<Triangle>& atCorners, RefinedMesh& result)
{
  const std::vector<RefinedPoint> points = std::exchange(result.points, {});
  const auto pointAt = [&](Id point) { return points[point - mesh.numberOfVertices()]; };
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
        numbers.emplace(mesh.triangle(face)[k], atCorners[face][k]);
      }
    }
    for (Id& corner : result.triangles[i])
    {
      corner = numberElsewhere(corner, numbers, pointAt, add);
    }
  }
}

/// Writes all triangles in parallel, with the numbers of the mesh's vertices.
void writeTriangles(const RefinedFaces& faces, const std::vector<Id>& firstInside, const Job& job,
  RefinedMesh& result)
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
        appendTriangles(faces, face, firstInside, range.triangles);
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

std::vector<Id> firstPointsInside(const RefinedFaces& faces)
{
  std::vector<Id> first;
  Id next = faces.field.mesh().numberOfVertices() + static_cast<Id>(faces.edges.points().size());
  for (const FaceTriangles& face : faces.openFaces())
  {
    first.push_back(next);
    for (const FaceTriangles::Point& point : face.points())
    {
      next += point.number == NoId ? 1 : 0;
    }
  }
  return first;
}

void appendTriangles(const RefinedFaces& faces, Id face, const std::vector<Id>& firstInside,
  std::vector<Triangle>& triangles)
{
  if (faces.isOpen(face))
  {
    const FaceTriangles& cut = faces.triangles(face);
    const std::vector<Id> numbers = numbersIn(cut, firstInside[faces.numberOf(face)]);
    for (const FaceTriangles::Part& part : cut.parts())
    {
      const Triangle& c = part.corners;
      triangles.push_back({ numbers[c[0]], numbers[c[1]], numbers[c[2]] });
    }
    return;
  }
  const TriangleMesh& mesh = faces.field.mesh();
  std::array<std::vector<Id>, 3> splits;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Id halfedge = TriangleMesh::halfedgeOf(face, k);
    const Id edge = faces.edges.find(halfedge);
    if (edge != NoId)
    {
      splits[k] = faces.edges[edge].points;
      if (mesh.origin(faces.edges[edge].halfedge) != mesh.origin(halfedge))
      {
        std::reverse(splits[k].begin(), splits[k].end());
      }
    }
  }
  cutAtEdges(
    mesh.triangle(face), splits,
    [&](Id point) { return position(mesh, faces.edges.placeOf(point)); }, triangles);
}

RefinedMesh writeOutput(
  const RefinedFaces& faces, const RefinementOptions& options, Id numberOfPoints, const Job& job)
{
  const TriangleMesh& mesh = faces.field.mesh();
  const std::vector<Id> firstInside = firstPointsInside(faces);
  RefinedMesh result;
  result.numberOfInputPoints = numberOfPoints;
  writeTriangles(faces, firstInside, job, result);
  result.points = addedPoints(faces, firstInside);
  if (!options.cornerPoints.empty())
  {
    useCallersPoints(mesh, options.cornerPoints, result);
    return result;
  }
  const Id left = mesh.numberOfVertices() - numberOfPoints;
  const auto renumber = [&](Id& point) { point -= point < numberOfPoints ? 0 : left; };
  for (RefinedPoint& point : result.points)
  {
    std::for_each(point.parents.begin(), point.parents.end(), renumber);
  }
  for (std::size_t i = 0; i < result.triangles.size() && left > 0; ++i)
  {
    std::for_each(result.triangles[i].begin(), result.triangles[i].end(), renumber);
  }
  return result;
}

}
