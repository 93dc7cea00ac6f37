// SPDX-License-Identifier: BSD-3-Clause
#include "source/CurvesInFaces.h"

#include <algorithm>

namespace geodesic
{

CurvesInFaces::CurvesInFaces(const TriangleMesh& mesh, const std::vector<SourceCurve>& curves)
  : mesh_(mesh)
{
  for (const SourceCurve& curve : curves)
  {
    for (std::size_t i = 0; i < curve.faces.size(); ++i)
    {
      const SurfacePoint p = normalized(mesh, curve.points[i]);
      const SurfacePoint q = normalized(mesh, curve.points[i + 1]);
      forEachFaceOfSegment(
        mesh, curve.faces[i], p, q, [&](Id face) { this->add(face, p, q, curve.source); });
    }
    if (curve.points.size() == 1)
    {
      const SurfacePoint point = normalized(mesh, curve.points.front());
      forEachFace(mesh, point, [&](Id face) { this->add(face, point, point, curve.source); });
    }
  }
  std::stable_sort(this->pieces_.begin(), this->pieces_.end(),
    [](const Piece& a, const Piece& b) { return a.place.face < b.place.face; });
}

void CurvesInFaces::add(Id face, const SurfacePoint& p, const SurfacePoint& q, Id source)
{
  this->pieces_.push_back(
    { { face, barycentric(this->mesh_, p, face), barycentric(this->mesh_, q, face) }, source });
}

Id CurvesInFaces::sourceAt(const SurfacePoint& point) const
{
  double nearest = Infinity;
  Id source = NoId;
  const auto isBefore = [](const Piece& piece, Id face) { return piece.place.face < face; };
  forEachFace(this->mesh_, point,
    [&](Id face)
    {
      const Barycentric weights = barycentric(this->mesh_, point, face);
      for (auto piece =
             std::lower_bound(this->pieces_.begin(), this->pieces_.end(), face, isBefore);
           piece != this->pieces_.end() && piece->place.face == face; ++piece)
      {
        const double distance = distanceToSource(this->mesh_, piece->place, weights);
        if (distance < nearest)
        {
          nearest = distance;
          source = piece->source;
        }
      }
    });
  return source;
}

}
