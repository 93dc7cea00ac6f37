// SPDX-License-Identifier: BSD-3-Clause
#include "source/TurnAroundPoint.h"

namespace geodesic
{

TurnAroundPoint::TurnAroundPoint(const TriangleMesh& mesh, const SurfacePoint& point, Id face)
  : mesh_(mesh)
  , isAtVertex_(point.kind == SurfacePoint::Kind::Vertex)
  , first_(this->isAtVertex_ ? mesh.cornerAt(face, point.id) : mesh.siblingInFace(point.id, face))
  , entered_(first_)
{
}

// Around a vertex the halfedge that begins there.
Id TurnAroundPoint::halfedge() const
{
  const bool isAtEnd = this->isAtVertex_ && !this->isCounterclockwise_;
  return isAtEnd ? TriangleMesh::nextInFace(this->entered_) : this->entered_;
}

double TurnAroundPoint::width() const
{
  return this->isAtVertex_ ? this->mesh_.cornerAngle(this->halfedge()) : Pi;
}

// A turn around a vertex leaves a face across another halfedge than it entered across.
Id TurnAroundPoint::exit() const
{
  return !this->isAtVertex_     ? this->entered_
    : this->isCounterclockwise_ ? TriangleMesh::previousInFace(this->entered_)
                                : TriangleMesh::nextInFace(this->entered_);
}

bool TurnAroundPoint::enterAcross(Id exit)
{
  this->entered_ = this->mesh_.acrossOriented(exit);
  return this->entered_ != NoId && !this->isClosed();
}

bool TurnAroundPoint::next()
{
  return this->enterAcross(this->exit());
}

bool TurnAroundPoint::turnBack()
{
  this->isCounterclockwise_ = false;
  return this->enterAcross(this->first_);
}

}
