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
    const std::vector<double>& places = chains.places(number);
    const std::size_t count = curve.points.size() - (curve.isClosed() ? 1 : 0);
    for (std::size_t i = 0; i < count; ++i)
    {
      if (curve.points[i].kind == SurfacePoint::Kind::Vertex)
      {
        this->vertices_.push_back({ curve.points[i].id, number, places[i] });
        const std::vector<SegmentEnd> ends = segmentEndsAt(mesh, curve, number, places, i);
        this->ends_.insert(this->ends_.end(), ends.begin(), ends.end());
      }
    }
  }
  std::stable_sort(this->vertices_.begin(), this->vertices_.end());
  const auto isSame = [](const VertexOnCurve& a, const VertexOnCurve& b)
  { return a.vertex == b.vertex; };
  this->vertices_.erase(
    std::unique(this->vertices_.begin(), this->vertices_.end(), isSame), this->vertices_.end());
  const auto key = [](const SegmentEnd& s)
  { return std::make_tuple(s.from.id, s.face, s.to.kind, s.to.id, s.to.u, s.to.v); };
  std::stable_sort(this->ends_.begin(), this->ends_.end(),
    [&key](const SegmentEnd& a, const SegmentEnd& b) { return key(a) < key(b); });
}

const VertexOnCurve* VerticesOnCurves::find(Id vertex) const
{
  const auto found =
    std::lower_bound(this->vertices_.begin(), this->vertices_.end(), VertexOnCurve{ vertex });
  return found != this->vertices_.end() && found->vertex == vertex ? &*found : nullptr;
}

std::vector<SegmentEnd> VerticesOnCurves::endsAt(Id vertex) const
{
  const auto first = std::lower_bound(this->ends_.begin(), this->ends_.end(), vertex,
    [](const SegmentEnd& end, Id id) { return end.from.id < id; });
  const auto last = std::find_if(
    first, this->ends_.end(), [vertex](const SegmentEnd& end) { return end.from.id != vertex; });
  return { first, last };
}

}
