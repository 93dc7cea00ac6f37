// SPDX-License-Identifier: BSD-3-Clause
#include "source/CurvesInFaces.h"

#include "Tolerance.h"

#include <algorithm>

namespace geodesic
{

CurvesInFaces::CurvesInFaces(const TriangleMesh& mesh, const CurveChains& chains)
  : mesh_(mesh)
{
  for (Id chain = 0; chain < chains.curves().size(); ++chain)
  {
    const SourceCurve& curve = chains.curves()[chain];
    const std::vector<double>& places = chains.places(chain);
    for (std::size_t i = 0; i < curve.faces.size(); ++i)
    {
      const SurfacePoint& p = curve.points[i];
      const SurfacePoint& q = curve.points[i + 1];
      forEachFaceOfSegment(mesh, curve.faces[i], p, q,
        [&](Id face) {
          this->add(face, p, q, { face, {}, {}, chain, places[i], places[i + 1] });
        });
    }
    if (curve.points.size() == 1)
    {
      const SurfacePoint& point = curve.points.front();
      forEachFace(mesh, point,
        [&](Id face) {
          this->add(face, point, point, { face, {}, {}, chain });
        });
    }
  }
  std::stable_sort(this->pieces_.begin(), this->pieces_.end(),
    [](const SourceInFace& a, const SourceInFace& b) { return a.face < b.face; });
}

void CurvesInFaces::add(
  Id face, const SurfacePoint& p, const SurfacePoint& q, const SourceInFace& places)
{
  this->pieces_.push_back(places);
  this->pieces_.back().a = barycentric(this->mesh_, p, face);
  this->pieces_.back().b = barycentric(this->mesh_, q, face);
}

template <typename Visit>
void CurvesInFaces::forEachIn(Id face, const Visit& visit) const
{
  const auto isBefore = [](const SourceInFace& piece, Id f) { return piece.face < f; };
  for (auto piece = std::lower_bound(this->pieces_.begin(), this->pieces_.end(), face, isBefore);
       piece != this->pieces_.end() && piece->face == face; ++piece)
  {
    visit(*piece);
  }
}

const SourceInFace* CurvesInFaces::nearest(const SurfacePoint& point, Id preferred) const
{
  const double rounding =
    tolerance::PlaceRounding * this->mesh_.length(longestHalfedge(this->mesh_, preferred));
  double least = Infinity;
  const SourceInFace* nearest = nullptr;
  forEachFace(this->mesh_, point,
    [&](Id face)
    {
      const Barycentric weights = barycentric(this->mesh_, point, face);
      this->forEachIn(face,
        [&](const SourceInFace& piece)
        {
          const double distance =
            distanceToSource(this->mesh_, piece, weights) + (face == preferred ? 0.0 : rounding);
          if (distance < least)
          {
            least = distance;
            nearest = &piece;
          }
        });
    });
  return nearest;
}

}
