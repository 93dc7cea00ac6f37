// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/VertexOfPoint.h"

#include "PolyData/Hash.h"
#include "mesh/GroupedItems.h"

#include <algorithm>

namespace geodesic
{

// By hashes rather than a point locator, whose buckets degenerate where most points crowd in a
// corner of the bounding box.
std::vector<Id> firstAtPlaces(
  const std::vector<Vec3>& points, const LoopProgress& progress, const ParallelFor& parallelFor)
{
  const auto count = static_cast<Id>(points.size());
  Id keys = 1;
  while (keys < count && keys < (NoId >> 1))
  {
    keys *= 2;
  }
  std::vector<Id> hashes(count);
  forRanges(parallelFor, count, progress.between(0.0, 0.3),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        hashes[i] = static_cast<Id>(hashOf(points[i]) & (keys - 1));
      }
    });
  const GroupedItems byHash = groupItems(count, keys, parallelFor, progress.between(0.3, 0.5),
    [&hashes](Id point) { return hashes[point]; });
  std::vector<Id>& first = hashes; // no longer needed
  forRanges(parallelFor, keys, progress.between(0.5, 1.0),
    [&](std::size_t begin, std::size_t end)
    {
      for (Id key = static_cast<Id>(begin); key < end; ++key)
      {
        for (const Id point : byHash.at(key))
        {
          const auto isThere = [&](Id other)
          { return other == point || (first[other] == other && points[other] == points[point]); };
          const IdRange candidates = byHash.at(key);
          first[point] = *std::find_if(candidates.begin(), candidates.end(), isThere);
        }
      }
    });
  return hashes;
}

}
