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

class Mixer
{
public:
  void add(std::uint64_t word)
  {
    this->first_ = mixed(this->first_ ^ word, 0x9e3779b97f4a7c15ULL);
    this->second_ = mixed(this->second_ + word, 0xd6e8feb86659fd93ULL);
  }

  void addBytes(const void* data, std::size_t size)
  {
    const auto* bytes = static_cast<const unsigned char*>(data);
    std::uint64_t word = 0;
    for (; size >= sizeof(word); size -= sizeof(word), bytes += sizeof(word))
    {
      std::memcpy(&word, bytes, sizeof(word));
      this->add(word);
    }
    word = 0;
    std::memcpy(&word, bytes, size);
    this->add(word);
  }

  void addArray(vtkDataArray* array)
  {
    this->add(array ? 1 : 0);
    if (!array)
    {
      return;
    }
    this->add(static_cast<std::uint64_t>(array->GetDataType()));
    this->add(static_cast<std::uint64_t>(array->GetNumberOfComponents()));
    this->add(static_cast<std::uint64_t>(array->GetNumberOfTuples()));
    const bool areBytes = array->GetDataTypeSize() > 0; // not bits
    if (areBytes && array->HasStandardMemoryLayout())
    {
      this->addBytes(array->GetVoidPointer(0),
        static_cast<std::size_t>(array->GetNumberOfValues()) *
          static_cast<std::size_t>(array->GetDataTypeSize()));
      return;
    }
    std::vector<double> tuple(static_cast<std::size_t>(array->GetNumberOfComponents()));
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      array->GetTuple(i, tuple.data());
      this->addBytes(tuple.data(), tuple.size() * sizeof(double));
    }
  }

  void addCells(vtkCellArray* cells)
  {
    this->addArray(cells->GetOffsetsArray());
    this->addArray(cells->GetConnectivityArray());
  }

  ContentKey key() const { return { this->first_, this->second_ }; }

private:
  static std::uint64_t mixed(std::uint64_t word, std::uint64_t odd)
  {
    word *= odd;
    return word ^ (word >> 32);
  }

  std::uint64_t first_ = 0;
  std::uint64_t second_ = 0;
};

}

ContentKey contentKey(const std::vector<PolyDataBlock>& blocks)
{
  Mixer mixer;
  for (const PolyDataBlock& block : blocks)
  {
    vtkPolyData* data = block.data;
    mixer.addArray(data->GetPoints() ? data->GetPoints()->GetData() : nullptr);
    // Of lines and vertices only the number counts, by which the cells after them are numbered.
    mixer.add(static_cast<std::uint64_t>(data->GetNumberOfVerts()));
    mixer.add(static_cast<std::uint64_t>(data->GetNumberOfLines()));
    mixer.addCells(data->GetPolys());
    mixer.addCells(data->GetStrips());
    mixer.addArray(data->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
    mixer.addArray(data->GetPointData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
    mixer.addArray(data->GetCellData()->GetGlobalIds());
    mixer.addArray(data->GetPointData()->GetGlobalIds());
    mixer.addArray(block.barriers);
  }
  return mixer.key();
}

void SurfaceCache::update(const std::vector<PolyDataBlock>& blocks, bool mergeCoincidentPoints,
  Exchange& exchange, const ProgressCallback& progress)
{
  const ContentKey key = contentKey(blocks);
  const bool isKept = this->surface_ && this->key_ == key &&
    this->isMerged_ == mergeCoincidentPoints && this->exchange_ == &exchange;
  if (!exchange.isTrueAnywhere(!isKept))
  {
    this->surface_->useCellsOf(blocks);
    return;
  }
  this->release();
  this->surface_ = std::make_unique<PolyDataSurface>(
    readSurface(blocks, mergeCoincidentPoints, exchange, progress));
  this->locator_ = std::make_unique<PolylineLocator>(this->surface_->partition());
  this->key_ = key;
  this->isMerged_ = mergeCoincidentPoints;
  this->exchange_ = &exchange;
}

void SurfaceCache::release()
{
  this->joinedPaths_ = JoinedPaths();
  this->locator_.reset();
  this->surface_.reset();
}

}
