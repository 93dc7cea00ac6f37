// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_WaysIntoFace_h
#define geodesic_WaysIntoFace_h

#include "field/DistanceField.h"
#include "mesh/HalfedgeFrame.h"

#include <algorithm>
#include <utility>

namespace geodesic
{

/// One way in which a path comes to a point of a face. FaceDistance has the same ways as functions
/// of the point.
struct WayIntoFace
{
  enum class Kind : std::uint8_t
  {
    /// No way.
    None,
    /// From a source in the face.
    Source,
    /// From a corner of the face.
    Corner,
    /// Through a window.
    Window
  };

  Kind kind = Kind::None;
  /// The lengths of the whole path and of its straight piece in the face.
  double distance = Infinity;
  double length = 0.0;
  /// Where the piece begins if it comes from a source or a corner.
  Barycentric begin = {};
  const SourceInFace* source = nullptr;
  /// The corner; NoId if it does not come from one.
  Id vertex = NoId;
  /// The window, its halfedge, and where on it the piece begins.
  const Window* window = nullptr;
  Id halfedge = NoId;
  double x = 0.0;
  /// Whether the halfedge holds the point. Then the window gives the point's distance, but its path
  /// came through the face behind the halfedge.
  bool isBehind = false;
};

/// Calls visit(const WayIntoFace&) for the ways to a point of a face, from sources, from corners
/// and through windows, but not for the way from a corner that the point is at.
template <typename Visit>
void forEachWay(const DistanceField& field, Id face, const SurfacePoint& place, const Visit& visit)
{
  const TriangleMesh& mesh = field.mesh();
  const Barycentric point = barycentric(mesh, place, face);
  WayIntoFace start;
  const auto visitFrom = [&](const Barycentric& begin, double distance)
  {
    start.begin = begin;
    start.length = distanceInFace(mesh, face, begin, point);
    start.distance = distance + start.length;
    visit(std::as_const(start));
  };
  start.kind = WayIntoFace::Kind::Source;
  for (const SourceInFace& source : field.sourcesIn(face))
  {
    start.source = &source;
    visitFrom(nearestOnSource(mesh, source, point), 0.0);
  }
  start.kind = WayIntoFace::Kind::Corner;
  for (std::size_t k = 0; k < 3; ++k)
  {
    start.vertex = mesh.triangle(face)[k];
    if (place.kind != SurfacePoint::Kind::Vertex || place.id != start.vertex)
    {
      visitFrom(cornerWeights(k), field.vertexDistances()[start.vertex]);
    }
  }
  WayIntoFace way;
  way.kind = WayIntoFace::Kind::Window;
  for (Id k = 0; k < 3; ++k)
  {
    way.halfedge = TriangleMesh::halfedgeOf(face, k);
    way.isBehind = point[(k + 2) % 3] == 0.0;
    const Vec2 p = inHalfedgeFrame(mesh, way.halfedge, point);
    for (const Window& window : field.windowsOn(way.halfedge))
    {
      way.window = &window;
      way.x = window.crossing(p);
      way.length = norm(p - Vec2{ way.x, 0.0 });
      way.distance = std::max(window.distance(way.x), 0.0) + way.length;
      visit(std::as_const(way));
    }
  }
}

}

#endif
