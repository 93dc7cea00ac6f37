// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/BarrierFaces.h"

#include <algorithm>

namespace geodesic
{

namespace
{

std::vector<Vec3> pointsOf(const TriangleMesh& mesh)
{
  std::vector<Vec3> points;
  points.reserve(mesh.numberOfVertices());
  for (Id vertex = 0; vertex < mesh.numberOfVertices(); ++vertex)
  {
    points.push_back(mesh.point(vertex));
  }
  return points;
}

} // anonymous namespace

BarrierFaces::BarrierFaces(const TriangleMesh& mesh, const std::vector<Triangle>& triangles)
  : open_(mesh)
  , barriers_(pointsOf(mesh), triangles)
  , faceLocator_(this->barriers_)
{
}

Id BarrierFaces::barrierAt(
  const Vec3& point, const std::vector<Id>& closest, double coordinatePrecision)
{
  double toOpen = Infinity;
  for (const Id face : closest)
  {
    toOpen = std::min(toOpen, snapToFace(this->open_, face, point, coordinatePrecision).distance);
  }
  if (toOpen == 0.0)
  {
    return NoId;
  }
  for (const Id face : this->faceLocator_.closest(point, coordinatePrecision))
  {
    if (isInBarrier(snapToFace(this->barriers_, face, point, coordinatePrecision), toOpen))
    {
      return face;
    }
  }
  return NoId;
}

}
