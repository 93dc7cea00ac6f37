// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PolygonTriangles_h
#define geodesic_PolygonTriangles_h

#include "Types.h"

#include <vector>

namespace geodesic
{

struct PolygonTriangles
{
  /// Corners by their numbers in the outline. Two less than the outline has corners.
  std::vector<Triangle> triangles;
  /// Whether the triangles are no triangulation, because the outline crosses itself.
  bool crossesItself = false;
};

/// Cuts a polygon into triangles by clipping ears, of which those with the least ratio of squared
/// perimeter to area come first.
///
/// The polygon may be concave and nearly planar, of any size and thinness. Its outline may touch
/// itself: edges that run there and back join an outline with those of its holes. A triangle
/// without area is made only where no other is possible. No triangles overlap unless the outline
/// crosses itself. A polygon whose corners lie on one line becomes a fan.
///
/// \param outline the corners; at least three.
PolygonTriangles triangulatePolygon(const std::vector<Vec3>& outline);

}

#endif
