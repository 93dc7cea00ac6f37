// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_BarrierArrays_h
#define geodesic_BarrierArrays_h

#include "Exchange.h"
#include "PolyData/PolyDataBlocks.h"

#include "vtkType.h"

#include <string>
#include <vector>

class vtkDataArray;

namespace geodesic
{

/// The cell array of a surface that says which cells are barriers: those where it is not 0.
class BarrierArrays
{
public:
  /// No barriers.
  BarrierArrays() = default;

  /// Finds the array in each block. Blocks without it have no barriers.
  ///
  /// \param name of the array; null, empty and "None" (the first entry of ParaView's list) stand
  ///        for no barriers.
  /// \param exchange with other ranks, all of which read the arrays of their blocks now.
  /// \throws InputError where no block with cells, of any rank, has the array, or where it is not
  ///         numeric, has several components, no value for some cell, or NaN.
  BarrierArrays(const std::vector<PolyDataBlock>& blocks, const char* name, Exchange& exchange);

  /// Whether there may be barriers, here or on other ranks.
  bool isGiven() const { return !this->name_.empty(); }
  /// Of a block; null where it has none.
  vtkDataArray* of(std::size_t block) const
  {
    return this->isGiven() ? this->arrays_[block] : nullptr;
  }
  bool isBarrier(std::size_t block, vtkIdType cell) const;
  const std::string& name() const { return this->name_; }

private:
  std::string name_;
  /// One a block where barriers were asked for.
  std::vector<vtkDataArray*> arrays_;
};

}

#endif
