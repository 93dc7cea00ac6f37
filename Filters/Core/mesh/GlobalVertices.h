// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_GlobalVertices_h
#define geodesic_GlobalVertices_h

#include "mesh/MeshPartition.h"

#include <vector>

namespace geodesic
{

/// Finds vertices of a surface that ranks have together by their numbers in the whole: the rank
/// that counts a vertex, and on that rank the vertex.
class GlobalVertices
{
public:
  /// All ranks together make it.
  ///
  /// \param part of this rank; must outlive this.
  explicit GlobalVertices(const MeshPartition& part);

  /// The rank that counts a vertex.
  int rankOf(Id globalId) const;
  bool isHere(Id globalId) const { return globalId - this->first_ < this->count_; }
  /// One that is counted here.
  Id vertexAt(Id globalId) const { return this->here(globalId - this->first_); }
  /// How many are counted here, and these, ascending, which is in the order of their numbers.
  Id count() const { return this->count_; }
  Id here(Id i) const { return this->here_.empty() ? i : this->here_[i]; }

private:
  /// Empty in one process, where all are.
  std::vector<Id> here_;
  Id count_ = 0;
  /// The number of the first vertex that each rank counts, and this rank's.
  std::vector<Id> firstOfRank_;
  Id first_ = 0;
};

}

#endif
