// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SeamMerger_h
#define geodesic_SeamMerger_h

#include "Types.h"

#include <cstddef>
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

/// Where blocks of one surface meet, their points may differ by roundings: each block may have
/// computed or stored them on its own. Finds the vertices on the boundaries of different blocks
/// that are one within the precision of the coordinates (tolerance::SeamRoundings, SeamFraction),
/// the nearest first. Vertices of one block are never made one.
///
/// \param vertices points at exactly one place are one vertex already.
/// \returns for each vertex the lowest one that it is one with; empty where there are no such.
std::vector<Id> mergeSeams(const std::vector<Vec3>& vertices, const std::vector<SeamBlock>& blocks);

}

#endif
