// SPDX-License-Identifier: BSD-3-Clause
#include "front/SaddleWedge.h"

#include <algorithm>

namespace geodesic
{

namespace
{

/// A corner that a walk around the vertex has reached, and whether the walk came across the
/// corner's first edge (the outgoing halfedge) or its second (the incoming one).
struct Stop
{
  Id corner = NoId;
  bool acrossOutgoing = true;

  Id leavingEdge() const
  {
    return this->acrossOutgoing ? TriangleMesh::previousInFace(this->corner) : this->corner;
  }
};

/// Where the straight continuation of the arriving path leaves through the halfedge opposite a
/// corner.
struct Continuation
{
  enum class Found
  {
    Yes,
    /// The walk ends at the boundary first.
    No,
    Unknown
  };
  Found found = Found::Unknown;
  Stop stop;
  double x = 0.0;

  /// The part of the halfedge beyond the continuation.
  EmittedInterval beyond(double length) const
  {
    return this->stop.acrossOutgoing ? EmittedInterval{ this->stop.corner, this->x, length }
                                     : EmittedInterval{ this->stop.corner, 0.0, this->x };
  }
};

// Rotations are unit complex numbers, which avoids computing angles.
Vec2 unit(Vec2 v)
{
  return (1.0 / norm(v)) * v;
}

Vec2 rotated(Vec2 v, Vec2 by)
{
  return { v.x * by.x - v.y * by.y, v.x * by.y + v.y * by.x };
}

// Behind an edge, whose other halfedge is given.
Stop behind(const TriangleMesh& mesh, Id vertex, Id other)
{
  return mesh.origin(other) == vertex ? Stop{ other, true }
                                      : Stop{ TriangleMesh::nextInFace(other), false };
}

// Where the ray from the vertex meets the opposite halfedge. Its direction is relative to the edge
// that was crossed.
double meet(const TriangleMesh& mesh, const Stop& stop, Vec2 direction)
{
  const FaceShape& shape = mesh.shape(TriangleMesh::faceOf(stop.corner));
  const double edge =
    mesh.length(stop.acrossOutgoing ? stop.corner : TriangleMesh::previousInFace(stop.corner));
  const Vec2 other =
    (1.0 / edge) * Vec2{ shape.cornerDot[TriangleMesh::indexInFace(stop.corner)], shape.area2 };
  const double before = direction.y * edge;
  const double behind = direction.x * other.y - direction.y * other.x;
  const double t = std::clamp(before / (before + behind), 0.0, 1.0);
  return mesh.length(TriangleMesh::nextInFace(stop.corner)) * (stop.acrossOutgoing ? t : 1.0 - t);
}

// Walks away from the arriving path until the angle is pi, starting with the path's angle to the
// first edge.
Continuation continueAcross(const TriangleMesh& mesh, Id vertex, Id edge, Vec2 angle)
{
  using Found = Continuation::Found;
  for (std::size_t left = mesh.cornersAt(vertex).size(); left > 0; --left)
  {
    const Id other = mesh.nextSibling(edge);
    if (other == edge)
    {
      return { Found::No, {}, 0.0 };
    }
    const FaceShape& shape = mesh.shape(TriangleMesh::faceOf(other));
    if (mesh.nextSibling(other) != edge || !(shape.area2 > 0.0))
    {
      return {};
    }
    const Stop stop = behind(mesh, vertex, other);
    const Id k = TriangleMesh::indexInFace(stop.corner);
    const Vec2 next = rotated(angle, unit({ shape.cornerDot[k], shape.area2 }));
    if (next.y < 0.0 || (next.y == 0.0 && next.x < 0.0))
    {
      return { Found::Yes, stop, meet(mesh, stop, { -angle.x, angle.y }) };
    }
    angle = next;
    edge = stop.leavingEdge();
  }
  return {};
}

// Adds the shadow behind a continuation, up to the other one or to the boundary. Returns whether it
// reached the other one.
bool addShadow(const TriangleMesh& mesh, Id vertex, const Continuation& from,
  const Continuation& to, std::vector<EmittedInterval>& shadow)
{
  const auto length = [&mesh](Id corner) { return mesh.length(TriangleMesh::nextInFace(corner)); };
  const bool closed = to.found == Continuation::Found::Yes;
  EmittedInterval part = from.beyond(length(from.stop.corner));
  Stop stop = from.stop;
  for (std::size_t left = mesh.cornersAt(vertex).size(); left > 0; --left)
  {
    if (closed && stop.corner == to.stop.corner)
    {
      const EmittedInterval end = to.beyond(length(stop.corner));
      shadow.push_back(
        { stop.corner, std::max(part.begin, end.begin), std::min(part.end, end.end) });
      return true;
    }
    shadow.push_back(part);
    const Id edge = stop.leavingEdge();
    if (mesh.isBoundary(edge))
    {
      break;
    }
    stop = behind(mesh, vertex, mesh.nextSibling(edge));
    part = { stop.corner, 0.0, length(stop.corner) };
  }
  return false;
}

} // anonymous namespace

bool findSaddleWedge(
  const TriangleMesh& mesh, Id vertex, const Arrival& arrival, std::vector<EmittedInterval>& shadow)
{
  shadow.clear();
  if (arrival.halfedge == NoId)
  {
    return false;
  }
  const Id corner = TriangleMesh::previousInFace(arrival.halfedge);
  const FaceShape& shape = mesh.shape(TriangleMesh::faceOf(corner));
  const double first = mesh.length(corner);
  // In the corner's frame, whose x axis is its first edge.
  const Vec2 second =
    (1.0 / first) * Vec2{ shape.cornerDot[TriangleMesh::indexInFace(corner)], shape.area2 };
  const double t = arrival.x / mesh.length(arrival.halfedge);
  const Vec2 back = unit(Vec2{ first, 0.0 } + t * (second - Vec2{ first, 0.0 }));
  const Vec2 toSecond = rotated(unit(second), { back.x, -back.y });
  const auto positive = [](Vec2 v) { return Vec2{ v.x, std::max(v.y, 0.0) }; };
  const Continuation onSecond =
    continueAcross(mesh, vertex, TriangleMesh::previousInFace(corner), positive(toSecond));
  const Continuation onFirst = continueAcross(mesh, vertex, corner, positive(back));
  using Found = Continuation::Found;
  if (onSecond.found == Found::Unknown || onFirst.found == Found::Unknown)
  {
    return false;
  }
  const bool met =
    onSecond.found == Found::Yes && addShadow(mesh, vertex, onSecond, onFirst, shadow);
  if (onFirst.found == Found::Yes && !met)
  {
    addShadow(mesh, vertex, onFirst, onSecond, shadow);
  }
  return true;
}

}
