// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/LinearBand.h"

#include "Tolerance.h"

#include <algorithm>

namespace geodesic
{

namespace
{

// The widest gap allowed between the windows of a list, or before and behind them, as a fraction of
// the band's half width.
constexpr double BandGap = 0.25;

/// A line along a halfedge, and the half width of the band around it.
struct Band
{
  double atOrigin;
  double slope;
  /// The sine of the angle between the halfedge and rays whose distance rises like the line.
  double depth;
  double limit;

  double high(double x) const { return this->atOrigin + this->limit + this->slope * x; }
  double low(double x) const { return this->atOrigin - this->limit + this->slope * x; }
};

// A window is convex, so it is highest over the line at an end.
bool isUnder(const Window& w, const Band& band)
{
  const double overBegin = band.high(w.begin) - w.sigma;
  const double overEnd = band.high(w.end) - w.sigma;
  if (w.isLinear())
  {
    return w.sourceX * w.begin <= overBegin && w.sourceX * w.end <= overEnd;
  }
  const double b = w.begin - w.sourceX;
  const double e = w.end - w.sourceX;
  const double h2 = w.sourceDepth * w.sourceDepth;
  return std::min(overBegin, overEnd) >= 0.0 && b * b + h2 <= overBegin * overBegin &&
    e * e + h2 <= overEnd * overEnd;
}

// A circular window is above its tangent with the line's slope, which suffices in most cases.
bool isOver(const Window& w, const Band& band)
{
  if (w.isLinear())
  {
    return w.distance(w.begin) >= band.low(w.begin) && w.distance(w.end) >= band.low(w.end);
  }
  if (w.sigma + w.sourceDepth * band.depth >= band.low(w.sourceX))
  {
    return true;
  }
  const double steepest = band.slope > 0.0 ? w.end : w.begin;
  const double x = band.depth > 0.0
    ? std::clamp(w.sourceX + w.sourceDepth * band.slope / band.depth, w.begin, w.end)
    : steepest;
  return w.distance(x) >= band.low(x);
}

} // anonymous namespace

ListInBand listInBand(
  const WindowRange& windows, double length, double atOrigin, double atDestination, double limit)
{
  const double slope = (atDestination - atOrigin) / length;
  const double squared = (1.0 - slope) * (1.0 + slope);
  if (!(squared >= -tolerance::Tie)) // 0 along a ray
  {
    return {};
  }
  const Band band = { atOrigin, slope, std::sqrt(std::max(0.0, squared)), limit };
  const double gap = BandGap * limit;
  ListInBand inBand = { true, true };
  double covered = 0.0;
  for (const Window& w : windows)
  {
    if (!isOver(w, band))
    {
      return {};
    }
    inBand.staysBelowBand = inBand.staysBelowBand && w.begin <= covered + gap && isUnder(w, band);
    covered = w.end;
  }
  inBand.staysBelowBand = inBand.staysBelowBand && covered + gap >= length;
  return inBand;
}

// In a gap the distance changes by no more than the length moved from the gap's ends, and the line
// by no more either.
FaceBounds boundsFromBands(const TriangleMesh& mesh, Id face, const std::array<double, 3>& d,
  const std::array<bool, 3>& staysBelowBand, double limit)
{
  const FaceShape& shape = mesh.shape(face);
  if (!(shape.area2 > 0.0))
  {
    return {};
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (!staysBelowBand[k] && risesFrom(k, shape, d))
    {
      return {};
    }
  }
  const GradientSlack slack = slackOf(shape, d);
  return { (1.0 + BandGap) * limit + slack.above, limit + slack.below };
}

}
