// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SurfaceLocator_h
#define geodesic_SurfaceLocator_h

#include "Progress.h"
#include "mesh/Box.h"
#include "mesh/FaceLocator.h"
#include "mesh/MeshPartition.h"

#include <memory>
#include <vector>

namespace geodesic
{

/// A face that is closest to a point in space.
struct ClosestFace
{
  RankAddress face;
  /// Whether it is as close as the closest one up to rounding. These come first.
  bool isUpToRounding = true;

  bool operator<(const ClosestFace& other) const
  {
    return this->isUpToRounding != other.isUpToRounding ? this->isUpToRounding
                                                        : this->face < other.face;
  }
};

/// For each of some points its closest faces.
using ClosestFaces = std::vector<std::vector<ClosestFace>>;

/// Finds the faces that points are closest to, among the faces of all ranks.
class SurfaceLocator
{
public:
  explicit SurfaceLocator(const MeshPartition& surface)
    : surface_(surface)
  {
  }

  /// For each point the faces that FaceLocator::chosen() takes on the whole surface, in the order
  /// of ClosestFace. All ranks call this together and get the same. Not thread-safe.
  ///
  /// \param points the same on all ranks.
  /// \param coordinatePrecision relative precision of the points' coordinates.
  /// \param progress called now and then with a fraction done; returning false throws Aborted.
  ClosestFaces closest(const std::vector<Vec3>& points, double coordinatePrecision,
    const ProgressCallback& progress = {});

private:
  using Candidates = std::vector<FaceLocator::Candidate>;

  bool isSearched(const Vec3& point, bool isInBox, double least, double coordinatePrecision) const;
  Message messageOf(
    const std::vector<Candidates>& candidates, const std::vector<double>& least) const;

  MeshPartition surface_;
  /// Made with the first points.
  std::unique_ptr<FaceLocator> locator_;
  /// Of the faces that this rank owns.
  Box box_;
};

}

#endif
