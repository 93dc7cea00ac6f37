// SPDX-License-Identifier: BSD-3-Clause
#include "source/PointWindows.h"

#include "Tolerance.h"
#include "window/UnfoldedFace.h"

#include <algorithm>

namespace geodesic
{

namespace
{

Vec2 directionInLeavingFrame(const TriangleMesh& mesh, Id halfedge, const WedgeBound& bound)
{
  const Vec2 u = turned(mesh, bound.direction, bound.halfedge, halfedge);
  return { -u.x, -u.y };
}

/// The x axis of the frame that a window is in, seen from the leaving frame of the halfedge that
/// its rays have left the point's face through.
struct WindowFrame
{
  Id leftThrough;
  Vec2 axis = { 1.0, 0.0 };

  /// A direction in the frame of the halfedge, seen from that of the window.
  Vec2 fromHalfedge(Vec2 u) const { return { -dot(u, this->axis), -cross(this->axis, u) }; }
  Vec2 toHalfedge(Vec2 u) const
  {
    return { -(u.x * this->axis.x - u.y * this->axis.y),
      -(u.x * this->axis.y + u.y * this->axis.x) };
  }
};

// Tells the windows of a point from where on which of its rays belong to another curve, or to the
// other side of one.
void addBySector(const CurveSectors& sectors, const WindowFrame& frame,
  const LeavingWindow& leaving, std::vector<LeavingWindow>& windows)
{
  const Window& w = leaving.window;
  std::vector<double> cuts = { w.begin };
  for (const Vec2& change : sectors.changesIn(frame.leftThrough))
  {
    const Vec2 u = frame.fromHalfedge(change);
    const double x = u.y > 0.0 ? w.sourceX + w.sourceDepth * u.x / u.y : w.begin;
    if (x > w.begin && x < w.end)
    {
      cuts.push_back(x);
    }
  }
  std::sort(cuts.begin(), cuts.end());
  cuts.push_back(w.end);
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
  {
    Window part = w;
    part.begin = cuts[i];
    part.end = cuts[i + 1];
    const Vec2 middle = w.direction(0.5 * (part.begin + part.end));
    const CurveOrigin from = sectors.of(frame.leftThrough, frame.toHalfedge(middle));
    part.origin = from.origin;
    part.place = from.place;
    windows.push_back({ leaving.halfedge, part });
  }
}

void addBehindEdge(const TriangleMesh& mesh, LeavingWindow leaving, const CurveSectors& sectors,
  const WindowFrame& frame, std::vector<LeavingWindow>& windows)
{
  Window& window = leaving.window;
  if (mesh.isBoundary(leaving.halfedge) || !(window.end > window.begin))
  {
    return;
  }
  window.sourceDepth = std::max(window.sourceDepth, tolerance::SourceDepth * window.end);
  addBySector(sectors, frame, leaving, windows);
}

// Sends the rays of a point close to the halfedge through the faces behind in one step: between the
// rays through the ends of the edge, which hide what is beside them.
void addBehindNextFaces(const TriangleMesh& mesh, Id halfedge, Vec2 point,
  const CurveSectors& sectors, std::vector<LeavingWindow>& windows)
{
  const double length = mesh.length(halfedge);
  for (Id s = mesh.nextSibling(halfedge); s != halfedge; s = mesh.nextSibling(s))
  {
    const bool turned = mesh.origin(s) == mesh.origin(halfedge);
    const Window w = { 0.0, length, turned ? length - point.x : point.x, -point.y, 0.0, 0.0,
      Window::Kind::Circular, 0 };
    const UnfoldedFace face = unfold(mesh, s);
    const bool toLeft = !w.passesRightOf(0.0, face.apex);
    const bool toRight = w.passesRightOf(length, face.apex);
    if (toLeft)
    {
      const double end = toRight ? face.leftLength : face.meetLeft(w, length);
      addBehindEdge(mesh, { TriangleMesh::previousInFace(s), face.throughLeft(w, 0.0, end) },
        sectors, { halfedge, face.leftAxis }, windows);
    }
    if (toRight)
    {
      const double begin = toLeft ? 0.0 : face.meetRight(w, 0.0);
      addBehindEdge(mesh,
        { TriangleMesh::nextInFace(s), face.throughRight(w, begin, face.rightLength) }, sectors,
        { halfedge, face.rightAxis }, windows);
    }
  }
}

void addThroughHalfedge(const TriangleMesh& mesh, Id halfedge, const Barycentric& point,
  const CurveWedge::Bounds& bounds, const CurveSectors& sectors,
  std::vector<LeavingWindow>& windows)
{
  const double length = mesh.length(halfedge);
  const Vec2 p = inLeavingFrame(mesh, halfedge, point);
  const bool near = -p.y <= tolerance::NearEdge * length;
  Interval interval{ 0.0, length };
  for (const WedgeBound* bound = bounds.first; bound != bounds.second && !near; ++bound)
  {
    const Vec2 u = directionInLeavingFrame(mesh, halfedge, *bound);
    interval.clip(dot(p, u) + std::abs(u.x) * tolerance::Rounding * length, -u.x);
  }
  const double depth = std::max(-p.y, tolerance::SourceDepth * length);
  std::vector<LeavingWindow> leaving;
  addLeavingWindow(mesh, halfedge, interval,
    { 0.0, 0.0, p.x, depth, 0.0, 0.0, Window::Kind::Circular, 0 }, leaving);
  for (const LeavingWindow& window : leaving)
  {
    addBySector(sectors, { halfedge }, window, windows);
  }
  if (near && p.x > 0.0 && p.x < length)
  {
    addBehindNextFaces(mesh, halfedge, p, sectors, windows);
  }
}

} // anonymous namespace

void addPointWindows(const TriangleMesh& mesh, Id face, const Barycentric& point,
  const CurveWedge& wedge, const CurveSectors& sectors, std::vector<LeavingWindow>& windows)
{
  const CurveWedge::Bounds bounds = wedge.boundsIn(face);
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Id halfedge = 3 * face + static_cast<Id>(k);
    const bool isOnIt = point[(k + 2) % 3] == 0.0;
    if (!isOnIt && !mesh.isBoundary(halfedge) && mesh.length(halfedge) > 0.0)
    {
      addThroughHalfedge(mesh, halfedge, point, bounds, sectors, windows);
    }
  }
}

}
