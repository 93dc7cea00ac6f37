// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/GatheredBlocks.h"

#include "Types.h"

#include "vtkCellArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace geodesic
{

namespace
{

void putCells(vtkCellArray* cells, Message& message)
{
  vtkNew<vtkIdTypeArray> ids;
  cells->ExportLegacyFormat(ids);
  put(message, ids->GetNumberOfValues());
  put(message, ids->GetPointer(0), static_cast<std::size_t>(ids->GetNumberOfValues()));
}

vtkSmartPointer<vtkCellArray> getCells(MessageReader& reader)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  std::vector<vtkIdType> ids(static_cast<std::size_t>(reader.get<vtkIdType>()));
  reader.get(ids.data(), ids.size());
  cells->ImportLegacyFormat(ids.data(), static_cast<vtkIdType>(ids.size()));
  return cells;
}

void putBlock(const PolyDataBlock& block, Message& message)
{
  putAll(message, std::vector<char>(block.name.begin(), block.name.end()));
  vtkPolyData* data = block.data;
  const vtkIdType count = data->GetNumberOfPoints();
  const bool isFloat = count > 0 && data->GetPoints()->GetDataType() == VTK_FLOAT;
  put(message, isFloat ? VTK_FLOAT : VTK_DOUBLE); // coordinates keep their precision
  put(message, count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    put(message, data->GetPoint(i), 3);
  }
  for (vtkCellArray* cells :
    { data->GetVerts(), data->GetLines(), data->GetPolys(), data->GetStrips() })
  {
    putCells(cells, message);
  }
  putAll(message, block.inputCells);
  put(message, block.droppedCells);
}

}

GatheredBlocks::GatheredBlocks(
  const std::vector<PolyDataBlock>& own, const std::string& name, Exchange& exchange)
{
  if (exchange.numberOfRanks() == 1)
  {
    this->blocks_ = own;
    return;
  }
  Message message;
  for (const PolyDataBlock& block : own)
  {
    const bool isEmpty =
      block.data->GetNumberOfPoints() == 0 && block.data->GetNumberOfCells() == 0;
    if (!isEmpty)
    {
      putBlock(block, message);
    }
  }
  const std::vector<Message> all = exchange.tellAll(message);
  const auto isFull = [](const Message& m) { return !m.empty(); };
  const bool isOnOneRank = std::count_if(all.begin(), all.end(), isFull) <= 1;
  const bool areCopies =
    std::all_of(all.begin(), all.end(), [&all](const Message& m) { return m == all.front(); });
  for (std::size_t rank = 0; rank < (areCopies ? 1 : all.size()); ++rank)
  {
    this->unpack(
      all[rank], isOnOneRank || areCopies ? std::string() : " on rank " + std::to_string(rank));
    this->firstPointOfRank_.push_back(this->numberOfPoints_);
  }
  if (this->blocks_.empty())
  {
    this->blocks_.push_back({ vtkSmartPointer<vtkPolyData>::New(), name, {}, 0 });
  }
}

void GatheredBlocks::unpack(const Message& message, const std::string& suffix)
{
  MessageReader reader(message);
  while (!reader.isAtEnd())
  {
    const auto name = reader.getAll<char>();
    const auto data = vtkSmartPointer<vtkPolyData>::New();
    PolyDataBlock& block = this->blocks_.emplace_back();
    block.data = data;
    block.name = std::string(name.begin(), name.end()) + suffix;
    vtkNew<vtkPoints> points;
    points->SetDataType(reader.get<int>());
    points->SetNumberOfPoints(reader.get<vtkIdType>());
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      points->SetPoint(i, reader.get<Vec3>().data());
    }
    this->numberOfPoints_ += static_cast<std::size_t>(points->GetNumberOfPoints());
    data->SetPoints(points);
    data->SetVerts(getCells(reader));
    data->SetLines(getCells(reader));
    data->SetPolys(getCells(reader));
    data->SetStrips(getCells(reader));
    block.inputCells = reader.getAll<vtkIdType>();
    block.droppedCells = reader.get<vtkIdType>();
  }
}

}
