// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SourceCurve_h
#define geodesic_SourceCurve_h

#include "mesh/SurfacePoint.h"

#include <cstdint>
#include <vector>

namespace geodesic
{

/// A polyline on the surface, cut so that each segment lies in one face (paper, section 4.2). A
/// single point is a curve without segments.
struct SourceCurve
{
  /// Consecutive points; a closed curve repeats its first point at the end.
  std::vector<SurfacePoint> points;
  /// The face that holds points i and i + 1; one fewer than points.
  std::vector<Id> faces;
  /// Whether point i only cuts a straight segment at a mesh edge: no wedge and no circular windows
  /// there. One a point.
  std::vector<std::uint8_t> isCut;
  /// The number of the part of the source that it belongs to, such as a cell's.
  Id source = 0;

  bool isClosed() const;
};

/// Where the points of a curve are along it: lengths from its beginning. Each is behind the one
/// before, also where the segment between them has no length.
std::vector<double> placesAlong(const TriangleMesh& mesh, const SourceCurve& curve);

/// A source that is one point.
SourceCurve pointCurve(const SurfacePoint& point);

}

#endif
