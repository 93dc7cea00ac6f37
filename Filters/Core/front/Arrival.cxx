// SPDX-License-Identifier: BSD-3-Clause
#include "front/Arrival.h"

#include "Tolerance.h"
#include "mesh/HalfedgeFrame.h"

#include <cmath>

namespace geodesic
{

bool bends(Vec2 ray, Vec2 way, double longest)
{
  const double length = norm(ray);
  const double rounding = tolerance::PlaceRounding * longest;
  const double ofBoth = rounding * (length + norm(way));
  return length <= rounding || std::abs(cross(ray, way)) > ofBoth || dot(ray, way) < -ofBoth;
}

bool isBent(const TriangleMesh& mesh, const Arrival& arrival)
{
  return arrival.isThroughWindow() &&
    bends(arrival.direction, apexOf(mesh, arrival.halfedge) - Vec2{ arrival.x, 0.0 },
      mesh.shape(TriangleMesh::faceOf(arrival.halfedge)).longest());
}

}
