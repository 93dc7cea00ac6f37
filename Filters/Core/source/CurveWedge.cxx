// SPDX-License-Identifier: BSD-3-Clause
#include "source/CurveWedge.h"

#include <algorithm>

namespace geodesic
{

namespace
{

constexpr double RightAngle = 1.57079632679489661923;

struct ByFace
{
  bool operator()(const WedgeBound& a, const WedgeBound& b) const
  {
    return TriangleMesh::faceOf(a.halfedge) < TriangleMesh::faceOf(b.halfedge);
  }
};

} // anonymous namespace

void CurveWedge::assign(const SurfacePoint& point, const std::vector<SegmentEnd>& ends)
{
  this->bounds_.clear();
  this->leaving_.clear();
  for (const SegmentEnd& end : ends)
  {
    switch (point.kind)
    {
      case SurfacePoint::Kind::Face:
        this->bounds_.push_back(this->inOwnFace(end, 0));
        break;
      case SurfacePoint::Kind::Edge:
        this->addAroundEdge(end);
        break;
      case SurfacePoint::Kind::Vertex:
        this->startAroundVertex(end);
        break;
    }
  }
  if (!this->leaving_.empty())
  {
    this->addAroundVertex(point.id);
  }
  std::stable_sort(this->bounds_.begin(), this->bounds_.end(), ByFace());
}

CurveWedge::Bounds CurveWedge::boundsIn(Id face) const
{
  const auto range = std::equal_range(this->bounds_.data(),
    this->bounds_.data() + this->bounds_.size(), WedgeBound{ 3 * face, {} }, ByFace());
  return { range.first, range.second };
}

// In the frame of the first halfedge, from k on, that has a length; a face in one point has none.
WedgeBound CurveWedge::inOwnFace(const SegmentEnd& end, std::size_t k) const
{
  const FaceShape& shape = this->mesh_.shape(end.face);
  while (shape.length[k] == 0.0 && shape.longest() > 0.0)
  {
    k = (k + 1) % 3;
  }
  const Id halfedge = 3 * end.face + static_cast<Id>(k);
  const Vec2 d = directionIn(this->mesh_, end, halfedge);
  const double length = norm(d);
  return { halfedge, length > 0.0 ? (1.0 / length) * d : d };
}

// The faces across the edge unfold into the plane of the segment, where its direction stays the
// same.
void CurveWedge::addAroundEdge(const SegmentEnd& end)
{
  const Id halfedge = this->mesh_.siblingInFace(end.from.id, end.face);
  const WedgeBound own = this->inOwnFace(end, halfedge % 3);
  this->bounds_.push_back(own);
  const Vec2 u = own.direction;
  for (Id s = this->mesh_.nextSibling(halfedge); s != halfedge; s = this->mesh_.nextSibling(s))
  {
    const bool opposed = this->mesh_.origin(s) == this->mesh_.destination(halfedge);
    this->bounds_.push_back({ s, { opposed ? -u.x : u.x, -u.y } });
  }
}

// Ways leave the segment's face to both sides of the segment.
void CurveWedge::startAroundVertex(const SegmentEnd& end)
{
  const Id corner = this->mesh_.cornerAt(end.face, end.from.id);
  const WedgeBound own = this->inOwnFace(end, corner % 3);
  this->bounds_.push_back(own);
  if (own.halfedge != corner)
  {
    return; // a halfedge without length: its neighbours emit too, which only costs time
  }
  // Rounding may put a direction along an edge below it, a straight angle the other way around.
  const double angle = std::atan2(std::max(0.0, own.direction.y), own.direction.x);
  this->leaving_.push_back({ corner, angle });
  this->leaving_.push_back({ TriangleMesh::previousInFace(corner),
    std::max(0.0, this->mesh_.cornerAngle(corner) - angle) });
}

// In a face entered across an edge, the nearest segment on that way bounds the wedge.
void CurveWedge::addAroundVertex(Id vertex)
{
  for (const EdgeAngle& entered :
    this->angles_.find(this->mesh_, vertex, this->leaving_, RightAngle))
  {
    // In the frame of the halfedge, which begins or ends at the vertex.
    const double x = std::cos(entered.angle);
    const bool atOrigin = this->mesh_.origin(entered.halfedge) == vertex;
    this->bounds_.push_back({ entered.halfedge, { atOrigin ? x : -x, -std::sin(entered.angle) } });
  }
}

}
