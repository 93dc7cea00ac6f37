// SPDX-License-Identifier: BSD-3-Clause
#include "source/TurnAroundPoint.h"

#include "Tolerance.h"

#include <algorithm>

namespace geodesic
{

namespace
{

double roundingOn(double length)
{
  return tolerance::PlaceRounding * length;
}

} // anonymous namespace

TurnAroundPoint::TurnAroundPoint(const TriangleMesh& mesh, const SurfacePoint& point, Id face)
  : mesh_(mesh)
{
  if (point.kind == SurfacePoint::Kind::Vertex)
  {
    this->first_ = { mesh.cornerAt(face, point.id), 0.0 };
  }
  else
  {
    const Id halfedge = mesh.siblingInFace(point.id, face);
    const Barycentric b = barycentric(mesh, point, face);
    const std::size_t end = (TriangleMesh::indexInFace(halfedge) + 1) % 3;
    this->first_ = { halfedge, b[end] * mesh.length(halfedge) };
  }
  this->point_ = this->first_;
}

// Around a vertex the halfedge that begins there.
Id TurnAroundPoint::halfedge() const
{
  const bool isAtEnd = !this->isCounterclockwise_ && this->point_.x == 0.0;
  return isAtEnd ? TriangleMesh::nextInFace(this->point_.halfedge) : this->point_.halfedge;
}

double TurnAroundPoint::width() const
{
  return this->point_.x == 0.0 ? this->mesh_.cornerAngle(this->halfedge()) : Pi;
}

// The halfedge that a turn around the corner leaves a face across if it entered the face across the
// given one.
Id TurnAroundPoint::pivotNext(Id halfedge) const
{
  return this->isCounterclockwise_ ? TriangleMesh::previousInFace(halfedge)
                                   : TriangleMesh::nextInFace(halfedge);
}

// Around an end of its longest edge a face without area has an angle of 0.
bool TurnAroundPoint::isCrossed() const
{
  const Id face = TriangleMesh::faceOf(this->point_.halfedge);
  if (!this->mesh_.shape(face).hasZeroArea())
  {
    return false;
  }
  const Id longest = longestHalfedge(this->mesh_, face);
  const bool isAtApex = this->point_.halfedge == this->pivotNext(longest) &&
    this->mesh_.length(this->point_.halfedge) > roundingOn(this->mesh_.length(longest));
  return this->point_.x > 0.0 || isAtApex;
}

// Across a face without area from its longest edge to that of the others which has the point, and
// back. At the apex these two have it: the farther one is entered at the apex, whose faces follow.
TurnAroundPoint::PointOnHalfedge TurnAroundPoint::exit() const
{
  const auto [halfedge, x] = this->point_;
  if (!this->isCrossed())
  {
    return x > 0.0 ? this->point_ : PointOnHalfedge{ this->pivotNext(halfedge), Infinity };
  }
  const Id longest = longestHalfedge(this->mesh_, TriangleMesh::faceOf(halfedge));
  const Id near = this->pivotNext(longest); // shares the end that x counts from
  const Id far = this->pivotNext(near);
  const double apex = this->mesh_.length(near);
  if (halfedge == longest)
  {
    const bool isBehind = x >= apex - roundingOn(this->mesh_.length(longest));
    return isBehind ? PointOnHalfedge{ far, this->mesh_.length(far) - (x - apex) }
                    : PointOnHalfedge{ near, apex - x };
  }
  return { longest, halfedge == near ? apex - x : this->mesh_.length(longest) - x };
}

// Places on the halfedges of an edge count from its two ends.
bool TurnAroundPoint::enterAcross(const PointOnHalfedge& exit)
{
  this->entered_ = this->mesh_.acrossOriented(exit.halfedge);
  if (this->entered_ == NoId)
  {
    return false;
  }
  const double length = this->mesh_.length(exit.halfedge);
  const double x = length - exit.x;
  this->point_ = { this->entered_, x > roundingOn(length) ? x : 0.0 };
  return !this->isClosed();
}

// A turn around a corner comes back to where it has begun, as each face follows one alone. It
// begins where the turn comes from an edge or across a face, which no turn does twice.
bool TurnAroundPoint::next()
{
  if (this->isCrossed())
  {
    const Id halfedge = this->point_.halfedge;
    if (std::find(this->crossed_.begin(), this->crossed_.end(), halfedge) != this->crossed_.end())
    {
      return false;
    }
    this->crossed_.push_back(halfedge);
  }
  const bool isAroundCorner = this->point_.x == 0.0 && !this->isCrossed();
  if (!this->enterAcross(this->exit()) || (isAroundCorner && this->entered_ == this->corner_))
  {
    return false;
  }
  this->corner_ = isAroundCorner ? this->corner_ : this->entered_;
  return true;
}

bool TurnAroundPoint::turnBack()
{
  this->isCounterclockwise_ = false;
  this->crossed_.clear();
  const double length = this->mesh_.length(this->first_.halfedge);
  const bool isThere = this->enterAcross({ this->first_.halfedge, length - this->first_.x });
  this->corner_ = this->entered_;
  return isThere;
}

std::vector<Id> verticesAtPlaceOf(const TriangleMesh& mesh, const SurfacePoint& point)
{
  std::vector<Id> vertices;
  forEachFace(mesh, point,
    [&](Id face)
    {
      if (!mesh.shape(face).hasZeroArea())
      {
        return;
      }
      TurnAroundPoint turn(mesh, point, face);
      const auto addOthers = [&](bool isThere)
      {
        for (; isThere; isThere = turn.next())
        {
          const bool isOwn = point.kind == SurfacePoint::Kind::Vertex && turn.vertex() == point.id;
          if (turn.vertex() != NoId && !isOwn)
          {
            vertices.push_back(turn.vertex());
          }
        }
      };
      addOthers(true);
      addOthers(!turn.isClosed() && turn.turnBack());
    });
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

}
