// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PolyDataBlocks_h
#define geodesic_PolyDataBlocks_h

#include "Errors.h"
#include "Exchange.h"
#include "source/PartName.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <string>
#include <vector>

class vtkDataArray;
class vtkDataObject;

namespace geodesic
{

/// An input is of a kind that cannot be used.
class InputError : public Error
{
public:
  using Error::Error;
};

/// One data set of an input.
struct PolyDataBlock
{
  vtkSmartPointer<vtkPolyData> data;
  /// "the surface (input port 0)", or "block 3 (wing) of the surface (input port 0)".
  PartName name;
  /// The number that each cell of data has in the input, where these differ: a vtkPolyData has its
  /// vertices before its lines, and a cell of a grid may be several here. Empty where they are the
  /// same.
  std::vector<vtkIdType> inputCells;
  /// How many cells of a grid as a source are neither vertices, lines nor flat faces, and have no
  /// points here.
  vtkIdType droppedCells = 0;
  /// The cell array that is not 0 where cells are barriers; null where there is none. See
  /// findBarrierArrays().
  vtkDataArray* barriers = nullptr;
  /// How many cells the input has, where data has another number of them; 0 where it has as many.
  /// The cell data of data is that of the cells of the input.
  vtkIdType numberOfInputCells = 0;
  /// The ids of the parts of a source, by the numbers that cells have in the input, or by the
  /// points of a set of points. Empty unless an array names them; see sourceBlocks().
  std::vector<vtkIdType> sourceIds = {};
  /// What the parts of a source are called, by the same numbers. Empty unless an array says so.
  std::vector<std::string> partNames = {};
  /// What the points are called if they are targets. Empty unless an array says so.
  std::vector<std::string> pointNames = {};
  /// For each point of a source, or of targets, the point of the surface that it was taken from
  /// (ParaView's array vtkOriginalPointIds). Empty where that is unknown.
  std::vector<vtkIdType> originalPoints = {};

  /// The number in the input of a cell of data.
  vtkIdType inputCell(vtkIdType cell) const
  {
    return this->inputCells.empty() ? cell : this->inputCells[static_cast<std::size_t>(cell)];
  }
  vtkIdType countInputCells() const
  {
    return this->numberOfInputCells > 0 ? this->numberOfInputCells : this->data->GetNumberOfCells();
  }
  /// The relative precision of the coordinates: epsilon of float or, without points, of double.
  double precision() const;
  /// Whether there are no cells, or vertex cells only: each point is a source of its own then.
  bool isSetOfPoints() const
  {
    return this->data->GetNumberOfCells() == this->data->GetNumberOfVerts();
  }
};

/// Ids of sources are below this: VTK hands the values of arrays on as double, which has all whole
/// numbers up to here.
constexpr vtkIdType SourceIdEnd = static_cast<vtkIdType>(
  sizeof(vtkIdType) > 4 ? 1ULL << 53U : static_cast<unsigned long long>(VTK_ID_MAX));

/// The surface that an input is, or those that the leaves of a composite one are, in their
/// flattened order: each a vtkPolyData, or a vtkUnstructuredGrid of two-dimensional cells (see
/// surfaceOfGrid()). Blocks that are null are left out.
///
/// \param name as messages call the input.
/// \throws InputError where the input or a block is something else, or has cells that cannot be
///         read; it says which and what to do.
std::vector<PolyDataBlock> polyDataBlocks(vtkDataObject* input, const PartName& name);

/// Whether the name of an array stands for one: null, empty and "None" (the first entry of
/// ParaView's list) do not.
bool isChosen(const char* array);

/// Names of arrays of a source or of targets, where isChosen().
struct PartArrays
{
  /// Of the ids of the source's parts: an array of the points of a set of points, else of cells.
  const char* sourceIds = nullptr;
  /// Of the parts' names, in the same place.
  const char* sourceNames = nullptr;
  /// Of the names of the points, which are the targets.
  const char* targetNames = nullptr;
  /// Whether the parts are sets of targets: messages name the properties of those, and points are
  /// parts, whatever cells there are, where they have the ids and cells have not.
  bool areTargets = false;
};

/// The same for a source, which may be any vtkPointSet, or leaves that are: of a
/// vtkUnstructuredGrid the vertices and lines, of others than that and vtkPolyData the points
/// alone.
///
/// \throws InputError also where a block that is not empty has no such array, or one of another
///         type (integers, or also strings for names), of several components or of too few values.
std::vector<PolyDataBlock> sourceBlocks(
  vtkDataObject* input, const PartName& name, const PartArrays& arrays);

/// The same for targets, which are the points of any vtkPointSet. Cells are left out.
///
/// \param nameArray as PartArrays::targetNames.
std::vector<PolyDataBlock> targetBlocks(
  vtkDataObject* input, const PartName& name, const char* nameArray);

/// Finds PolyDataBlock::barriers of the blocks of a surface. Blocks without the array have no
/// barriers. An array with one value a face, which leaves out vertices and lines, is replaced by
/// one with a value for each cell.
///
/// \param array its name; null, empty and "None" (the first entry of ParaView's list) stand for no
///        barriers.
/// \param exchange with other ranks, all of which find the arrays of their blocks now.
/// \throws InputError where no block with cells, of any rank, has the array, or where it is not
///         numeric, has several components, neither a value for each cell nor one for each face, or
///         NaN.
void findBarrierArrays(std::vector<PolyDataBlock>& blocks, const char* array, Exchange& exchange);

/// "cell 3, cell 17 and 5 more", by the names of the first of so many.
std::string listFirst(const std::vector<std::string>& names, std::size_t count);
/// The first few of some ids, for an error message: "3, 17, 20 and 5 more".
std::string listIds(const std::vector<vtkIdType>& ids);

/// The error message for a block with points whose coordinates are not finite; empty if there is
/// none.
///
/// \param isUsed of each point whether it counts; null: all do.
std::string whereNotFinite(const PolyDataBlock& block, const char* isUsed = nullptr);

/// Calls visit(vtkIdType size, const vtkIdType* ids) for each cell.
template <typename Visit>
void forEachCell(vtkCellArray* cells, Visit&& visit)
{
  const auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    iterator->GetCurrentCell(size, ids);
    visit(size, ids);
  }
}

/// \param cell the number of a cell of the block, with these points.
/// \throws Failure where a point does not exist.
template <typename Failure>
void requirePoints(const PolyDataBlock& block, vtkIdType cell, vtkIdType size, const vtkIdType* ids)
{
  const vtkIdType count = block.data->GetNumberOfPoints();
  for (vtkIdType i = 0; i < size; ++i)
  {
    if (ids[i] < 0 || ids[i] >= count)
    {
      throw Failure(block.name.part("cell", cell).atBeginning() + " names point " +
        std::to_string(ids[i]) + ", but there are only " + std::to_string(count) +
        " points. Repair the cells upstream.");
    }
  }
}

/// Gives an output the structure of an input that polyDataBlocks() has taken, with an empty
/// vtkPolyData for each block, and returns these in the same order. Where the input is a
/// vtkPolyData, that is the output itself.
std::vector<vtkPolyData*> makeBlocksLike(vtkDataObject* input, vtkDataObject* output);

/// The blocks of an input of all ranks, on every rank: points, cells and ids, without other data.
/// They stand in the order of ranks, then of each rank's blocks. If all ranks have the same blocks,
/// these count once.
struct GatheredBlocks
{
  std::vector<PolyDataBlock> blocks;
  std::vector<std::size_t> firstPointOfRank = { 0 };

  /// The rank that has a point, by its number over all blocks; 0 where all have the same.
  int rankOfPoint(std::size_t number) const
  {
    const auto& first = this->firstPointOfRank;
    return static_cast<int>(std::upper_bound(first.begin(), first.end(), number) - first.begin()) -
      1;
  }
};

/// All ranks call this together.
///
/// \param own of this rank.
/// \param name as messages call the input.
GatheredBlocks gatherBlocks(
  const std::vector<PolyDataBlock>& own, const PartName& name, Exchange& exchange);

}

#endif
