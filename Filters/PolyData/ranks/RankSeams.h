// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RankSeams_h
#define geodesic_RankSeams_h

#include "Exchange.h"
#include "PolyData/ranks/BorrowedValues.h"
#include "Types.h"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace geodesic
{

/// What one rank knows of the vertices of its piece that other ranks may have, too.
struct RankLabels
{
  /// The rank and the number of a vertex.
  using Label = std::uint64_t;
  static constexpr Label Shared = Label(1) << 63;

  /// One a vertex. Vertices of all ranks that are one have the same label, and no others. The bit
  /// Shared is set where another rank has the vertex, too. Empty in one process, where a vertex's
  /// label is its number.
  std::vector<Label> labels;

  Label of(Id vertex) const
  {
    return this->labels.empty() ? vertex : this->labels[vertex] & ~Shared;
  }
  bool isSharedAt(Id vertex) const
  {
    return !this->labels.empty() && (this->labels[vertex] & Shared) != 0;
  }
};

/// What vertices have in common that are one: x, y, z, 0 of a place, or a global id, 0, 0, 1.
using VertexKey = std::array<double, 4>;
/// A key and a vertex that has it.
using KeyedVertex = std::pair<VertexKey, Id>;

/// Finds the vertices of several ranks' pieces of a surface that are one: those at exactly one
/// place, and those with the same global id. All ranks call this together.
///
/// \param vertices of this rank's piece.
/// \param byPlace whether places count; the same on all ranks.
/// \param globalIds empty where there are none.
RankLabels joinSameVertices(const std::vector<Vec3>& vertices, bool byPlace,
  std::vector<KeyedVertex> globalIds, Exchange& exchange);

/// Finds values for the vertices of a rank's points that no own face has: corners of duplicates of
/// other ranks' faces, and points that no face uses here. The values come from the lowest rank that
/// has a face there. All ranks call this together.
///
/// \param labels of all vertices of this rank.
/// \param ownNumbers of each vertex its number among those with faces; NoId without faces. Empty in
///        one process.
/// \returns one value for each vertex without faces, in their order.
BorrowedValues findValuesElsewhere(
  const RankLabels& labels, const std::vector<Id>& ownNumbers, Exchange& exchange);

}

#endif
