// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PieceVertices_h
#define geodesic_PieceVertices_h

#include "PolyData/reading/PolyDataSurface.h"

#include <cstdint>
#include <vector>

namespace geodesic
{

/// The vertices of this rank's blocks, and which of them other ranks may have, too. All ranks call
/// functions with an exchange together.
struct PieceVertices
{
  /// The rank and the number of a vertex.
  using Label = std::uint64_t;
  static constexpr Label Shared = Label(1) << 63;

  std::vector<Vec3> positions;
  VertexOfPoint of;
  /// One a vertex. Vertices of all ranks that are one have the same label, and no others. The bit
  /// Shared is set where another rank has the vertex, too. Empty in one process, where a vertex's
  /// label is its number.
  std::vector<Label> labels;

  Label labelOf(Id vertex) const
  {
    return this->labels.empty() ? vertex : this->labels[vertex] & ~Shared;
  }
  bool isSharedAt(Id vertex) const
  {
    return !this->labels.empty() && (this->labels[vertex] & Shared) != 0;
  }

  /// Appends the places and the labels of some vertices.
  void copy(const std::vector<Id>& some, std::vector<Vec3>& points, std::vector<Label>& keys) const;
  /// Makes one vertex of those that are the same.
  ///
  /// \param same for each vertex the one of the same that stays.
  void join(const std::vector<Id>& same);
  /// Makes one vertex of those with the same label, if ranks share any.
  void joinSameLabels();
  /// Labels the vertices, if there are several ranks, and makes one vertex of those that are one:
  /// those with the same global id.
  ///
  /// \param byPlace whether those at exactly one place are one, too; the same on all ranks.
  void joinRanks(const std::vector<PolyDataBlock>& inputs, const std::vector<SurfaceBlock>& blocks,
    bool byPlace, Exchange& exchange);
  /// If ranks share the surface, leaves only the vertices that faces use, in the order of use. One
  /// process keeps the others, too: points need no table then.
  ///
  /// \param faces on all vertices; then on those that are left.
  /// \param keys gets the labels of the vertices left; none in one process.
  /// \returns for each vertex its new number, NoId if it is not left; empty in one process.
  std::vector<Id> keepUsed(
    std::vector<Triangle>& faces, const Exchange& exchange, std::vector<Label>& keys);
  /// Finds values for the vertices of a rank's points that no own face has: corners of duplicates
  /// of other ranks' faces, and points that no face uses here. The values come from the lowest rank
  /// that has a face there.
  ///
  /// \param ownNumbers what keepUsed() has returned.
  /// \returns one value for each vertex without faces, in their order.
  BorrowedValues valuesElsewhere(const std::vector<Id>& ownNumbers, Exchange& exchange) const;
};

}

#endif
