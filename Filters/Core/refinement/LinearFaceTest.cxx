// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/LinearFaceTest.h"

#include "Tolerance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace geodesic
{

namespace
{

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

double sumOf(const FaceBounds& bounds, double rounding)
{
  return static_cast<double>(roundedUp(bounds.above)) + bounds.below + 2.0 * rounding;
}

} // anonymous namespace

MeasuredList LinearFaceTest::measure(const PassedList& list) const
{
  return { list,
    listInBand(list.windows.range(), this->mesh_.length(list.halfedge), list.ends[0], list.ends[1],
      BandOfTolerance * this->tolerance_) };
}

LinearFaceTest::Result LinearFaceTest::test(
  Id face, const std::array<double, 3>& d, const PassedLists& lists, double known) const
{
  const double rounding = roundingOf(d);
  if (!(rounding < this->tolerance_))
  {
    return {};
  }
  const FaceBounds quick = this->boundsByBand(face, d, lists);
  Result result;
  result.boundByBand = sumOf(quick, rounding);
  result.aboveByBand = roundedUp(quick.above);
  if (result.boundByBand <= known)
  {
    return result.boundUnlessDominated(known);
  }
  const FaceBounds bounds = this->boundsByWindows(face, d, lists, this->tolerance_ - rounding);
  if (sumOf(bounds, rounding) <= this->tolerance_)
  {
    result.isLinear = true;
    result.bound = sumOf(bounds, rounding);
    result.above = roundedUp(bounds.above);
    result.isSplitOnce = true;
    return result;
  }
  const double once = SplitOnce * this->tolerance_;
  const FaceBounds wide = this->boundsByWindows(face, d, lists, once);
  result.isSplitOnce = std::max(wide.above, wide.below) + rounding <= once;
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
  Id face, const std::array<double, 3>& d, const PassedLists& lists) const
{
  const double rounding = roundingOf(d);
  std::array<bool, 3> staysBelowBand{};
  const bool inBand = lists.forEach(face,
    [&](const MeasuredList& measured)
    {
      const std::array<double, 2>& ends = measured.list.ends;
      const std::size_t k = measured.list.halfedge % 3;
      staysBelowBand[k] = staysBelowBand[k] || measured.inBand.staysBelowBand;
      return measured.inBand.staysAboveBand && std::abs(ends[0] - d[k]) <= rounding &&
        std::abs(ends[1] - d[(k + 1) % 3]) <= rounding;
    });
  return inBand
    ? boundsFromBands(this->mesh_, face, d, staysBelowBand, BandOfTolerance * this->tolerance_)
    : FaceBounds();
}

FaceBounds LinearFaceTest::boundsByWindows(
  Id face, const std::array<double, 3>& d, const PassedLists& lists, double limit) const
{
  std::array<std::vector<WindowRange>, 3> ranges;
  lists.forEach(face,
    [&](const MeasuredList& measured)
    {
      ranges[measured.list.halfedge % 3].push_back(measured.list.windows.range());
      return true;
    });
  std::array<WindowRuns, 3> windows;
  for (std::size_t k = 0; k < 3; ++k)
  {
    windows[k] = WindowRuns(ranges[k].data(), ranges[k].data() + ranges[k].size());
  }
  return boundsOfFace(this->mesh_, face, d, windows, limit);
}

}
