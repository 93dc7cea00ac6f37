// SPDX-License-Identifier: BSD-3-Clause
#include "source/TurnAroundPoint.h"

#include "Tolerance.h"

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

TurnAroundPoint::PointOnHalfedge TurnAroundPoint::exit() const
{
  return this->point_.x > 0.0 ? this->point_
                              : PointOnHalfedge{ this->pivotNext(this->point_.halfedge), Infinity };
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

bool TurnAroundPoint::next()
{
  return this->enterAcross(this->exit());
}

bool TurnAroundPoint::turnBack()
{
  this->isCounterclockwise_ = false;
  const double length = this->mesh_.length(this->first_.halfedge);
  return this->enterAcross({ this->first_.halfedge, length - this->first_.x });
}

}
