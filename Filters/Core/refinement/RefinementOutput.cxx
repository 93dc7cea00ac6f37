// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/RefinementOutput.h"

#include <unordered_map>
#include <utility>

namespace geodesic
{

namespace
{

RefinedPoint refinedPoint(
  const TriangleMesh& mesh, const RedGreenMesh::Point& split, const std::array<Id, 2>& parents)
{
  return { parents, split.weight, split.place, position(mesh, split.place), split.distance };
}

/// The caller's numbers for the points of a refined mesh.
class CallersNumbers
{
public:
  CallersNumbers(
    const RedGreenMesh& triangles, const std::vector<Triangle>& atCorners, RefinedMesh& result)
    : triangles_(triangles)
    , atCorners_(atCorners)
    , splits_(result)
  {
  }

  /// Requires that the triangles of a face are consecutive.
  Triangle of(Id face, const Triangle& corners)
  {
    if (face != this->face_)
    {
      this->face_ = face;
      this->inFace_.clear();
    }
    return { this->of(corners[0]), this->of(corners[1]), this->of(corners[2]) };
  }

private:
  Id of(Id point)
  {
    const Id inputPoints = this->triangles_.numberOfInputPoints();
    if (point < inputPoints)
    {
      const Triangle& corners = this->triangles_.mesh().triangle(this->face_);
      const std::size_t k = point == corners[0] ? 0 : point == corners[1] ? 1 : 2;
      return this->atCorners_[this->face_][k];
    }
    const auto known = this->inFace_.find(point);
    if (known != this->inFace_.end())
    {
      return known->second;
    }
    const RedGreenMesh::Point& split = this->triangles_.points()[point - inputPoints];
    const Id a = this->of(split.parents[0]);
    const Id b = this->of(split.parents[1]);
    const Id number =
      this->splits_.numberOf(refinedPoint(this->triangles_.mesh(), split, { a, b }));
    this->inFace_.emplace(point, number);
    return number;
  }

  const RedGreenMesh& triangles_;
  const std::vector<Triangle>& atCorners_;
  SplitPointNumbering splits_;
  /// The numbers found in the current face: a point's ancestors occur many times.
  std::unordered_map<Id, Id> inFace_;
  Id face_ = NoId;
};

/// Writes all triangles in parallel, with numberOf(point) for each corner.
template <typename NumberOf>
void writeTriangles(
  const RedGreenMesh& triangles, const Job& job, const NumberOf& numberOf, RefinedMesh& result)
{
  const Id first = triangles.firstFace();
  const std::size_t faces = triangles.endOfFaces() - first;
  const auto forEach = [&](std::size_t begin, std::size_t end, const auto& visit) {
    triangles.forEachTriangle(first + static_cast<Id>(begin), first + static_cast<Id>(end), visit);
  };
  std::vector<std::size_t> offsets = job.part(0.0, 0.5).resultsOfRanges(faces,
    [&](std::size_t begin, std::size_t end)
    {
      std::size_t count = 0;
      forEach(begin, end, [&count](Id, const Triangle&) { ++count; });
      return count;
    });
  std::size_t next = 0;
  for (std::size_t& offset : offsets)
  {
    next += std::exchange(offset, next);
  }
  result.triangles.resize(next);
  result.faces.resize(next);
  job.part(0.5, 1.0).ranges(faces,
    [&](std::size_t begin, std::size_t end)
    {
      std::size_t offset = offsets[begin / ItemsInRange];
      forEach(begin, end,
        [&](Id face, const Triangle& c)
        {
          result.triangles[offset] = { numberOf(c[0]), numberOf(c[1]), numberOf(c[2]) };
          result.faces[offset++] = face;
        });
    });
}

} // anonymous namespace

RefinedMesh writeOutput(const RedGreenMesh& triangles, const RefinementOptions& options,
  Id numberOfPoints, const Job& job)
{
  const TriangleMesh& mesh = triangles.mesh();
  RefinedMesh result;
  result.numberOfInputPoints = numberOfPoints;
  if (options.cornerPoints.empty())
  {
    const Id left = mesh.numberOfVertices() - numberOfPoints;
    const auto numberOf = [&](Id point) { return point < numberOfPoints ? point : point - left; };
    result.points.reserve(triangles.points().size());
    for (const RedGreenMesh::Point& split : triangles.points())
    {
      result.points.push_back(
        refinedPoint(mesh, split, { numberOf(split.parents[0]), numberOf(split.parents[1]) }));
    }
    writeTriangles(triangles, job, numberOf, result);
    return result;
  }
  writeTriangles(
    triangles, job, [](Id point) { return point; }, result);
  // Points that split edges are numbered in the order in which triangles reach them.
  CallersNumbers numbers(triangles, options.cornerPoints, result);
  for (std::size_t i = 0; i < result.triangles.size(); ++i)
  {
    result.triangles[i] = numbers.of(result.faces[i], result.triangles[i]);
  }
  return result;
}

}
