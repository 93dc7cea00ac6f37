// SPDX-License-Identifier: BSD-3-Clause
#include "source/CurvesOnPatch.h"

#include "source/DirectionsAround.h"

#include <algorithm>
#include <tuple>

namespace geodesic
{

namespace
{

bool isBefore(const VertexOnCurve& a, const VertexOnCurve& b)
{
  return a.vertex < b.vertex;
}

} // anonymous namespace

CurvesOnPatch::CurvesOnPatch(const ReplicatedPatch& patch, const std::vector<SourceCurve>& curves)
  : patch_(patch)
  , chains_(patch.mesh(), curves)
{
  for (Id chain = 0; chain < this->chains_.curves().size(); ++chain)
  {
    const SourceCurve& curve = this->chains_.curves()[chain];
    const std::size_t count = curve.points.size() - (curve.isClosed() ? 1 : 0);
    for (std::size_t i = 0; i < count; ++i)
    {
      std::vector<Id> vertices = verticesAtCornerOf(this->mesh(), curve, i);
      if (curve.points[i].kind == SurfacePoint::Kind::Vertex)
      {
        vertices.push_back(curve.points[i].id);
      }
      for (const Id vertex : vertices)
      {
        this->vertices_.push_back({ vertex, chain, i, this->chains_.places(chain)[i] });
      }
    }
  }
  std::stable_sort(this->vertices_.begin(), this->vertices_.end(), isBefore);
}

const VertexOnCurve* CurvesOnPatch::find(Id vertex) const
{
  const auto found = std::lower_bound(
    this->vertices_.begin(), this->vertices_.end(), VertexOnCurve{ vertex }, isBefore);
  return found != this->vertices_.end() && found->vertex == vertex ? &*found : nullptr;
}

// Several points of a curve may be at one place: their ends are the same.
std::vector<SegmentEnd> CurvesOnPatch::endsOf(Id vertex, bool isAround) const
{
  std::vector<SegmentEnd> ends;
  const auto range = std::equal_range(
    this->vertices_.begin(), this->vertices_.end(), VertexOnCurve{ vertex }, isBefore);
  for (auto on = range.first; on != range.second; ++on)
  {
    const SurfacePoint& p = this->chains_.curves()[on->curve].points[on->i];
    if (isAround || (p.kind == SurfacePoint::Kind::Vertex && p.id == vertex))
    {
      const CurveChains::Point at = { on->curve, on->i };
      const std::vector<SegmentEnd> added = isAround
        ? segmentEndsAround(this->mesh(), this->chains_, at)
        : segmentEndsAt(this->mesh(), this->chains_, at);
      ends.insert(ends.end(), added.begin(), added.end());
    }
  }
  const auto key = [](const SegmentEnd& end)
  {
    const SurfacePoint& to = end.to;
    return std::make_tuple(end.face, to.kind, to.id, to.u, to.v, end.curve, end.place);
  };
  std::stable_sort(ends.begin(), ends.end(),
    [&key](const SegmentEnd& a, const SegmentEnd& b) { return key(a) < key(b); });
  ends.erase(std::unique(ends.begin(), ends.end(),
               [&key](const SegmentEnd& a, const SegmentEnd& b) { return key(a) == key(b); }),
    ends.end());
  return ends;
}

PointWithEnds CurvesOnPatch::around(Id point) const
{
  const CurveChains::Point at = this->chains_.pointWith(point);
  const SourceCurve& curve = this->chains_.curves()[at.chain];
  const Id vertex = vertexAtPlaceOf(this->mesh(), curve, at.i);
  if (vertex != NoId)
  {
    return { SurfacePoint::atVertex(vertex), this->endsAround(vertex) };
  }
  return { curve.points[at.i], segmentEndsAround(this->mesh(), this->chains_, at) };
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
