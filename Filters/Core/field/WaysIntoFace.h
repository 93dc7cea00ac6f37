// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_WaysIntoFace_h
#define geodesic_WaysIntoFace_h

#include "field/DistanceField.h"
#include "mesh/HalfedgeFrame.h"

#include <algorithm>

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

/// Calls visit(const WayIntoFace&) for the ways to a point from sources, and from corners, but not
/// the one that the point is at.
///
/// \param point the place in the face.
template <typename Visit>
void forEachStart(const DistanceField& field, Id face, const SurfacePoint& place,
  const Barycentric& point, const Visit& visit)
{
  const TriangleMesh& mesh = field.mesh();
  WayIntoFace way;
  way.kind = WayIntoFace::Kind::Source;
  for (const SourceInFace& source : field.sourcesIn(face))
  {
    way.source = &source;
    way.begin = nearestOnSource(mesh, source, point);
    way.length = distanceInFace(mesh, face, way.begin, point);
    way.distance = way.length;
    visit(way);
  }
  way.kind = WayIntoFace::Kind::Corner;
  for (std::size_t k = 0; k < 3; ++k)
  {
    way.vertex = mesh.triangle(face)[k];
    if (place.kind != SurfacePoint::Kind::Vertex || place.id != way.vertex)
    {
      way.begin = cornerWeights(k);
      way.length = distanceInFace(mesh, face, way.begin, point);
      way.distance = field.vertexDistances()[way.vertex] + way.length;
      visit(way);
    }
  }
}

/// The same for all ways to a point: the starts, and the ways through windows.
template <typename Visit>
void forEachWay(const DistanceField& field, Id face, const SurfacePoint& place, const Visit& visit)
{
  const TriangleMesh& mesh = field.mesh();
  const Barycentric point = barycentric(mesh, place, face);
  forEachStart(field, face, place, point, visit);
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
      visit(way);
    }
  }
}

}

#endif
