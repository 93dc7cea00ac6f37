// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SeamVertices_h
#define geodesic_SeamVertices_h

#include "Exchange.h"
#include "PolyData/ranks/RankSeams.h"
#include "PolyData/reading/PolyDataSurface.h"
#include "PolyData/reading/TriangleReader.h"
#include "Types.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace geodesic
{

/// What a rank has of a surface, for mergeSeams(). Points at exactly one place, and those that
/// ranks share, are one vertex already.
struct SeamSurface
{
  const std::vector<Vec3>& vertices;
  const RankLabels& labels;
  const TriangleList& triangles;
  const VertexOfPoint& vertexOf;
  /// The relative precision of the coordinates, of each block.
  std::vector<double> precisions;
  /// The largest coordinate of a vertex of any rank's triangles.
  double largest = 0.0;
  /// How far apart the user allows vertices on the boundary to be that are one.
  double mergeTolerance = 0.0;

  bool hasGhosts() const
  {
    const std::vector<bool>& ghosts = this->triangles.isDuplicate;
    return std::find(ghosts.begin(), ghosts.end(), true) != ghosts.end();
  }

  /// Calls visit(triangle of vertices, block, whether a ghost array marks it as a duplicate).
  template <typename Visit>
  void forEachTriangle(const Visit& visit) const
  {
    // Most surfaces have no table of vertices and no ghosts.
    const bool isPlain = this->vertexOf.isIdentity() && !this->hasGhosts();
    for (std::size_t block = 0; block < this->precisions.size(); ++block)
    {
      const std::size_t first = this->triangles.firstOfBlock[block];
      const std::size_t end = this->triangles.firstOfBlock[block + 1];
      for (std::size_t i = first; i < end && isPlain; ++i)
      {
        visit(this->triangles.corners[i], block, false);
      }
      for (std::size_t i = first; i < end && !isPlain; ++i)
      {
        visit(this->vertexOf(this->triangles.corners[i]), block, this->triangles.isDuplicate[i]);
      }
    }
  }
};

/// A vertex that may be one with others.
struct SeamVertex
{
  RankLabels::Label label = 0;
  Vec3 position{};
  /// The first block that has a face there; where none has, after all blocks.
  std::size_t block = std::numeric_limits<std::size_t>::max();
  /// Whether there is a triangle that is no ghost.
  bool hasFace = false;
  /// Whether it is on the boundary of the whole surface.
  bool isOnBoundary = false;
  /// Whether other ranks have it, too.
  bool isShared = false;
  /// Whether it may be near a vertex that only ghosts have.
  bool isNearGhost = false;
  /// The rounding of coordinates around.
  double rounding = 0.0;
  double shortestEdge = Infinity;

  /// How far from each other points may be stored that are one place.
  double tolerance() const;
};

/// A cube of a grid whose edges are a power of two, the last number.
using SeamCell = std::array<std::int64_t, 4>;

/// The least cubes that are twice as large as a distance, or larger.
int seamLevelFor(double distance);
/// \param shift of the point, in cubes.
SeamCell seamCellAt(const Vec3& point, int level, double shift = 0.0);
/// The cubes that have all points whose coordinates differ by at most half a cube.
std::array<SeamCell, 8> seamCellsAround(const Vec3& point, int level);

/// The vertices of this rank that may be one with others of any rank: those on the boundary of the
/// whole surface, those that only ghosts have, and those near such a ghost's corner. A vertex that
/// other ranks have, too, is there on each, with what the rank knows of it. All ranks call this
/// together.
///
/// An edge is boundary if one face has it; faces on the same three vertices count as one.
std::vector<SeamVertex> findSeamVertices(const SeamSurface& surface, Exchange& exchange);

}

#endif
