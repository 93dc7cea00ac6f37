// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SurfaceLocatorOnRanks_h
#define geodesic_SurfaceLocatorOnRanks_h

#include "Tolerance.h"
#include "mesh/Box.h"
#include "mesh/MeshPartition.h"

#include <algorithm>
#include <array>
#include <functional>
#include <vector>

namespace geodesic
{

/// A face that may be among the closest to a point.
struct FaceCandidate
{
  /// Its number on the rank that found it; once sent, its address on the whole surface.
  RankAddress face;
  double distance = 0.0;
  /// How much farther than the closest face it may be: by the coordinates' precision, and by
  /// rounding alone.
  double precision = 0.0;
  double rounding = 0.0;
  /// The rounding of measuring, which does not depend on the position of the origin.
  double measuring = 0.0;
  /// From the point to the face's closest point, and to where snapToFace puts it.
  Vec3 toClosest{};
  Vec3 toPlace{};
  /// The face's unit normal; zero if it has none.
  Vec3 normal{};
  GlobalTriangle corners{};
  /// Which corners its smallest part (vertex, edge or the face) has that contains the closest
  /// point.
  std::array<bool, 3> isPart{};

  bool isClosest(double least) const { return this->distance <= least + this->precision; }
};

/// For each of some points the faces of all ranks that may be among the closest, unordered, and
/// their least distance.
struct FoundOnRanks
{
  std::vector<std::vector<FaceCandidate>> candidates;
  std::vector<double> least;
};

/// The precision of a point and of the corners of a box.
inline double precisionFor(const Box& box, const Vec3& point, double coordinatePrecision)
{
  return tolerance::SnapRoundings * coordinatePrecision *
    std::max(box.largestCoordinate(), largestCoordinate(point));
}

/// Searches for some points on all ranks. First each rank searches for the points in the box of its
/// faces, then for the others, unless another rank has found a face closer than the box. All ranks
/// call this together. In one process it searches for each point.
///
/// \param box around the faces that this rank owns.
/// \param points the same on all ranks.
/// \param limits for each point the distance beyond which no face is wanted.
/// \param search (point) -> candidates of this rank.
FoundOnRanks searchOnRanks(const MeshPartition& surface, const Box& box, ArrayRange<Vec3> points,
  std::vector<double> limits, double coordinatePrecision,
  const std::function<std::vector<FaceCandidate>(std::size_t)>& search);

}

#endif
