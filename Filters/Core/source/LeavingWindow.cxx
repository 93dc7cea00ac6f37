// SPDX-License-Identifier: BSD-3-Clause
#include "source/LeavingWindow.h"

#include "Tolerance.h"

namespace geodesic
{

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

LeavingWindow vertexWindow(const TriangleMesh& mesh, Id corner, double sigma)
{
  const Id halfedge = TriangleMesh::nextInFace(corner);
  const double length = mesh.length(halfedge);
  Barycentric vertex{};
  vertex[corner % 3] = 1.0;
  const Vec2 p = inLeavingFrame(mesh, halfedge, vertex);
  const double depth = std::max(-p.y, tolerance::SourceDepth * length);
  return { halfedge, { 0.0, length, p.x, depth, sigma, 0.0, Window::Kind::Circular, 0 } };
}

}
