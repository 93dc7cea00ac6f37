// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_VerticesOfWhole_h
#define geodesic_VerticesOfWhole_h

#include "mesh/SurfacePart.h"

#include <vector>

namespace geodesic
{

/// Finds vertices of a surface that ranks have together by their numbers in the whole: the rank
/// that counts a vertex, and on that rank the vertex.
class VerticesOfWhole
{
public:
  /// All ranks together make it.
  ///
  /// \param part of this rank; must outlive this.
  explicit VerticesOfWhole(const SurfacePart& part);

  /// The rank that counts a vertex.
  int rankOf(Id numberInWhole) const;
  bool isHere(Id numberInWhole) const { return numberInWhole - this->first_ < this->here_.size(); }
  /// One that is counted here.
  Id vertexAt(Id numberInWhole) const { return this->here_[numberInWhole - this->first_]; }
  /// Those that are counted here, ascending, which is in the order of their numbers.
  const std::vector<Id>& here() const { return this->here_; }

private:
  std::vector<Id> here_;
  /// The number of the first vertex that each rank counts, and this rank's.
  std::vector<Id> firstOfRank_;
  Id first_ = 0;
};

}

#endif
