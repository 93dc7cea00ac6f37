// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/FaceBounds.h"

#include "Tolerance.h"
#include "refinement/Deviation.h"

#include <algorithm>

namespace geodesic
{

GradientSlack slackOf(const FaceShape& shape, const std::array<double, 3>& d)
{
  return slackOf(shape.length[0] * shape.length[0], shape.cornerDot[0],
    shape.length[2] * shape.length[2], shape.area2, d[1] - d[0], d[2] - d[0], shape.longest());
}

GradientSlack slackOf(
  double e1e1, double e1e2, double e2e2, double area2, double rise1, double rise2, double longest)
{
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

// Along the normal into the face, from the line of the halfedge to the opposite corner.
bool risesFrom(std::size_t k, const FaceShape& shape, const std::array<double, 3>& d)
{
  const std::size_t next = (k + 1) % 3;
  const double length2 = shape.length[k] * shape.length[k];
  const double onLine = d[k] * length2 + (d[next] - d[k]) * shape.cornerDot[k];
  return d[(k + 2) % 3] * length2 >= onLine;
}

namespace
{

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

} // anonymous namespace

double belowThroughHalfedge(
  const TriangleMesh& mesh, Id halfedge, const std::array<double, 3>& d, const WindowRuns& windows)
{
  const FaceShape& shape = mesh.shape(TriangleMesh::faceOf(halfedge));
  const std::size_t k = halfedge % 3;
  const LineOnSegment line(shape.length[k], d[k], d[(k + 1) % 3]);
  return belowOfHalfedge(line, windows) + slackOf(shape, d).below;
}

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

QuickError quickErrorOfFace(const DistanceField& field, Id face, double tolerance, double known)
{
  const TriangleMesh& mesh = field.mesh();
  const Triangle& corners = mesh.triangle(face);
  const FaceShape& shape = mesh.shape(face);
  std::array<double, 3> d;
  for (std::size_t k = 0; k < 3; ++k)
  {
    d[k] = field.vertexDistances()[corners[k]];
  }
  QuickError error;
  error.rounding = tolerance::FaceRounding * std::max({ d[0], d[1], d[2] });
  const double limit = tolerance - error.rounding;
  error.bySize = shape.longest() <= limit ? shape.longest() : Infinity;
  error.byWindows = error.bySize;
  if (error.bySize <= known || !(shape.area2 > 0.0))
  {
    return error;
  }
  const Id halfedge = 3 * face;
  const FaceBounds bounds = boundsOfFace(mesh, face, d,
    { field.windowsOn(halfedge), field.windowsOn(halfedge + 1), field.windowsOn(halfedge + 2) },
    limit);
  double bound = std::max(bounds.above, bounds.below);
  for (const SourceInFace& source : field.sourcesIn(face))
  {
    const double atA = source.a[0] * d[0] + source.a[1] * d[1] + source.a[2] * d[2];
    const double atB = source.b[0] * d[0] + source.b[1] * d[1] + source.b[2] * d[2];
    bound = std::max(bound, std::max(atA, atB) + slackOf(shape, d).below);
  }
  error.byWindows = bound <= limit ? std::min(bound, error.bySize) : error.bySize;
  return error;
}

}
