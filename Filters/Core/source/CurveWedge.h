// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_CurveWedge_h
#define geodesic_CurveWedge_h

#include "mesh/HalfedgeFrame.h"
#include "mesh/SurfacePoint.h"
#include "source/AnglesAroundVertex.h"
#include "source/SegmentEnd.h"

#include <utility>
#include <vector>

namespace geodesic
{

/// The direction of a segment that ends at a point, in a face around the point: a unit vector in
/// the frame of a halfedge of the face. A ray at less than a right angle to it starts at the wrong
/// point, as one from inside the segment is shorter.
struct WedgeBound
{
  Id halfedge;
  Vec2 direction;
};

/// The wedge of directions into which a point of a curve emits: those at a right angle or more to
/// all its segments there, measured around the point across any of the faces (paper, section 4.2).
///
/// Reuses its memory for the next point.
class CurveWedge
{
public:
  explicit CurveWedge(const TriangleMesh& mesh)
    : mesh_(mesh)
  {
  }

  /// Moves to another point of a curve.
  ///
  /// \param ends the ends of all segments there; for a vertex, of all curves.
  void assign(const SurfacePoint& point, const std::vector<SegmentEnd>& ends);

  /// The segments that bound the wedge in a face around the point.
  using Bounds = std::pair<const WedgeBound*, const WedgeBound*>;
  Bounds boundsIn(Id face) const;

private:
  WedgeBound inOwnFace(const SegmentEnd& end, std::size_t k) const;
  void addAroundEdge(const SegmentEnd& end);
  void startAroundVertex(const SegmentEnd& end);
  void addAroundVertex(Id vertex);

  const TriangleMesh& mesh_;
  /// In the order of the faces.
  std::vector<WedgeBound> bounds_;
  AnglesAroundVertex angles_;
  std::vector<EdgeAngle> leaving_;
};

}

#endif
