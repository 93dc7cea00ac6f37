// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_TurnAroundPoint_h
#define geodesic_TurnAroundPoint_h

#include "mesh/SurfacePoint.h"

namespace geodesic
{

/// A turn around a point of an edge or a vertex, from face to face.
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

  /// Turns into the next face. \returns false where the turn has ended.
  bool next();
  /// Whether the turn has ended in the face where it had begun.
  bool isClosed() const { return this->entered_ == this->first_; }
  /// Goes back to the first face and turns clockwise into the face before it. \returns as next().
  bool turnBack();

private:
  Id exit() const;
  bool enterAcross(Id exit);

  const TriangleMesh& mesh_;
  bool isAtVertex_;
  bool isCounterclockwise_ = true;
  Id first_;
  /// The halfedge that the turn entered across last; NoId where nothing follows.
  Id entered_;
};

}

#endif
