// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_BarriersOnRanks_h
#define geodesic_BarriersOnRanks_h

#include "PolyData/ranks/RankSeams.h"
#include "PolyData/ranks/RemoteVertices.h"
#include "PolyData/ranks/SourceOnRanks.h"
#include "mesh/MeshPartition.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace geodesic
{

/// A rank's triangles that are barriers, with points of their own.
struct BarrierTriangles
{
  /// \param onVertices the triangles, on vertices of the rank's piece.
  /// \param labels of these vertices.
  BarrierTriangles(
    std::vector<Triangle> onVertices, const std::vector<Vec3>& positions, const RankLabels& labels);

  std::vector<Triangle> triangles;
  /// Those that the triangles use, and the vertices that they are.
  std::vector<Vec3> points;
  std::vector<Id> vertices;
  std::vector<std::uint64_t> keys;
};

/// The barriers of a surface that ranks have in pieces: the faces that no path may enter, as
/// BarrierFaces has them where the surface is whole. All ranks call its functions together, but for
/// those that only look something up.
class BarriersOnRanks
{
public:
  /// \param barriers those of this rank.
  /// \param vertices for each vertex of its piece, the one of PolyDataSurface::vertexOf().
  /// \param open what this rank has of the other faces; must outlive the result.
  /// \param borrowed those of the piece.
  /// \returns null where no rank has barriers.
  static std::unique_ptr<BarriersOnRanks> make(BarrierTriangles barriers,
    const std::vector<Id>& vertices, const MeshPartition& open, const RemoteVertices& borrowed);

  /// What this rank has of the barriers, as a surface of their own.
  const MeshPartition& part() const { return *this->part_; }
  /// For each vertex of the part's own, the one of PolyDataSurface::vertexOf().
  const std::vector<Id>& vertices() const { return this->vertices_; }
  /// Which of this rank's triangles has become a face that the part owns.
  Id triangleOf(Id face) const;
  /// How many vertices that only barriers have are counted here.
  Id countInnerVertices() const;

  /// For each point in space the barrier that it lies in, as BarrierFaces::barrierAt() would find
  /// it on the whole surface; the face's number is NoId where it lies in none.
  ///
  /// \param points the same on all ranks.
  /// \param closest the faces that are no barriers and are closest to each.
  /// \param coordinatePrecision relative precision of the points' coordinates.
  std::vector<RankAddress> barriersAt(const std::vector<Vec3>& points,
    const std::vector<std::vector<LocatorOnRanks::Found>>& closest, double coordinatePrecision);

private:
  BarriersOnRanks(const MeshPartition& open, std::unique_ptr<MeshPartition> part,
    std::vector<Id> vertices, const RemoteVertices& borrowed);

  const MeshPartition& open_;
  std::unique_ptr<MeshPartition> part_;
  std::vector<Id> vertices_;
  /// Whether only barriers have each of them.
  std::vector<std::uint8_t> isInner_;
  /// Made where it is needed first.
  std::optional<LocatorOnRanks> locator_;
};

}

#endif
