// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/LinearFaceTest.h"

#include "Tolerance.h"
#include "refinement/Deviation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

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
  LineOnSegment line;
  double limit;

  double high(double x) const { return this->line.atBegin + this->limit + this->line.slope * x; }
  double low(double x) const { return this->line.atBegin - this->limit + this->line.slope * x; }
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
  if (!w.isLinear() && w.sigma + w.sourceDepth * band.line.sine >= band.low(w.sourceX))
  {
    return true;
  }
  const double x = band.line.lowestOf(w);
  return w.distance(x) >= band.low(x);
}

// Half the width of the band, as a fraction of the tolerance. If the distance on the halfedges
// stays in this band around the interpolant, the face is linear without another look at its
// windows. The half width counts twice, above and below, and the gradient in the face adds to both.
constexpr double BandOfTolerance = 0.25;

// If a face's interpolant deviates by at most this many tolerances, one split of its edges
// suffices: it quarters the deviation where the distance is smooth and halves it at a kink.
constexpr double SplitOnce = 2.0;

double roundingOf(const std::array<double, 3>& d)
{
  return tolerance::FaceRounding * std::max({ d[0], d[1], d[2] });
}

float roundedUp(double value)
{
  return std::nextafter(static_cast<float>(value), std::numeric_limits<float>::infinity());
}

LinearFaceTest::Sum sumOf(const FaceBounds& bounds, double rounding)
{
  const float above = roundedUp(bounds.above);
  return { static_cast<double>(above) + bounds.below + 2.0 * rounding, above };
}

} // anonymous namespace

ListInBand listInBand(
  const WindowRange& windows, double length, double atOrigin, double atDestination, double limit)
{
  const Band band = { LineOnSegment(length, atOrigin, atDestination), limit };
  const double slope = band.line.slope;
  if (!((1.0 - slope) * (1.0 + slope) >= -tolerance::Tie)) // 0 along a ray
  {
    return {};
  }
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

MeasuredList LinearFaceTest::measure(const PassedList& list) const
{
  return { list,
    listInBand(list.windows.range(), this->mesh_.length(list.halfedge), list.ends[0], list.ends[1],
      BandOfTolerance * this->tolerance_) };
}

LinearFaceTest::Result LinearFaceTest::test(
  Id face, const std::array<double, 3>& d, const MeasuredLists& lists, double known) const
{
  const double rounding = roundingOf(d);
  if (!(rounding < this->tolerance_))
  {
    return { {}, {}, false };
  }
  Result result;
  result.byBand = sumOf(this->boundsByBand(face, d, lists), rounding);
  if (result.byBand.bound <= known)
  {
    return result;
  }
  result.byWindows =
    sumOf(this->boundsByWindows(face, d, lists, this->tolerance_ - rounding), rounding);
  if (!(result.byWindows.bound <= this->tolerance_))
  {
    result.byWindows = {};
    const double once = SplitOnce * this->tolerance_;
    const FaceBounds wide = this->boundsByWindows(face, d, lists, once);
    result.isSplitOnce = std::max(wide.above, wide.below) + rounding <= once;
  }
  return result;
}

double LinearFaceTest::boundWith(
  const PassedList& late, float above, const std::array<double, 3>& d) const
{
  const WindowRange windows = late.windows.range();
  return static_cast<double>(above) + roundingOf(d) +
    belowThroughHalfedge(this->mesh_, late.halfedge, d, { &windows, &windows + 1 });
}

// Uses what was found about the lists as they passed.
FaceBounds LinearFaceTest::boundsByBand(
  Id face, const std::array<double, 3>& d, const MeasuredLists& lists) const
{
  const double rounding = roundingOf(d);
  std::array<bool, 3> staysBelowBand{};
  for (const auto& [list, inBand] : lists)
  {
    const std::size_t k = list.halfedge % 3;
    if (!inBand.staysAboveBand || !(std::abs(list.ends[0] - d[k]) <= rounding) ||
      !(std::abs(list.ends[1] - d[(k + 1) % 3]) <= rounding))
    {
      return {};
    }
    staysBelowBand[k] = staysBelowBand[k] || inBand.staysBelowBand;
  }
  return boundsFromBands(this->mesh_, face, d, staysBelowBand, BandOfTolerance * this->tolerance_);
}

FaceBounds LinearFaceTest::boundsByWindows(
  Id face, const std::array<double, 3>& d, const MeasuredLists& lists, double limit) const
{
  std::array<std::vector<WindowRange>, 3> ranges;
  for (const auto& [list, inBand] : lists)
  {
    ranges[list.halfedge % 3].push_back(list.windows.range());
  }
  std::array<WindowRuns, 3> windows;
  for (std::size_t k = 0; k < 3; ++k)
  {
    windows[k] = WindowRuns(ranges[k].data(), ranges[k].data() + ranges[k].size());
  }
  return boundsOfFace(this->mesh_, face, d, windows, limit);
}

}
