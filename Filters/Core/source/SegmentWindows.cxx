// SPDX-License-Identifier: BSD-3-Clause
#include "source/SegmentWindows.h"

#include "Tolerance.h"

#include <utility>

namespace geodesic
{

namespace
{

// The rays through one halfedge: the strip beside the segment, cut off by the rays at its two ends.
void addThroughHalfedge(const TriangleMesh& mesh, Id halfedge, const Barycentric& a,
  const Barycentric& b, std::vector<LeavingWindow>& windows)
{
  Vec2 from = inLeavingFrame(mesh, halfedge, a);
  Vec2 to = inLeavingFrame(mesh, halfedge, b);
  if (from.x > to.x)
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
  // Where the segment touches the halfedge, rays leave the face up to there only.
  const double sigma = -cross(t, from);
  interval.clip(sigma + tolerance::SourceDepth * mesh.length(halfedge), -t.y);
  addLeavingWindow(mesh, halfedge, interval, Window::Kind::Linear, { -t.y, t.x }, sigma, windows);
}

} // anonymous namespace

void addSegmentWindows(const TriangleMesh& mesh, Id face, const Barycentric& a,
  const Barycentric& b, std::vector<LeavingWindow>& windows)
{
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Id halfedge = 3 * face + static_cast<Id>(k);
    if (!runsAlong(k, a, b) && !mesh.isBoundary(halfedge) && mesh.length(halfedge) > 0.0)
    {
      addThroughHalfedge(mesh, halfedge, a, b, windows);
    }
  }
}

}
