// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/GlobalVertices.h"

#include <algorithm>

namespace geodesic
{

GlobalVertices::GlobalVertices(const MeshPartition& part)
  : count_(part.numberOfOwnVertices())
{
  if (part.isDistributed())
  {
    for (Id vertex = 0; vertex < part.numberOfOwnVertices(); ++vertex)
    {
      if (part.isCountedHere(vertex))
      {
        this->here_.push_back(vertex);
      }
    }
    this->count_ = static_cast<Id>(this->here_.size());
  }
  Id first = 0;
  for (const Id count : valuesOfRanks(part.exchange(), this->count_))
  {
    this->firstOfRank_.push_back(first);
    first += count;
  }
  this->first_ = this->firstOfRank_[rankIndex(part.exchange().rank())];
}

// A rank that counts no vertex begins at the same id as the next rank.
int GlobalVertices::rankOf(Id globalId) const
{
  const auto behind =
    std::upper_bound(this->firstOfRank_.begin(), this->firstOfRank_.end(), globalId);
  return static_cast<int>(behind - this->firstOfRank_.begin()) - 1;
}

}
