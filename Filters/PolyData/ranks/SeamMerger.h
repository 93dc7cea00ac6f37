// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SeamMerger_h
#define geodesic_SeamMerger_h

#include "PolyData/Hash.h"
#include "Types.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_set>
#include <vector>

namespace geodesic
{

/// One block of a surface, for mergeSeams().
struct SeamBlock
{
  /// Its triangles, as vertices.
  std::vector<Triangle> triangles;
  /// Those that a ghost array marks as duplicates.
  std::vector<Triangle> ghosts;
  /// The relative precision of its coordinates.
  double precision = 0.0;
};

/// A vertex on the boundary of one block or of several, or at a ghost.
struct SeamVertex
{
  /// Its number.
  std::uint64_t vertex = 0;
  Vec3 position{};
  /// The blocks on whose boundary it is; near ghosts all blocks that have a triangle there;
  /// ascending. None if it is a corner of ghosts only.
  std::vector<std::size_t> blocks;
  bool isOnBoundary = false;
  /// Whether it is a corner of a ghost.
  bool isAtGhost = false;
  /// The rounding of coordinates around.
  double rounding = 0.0;
  double shortestEdge = Infinity;

  /// How far it may be from another to be one with it.
  double tolerance() const;
};

/// A cube of a grid whose edges are a power of two, the last number.
using SeamCell = std::array<std::int64_t, 4>;
struct SeamCellHash
{
  std::size_t operator()(const SeamCell& cell) const
  {
    return static_cast<std::size_t>(hashOf(cell.data(), cell.size()));
  }
};
SeamCell cellAt(const Vec3& point, int level);

/// The places of ghosts' corners.
class GhostPlaces
{
public:
  /// \param margin the largest tolerance of all vertices.
  explicit GhostPlaces(double margin);

  void add(const Vec3& corner);
  /// Whether a point may be within the margin of a corner. Never false if it is.
  bool isNear(const Vec3& point) const
  {
    return !this->cells_.empty() && this->cells_.count(cellAt(point, this->level_)) > 0;
  }

private:
  int level_;
  std::unordered_set<SeamCell, SeamCellHash> cells_;
};

/// The largest tolerance that a vertex of the blocks can have.
double largestTolerance(const std::vector<Vec3>& vertices, const std::vector<SeamBlock>& blocks);

/// The corners of a block's ghosts, each once.
std::vector<Id> ghostVertices(const SeamBlock& block);

/// The vertices that may have to be joined: on the boundaries of blocks, at ghosts, and near these.
std::vector<SeamVertex> findSeamVertices(const std::vector<Vec3>& vertices,
  const std::vector<SeamBlock>& blocks, const GhostPlaces& ghosts);

/// Finds those that are one within the precision of the coordinates (tolerance::SeamRoundings,
/// SeamFraction), the nearest first: two on boundaries, or one at a ghost and any other. Two with
/// triangles of one block are never made one.
///
/// \returns for each the one that stands for all that it is one with: the one with the lowest
/// number of those that are no corners of ghosts only, if there are any.
std::vector<std::size_t> joinSeamVertices(std::vector<SeamVertex> vertices);

/// Vertices that are one.
struct JoinedVertices
{
  /// For each vertex the one that stands for it (joinSeamVertices()); empty if each stands for
  /// itself.
  std::vector<Id> same;
  /// How many were joined with others, not counting those that only ghosts have.
  Id count = 0;
};

/// Where blocks of one surface meet, their points may differ by roundings, and ghosts may differ
/// from what they duplicate: each block may have computed or stored them on its own. Finds the
/// vertices that are one nevertheless (joinSeamVertices()).
///
/// \param vertices points at exactly one place are one vertex already.
JoinedVertices mergeSeams(const std::vector<Vec3>& vertices, const std::vector<SeamBlock>& blocks);

}

#endif
