// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/ranks/GatheredBlocks.h"

#include "Types.h"

#include "vtkCellArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <cfloat>
#include <string>
#include <utility>

namespace geodesic
{

namespace
{

vtkSmartPointer<vtkCellArray> getCells(MessageReader& reader)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  const auto ids = reader.getAll<vtkIdType>();
  cells->ImportLegacyFormat(ids.data(), static_cast<vtkIdType>(ids.size()));
  return cells;
}

void putNames(Message& message, const std::vector<std::string>& names)
{
  put(message, names.size());
  for (const std::string& name : names)
  {
    putAll(message, std::vector<char>(name.begin(), name.end()));
  }
}

std::vector<std::string> getNames(MessageReader& reader)
{
  std::vector<std::string> names(reader.get<std::size_t>());
  for (std::string& name : names)
  {
    const auto chars = reader.getAll<char>();
    name.assign(chars.begin(), chars.end());
  }
  return names;
}

void putBlock(const PolyDataBlock& block, Message& message)
{
  putNames(message, { block.name.withoutInput() });
  vtkPolyData* data = block.data;
  const vtkIdType count = data->GetNumberOfPoints();
  put(message, block.precision() == FLT_EPSILON ? VTK_FLOAT : VTK_DOUBLE);
  put(message, count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    put(message, data->GetPoint(i), 3);
  }
  for (vtkCellArray* cells :
    { data->GetVerts(), data->GetLines(), data->GetPolys(), data->GetStrips() })
  {
    vtkNew<vtkIdTypeArray> ids;
    cells->ExportLegacyFormat(ids);
    putAll(message, std::vector<vtkIdType>(ids->Begin(), ids->End()));
  }
  putAll(message, block.inputCells);
  put(message, block.droppedCells);
  putAll(message, block.sourceIds);
  putAll(message, block.originalPoints);
  putNames(message, block.partNames);
  putNames(message, block.pointNames);
}

/// Adds the blocks of a message to others.
///
/// \param input as messages call what they are blocks of.
/// \returns how many points they have.
std::size_t takeBlocks(
  const Message& message, const PartName& input, std::vector<PolyDataBlock>& blocks)
{
  std::size_t numberOfPoints = 0;
  MessageReader reader(message);
  while (!reader.isAtEnd())
  {
    const std::string part = getNames(reader).front();
    const auto data = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    points->SetDataType(reader.get<int>());
    points->SetNumberOfPoints(reader.get<vtkIdType>());
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      points->SetPoint(i, reader.get<Vec3>().data());
    }
    numberOfPoints += static_cast<std::size_t>(points->GetNumberOfPoints());
    data->SetPoints(points);
    data->SetVerts(getCells(reader));
    data->SetLines(getCells(reader));
    data->SetPolys(getCells(reader));
    data->SetStrips(getCells(reader));
    auto inputCells = reader.getAll<vtkIdType>();
    blocks.push_back({ data, part.empty() ? input : input.part(part), std::move(inputCells),
      reader.get<vtkIdType>() });
    blocks.back().sourceIds = reader.getAll<vtkIdType>();
    blocks.back().originalPoints = reader.getAll<vtkIdType>();
    blocks.back().partNames = getNames(reader);
    blocks.back().pointNames = getNames(reader);
  }
  return numberOfPoints;
}

}

GatheredBlocks gatherBlocks(
  const std::vector<PolyDataBlock>& own, const PartName& name, Exchange& exchange)
{
  GatheredBlocks gathered;
  if (exchange.numberOfRanks() == 1)
  {
    gathered.blocks = own;
    return gathered;
  }
  Message message;
  for (const PolyDataBlock& block : own)
  {
    if (block.data->GetNumberOfPoints() > 0 || block.data->GetNumberOfCells() > 0)
    {
      putBlock(block, message);
    }
  }
  const std::vector<Message> all = exchange.tellAll(message);
  const auto ranks = static_cast<std::ptrdiff_t>(all.size());
  const bool isOnOneRank = std::count(all.begin(), all.end(), Message()) >= ranks - 1;
  const bool areCopies = std::count(all.begin(), all.end(), all.front()) == ranks;
  for (std::size_t rank = 0; rank < (areCopies ? 1 : all.size()); ++rank)
  {
    const PartName input = isOnOneRank || areCopies ? name : name.onRank(static_cast<int>(rank));
    gathered.firstPointOfRank.push_back(
      gathered.firstPointOfRank.back() + takeBlocks(all[rank], input, gathered.blocks));
  }
  if (gathered.blocks.empty())
  {
    gathered.blocks.push_back({ vtkSmartPointer<vtkPolyData>::New(), name, {} });
  }
  return gathered;
}

}
