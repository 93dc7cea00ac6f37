// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SegmentEnd_h
#define geodesic_SegmentEnd_h

#include "mesh/HalfedgeFrame.h"
#include "mesh/SurfacePoint.h"

namespace geodesic
{

/// An end of a curve's segment, which runs from it to another point of the same face.
struct SegmentEnd
{
  SurfacePoint from;
  SurfacePoint to;
  Id face = NoId;
  /// The curve's number, the end's place along it, and whether the curve runs away from the end.
  Id curve = 0;
  double place = 0.0;
  bool isBeginning = true;
  /// For a segment without length: a halfedge of its face, and the direction in which the curve
  /// continues behind it, in that halfedge's frame.
  Id frame = NoId;
  Vec2 onward = {};
};

/// The direction of a segment away from its end, in the frame of a halfedge of its face; not
/// normalized.
inline Vec2 directionIn(const TriangleMesh& mesh, const SegmentEnd& end, Id halfedge)
{
  if (end.frame != NoId)
  {
    return turned(mesh, end.onward, end.frame, halfedge);
  }
  return inHalfedgeFrame(mesh, halfedge, barycentric(mesh, end.to, end.face)) -
    inHalfedgeFrame(mesh, halfedge, barycentric(mesh, end.from, end.face));
}

}

#endif
