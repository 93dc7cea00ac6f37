// SPDX-License-Identifier: BSD-3-Clause
#include "source/CurveWedge.h"

#include "Tolerance.h"
#include "Trigonometry.h"
#include "source/FanAround.h"

#include <algorithm>
#include <queue>
#include <unordered_set>
#include <utility>

namespace geodesic
{

namespace
{

/// Whether one of a corner's edges is short (tolerance::ShortEdge).
bool hasShortEdge(const TriangleMesh& mesh, Id corner)
{
  const double shortest =
    std::min(mesh.length(corner), mesh.length(TriangleMesh::previousInFace(corner)));
  return shortest < tolerance::ShortEdge * mesh.shape(TriangleMesh::faceOf(corner)).longest();
}

// In the frame of the first halfedge, from k on, that has a length; a face in one point has none.
FaceDirection inOwnFace(const TriangleMesh& mesh, const SegmentEnd& end, std::size_t k)
{
  const FaceShape& shape = mesh.shape(end.face);
  while (shape.length[k] == 0.0 && shape.longest() > 0.0)
  {
    k = (k + 1) % 3;
  }
  const Id halfedge = TriangleMesh::halfedgeOf(end.face, k);
  const Vec2 d = directionIn(mesh, end, halfedge);
  const double length = norm(d);
  return { halfedge, length > 0.0 ? (1.0 / length) * d : d };
}

void add(const FaceDirection& bound, CurveWedge& wedge)
{
  wedge.emplace(TriangleMesh::faceOf(bound.halfedge), bound);
}

// The faces across the edge unfold into the plane of the segment, where its direction stays the
// same.
void addAroundEdge(const TriangleMesh& mesh, const SegmentEnd& end, CurveWedge& wedge)
{
  const Id halfedge = mesh.siblingInFace(end.from.id, end.face);
  const FaceDirection own = inOwnFace(mesh, end, TriangleMesh::indexInFace(halfedge));
  add(own, wedge);
  for (Id s = mesh.nextSibling(halfedge); s != halfedge; s = mesh.nextSibling(s))
  {
    add(acrossEdge(mesh, { halfedge, own.vector }, s), wedge);
  }
}

// Ways leave the segments' faces to both sides of the segments. In a face entered across an edge,
// the nearest segment on that way bounds the wedge.
void addAroundVertex(
  const TriangleMesh& mesh, Id vertex, const std::vector<SegmentEnd>& ends, CurveWedge& wedge)
{
  std::vector<EdgeAngle> leaving;
  for (const SegmentEnd& end : ends)
  {
    const Id corner = mesh.cornerAt(end.face, end.from.id);
    const FaceDirection own = inOwnFace(mesh, end, TriangleMesh::indexInFace(corner));
    add(own, wedge);
    if (own.halfedge == corner) // else it has no length: its neighbours emit too, in vain
    {
      // Rounding may put a direction along an edge below it, a straight angle the other way around.
      const double angle = polarAngle({ own.vector.x, std::max(0.0, own.vector.y) });
      leaving.push_back({ corner, angle });
      leaving.push_back(
        { TriangleMesh::previousInFace(corner), std::max(0.0, mesh.cornerAngle(corner) - angle) });
    }
  }
  for (const EdgeAngle& entered : leastAnglesAround(mesh, vertex, std::move(leaving), RightAngle))
  {
    // In the frame of the halfedge, which begins or ends at the vertex.
    const Vec2 v = unitVector(entered.angle);
    const bool isAtOrigin = mesh.origin(entered.halfedge) == vertex;
    add({ entered.halfedge, { isAtOrigin ? v.x : -v.x, -v.y } }, wedge);
  }
}

} // anonymous namespace

std::vector<EdgeAngle> leastAnglesAround(
  const TriangleMesh& mesh, Id vertex, std::vector<EdgeAngle> leaving, double limit)
{
  const auto isFarther = [](const EdgeAngle& a, const EdgeAngle& b)
  { return a.angle != b.angle ? a.angle > b.angle : a.halfedge > b.halfedge; };
  std::priority_queue<EdgeAngle, std::vector<EdgeAngle>, decltype(isFarther)> queue(
    isFarther, std::move(leaving));
  std::vector<EdgeAngle> entered;
  std::unordered_set<Id> halfedges; // of `entered`
  while (!queue.empty() && queue.top().angle < limit)
  {
    const EdgeAngle nearest = queue.top();
    queue.pop();
    for (Id s = mesh.nextSibling(nearest.halfedge); s != nearest.halfedge; s = mesh.nextSibling(s))
    {
      if (!halfedges.insert(s).second)
      {
        continue;
      }
      entered.push_back({ s, nearest.angle });
      const EnteredCorner to(mesh, vertex, s);
      if (!hasShortEdge(mesh, to.corner))
      {
        queue.push({ to.onward, nearest.angle + mesh.cornerAngle(to.corner) });
      }
    }
  }
  return entered;
}

CurveWedge wedgeAround(
  const TriangleMesh& mesh, const SurfacePoint& point, const std::vector<SegmentEnd>& ends)
{
  CurveWedge wedge;
  if (point.kind == SurfacePoint::Kind::Vertex)
  {
    addAroundVertex(mesh, point.id, ends, wedge);
    return wedge;
  }
  for (const SegmentEnd& end : ends)
  {
    if (point.kind == SurfacePoint::Kind::Edge)
    {
      addAroundEdge(mesh, end, wedge);
    }
    else
    {
      add(inOwnFace(mesh, end, 0), wedge);
    }
  }
  return wedge;
}

}
