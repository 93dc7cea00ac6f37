// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_DistanceRange_h
#define geodesic_DistanceRange_h

#include "mesh/TriangleMesh.h"

#include <array>
#include <vector>

namespace geodesic
{

/// Bounds of the distance in a face or on an edge, from the distances at its corners and the
/// triangle inequality.
struct DistanceRange
{
  double least;
  double most;

  /// The index of the first of some ascending values that may lie in the range, and the index
  /// behind the last one.
  std::array<std::size_t, 2> indicesIn(const std::vector<double>& values) const;
  bool holdsOneOf(const std::vector<double>& values) const;
};

/// \param atCorners the distances found so far, exact if they are below `certain`.
/// \param certain a lower bound of the length of any path that is still to be found.
/// \param hasSource whether a source lies in the face.
DistanceRange rangeInFace(
  const FaceShape& shape, const std::array<double, 3>& atCorners, double certain, bool hasSource);

/// The same on an edge of a face without a source in it.
DistanceRange rangeOnEdge(double length, double atBegin, double atEnd, double certain);

}

#endif
