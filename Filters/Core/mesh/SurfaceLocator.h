// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SurfaceLocator_h
#define geodesic_SurfaceLocator_h

#include "Job.h"
#include "mesh/Box.h"
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
  /// Whether the point is beside the face by more than the precision of coordinates.
  bool isBeside = false;
  /// From the point to its place on the face, and the face's unit normal; zero where a point was
  /// not searched.
  Vec3 toPlace{};
  Vec3 normal{};

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
  explicit SurfaceLocator(const MeshPartition& surface);
  ~SurfaceLocator();

  const MeshPartition& surface() const { return this->surface_; }

  /// For each point all faces that put it onto its closest place, in the order of ClosestFace.
  /// There are several where the surface touches or overlaps itself, and the locator cannot know
  /// which one is meant. Faces without area count only where there are no others. All ranks call
  /// this together and get the same. Not thread-safe.
  ///
  /// \param points the same on all ranks.
  /// \param isWanted for each point whether it is searched: the others get no faces.
  /// \param coordinatePrecision relative precision of the points' coordinates.
  ClosestFaces closest(const std::vector<Vec3>& points, const std::vector<std::uint8_t>& isWanted,
    double coordinatePrecision, const Job& job = {});

  /// For each point between two walls, the faces closest to the point on the farther wall: faces
  /// that look the other way than the point's closest faces, lie in the other direction, and are
  /// about as near (tolerance::AboutAsNear). Points without such a wall have no faces. As closest()
  /// otherwise.
  ///
  /// \param closest the points' closest faces.
  ClosestFaces opposite(const std::vector<Vec3>& points, const std::vector<std::uint8_t>& isWanted,
    const ClosestFaces& closest, double coordinatePrecision, const Job& job = {});

private:
  class FaceTree;

  ClosestFaces find(const std::vector<Vec3>& points, const std::vector<std::uint8_t>& isWanted,
    const ClosestFaces* oppositeTo, double coordinatePrecision, const Job& job);

  void plantTree();

  MeshPartition surface_;
  /// Made with the first points.
  std::unique_ptr<FaceTree> tree_;
  /// Around the faces that this rank owns.
  Box box_;
};

}

#endif
