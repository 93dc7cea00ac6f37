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
  /// The face that contains points i and i + 1; one fewer than points.
  std::vector<Id> faces;
  /// Whether point i only cuts a straight segment at a mesh edge, so that it has no wedge and no
  /// circular windows. One for each point.
  std::vector<std::uint8_t> isCut;
  /// The part of the source to which it belongs, such as a cell's number.
  Id source = 0;

  bool isClosed() const
  {
    if (this->points.size() < 2)
    {
      return false;
    }
    const SurfacePoint& first = this->points.front();
    const SurfacePoint& last = this->points.back();
    return first.kind == last.kind && first.id == last.id && first.u == last.u && first.v == last.v;
  }
};

/// A source that is a single point.
inline SourceCurve pointCurve(const SurfacePoint& point)
{
  return { { point }, {}, { 0 } };
}

}

#endif
