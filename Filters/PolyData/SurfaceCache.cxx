// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/SurfaceCache.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cstring>

namespace geodesic
{

namespace
{

void addBytes(const void* data, std::size_t size, Fingerprint& key)
{
  const auto* bytes = static_cast<const unsigned char*>(data);
  std::uint64_t word = 0;
  for (; size >= sizeof(word); size -= sizeof(word), bytes += sizeof(word))
  {
    std::memcpy(&word, bytes, sizeof(word));
    addWord(word, key);
  }
  word = 0;
  std::memcpy(&word, bytes, size);
  addWord(word, key);
}

void addArray(vtkDataArray* array, Fingerprint& key)
{
  addWord(array ? 1 : 0, key);
  if (!array)
  {
    return;
  }
  addWord(static_cast<std::uint64_t>(array->GetDataType()), key);
  addWord(static_cast<std::uint64_t>(array->GetNumberOfComponents()), key);
  addWord(static_cast<std::uint64_t>(array->GetNumberOfTuples()), key);
  const bool areBytes = array->GetDataTypeSize() > 0; // not bits
  if (areBytes && array->HasStandardMemoryLayout())
  {
    const auto values = static_cast<std::size_t>(array->GetNumberOfValues());
    addBytes(
      array->GetVoidPointer(0), values * static_cast<std::size_t>(array->GetDataTypeSize()), key);
    return;
  }
  std::vector<double> tuple(static_cast<std::size_t>(array->GetNumberOfComponents()));
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    array->GetTuple(i, tuple.data());
    addBytes(tuple.data(), tuple.size() * sizeof(double), key);
  }
}

}

Fingerprint contentKey(const std::vector<PolyDataBlock>& blocks)
{
  Fingerprint key{};
  for (const PolyDataBlock& block : blocks)
  {
    vtkPolyData* data = block.data;
    addArray(data->GetPoints() ? data->GetPoints()->GetData() : nullptr, key);
    // The number of vertices and lines counts, as cells after them are numbered on; what they are
    // does not.
    addWord(static_cast<std::uint64_t>(data->GetNumberOfVerts()), key);
    addWord(static_cast<std::uint64_t>(data->GetNumberOfLines()), key);
    for (vtkCellArray* cells : { data->GetPolys(), data->GetStrips() })
    {
      addArray(cells->GetOffsetsArray(), key);
      addArray(cells->GetConnectivityArray(), key);
    }
    addArray(data->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()), key);
    addArray(data->GetCellData()->GetGlobalIds(), key);
    addArray(data->GetPointData()->GetGlobalIds(), key);
    addArray(block.barriers, key);
    addWord(block.inputCells.size(), key);
    if (!block.inputCells.empty())
    {
      addBytes(block.inputCells.data(), block.inputCells.size() * sizeof(vtkIdType), key);
    }
  }
  return key;
}

void SurfaceCache::update(const std::vector<PolyDataBlock>& blocks, const PointMerging& merging,
  Exchange& exchange, const Job& job)
{
  const Fingerprint key = contentKey(blocks);
  const bool isKept = this->surface_ && this->key_ == key && this->merging_ == merging &&
    this->exchange_ == &exchange;
  if (!exchange.isTrueAnywhere(!isKept))
  {
    this->surface_->useBlocks(blocks);
    return;
  }
  this->release();
  this->surface_ = std::make_unique<PolyDataSurface>(readSurface(blocks, merging, exchange, job));
  this->locator_ = std::make_unique<PolylineLocator>(this->surface_->partition);
  this->key_ = key;
  this->merging_ = merging;
  this->exchange_ = &exchange;
}

const PolyDataSurface& SurfaceCache::keepNothing(std::size_t numberOfBlocks)
{
  this->release();
  this->surface_ = std::make_unique<PolyDataSurface>();
  this->surface_->blocks.resize(numberOfBlocks);
  for (SurfaceBlock& block : this->surface_->blocks)
  {
    block.triangles = vtkSmartPointer<vtkCellArray>::New();
  }
  this->key_ = {};
  return *this->surface_;
}

void SurfaceCache::release()
{
  this->joinedPaths_ = JoinedPaths();
  this->locator_.reset();
  this->surface_.reset();
}

}
