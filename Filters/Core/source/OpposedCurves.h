// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_OpposedCurves_h
#define geodesic_OpposedCurves_h

#include "source/SourceCurve.h"

#include <vector>

namespace geodesic
{

/// A segment of one of some curves.
struct SegmentOfCurve
{
  std::size_t curve = 0;
  std::size_t segment = 0;

  bool operator<(const SegmentOfCurve& other) const
  {
    return this->curve != other.curve ? this->curve < other.curve : this->segment < other.segment;
  }
};

/// The segments of curves that lie on an earlier one, or on a part of it, in the opposite
/// direction, in order: each point there has the left side of one at the right side of the other.
/// Segments lie on each other in one face or along one edge, within tolerance::OnEachOther.
std::vector<SegmentOfCurve> opposedSegments(
  const TriangleMesh& mesh, const std::vector<SourceCurve>& curves);

}

#endif
