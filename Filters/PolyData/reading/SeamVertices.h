// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SeamVertices_h
#define geodesic_SeamVertices_h

#include "Exchange.h"
#include "PolyData/reading/PieceVertices.h"
#include "PolyData/reading/TriangleReader.h"
#include "Types.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <tuple>
#include <vector>

namespace geodesic
{

/// What a rank has of a surface, for mergeSeams(). Points at exactly one place, and those that
/// ranks share, are one vertex already.
struct SeamSurface
{
  PieceVertices& vertices;
  const TriangleList& triangles;
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
    const bool isPlain = this->vertices.of.isIdentity() && !this->hasGhosts();
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
        visit(this->vertices.of(this->triangles.corners[i]), block, this->triangles.isDuplicate[i]);
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
  /// Whether it may be near a vertex that only ghosts have.
  bool isNearGhost = false;
  /// The rounding of coordinates around.
  double rounding = 0.0;
  double shortestEdge = Infinity;

  /// How far from each other points may be stored that are one place.
  double tolerance() const;
};

/// An edge of a face, and the face's third vertex.
struct SeamEdge
{
  RankLabels::Label low;
  RankLabels::Label high;
  RankLabels::Label apex;

  bool isOn(const SeamEdge& edge) const { return this->low == edge.low && this->high == edge.high; }
  bool operator<(const SeamEdge& other) const
  {
    return std::tie(this->low, this->high, this->apex) <
      std::tie(other.low, other.high, other.apex);
  }
};

/// What a rank knows of the vertices that may be one with others of any rank: those that can be on
/// the boundary of the surface, those that only ghosts have, and those near such a ghost's corner.
struct SeamCandidates
{
  /// Ascending. Several ranks may have one of them, each with what that rank knows of it.
  std::vector<SeamVertex> vertices;
  /// The edges of faces between candidates, in no order.
  std::vector<SeamEdge> edges;
};

/// All ranks call this together.
SeamCandidates findCandidates(const SeamSurface& surface, Exchange& exchange);

}

#endif
