// SPDX-License-Identifier: BSD-3-Clause
#include "source/CurvesOnPatch.h"

#include "source/DirectionsAround.h"

#include <algorithm>

namespace geodesic
{

PointWithEnds CurvesOnPatch::around(Id point) const
{
  const CurveChains::Point at = this->chains_.pointWith(point);
  const SourceCurve& curve = this->chains_.curves()[at.chain];
  const Id vertex = vertexAtPlaceOf(this->mesh(), curve, at.i);
  if (vertex != NoId)
  {
    return { SurfacePoint::atVertex(vertex), this->vertices_.endsAround(vertex) };
  }
  return { curve.points[at.i],
    segmentEndsAround(this->mesh(), curve, at.chain, this->chains_.places(at.chain), at.i) };
}

SourceFrame CurvesOnPatch::frameOf(Id number) const
{
  const TriangleMesh& mesh = this->mesh();
  const CurveChains::Part& part = this->chains_.partOf(number);
  const SourceCurve& curve = this->chains_.curves()[part.chain];
  SourceFrame frame;
  if (part.begin == part.end)
  {
    const double place = this->chains_.places(part.chain)[part.begin];
    const PointWithEnds at = this->around(this->chains_.pointAt(part.chain, place));
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
