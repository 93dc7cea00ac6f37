// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_GlobalVertices_h
#define geodesic_GlobalVertices_h

#include "mesh/MeshPartition.h"

#include <vector>

namespace geodesic
{

/// Finds vertices of a distributed surface by their global ids: the rank that counts a vertex, and
/// the vertex on that rank.
class GlobalVertices
{
public:
  /// A collective call of all ranks.
  ///
  /// \param part this rank's partition; must outlive this.
  explicit GlobalVertices(const MeshPartition& part);

  /// The rank that counts a vertex.
  int rankOf(Id globalId) const;
  bool isHere(Id globalId) const { return globalId - this->first_ < this->count_; }
  /// A vertex that this rank counts.
  Id vertexAt(Id globalId) const { return this->here(globalId - this->first_); }
  /// The number of vertices that this rank counts, and these vertices in ascending order, which is
  /// also the order of their global ids.
  Id count() const { return this->count_; }
  Id here(Id i) const { return this->here_.empty() ? i : this->here_[i]; }

private:
  /// Empty in one process, which counts all vertices.
  std::vector<Id> here_;
  Id count_ = 0;
  /// The global id of the first vertex that each rank counts, and this rank's.
  std::vector<Id> firstOfRank_;
  Id first_ = 0;
};

}

#endif
