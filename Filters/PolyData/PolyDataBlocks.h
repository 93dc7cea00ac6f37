// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PolyDataBlocks_h
#define geodesic_PolyDataBlocks_h

#include "Errors.h"

#include <string>
#include <vector>

class vtkDataObject;
class vtkPolyData;

namespace geodesic
{

/// An input is of a kind that cannot be used.
class InputError : public Error
{
public:
  using Error::Error;
};

/// One vtkPolyData of an input.
struct PolyDataBlock
{
  vtkPolyData* data = nullptr;
  /// As messages call it: "the surface (input port 0)", or
  /// "block 3 (wing) of the surface (input port 0)".
  std::string name;
};

/// The vtkPolyData that an input is, or the leaves of a composite one in their flattened order.
/// Blocks that are null are left out.
///
/// \param name as messages call the input.
/// \throws InputError where the input or a block is something else; it says which and what to do.
std::vector<PolyDataBlock> polyDataBlocks(vtkDataObject* input, const std::string& name);

/// A block's name at the beginning of a sentence.
std::string capitalized(std::string name);

/// Gives an output the structure of an input that polyDataBlocks() has taken, with an empty
/// vtkPolyData for each block, and returns these in the same order. Where the input is a
/// vtkPolyData, that is the output itself.
std::vector<vtkPolyData*> makeBlocksLike(vtkDataObject* input, vtkDataObject* output);

}

#endif
