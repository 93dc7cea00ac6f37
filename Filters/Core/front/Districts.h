// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Districts_h
#define geodesic_Districts_h

#include "Job.h"
#include "mesh/TriangleMesh.h"

#include <cstdint>
#include <vector>

namespace geodesic
{

/// Which thread works on which vertices. Blocks of vertices are contiguous in space and of nearly
/// equal size, so that most neighbours of a vertex are in its own block. For several threads each
/// block is a district. One thread has a single district, which needs less memory and no mail
/// between districts; so have several threads while they do not pay (ThreadTrial).
///
/// Blocks depend on the mesh alone. A front that processes the vertices of a batch block by block
/// has the same result for any number of districts.
class Districts
{
public:
  explicit Districts(const TriangleMesh& mesh, const Job& job = {});

  /// The number of districts, and the largest that there may be.
  Id size() const { return this->areJoined_ ? 1 : this->most_; }
  Id most() const { return this->most_; }
  /// Whether all blocks are one district.
  bool areJoined() const { return this->areJoined_; }
  /// With several threads, makes one district of all blocks, or one of each.
  void join(bool areJoined) { this->areJoined_ = areJoined || this->most_ == 1; }
  /// The district of a vertex.
  Id of(Id vertex) const { return this->areJoined_ ? 0 : this->blockOf(vertex); }
  /// The block of a vertex.
  Id blockOf(Id vertex) const { return this->blocks_.empty() ? 0 : this->blocks_[vertex]; }
  /// Sorts vertices by block, those of one block by number.
  void sort(std::vector<Id>& vertices) const;

  static constexpr Id Most = 256;

private:
  Id most_ = 1;
  bool areJoined_ = true;
  /// Empty where there is a single block.
  std::vector<std::uint8_t> blocks_;
};

}

#endif
