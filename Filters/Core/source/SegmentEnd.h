// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SegmentEnd_h
#define geodesic_SegmentEnd_h

#include "mesh/TriangleMesh.h"
#include "source/SourceCurve.h"

#include <vector>

namespace geodesic
{

/// An end of a curve's segment: the segment runs from it to another point of the same face.
struct SegmentEnd
{
  SurfacePoint from;
  SurfacePoint to;
  Id face = NoId;
  /// The curve's number, where along it the end is, and whether the curve runs away from the end.
  Id curve = 0;
  double place = 0.0;
  bool isBeginning = true;
};

/// The ends of the segments of a curve that meet in its point i: two inside the curve, one at an
/// end, none in a curve that is a point. Segments without length have none.
///
/// \param curve with normalized points.
/// \param number of the curve.
/// \param places where its points are along it: placesAlong().
std::vector<SegmentEnd> segmentEndsAt(const TriangleMesh& mesh, const SourceCurve& curve, Id number,
  const std::vector<double>& places, std::size_t i);

}

#endif
