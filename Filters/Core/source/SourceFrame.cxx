// SPDX-License-Identifier: BSD-3-Clause
#include "source/SourceFrame.h"

#include "source/DirectionsAround.h"

#include <algorithm>

namespace geodesic
{

SourceFrame sourceFrame(
  const TriangleMesh& mesh, const CurveChains& chains, const VerticesOnCurves& onCurves, Id number)
{
  const CurveChains::Part& part = chains.partOf(number);
  const SourceCurve& curve = chains.curves()[part.chain];
  SourceFrame frame;
  if (part.begin == part.end)
  {
    const PointWithEnds at = onCurves.around(mesh, chains, { part.chain, part.begin });
    DirectionsAround directions(mesh);
    directions.assign(at.point, at.ends);
    const DirectionsAround::Axis axis = directions.axis();
    frame.x = inSpace(mesh, axis.halfedge, { axis.isAgainst ? -1.0 : 1.0, 0.0 });
    frame.y = inSpace(mesh, axis.halfedge, { 0.0, 1.0 });
  }
  else
  {
    const std::size_t first = part.isReversed ? part.end : part.begin;
    const std::size_t second = part.isReversed ? part.end - 1 : part.begin + 1;
    const Id face = curve.faces[std::min(first, second)];
    const Id halfedge = longestHalfedge(mesh, face);
    const Vec2 d = inHalfedgeFrame(mesh, halfedge, barycentric(mesh, curve.points[second], face)) -
      inHalfedgeFrame(mesh, halfedge, barycentric(mesh, curve.points[first], face));
    frame.x = inSpace(mesh, halfedge, d);
    frame.y = inSpace(mesh, halfedge, { -d.y, d.x });
  }
  frame.normal = cross(frame.x, frame.y);
  return frame;
}

}
