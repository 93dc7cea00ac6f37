// SPDX-License-Identifier: BSD-3-Clause
#include "source/SourceCurve.h"

#include "mesh/HalfedgeFrame.h"

namespace geodesic
{

bool SourceCurve::isClosed() const
{
  if (this->points.size() < 2)
  {
    return false;
  }
  const SurfacePoint& first = this->points.front();
  const SurfacePoint& last = this->points.back();
  return first.kind == last.kind && first.id == last.id && first.u == last.u && first.v == last.v;
}

std::vector<double> placesAlong(const TriangleMesh& mesh, const SourceCurve& curve)
{
  std::vector<double> places = { 0.0 };
  for (std::size_t i = 0; i + 1 < curve.points.size(); ++i)
  {
    const Id face = curve.faces[i];
    const double place = places.back() +
      distanceInFace(mesh, face, barycentric(mesh, curve.points[i], face),
        barycentric(mesh, curve.points[i + 1], face));
    places.push_back(std::max(place, std::nextafter(places.back(), Infinity)));
  }
  return places;
}

SourceCurve pointCurve(const SurfacePoint& point)
{
  SourceCurve curve;
  curve.points = { point };
  curve.isCut = { 0 };
  return curve;
}

}
