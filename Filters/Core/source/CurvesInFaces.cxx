// SPDX-License-Identifier: BSD-3-Clause
#include "source/CurvesInFaces.h"

#include "Tolerance.h"

#include <algorithm>

namespace geodesic
{

namespace
{

bool isBefore(const SourceInFace& a, const SourceInFace& b)
{
  return a.face < b.face;
}

} // anonymous namespace

CurvesInFaces::CurvesInFaces(const TriangleMesh& mesh, const CurveChains& chains)
  : mesh_(mesh)
{
  for (Id chain = 0; chain < chains.curves().size(); ++chain)
  {
    const SourceCurve& curve = chains.curves()[chain];
    const std::vector<SourceInFace> segments =
      segmentsInFaces(mesh, curve, chain, chains.places(chain));
    this->pieces_.insert(this->pieces_.end(), segments.begin(), segments.end());
    if (curve.points.size() == 1)
    {
      forEachFace(mesh, curve.points.front(),
        [&](Id face)
        {
          const Barycentric point = barycentric(mesh, curve.points.front(), face);
          this->pieces_.push_back({ face, point, point, chain });
        });
    }
  }
  std::stable_sort(this->pieces_.begin(), this->pieces_.end(), isBefore);
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
      const auto pieces = std::equal_range(
        this->pieces_.begin(), this->pieces_.end(), SourceInFace{ face }, isBefore);
      for (auto piece = pieces.first; piece != pieces.second; ++piece)
      {
        const double distance =
          distanceToSource(this->mesh_, *piece, weights) + (face == preferred ? 0.0 : rounding);
        if (distance < least)
        {
          least = distance;
          nearest = &*piece;
        }
      }
    });
  return nearest;
}

}
