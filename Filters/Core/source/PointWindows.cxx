// SPDX-License-Identifier: BSD-3-Clause
#include "source/PointWindows.h"

#include "Tolerance.h"
#include "window/UnfoldedFace.h"

#include <algorithm>

namespace geodesic
{

namespace
{

std::size_t next(std::size_t k)
{
  return (k + 1) % 3;
}
std::size_t previous(std::size_t k)
{
  return (k + 2) % 3;
}

Vec2 rotated(Vec2 v, Vec2 axis)
{
  return { v.x * axis.x - v.y * axis.y, v.x * axis.y + v.y * axis.x };
}

// The unit vector along halfedge `of` of a face in the frame of its halfedge `in`.
Vec2 halfedgeAxis(const FaceShape& shape, std::size_t of, std::size_t in)
{
  if (of == in)
  {
    return { 1.0, 0.0 };
  }
  const double scale = shape.length[in] * shape.length[of];
  if (of == next(in))
  {
    return { -shape.cornerDot[of] / scale, shape.area2 / scale };
  }
  return { -shape.cornerDot[in] / scale, -shape.area2 / scale };
}

Vec2 directionInLeavingFrame(const TriangleMesh& mesh, Id halfedge, const WedgeBound& bound)
{
  const FaceShape& shape = mesh.shape(TriangleMesh::faceOf(halfedge));
  const Vec2 u = rotated(bound.direction, halfedgeAxis(shape, bound.halfedge % 3, halfedge % 3));
  return { -u.x, -u.y };
}

void addBehindEdge(
  const TriangleMesh& mesh, Id halfedge, Window window, std::vector<LeavingWindow>& windows)
{
  if (mesh.isBoundary(halfedge) || !(window.end > window.begin))
  {
    return;
  }
  window.sourceDepth = std::max(window.sourceDepth, tolerance::SourceDepth * window.end);
  windows.push_back({ halfedge, window });
}

// Sends the rays of a point close to the halfedge through the faces behind in one step: between the
// rays through the ends of the edge, which hide what is beside them.
void addBehindNextFaces(
  const TriangleMesh& mesh, Id halfedge, Vec2 point, std::vector<LeavingWindow>& windows)
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
      addBehindEdge(mesh, TriangleMesh::previousInFace(s), face.throughLeft(w, 0.0, end), windows);
    }
    if (toRight)
    {
      const double begin = toLeft ? 0.0 : face.meetRight(w, 0.0);
      addBehindEdge(
        mesh, TriangleMesh::nextInFace(s), face.throughRight(w, begin, face.rightLength), windows);
    }
  }
}

void addThroughHalfedge(const TriangleMesh& mesh, Id halfedge, const Barycentric& point,
  const CurveWedge::Bounds& bounds, std::vector<LeavingWindow>& windows)
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
  addLeavingWindow(mesh, halfedge, interval, Window::Kind::Circular, { p.x, depth }, 0.0, windows);
  if (near && p.x > 0.0 && p.x < length)
  {
    addBehindNextFaces(mesh, halfedge, p, windows);
  }
}

} // anonymous namespace

void addPointWindows(const TriangleMesh& mesh, Id face, const Barycentric& point,
  const CurveWedge& wedge, std::vector<LeavingWindow>& windows)
{
  const CurveWedge::Bounds bounds = wedge.boundsIn(face);
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Id halfedge = 3 * face + static_cast<Id>(k);
    const bool isOnIt = point[previous(k)] == 0.0;
    if (!isOnIt && !mesh.isBoundary(halfedge) && mesh.length(halfedge) > 0.0)
    {
      addThroughHalfedge(mesh, halfedge, point, bounds, windows);
    }
  }
}

}
