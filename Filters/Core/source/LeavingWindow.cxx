// SPDX-License-Identifier: BSD-3-Clause
#include "source/LeavingWindow.h"

#include "Tolerance.h"

#include <utility>

namespace geodesic
{

namespace
{

// Whether rays to one side of the segment may leave through a halfedge. If the segment ends in a
// corner, one of the corner's halfedges lies on its left and the other on its right: through the
// wrong one rounding would admit a sliver of rays.
bool isSideOf(std::size_t k, const SourceInFace& segment, bool isRight)
{
  const auto isCorner = [](const Barycentric& p, std::size_t corner)
  { return p[(corner + 1) % 3] == 0.0 && p[(corner + 2) % 3] == 0.0; };
  const bool isOnRight = isCorner(segment.a, k) || isCorner(segment.b, (k + 1) % 3);
  const bool isOnLeft = isCorner(segment.b, k) || isCorner(segment.a, (k + 1) % 3);
  return isRight ? !isOnLeft : !isOnRight;
}

// The rays through one halfedge: the strip beside the segment, bounded by the rays at its two ends.
void addThroughHalfedge(const TriangleMesh& mesh, Id halfedge, const SourceInFace& segment,
  std::vector<LeavingWindow>& windows)
{
  Vec2 from = inLeavingFrame(mesh, halfedge, segment.a);
  Vec2 to = inLeavingFrame(mesh, halfedge, segment.b);
  // Rays go up; they leave to the left of a segment that runs from left to right.
  const bool isRight = from.x > to.x;
  if (!isSideOf(halfedge % 3, segment, isRight))
  {
    return;
  }
  if (isRight)
  {
    std::swap(from, to);
  }
  const double length = norm(to - from);
  if (!(length > 0.0))
  {
    return;
  }
  const Vec2 t = (1.0 / length) * (to - from);
  Interval interval{ 0.0, mesh.length(halfedge) };
  const double origin = dot(from, t); // position along the segment of x = 0, negated
  interval.clip(-origin, t.x);
  interval.clip(origin + length, -t.x);
  // If the segment touches the halfedge, rays leave the face only up to there.
  const double sigma = -cross(t, from);
  interval.clip(sigma, -t.y);
  const double place = isRight ? segment.placeOfB + origin : segment.placeOfA - origin;
  addLeavingWindow(mesh, halfedge, interval,
    { 0.0, 0.0, -t.y, t.x, sigma, 0.0, Window::Kind::Linear, 0,
      CurveSide{ segment.curve, isRight }.origin(mesh.numberOfVertices()), place },
    windows);
}

} // anonymous namespace

Vec2 inLeavingFrame(const TriangleMesh& mesh, Id halfedge, const Barycentric& point)
{
  const Vec2 p = inHalfedgeFrame(mesh, halfedge, point);
  return { mesh.length(halfedge) - p.x, -p.y };
}

void addLeavingWindow(const TriangleMesh& mesh, Id halfedge, const Interval& interval,
  const Window& window, std::vector<LeavingWindow>& windows)
{
  const double length = mesh.length(halfedge);
  const double begin = std::max(interval.begin, 0.0);
  const double end = std::min(interval.end, length);
  if (end - begin > tolerance::LeastWidth * length && window.sourceDepth > 0.0)
  {
    LeavingWindow& leaving = windows.emplace_back(LeavingWindow{ halfedge, window });
    leaving.window.begin = begin;
    leaving.window.end = end;
  }
}

void addSegmentWindows(
  const TriangleMesh& mesh, const SourceInFace& segment, std::vector<LeavingWindow>& windows)
{
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Id halfedge = 3 * segment.face + static_cast<Id>(k);
    if (!runsAlong(k, segment.a, segment.b) && !mesh.isBoundary(halfedge) &&
      mesh.length(halfedge) > 0.0)
    {
      addThroughHalfedge(mesh, halfedge, segment, windows);
    }
  }
}

LeavingWindow vertexWindow(const TriangleMesh& mesh, Id corner, double sigma)
{
  const Id halfedge = TriangleMesh::nextInFace(corner);
  const double length = mesh.length(halfedge);
  const Vec2 p = inLeavingFrame(mesh, halfedge, cornerWeights(corner % 3));
  const double depth = std::max(-p.y, tolerance::SourceDepth * length);
  return { halfedge, { 0.0, length, p.x, depth, sigma, 0.0, Window::Kind::Circular, 0 } };
}

}
