// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/writing/CellsOfFaces.h"

#include "Questions.h"

namespace geodesic
{

std::vector<vtkIdType> cellsOfFaces(const PolyDataSurface& surface,
  const std::vector<PolyDataBlock>& inputs, const std::vector<RankAddress>& faces)
{
  std::vector<vtkIdType> firstCells = { 0 };
  for (const PolyDataBlock& input : inputs)
  {
    firstCells.push_back(firstCells.back() + input.countInputCells());
  }
  const auto before = static_cast<vtkIdType>(
    sumOverRanks(surface.exchange(), static_cast<std::uint64_t>(firstCells.back())).before);
  const auto cellOf = [&](Id face)
  {
    const auto [block, cell] = surface.inputCellOf(surface.triangleOf(face));
    return before + firstCells[block] + cell;
  };
  std::vector<vtkIdType> cells(faces.size());
  Questions questions(surface.exchange());
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    if (faces[i].rank == surface.exchange().rank())
    {
      cells[i] = cellOf(faces[i].id); // nearly all
    }
    else
    {
      questions.ask(faces[i].rank, i, faces[i].id);
    }
  }
  questions.exchangeAnswers([&cellOf](MessageReader& question, Message& answer)
    { put(answer, cellOf(question.get<Id>())); },
    [&cells](std::size_t i, MessageReader& answer) { cells[i] = answer.get<vtkIdType>(); });
  return cells;
}

}
