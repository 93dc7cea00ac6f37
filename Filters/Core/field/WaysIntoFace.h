// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_WaysIntoFace_h
#define geodesic_WaysIntoFace_h

#include "field/DistanceField.h"
#include "mesh/HalfedgeFrame.h"

#include <algorithm>
#include <utility>

namespace geodesic
{

// A shortest path comes to a point of a face from a source in the face, from a corner, or through a
// window of a halfedge. `length` is that of the straight piece in the face, `distance` that of the
// whole path. FaceDistance has the same ways as functions of the point.

/// Calls visit(const SourceInFace&, const Barycentric& begin, double length).
template <typename Visit>
void forEachWayFromSource(
  const DistanceField& field, Id face, const Barycentric& point, Visit&& visit)
{
  for (const SourceInFace& source : field.sourcesIn(face))
  {
    const Barycentric begin = nearestOnSource(field.mesh(), source, point);
    visit(source, begin, distanceInFace(field.mesh(), face, begin, point));
  }
}

/// Calls visit(std::size_t corner, double distance, double length), but not for the point's own
/// corner.
///
/// \param place the point itself.
template <typename Visit>
void forEachWayFromCorner(const DistanceField& field, Id face, const SurfacePoint& place,
  const Barycentric& point, Visit&& visit)
{
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Id vertex = field.mesh().triangle(face)[k];
    if (place.kind != SurfacePoint::Kind::Vertex || place.id != vertex)
    {
      const double length = distanceInFace(field.mesh(), face, cornerWeights(k), point);
      visit(k, field.vertexDistances()[vertex] + length, length);
    }
  }
}

/// Calls visit(const Window&, double x, double distance, double length): the piece begins at x on
/// the halfedge.
///
/// \param p the point in the halfedge's frame.
template <typename Visit>
void forEachWayThrough(const DistanceField& field, Id halfedge, Vec2 p, Visit&& visit)
{
  for (const Window& window : field.windowsOn(halfedge))
  {
    const double x = window.crossing(p);
    const double length = norm(p - Vec2{ x, 0.0 });
    visit(window, x, std::max(window.distance(x), 0.0) + length, length);
  }
}

/// Whether a point of a face lies on the halfedge from corner k. The halfedge's windows give the
/// distance of the point, but they came through the face behind it.
inline bool isOnHalfedge(const Barycentric& point, Id k)
{
  return point[(k + 2) % 3] == 0.0;
}

}

#endif
