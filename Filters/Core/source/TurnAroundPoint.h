// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_TurnAroundPoint_h
#define geodesic_TurnAroundPoint_h

#include "mesh/SurfacePoint.h"

#include <vector>

namespace geodesic
{

/// A turn around a point of an edge or a vertex, from face to face. A face without area is no
/// obstacle: the turn goes on in the face behind it, where the point is a vertex or lies on an
/// edge, as the place tells.
///
/// Ends at edges with other than two faces, and where the orientation changes.
class TurnAroundPoint
{
public:
  /// Begins in a face that contains the point; counterclockwise.
  TurnAroundPoint(const TriangleMesh& mesh, const SurfacePoint& point, Id face);

  /// A halfedge of the face with the point: those directions in its frame that point into the face
  /// have angles from 0 to width().
  Id halfedge() const;
  double width() const;
  /// The angle that the turn takes in the face: none in a face without area that it crosses.
  double angle() const { return this->isCrossed() ? 0.0 : this->width(); }

  /// The vertex of the face that the point is at; NoId where it lies on an edge.
  Id vertex() const { return this->point_.x == 0.0 ? this->mesh_.origin(this->halfedge()) : NoId; }

  /// Turns into the next face. \returns false where the turn has ended.
  bool next();
  /// Whether the turn has ended in the face where it had begun.
  bool isClosed() const { return this->entered_ == this->first_.halfedge; }
  /// Goes back to the first face and turns clockwise into the face before it. \returns as next().
  bool turnBack();

private:
  /// A halfedge that the point lies on, and the distance between the point and the halfedge's
  /// origin, in a clockwise turn its destination.
  struct PointOnHalfedge
  {
    Id halfedge;
    double x;
  };

  Id pivotNext(Id halfedge) const;
  bool isCrossed() const;
  PointOnHalfedge exit() const;
  bool enterAcross(const PointOnHalfedge& exit);

  const TriangleMesh& mesh_;
  bool isCounterclockwise_ = true;
  PointOnHalfedge first_;
  /// On the halfedge across which the turn has entered the face.
  PointOnHalfedge point_;
  /// The halfedge that the turn entered across last; NoId before that and where nothing follows.
  Id entered_ = NoId;
  /// That across which it entered the first face around the current corner; NoId before.
  Id corner_ = NoId;
  /// The halfedges across which the turn has entered faces without area that it crosses.
  std::vector<Id> crossed_;
};

/// The vertices at the place of a vertex or of a point on an edge, behind faces without area.
std::vector<Id> verticesAtPlaceOf(const TriangleMesh& mesh, const SurfacePoint& point);

}

#endif
