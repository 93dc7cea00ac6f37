// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/VerticesOfWhole.h"

#include <algorithm>

namespace geodesic
{

VerticesOfWhole::VerticesOfWhole(const SurfacePart& part)
{
  for (Id vertex = 0; vertex < part.numberOfOwnVertices(); ++vertex)
  {
    if (part.isCountedHere(vertex))
    {
      this->here_.push_back(vertex);
    }
  }
  Message message;
  put(message, static_cast<Id>(this->here_.size()));
  Id first = 0;
  readEach(part.exchange().tellAll(message),
    [&](int, MessageReader& reader)
    {
      this->firstOfRank_.push_back(first);
      first += reader.get<Id>();
    });
  this->first_ = this->firstOfRank_[static_cast<std::size_t>(part.exchange().rank())];
}

// Ranks that count none begin where the next one does.
int VerticesOfWhole::rankOf(Id numberInWhole) const
{
  const auto behind =
    std::upper_bound(this->firstOfRank_.begin(), this->firstOfRank_.end(), numberInWhole);
  return static_cast<int>(behind - this->firstOfRank_.begin()) - 1;
}

}
