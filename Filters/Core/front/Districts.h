// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Districts_h
#define geodesic_Districts_h

#include "Tasks.h"
#include "mesh/TriangleMesh.h"

#include <cstdint>
#include <vector>

namespace geodesic
{

/// The vertices in districts: groups of nearly equal size that are contiguous in space, so that
/// most neighbours of a vertex are in its own. They depend on the mesh alone, not on threads: a
/// front that works district by district has one result, whoever works on which.
class Districts
{
public:
  /// \param parallelFor absent: one thread.
  explicit Districts(const TriangleMesh& mesh, const ParallelFor& parallelFor = {});

  Id size() const { return this->size_; }
  /// The district of a vertex.
  Id of(Id vertex) const { return this->districts_[vertex]; }

  static constexpr Id Most = 256;

private:
  Id size_;
  std::vector<std::uint8_t> districts_;
};

}

#endif
