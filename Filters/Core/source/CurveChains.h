// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_CurveChains_h
#define geodesic_CurveChains_h

#include "source/SourceCurve.h"

#include <vector>

namespace geodesic
{

/// Curves joined at their ends. The front then treats a line that is split into many cells as one
/// curve, whose parallel rays stay together.
class CurveChains
{
public:
  /// A curve as a part of its chain: whether the chain runs against its direction, and the numbers
  /// of the chain's points at which the part begins and ends.
  struct Part
  {
    Id chain = NoId;
    bool isReversed = false;
    std::size_t begin = 0;
    std::size_t end = 0;
  };

  /// Two curves are joined if the end of one coincides with the end of the other and of no third.
  CurveChains(const TriangleMesh& mesh, const std::vector<SourceCurve>& curves);

  /// The chains as curves with normalized points; SourceCurve::source is that of the first.
  const std::vector<SourceCurve>& curves() const { return this->chains_; }
  /// The places of a chain's points along it.
  const std::vector<double>& places(Id chain) const { return this->places_[chain]; }
  /// The curve at a place of a chain; at a joint, either one.
  Id curveAt(Id chain, double place) const;
  /// The points of all chains are numbered one after another. The number of the first at or behind
  /// a place of a chain, and the point with a number.
  Id pointAt(Id chain, double place) const;
  struct Point
  {
    Id chain;
    std::size_t i;
  };
  Point pointWith(Id number) const;
  const Part& partOf(Id curve) const { return this->parts_[curve]; }
  /// The length along a curve, from its first point to a place of its chain.
  double arcLength(Id curve, double place) const;
  /// An angle from the direction of a curve's chain, in radians, as one from the curve's direction.
  double angleFrom(Id curve, double angle) const;

private:
  std::vector<SourceCurve> chains_;
  std::vector<std::vector<double>> places_;
  /// The curves of each chain in order along it.
  std::vector<std::vector<Id>> order_;
  /// Where each curve lies in its chain.
  std::vector<Part> parts_;
  /// The number of each chain's first point.
  std::vector<Id> firstPoints_;
};

}

#endif
