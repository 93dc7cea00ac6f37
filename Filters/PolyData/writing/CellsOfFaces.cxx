// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/writing/CellsOfFaces.h"

#include "Questions.h"

namespace geodesic
{

namespace
{

/// Finds the input cells of this rank's faces.
class CellsOfOwnFaces
{
public:
  CellsOfOwnFaces(const PolyDataSurface& surface, const std::vector<PolyDataBlock>& inputs)
    : surface_(surface)
  {
    vtkIdType cells = 0;
    for (const PolyDataBlock& input : inputs)
    {
      this->firstCells_.push_back(cells);
      cells += input.countInputCells();
    }
    const auto before = static_cast<vtkIdType>(
      sumOverRanks(surface.exchange(), static_cast<std::uint64_t>(cells)).before);
    for (vtkIdType& first : this->firstCells_)
    {
      first += before;
    }
  }

  vtkIdType operator()(Id face) const
  {
    const Id triangle = this->surface_.triangleOf(face);
    const std::size_t index = this->surface_.blockOf(triangle, &SurfaceBlock::firstTriangle);
    const SurfaceBlock& block = this->surface_.blocks[index];
    return this->firstCells_[index] +
      block.inputCell(static_cast<vtkIdType>(triangle - block.firstTriangle));
  }

private:
  const PolyDataSurface& surface_;
  std::vector<vtkIdType> firstCells_;
};

}

std::vector<vtkIdType> cellsOfFaces(const PolyDataSurface& surface,
  const std::vector<PolyDataBlock>& inputs, const std::vector<RankAddress>& faces)
{
  const CellsOfOwnFaces cellOf(surface, inputs);
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
