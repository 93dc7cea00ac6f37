// SPDX-License-Identifier: BSD-3-Clause
#include "paths/ShortestWay.h"

#include "Tolerance.h"

#include <cmath>

namespace geodesic
{

namespace
{

WayFrom fromWindow(const TriangleMesh& mesh, const SurfacePoint& point, const WayIntoFace& way)
{
  const Id face = TriangleMesh::faceOf(way.halfedge);
  const Vec2 p = inHalfedgeFrame(mesh, way.halfedge, barycentric(mesh, point, face));
  return wayFrom(way.x, p, way.window->directionTo(p, way.x), mesh.shape(face).longest());
}

} // anonymous namespace

WayInFace shortestWayTo(const DistanceField& field, const SurfacePoint& point, Id without)
{
  WayInFace shortest;
  forEachFace(field.mesh(), point,
    [&](Id face)
    {
      if (face != without && field.surface().isOwn(face))
      {
        forEachWay(field, face, point,
          [&](const WayIntoFace& way)
          {
            const double tie = tolerance::Tie * way.distance;
            if (way.kind == WayIntoFace::Kind::Source || way.isBehind ||
              !(way.distance < shortest.distance + tie))
            {
              return;
            }
            const WayInFace found = { way, face,
              way.window != nullptr ? fromWindow(field.mesh(), point, way) : WayFrom() };
            const bool isTie = std::abs(way.distance - shortest.distance) <= tie;
            if (isTie && found.from.isBent != shortest.from.isBent
                ? shortest.from.isBent
                : way.distance < shortest.distance)
            {
              shortest = found;
            }
          });
      }
    });
  return shortest;
}

}
