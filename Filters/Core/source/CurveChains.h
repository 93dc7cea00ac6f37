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
  /// of the chain's points at which the curve begins and ends.
  struct CurveInChain
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
  /// The parameters of a chain's points: lengths along the chain from its beginning.
  const std::vector<double>& parameters(Id chain) const { return this->parameters_[chain]; }
  /// The curve at a parameter of a chain; at a joint, either one.
  Id curveAt(Id chain, double parameter) const;
  /// The points of all chains are numbered one after another.
  struct Point
  {
    Id chain;
    std::size_t i;
  };
  Point pointWith(Id number) const;
  Id numberOf(const Point& point) const
  {
    return this->firstPoints_[point.chain] + static_cast<Id>(point.i);
  }
  /// The number of the first point at or behind a parameter of a chain.
  Id pointAt(Id chain, double parameter) const;
  const CurveInChain& inChain(Id curve) const { return this->inChain_[curve]; }
  /// The length along a curve, from its first point to a parameter of its chain: from 0 to the
  /// curve's length, also if the parameter lies beside the curve.
  double arcLength(Id curve, double parameter) const;
  /// An angle from the direction of a curve's chain, in radians, as one from the curve's direction.
  double angleFrom(Id curve, double angle) const;

private:
  std::vector<SourceCurve> chains_;
  std::vector<std::vector<double>> parameters_;
  /// The curves of each chain in order along it.
  std::vector<std::vector<Id>> order_;
  /// Where each curve lies in its chain.
  std::vector<CurveInChain> inChain_;
  /// The number of each chain's first point.
  std::vector<Id> firstPoints_;
};

}

#endif
