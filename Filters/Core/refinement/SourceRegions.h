// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SourceRegions_h
#define geodesic_SourceRegions_h

#include "field/DistanceField.h"
#include "field/NearestSource.h"
#include "source/SourceCurve.h"

#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

namespace geodesic
{

/// What a point is nearest to: a part of the source (SourceCurve::source), and one of its sides.
struct SourceRegion
{
  /// NoId where the front did not arrive.
  Id source = NoId;
  bool isRight = false;

  bool operator!=(const SourceRegion& other) const
  {
    return this->source != other.source || this->isRight != other.isRight;
  }
};

/// Divides a surface into the regions that are nearest to one part of the source each. refine() can
/// split triangles along their borders (RefinementOptions::regions).
class SourceRegions
{
public:
  /// All arguments must outlive this.
  ///
  /// \param field the exact field that `nearest` knows the feet of.
  /// \param curves those of the field.
  /// \param bySides whether the two sides of a curve are two regions.
  SourceRegions(const DistanceField& field, NearestSource& nearest,
    const std::vector<SourceCurve>& curves, bool bySides)
    : field_(field)
    , nearest_(nearest)
    , curves_(curves)
    , bySides_(bySides)
  {
  }

  /// The region of a point of this rank's faces. Points that are not vertices must lie in faces
  /// with windows. Each is looked up once.
  SourceRegion at(const SurfacePoint& point);

  /// For each face that this rank owns, whether its corners lie in several regions; 0 for others.
  std::vector<std::uint8_t> facesAtBorders();

private:
  SourceRegion of(const Foot& foot) const;

  const DistanceField& field_;
  NearestSource& nearest_;
  const std::vector<SourceCurve>& curves_;
  bool bySides_;
  std::map<std::tuple<SurfacePoint::Kind, Id, double, double>, SourceRegion> known_;
};

}

#endif
