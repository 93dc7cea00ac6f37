// SPDX-License-Identifier: BSD-3-Clause
#include "source/VerticesOnCurves.h"

#include <algorithm>
#include <tuple>

namespace geodesic
{

VerticesOnCurves::VerticesOnCurves(const TriangleMesh& mesh, const CurveChains& chains)
{
  for (Id number = 0; number < chains.curves().size(); ++number)
  {
    const SourceCurve& curve = chains.curves()[number];
    const std::size_t count = curve.points.size() - (curve.isClosed() ? 1 : 0);
    for (std::size_t i = 0; i < count; ++i)
    {
      this->add(mesh, chains, number, i);
    }
  }
  std::stable_sort(this->vertices_.begin(), this->vertices_.end());
  const auto isSame = [](const VertexOnCurve& a, const VertexOnCurve& b)
  { return a.vertex == b.vertex; };
  this->vertices_.erase(
    std::unique(this->vertices_.begin(), this->vertices_.end(), isSame), this->vertices_.end());
  sort(this->ends_);
  sort(this->endsAround_);
}

void VerticesOnCurves::add(
  const TriangleMesh& mesh, const CurveChains& chains, Id number, std::size_t i)
{
  const SourceCurve& curve = chains.curves()[number];
  const std::vector<double>& places = chains.places(number);
  std::vector<Id> vertices = verticesAtCornerOf(mesh, curve, i);
  if (curve.points[i].kind == SurfacePoint::Kind::Vertex)
  {
    vertices.push_back(curve.points[i].id);
    for (const SegmentEnd& end : segmentEndsAt(mesh, curve, number, places, i))
    {
      this->ends_.push_back({ curve.points[i].id, end });
    }
  }
  for (const Id vertex : vertices)
  {
    this->vertices_.push_back({ vertex, number, places[i] });
    for (const SegmentEnd& end : segmentEndsAround(mesh, curve, number, places, i))
    {
      this->endsAround_.push_back({ vertex, end });
    }
  }
}

// Several points of a curve may be at one place: their ends are the same.
void VerticesOnCurves::sort(Ends& ends)
{
  const auto key = [](const EndAtVertex& e)
  {
    const SurfacePoint& to = e.end.to;
    return std::make_tuple(
      e.vertex, e.end.face, to.kind, to.id, to.u, to.v, e.end.curve, e.end.place);
  };
  std::stable_sort(ends.begin(), ends.end(),
    [&key](const EndAtVertex& a, const EndAtVertex& b) { return key(a) < key(b); });
  ends.erase(std::unique(ends.begin(), ends.end(),
               [&key](const EndAtVertex& a, const EndAtVertex& b) { return key(a) == key(b); }),
    ends.end());
}

const VertexOnCurve* VerticesOnCurves::find(Id vertex) const
{
  const auto found =
    std::lower_bound(this->vertices_.begin(), this->vertices_.end(), VertexOnCurve{ vertex });
  return found != this->vertices_.end() && found->vertex == vertex ? &*found : nullptr;
}

std::vector<SegmentEnd> VerticesOnCurves::of(Id vertex, const Ends& ends)
{
  const auto first = std::lower_bound(
    ends.begin(), ends.end(), vertex, [](const EndAtVertex& e, Id id) { return e.vertex < id; });
  std::vector<SegmentEnd> result;
  for (auto e = first; e != ends.end() && e->vertex == vertex; ++e)
  {
    result.push_back(e->end);
  }
  return result;
}

}
