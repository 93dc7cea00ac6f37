// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/PointMerger.h"

#include <cstring>
#include <utility>

namespace geodesic
{

namespace
{

std::uint64_t hashOf(const Vec3& p)
{
  std::uint64_t hash = 0;
  for (const double x : p)
  {
    const double normalized = x + 0.0; // -0 and 0 are one place
    std::uint64_t bits;
    std::memcpy(&bits, &normalized, sizeof(bits));
    hash = (hash ^ bits) * 0x9e3779b97f4a7c15ULL;
    hash ^= hash >> 32;
  }
  return hash;
}

}

// A hash table rather than a point locator, whose buckets degenerate where most points crowd in a
// corner of the bounding box.
void mergeCoincidentPoints(
  std::vector<Vec3>& points, std::vector<Id>& vertexOfPoint, const LoopProgress& progress)
{
  std::size_t capacity = 16;
  while (capacity < 2 * points.size())
  {
    capacity *= 2;
  }
  std::vector<Id> table(capacity, NoId);
  std::vector<Id> vertex(points.size());
  Id numberOfVertices = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    progress.at(i, points.size());
    std::size_t slot = hashOf(points[i]) & (capacity - 1);
    while (table[slot] != NoId && points[table[slot]] != points[i])
    {
      slot = (slot + 1) & (capacity - 1);
    }
    if (table[slot] == NoId)
    {
      table[slot] = numberOfVertices;
      points[numberOfVertices++] = points[i];
    }
    vertex[i] = table[slot];
  }
  if (numberOfVertices < points.size())
  {
    points.resize(numberOfVertices);
    vertexOfPoint = std::move(vertex);
  }
}

}
