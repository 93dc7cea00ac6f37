// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SegmentEnd_h
#define geodesic_SegmentEnd_h

#include "mesh/HalfedgeFrame.h"
#include "mesh/TriangleMesh.h"
#include "source/CurveChains.h"

#include <vector>

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
Vec2 directionIn(const TriangleMesh& mesh, const SegmentEnd& end, Id halfedge);

/// The ends of the segments that meet in a point of a chain: two inside the chain, one at its ends,
/// none if the chain is a point. A segment without length, as in a face without area, counts only
/// if the chain continues from it across edges.
std::vector<SegmentEnd> segmentEndsAt(
  const TriangleMesh& mesh, const CurveChains& chains, const CurveChains::Point& at);

/// The same of all points at the place of the point, which segments without length join.
std::vector<SegmentEnd> segmentEndsAround(
  const TriangleMesh& mesh, const CurveChains& chains, const CurveChains::Point& at);

/// The other vertices at the place of point i of a curve, behind faces without area. None where the
/// curve is merely cut, and for a curve that is a point.
std::vector<Id> verticesAtCornerOf(
  const TriangleMesh& mesh, const SourceCurve& curve, std::size_t i);

/// A vertex at the place of point i of a curve, whether one of the curve's points or not; NoId
/// where there is none.
Id vertexAtPlaceOf(const TriangleMesh& mesh, const SourceCurve& curve, std::size_t i);

/// Whether a segment without length leads from point i of a curve to a vertex. The segments on both
/// sides bound the vertex's wedge, not the point's.
bool isAtVertexBeside(const TriangleMesh& mesh, const SourceCurve& curve, std::size_t i);

}

#endif
