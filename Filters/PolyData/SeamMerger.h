// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SeamMerger_h
#define geodesic_SeamMerger_h

#include "Types.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace geodesic
{

/// The part of a surface that one block is, for mergeSeams().
struct SeamBlock
{
  /// Its triangles, as vertices.
  std::vector<Triangle> triangles;
  /// The relative precision of its coordinates.
  double precision = 0.0;
};

/// A vertex on the boundary of one block or of several.
struct SeamVertex
{
  /// Its number.
  std::uint64_t vertex = 0;
  Vec3 position{};
  /// The blocks on whose boundary it is, ascending.
  std::vector<std::size_t> blocks;
  /// The rounding of coordinates around.
  double rounding = 0.0;
  double shortestEdge = Infinity;

  /// How far it may be from another to be one with it.
  double tolerance() const;
};

/// The vertices on the boundaries of blocks.
std::vector<SeamVertex> findSeamVertices(
  const std::vector<Vec3>& vertices, const std::vector<SeamBlock>& blocks);

/// Finds those of different blocks that are one within the precision of the coordinates
/// (tolerance::SeamRoundings, SeamFraction), the nearest first. Two of one block are never made
/// one.
///
/// \returns for each the one with the lowest number that it is one with; empty where there are
/// none.
std::vector<std::size_t> joinSeamVertices(std::vector<SeamVertex> vertices);

/// Where blocks of one surface meet, their points may differ by roundings: each block may have
/// computed or stored them on its own. Finds the vertices that are one all the same
/// (joinSeamVertices()).
///
/// \param vertices points at exactly one place are one vertex already.
/// \returns for each vertex the lowest one that it is one with; empty where there are no such.
std::vector<Id> mergeSeams(const std::vector<Vec3>& vertices, const std::vector<SeamBlock>& blocks);

}

#endif
