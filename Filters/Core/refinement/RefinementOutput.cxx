// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/RefinementOutput.h"

#include <unordered_map>

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

  /// Faces come one after another.
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
  /// The numbers found in the face at hand: a point's ancestors are many times as many.
  std::unordered_map<Id, Id> inFace_;
  Id face_ = NoId;
};

/// Calls write(face, corners) for every triangle, and tells how far it is.
template <typename Write>
void writeTriangles(const RedGreenMesh& triangles, const std::function<void(double)>& progress,
  RefinedMesh& result, Write&& write)
{
  const auto count = static_cast<double>(triangles.numberOfTriangles());
  result.triangles.reserve(triangles.numberOfTriangles());
  result.faces.reserve(triangles.numberOfTriangles());
  triangles.forEachTriangle(
    [&](Id face, const Triangle& corners)
    {
      progress(static_cast<double>(result.faces.size()) / count);
      result.faces.push_back(face);
      result.triangles.push_back(write(face, corners));
    });
}

} // anonymous namespace

void writeOutput(const RedGreenMesh& triangles, const CallersPoints& points,
  const std::function<void(double)>& progress, RefinedMesh& result)
{
  const TriangleMesh& mesh = triangles.mesh();
  result.numberOfInputPoints = points.count;
  if (points.atCorners.empty())
  {
    const Id left = mesh.numberOfVertices() - points.count;
    const auto numberOf = [&](Id point) { return point < points.count ? point : point - left; };
    result.points.reserve(triangles.points().size());
    for (const RedGreenMesh::Point& split : triangles.points())
    {
      result.points.push_back(
        refinedPoint(mesh, split, { numberOf(split.parents[0]), numberOf(split.parents[1]) }));
    }
    writeTriangles(triangles, progress, result,
      [&](Id, const Triangle& c) {
        return Triangle{ numberOf(c[0]), numberOf(c[1]), numberOf(c[2]) };
      });
    return;
  }
  CallersNumbers numbers(triangles, points.atCorners, result);
  writeTriangles(triangles, progress, result,
    [&numbers](Id face, const Triangle& corners) { return numbers.of(face, corners); });
}

}
