// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_VertexOfPoint_h
#define geodesic_VertexOfPoint_h

#include "Progress.h"
#include "Tasks.h"
#include "Types.h"

#include <utility>
#include <vector>

namespace geodesic
{

/// Says which vertex each point of all blocks is. If each point is a vertex of its own with the
/// same number, there is no table.
class VertexOfPoint
{
public:
  VertexOfPoint() = default;
  explicit VertexOfPoint(std::vector<Id> table)
    : table_(std::move(table))
  {
  }

  Id operator()(Id point) const { return this->table_.empty() ? point : this->table_[point]; }
  Triangle operator()(const Triangle& points) const
  {
    return { (*this)(points[0]), (*this)(points[1]), (*this)(points[2]) };
  }
  bool isIdentity() const { return this->table_.empty(); }

  /// \param numbers the new number of each vertex; empty if none changes.
  void renumber(std::vector<Id> numbers)
  {
    if (numbers.empty())
    {
      return;
    }
    if (this->table_.empty())
    {
      this->table_ = std::move(numbers);
      return;
    }
    for (Id& vertex : this->table_)
    {
      vertex = numbers[vertex];
    }
  }

private:
  std::vector<Id> table_;
};

/// For each point the first one at exactly its place.
///
/// \param progress its current stretch.
/// \param parallelFor absent: one thread.
std::vector<Id> firstAtPlaces(
  const std::vector<Vec3>& points, const LoopProgress& progress, const ParallelFor& parallelFor);

}

#endif
