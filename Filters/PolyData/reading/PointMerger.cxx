// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/PointMerger.h"

#include "PolyData/Hash.h"
#include "mesh/GroupedItems.h"

#include <algorithm>
#include <utility>

namespace geodesic
{

namespace
{

/// For each point the first one at its place.
UninitializedVector<Id> findFirstAtPlaces(
  const std::vector<Vec3>& points, const LoopProgress& progress, const ParallelFor& parallelFor)
{
  const auto count = static_cast<Id>(points.size());
  Id keys = 1;
  while (keys < count && keys < (NoId >> 1))
  {
    keys *= 2;
  }
  UninitializedVector<Id> hashes(count);
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
  UninitializedVector<Id>& first = hashes; // no longer needed
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

// By hashes rather than a point locator, whose buckets degenerate where most points crowd in a
// corner of the bounding box.
VertexOfPoint mergeCoincidentPoints(
  std::vector<Vec3>& points, const LoopProgress& progress, const ParallelFor& parallelFor)
{
  const UninitializedVector<Id> first = findFirstAtPlaces(points, progress, parallelFor);
  const std::vector<Id> merged = resultsOfRanges(parallelFor, points.size(),
    [&first](std::size_t begin, std::size_t end)
    {
      Id count = 0;
      for (std::size_t i = begin; i < end; ++i)
      {
        count += first[i] != i ? 1 : 0;
      }
      return count;
    });
  if (std::all_of(merged.begin(), merged.end(), [](Id count) { return count == 0; }))
  {
    return {};
  }
  std::vector<Id> vertexOfPoint(points.size());
  Id numberOfVertices = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (first[i] == i)
    {
      points[numberOfVertices] = points[i];
      vertexOfPoint[i] = numberOfVertices++;
    }
    else
    {
      vertexOfPoint[i] = vertexOfPoint[first[i]];
    }
  }
  points.resize(numberOfVertices);
  return VertexOfPoint(std::move(vertexOfPoint));
}

}
