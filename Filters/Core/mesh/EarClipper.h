// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_EarClipper_h
#define geodesic_EarClipper_h

#include "mesh/PolygonTriangles.h"

#include <vector>

namespace geodesic
{

/// Cuts a polygon in the plane into triangles by clipping ears.
///
/// \param outline in space, for the shapes of triangles.
/// \param normal of length 1.
/// \param flat the outline in a plane, counterclockwise.
PolygonTriangles clipEars(
  const std::vector<Vec3>& outline, const Vec3& normal, const std::vector<Vec2>& flat);

}

#endif
