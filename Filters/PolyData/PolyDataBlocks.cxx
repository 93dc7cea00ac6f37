// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/PolyDataBlocks.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <utility>

namespace geodesic
{

namespace
{

const char* const WhatToDo = ": apply Extract Surface to it first. A vtkPolyData, or a composite "
                             "data set of these, is needed; "
                             "vtkDataSetSurfaceFilter and vtkGeometryFilter make one.";

/// Goes through the blocks of a composite data set, those of nested ones too, and calls them by
/// their number (as ParaView's composite index) and the name that a file or the user has given.
/// The parts of a partitioned data set go by its name where they have none of their own.
class BlockVisitor
{
public:
  explicit BlockVisitor(std::string input)
    : input_(std::move(input))
  {
  }

  template <typename Visitor>
  void forEach(vtkCompositeDataSet* data, Visitor&& visit)
  {
    const auto iterator = vtk::TakeSmartPointer(data->NewIterator());
    if (auto* tree = vtkDataObjectTreeIterator::SafeDownCast(iterator))
    {
      tree->VisitOnlyLeavesOff();
    }
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      this->at_ = iterator;
      vtkDataObject* block = iterator->GetCurrentDataObject();
      if (block->IsA("vtkCompositeDataSet"))
      {
        this->parent_ = block->IsA("vtkPartitionedDataSet") ? this->given() : "";
        continue;
      }
      visit(iterator.Get(), block);
    }
  }

  /// "block 3 (wing) of the surface (input port 0)"
  std::string name() const
  {
    const std::string given = this->given().empty() ? this->parent_ : this->given();
    return "block " + std::to_string(this->at_->GetCurrentFlatIndex()) +
      (given.empty() ? "" : " (" + given + ")") + " of " + this->input_;
  }

private:
  std::string given() const
  {
    vtkInformation* data =
      this->at_->HasCurrentMetaData() ? this->at_->GetCurrentMetaData() : nullptr;
    const char* text = data ? data->Get(vtkCompositeDataSet::NAME()) : nullptr;
    return text ? text : "";
  }

  std::string input_;
  std::string parent_;
  vtkCompositeDataIterator* at_ = nullptr;
};

}

std::string capitalized(std::string name)
{
  name[0] = name[0] == 'b' ? 'B' : 'T';
  return name;
}

std::vector<PolyDataBlock> polyDataBlocks(vtkDataObject* input, const std::string& name)
{
  if (auto* data = vtkPolyData::SafeDownCast(input))
  {
    return { { data, name } };
  }
  auto* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (!composite)
  {
    throw InputError(capitalized(name) + " is a " + input->GetClassName() + WhatToDo);
  }
  std::vector<PolyDataBlock> blocks;
  BlockVisitor visitor(name);
  visitor.forEach(composite,
    [&](vtkCompositeDataIterator*, vtkDataObject* block)
    {
      auto* data = vtkPolyData::SafeDownCast(block);
      if (!data)
      {
        throw InputError(capitalized(visitor.name()) + " is a " + block->GetClassName() + WhatToDo);
      }
      blocks.push_back({ data, visitor.name() });
    });
  return blocks;
}

std::vector<vtkPolyData*> makeBlocksLike(vtkDataObject* input, vtkDataObject* output)
{
  if (auto* data = vtkPolyData::SafeDownCast(output))
  {
    return { data };
  }
  auto* from = vtkCompositeDataSet::SafeDownCast(input);
  auto* to = vtkCompositeDataSet::SafeDownCast(output);
  to->CopyStructure(from);
  std::vector<vtkPolyData*> blocks;
  BlockVisitor("").forEach(from,
    [&](vtkCompositeDataIterator* at, vtkDataObject*)
    {
      vtkNew<vtkPolyData> block;
      to->SetDataSet(at, block);
      blocks.push_back(block);
    });
  return blocks;
}

}
