// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/FaceBounds.h"

#include "Tolerance.h"
#include "refinement/Deviation.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace geodesic
{

GradientSlack slackOf(const FaceShape& shape, const std::array<double, 3>& d)
{
  return slackOf({ shape.length[0] * shape.length[0], shape.cornerDot[0],
                   shape.length[2] * shape.length[2], shape.area2, shape.longest() },
    d[1] - d[0], d[2] - d[0]);
}

GradientSlack slackOf(const TriangleMetric& triangle, double rise1, double rise2)
{
  const auto& [e1e1, e1e2, e2e2, area2, longest] = triangle;
  const double scale = 1.0 / (area2 * area2);
  const double alpha = (rise1 * e2e2 - rise2 * e1e2) * scale; // gradient = alpha e1 + beta e2
  const double beta = (rise2 * e1e1 - rise1 * e1e2) * scale;
  const double steepness = std::sqrt(std::max(0.0, alpha * rise1 + beta * rise2));
  const double across1 = -beta * area2; // gradient x e1
  const double across2 = alpha * area2; // gradient x e2
  const auto [least, most] = std::minmax({ 0.0, across1, across2 });
  const double extent = most - least;
  // the longest way through the triangle in the gradient's direction
  const double chord = extent > 0.0 ? std::min(longest, area2 * steepness / extent) : longest;
  return { std::max(0.0, steepness - 1.0) * longest, std::max(0.0, 1.0 - steepness) * chord };
}

namespace
{

// The widest gap allowed between the windows of a list, or before and behind them, as a fraction of
// the band's half width.
constexpr double BandGap = 0.25;

// Half the width of the band, as a fraction of the tolerance. If the distance on the halfedges
// stays in this band around the interpolant, the face is linear without another look at its
// windows. The half width counts twice, above and below, and the gradient in the face adds to both.
constexpr double BandOfTolerance = 0.25;

// If a face's interpolant deviates by at most this many tolerances, one split of its edges
// suffices: it quarters the deviation where the distance is smooth and halves it at a kink.
constexpr double SplitOnce = 2.0;

// Whether the interpolant rises from the line of halfedge k into the face, to the opposite corner:
// ways against the gradient leave through such a halfedge.
bool risesFrom(std::size_t k, const FaceShape& shape, const std::array<double, 3>& d)
{
  const std::size_t next = (k + 1) % 3;
  const double length2 = shape.length[k] * shape.length[k];
  const double onLine = d[k] * length2 + (d[next] - d[k]) * shape.cornerDot[k];
  return d[(k + 2) % 3] * length2 >= onLine;
}

// How far the interpolant along a halfedge is above its windows.
double belowOfHalfedge(const LineOnSegment& line, const WindowRuns& windows)
{
  double below = 0.0;
  for (const Window& w : windows)
  {
    const double x = line.lowestOf(w);
    below = std::max(below, line.at(x) - w.distance(x));
  }
  return below;
}

// A bound, from the windows of a halfedge, of how far the distance along it is above its
// interpolant. The difference of a window is convex, so largest at an end; between windows that do
// not meet, the distance changes by no more than the length moved. Windows over the limit are
// ignored: later windows have overtaken them, or they fill a gap of rounding.
double aboveOfHalfedge(
  const LineOnSegment& line, double length, const WindowRuns& windows, double limit)
{
  const auto acrossGap = [&line](double from, double to, double gap)
  {
    const double meet = 0.5 * (to - from + (1.0 + line.slope) * gap);
    return meet > 0.0 && meet < gap ? from + (1.0 - line.slope) * meet : std::max(from, to);
  };
  double covered = 0.0;
  double atCovered = 0.0;
  double above = 0.0;
  for (const Window& w : windows)
  {
    if (w.end <= covered)
    {
      continue;
    }
    const double atBegin = w.distance(w.begin) - line.at(w.begin);
    const double atEnd = w.distance(w.end) - line.at(w.end);
    if (std::max(atBegin, atEnd) > limit)
    {
      continue;
    }
    const double between =
      w.begin > covered ? acrossGap(atCovered, atBegin, w.begin - covered) : atBegin;
    above = std::max({ above, between, atEnd });
    covered = w.end;
    atCovered = atEnd;
  }
  if (covered < length)
  {
    above = std::max(above, acrossGap(atCovered, 0.0, length - covered));
  }
  return above;
}

double roundingOf(const std::array<double, 3>& d)
{
  return tolerance::FaceRounding * std::max({ d[0], d[1], d[2] });
}

} // anonymous namespace

FaceBounds boundsOfFace(const TriangleMesh& mesh, Id face, const std::array<double, 3>& d,
  const std::array<WindowRuns, 3>& windows, double limit)
{
  const FaceShape& shape = mesh.shape(face);
  if (!(shape.area2 > 0.0))
  {
    return {};
  }
  const GradientSlack slack = slackOf(shape, d);
  if (!(std::max(slack.below, slack.above) <= limit))
  {
    return {};
  }
  double below = 0.0;
  double above = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const LineOnSegment line(shape.length[k], d[k], d[(k + 1) % 3]);
    below = std::max(below, belowOfHalfedge(line, windows[k]));
    if (!(below <= limit - slack.below))
    {
      return {};
    }
    if (risesFrom(k, shape, d))
    {
      above =
        std::max(above, aboveOfHalfedge(line, shape.length[k], windows[k], limit - slack.above));
    }
  }
  return { above + slack.above, below + slack.below };
}

double quickBoundOfFace(const DistanceField& field, Id face, double tolerance)
{
  const TriangleMesh& mesh = field.mesh();
  const Triangle& corners = mesh.triangle(face);
  const FaceShape& shape = mesh.shape(face);
  std::array<double, 3> d;
  for (std::size_t k = 0; k < 3; ++k)
  {
    d[k] = field.vertexDistances()[corners[k]];
  }
  const double rounding = roundingOf(d);
  const double limit = tolerance - rounding;
  const std::array<Id, 3> halfedges = TriangleMesh::halfedgesOf(face);
  const FaceBounds bounds = boundsOfFace(mesh, face, d,
    { field.windowsOn(halfedges[0]), field.windowsOn(halfedges[1]), field.windowsOn(halfedges[2]) },
    limit);
  double bound = std::max(bounds.above, bounds.below);
  for (const SourceInFace& source : field.sourcesIn(face))
  {
    const double atA = source.a[0] * d[0] + source.a[1] * d[1] + source.a[2] * d[2];
    const double atB = source.b[0] * d[0] + source.b[1] * d[1] + source.b[2] * d[2];
    bound = std::max(bound, std::max(atA, atB) + slackOf(shape, d).below);
  }
  bound = std::min(bound, shape.longest()); // distances change by no more than the length moved
  return bound <= limit ? bound + rounding : Infinity;
}

MeasuredList measuredList(const TriangleMesh& mesh, const PassedList& list, double tolerance)
{
  const double length = mesh.length(list.halfedge);
  const LineOnSegment line(length, list.ends[0], list.ends[1]);
  const double limit = BandOfTolerance * tolerance;
  MeasuredList measured{ list };
  if (!((1.0 - line.slope) * (1.0 + line.slope) >= -tolerance::Tie)) // 0 along a ray
  {
    return measured;
  }
  const double gap = BandGap * limit;
  bool isUnderAll = true;
  double covered = 0.0;
  for (const Window& w : list.windows.range())
  {
    const double lowest = line.lowestOf(w);
    if (!(line.at(lowest) - w.distance(lowest) <= limit))
    {
      return measured;
    }
    // A window is convex, so it is highest over the line at an end.
    isUnderAll = isUnderAll && w.begin <= covered + gap &&
      w.distance(w.begin) - line.at(w.begin) <= limit &&
      w.distance(w.end) - line.at(w.end) <= limit;
    covered = w.end;
  }
  measured.hasNoneBelow = true;
  measured.hasNoneAbove = isUnderAll && covered + gap >= length;
  return measured;
}

// In a gap the distance changes by no more than
// the length moved from the gap's ends, and the line by no more either.
FaceBounds boundsByBand(const TriangleMesh& mesh, Id face, const std::array<double, 3>& d,
  const MeasuredLists& lists, double tolerance)
{
  const FaceShape& shape = mesh.shape(face);
  if (!(shape.area2 > 0.0))
  {
    return {};
  }
  const double rounding = roundingOf(d);
  std::array<bool, 3> hasNoneAbove{};
  for (const MeasuredList& measured : lists)
  {
    const PassedList& list = measured.list;
    const std::size_t k = TriangleMesh::indexInFace(list.halfedge);
    if (!measured.hasNoneBelow || !(std::abs(list.ends[0] - d[k]) <= rounding) ||
      !(std::abs(list.ends[1] - d[(k + 1) % 3]) <= rounding))
    {
      return {};
    }
    hasNoneAbove[k] = hasNoneAbove[k] || measured.hasNoneAbove;
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (!hasNoneAbove[k] && risesFrom(k, shape, d))
    {
      return {};
    }
  }
  const GradientSlack slack = slackOf(shape, d);
  const double limit = BandOfTolerance * tolerance;
  return { (1.0 + BandGap) * limit + slack.above, limit + slack.below };
}

namespace
{

FaceBounds boundsByWindows(const TriangleMesh& mesh, Id face, const std::array<double, 3>& d,
  const MeasuredLists& lists, double limit)
{
  std::array<std::vector<WindowRange>, 3> ranges;
  for (const MeasuredList& measured : lists)
  {
    ranges[TriangleMesh::indexInFace(measured.list.halfedge)].push_back(
      measured.list.windows.range());
  }
  std::array<WindowRuns, 3> windows;
  for (std::size_t k = 0; k < 3; ++k)
  {
    windows[k] = WindowRuns(ranges[k].data(), ranges[k].data() + ranges[k].size());
  }
  return boundsOfFace(mesh, face, d, windows, limit);
}

} // anonymous namespace

LinearFaceTest testLinear(const TriangleMesh& mesh, Id face, const std::array<double, 3>& d,
  const MeasuredLists& lists, double tolerance, double known)
{
  const double rounding = roundingOf(d);
  const auto ofClosure = [rounding](const FaceBounds& bounds)
  { return bounds.above + bounds.below + 2.0 * rounding; };
  double bound = ofClosure(boundsByBand(mesh, face, d, lists, tolerance));
  if (!(bound <= known))
  {
    bound = ofClosure(boundsByWindows(mesh, face, d, lists, tolerance - rounding));
  }
  if (bound <= tolerance)
  {
    return { bound, true };
  }
  const double once = SplitOnce * tolerance;
  const FaceBounds wide = boundsByWindows(mesh, face, d, lists, once);
  return { Infinity, std::max(wide.above, wide.below) + rounding <= once };
}

}
