// SPDX-License-Identifier: BSD-3-Clause
// Cells that a ghost array marks as duplicates are not surface: they have the values and the
// refinement of what they duplicate, and count once where that is not there. Hidden ones are holes.
#include "GeodesicTesting.h"

#include "vtkCellData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkUnsignedCharArray.h"

#include <set>

using namespace GeodesicTesting;

namespace
{

using Flag = std::function<unsigned char(const Point&)>;

/// Marks cells by their centre.
vtkSmartPointer<vtkPolyData> WithGhosts(vtkSmartPointer<vtkPolyData> data, const Flag& flag)
{
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> ids;
    data->GetCellPoints(cell, ids);
    Point centre{};
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      const double* p = data->GetPoint(ids->GetId(k));
      for (std::size_t i = 0; i < 3; ++i)
      {
        centre[i] += p[i] / static_cast<double>(ids->GetNumberOfIds());
      }
    }
    ghosts->InsertNextValue(flag(centre));
  }
  data->GetCellData()->AddArray(ghosts);
  return data;
}

/// The part of a square of n x n cells that has its columns from first to the one before last.
/// From a column on its cells begin with another corner, so that quads may be cut the other way.
vtkSmartPointer<vtkPolyData> Columns(int n, int first, int last, Cells cells, int turnedFrom)
{
  const auto bump = [](const Point& p) { return Point{ p[0], p[1], p[0] * p[1] * (1.0 - p[0]) }; };
  auto whole = Square(n, cells);
  if (cells == Cells::Triangles)
  {
    MovePoints(whole, bump); // in flat squares both cuts are as good
  }
  auto part = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  std::vector<vtkIdType> numbers(static_cast<std::size_t>(whole->GetNumberOfPoints()), -1);
  vtkNew<vtkCellArray> polys;
  const int cellsASquare = cells == Cells::Quads ? 1 : 2;
  for (vtkIdType cell = 0; cell < whole->GetNumberOfPolys(); ++cell)
  {
    const auto column = static_cast<int>(cell / cellsASquare) % n;
    if (column < first || column >= last)
    {
      continue;
    }
    vtkNew<vtkIdList> ids;
    whole->GetPolys()->GetCellAtId(cell, ids);
    polys->InsertNextCell(static_cast<int>(ids->GetNumberOfIds()));
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      const vtkIdType id = ids->GetId((k + (column >= turnedFrom ? 1 : 0)) % ids->GetNumberOfIds());
      vtkIdType& number = numbers[static_cast<std::size_t>(id)];
      number = number < 0 ? points->InsertNextPoint(whole->GetPoint(id)) : number;
      polys->InsertCellPoint(number);
    }
  }
  part->SetPoints(points);
  part->SetPolys(polys);
  return part;
}

vtkSmartPointer<vtkMultiBlockDataSet> Blocks(const std::vector<vtkSmartPointer<vtkPolyData>>& parts)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (unsigned int i = 0; i < parts.size(); ++i)
  {
    blocks->SetBlock(i, parts[i]);
  }
  return blocks;
}

vtkPolyData* Block(vtkGeodesicDistanceField* filter, unsigned int i)
{
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  return blocks ? vtkPolyData::SafeDownCast(blocks->GetBlock(i)) : nullptr;
}

/// The corners of the triangles between two planes across x, with the distances there.
std::multiset<std::set<std::array<double, 4>>> TrianglesIn(
  vtkPolyData* block, double begin, double end)
{
  std::multiset<std::set<std::array<double, 4>>> triangles;
  vtkDataArray* distances = block->GetPointData()->GetArray("GeodesicDistance");
  for (vtkIdType cell = 0; cell < block->GetNumberOfPolys(); ++cell)
  {
    vtkNew<vtkIdList> ids;
    block->GetPolys()->GetCellAtId(cell, ids);
    std::set<std::array<double, 4>> corners;
    double x = 0.0;
    for (vtkIdType k = 0; k < 3; ++k)
    {
      const double* p = block->GetPoint(ids->GetId(k));
      corners.insert({ p[0], p[1], p[2], distances->GetTuple1(ids->GetId(k)) });
      x += p[0] / 3.0;
    }
    if (x > begin && x < end)
    {
      triangles.insert(corners);
    }
  }
  return triangles;
}

/// Two blocks with a layer of each other's cells give what they give without these.
void CheckLayers(Check& check, Cells cells, bool refine)
{
  const std::string name =
    std::string(cells == Cells::Quads ? "quads" : "triangles") + (refine ? ", refined" : "");
  const int n = 8;
  const auto duplicate = vtkDataSetAttributes::DUPLICATECELL;
  const Flag beyond = [=](const Point& p)
  { return static_cast<unsigned char>(p[0] > 0.5 ? duplicate : 0); };
  const Flag before = [=](const Point& p)
  { return static_cast<unsigned char>(p[0] < 0.5 ? duplicate : 0); };
  const auto execute = [&](vtkGeodesicDistanceField* filter, vtkDataObject* surface)
  {
    filter->SetInputDataObject(0, surface);
    filter->SetSourceTypeToSurfaceBoundary();
    filter->SetRefineMesh(refine);
    Messages messages(filter);
    messages.Update();
    check.That(messages.Error().empty(), name + ": " + messages.Error());
    return messages.Warning();
  };
  vtkNew<vtkGeodesicDistanceField> plain;
  const std::string said =
    execute(plain, Blocks({ Columns(n, 0, 4, cells, n), Columns(n, 4, 8, cells, n) }));
  vtkNew<vtkGeodesicDistanceField> ghosted;
  // The first block's ghosts come before their originals in the order of blocks.
  const std::string saidOfGhosts = execute(ghosted,
    Blocks({ WithGhosts(Columns(n, 0, 5, cells, 4), beyond),
      WithGhosts(Columns(n, 3, 8, cells, n), before) }));
  check.That(said == saidOfGhosts, name + ": the same is said with ghosts: " + saidOfGhosts);
  check.Equal(ghosted->GetWindowsPropagatedPerEdge(), plain->GetWindowsPropagatedPerEdge(),
    name + ": windows per edge with ghosts");
  check.That(TrianglesIn(Block(ghosted, 0), 0.0, 0.5) == TrianglesIn(Block(plain, 0), 0.0, 0.5) &&
      TrianglesIn(Block(ghosted, 1), 0.5, 1.0) == TrianglesIn(Block(plain, 1), 0.5, 1.0),
    name + ": the same with ghosts and without");
  check.That(
    TrianglesIn(Block(ghosted, 0), 0.5, 0.625) == TrianglesIn(Block(ghosted, 1), 0.5, 0.625) &&
      TrianglesIn(Block(ghosted, 1), 0.375, 0.5) == TrianglesIn(Block(ghosted, 0), 0.375, 0.5),
    name + ": ghosts look like what they duplicate");
  check.Equal(ghosted->GetInterpolationErrorBound(), plain->GetInterpolationErrorBound(),
    name + ": the bound");
}

/// The cap is of the whole without ghosts.
void CheckCap(Check& check)
{
  const Flag beyond = [](const Point& p)
  { return static_cast<unsigned char>(p[0] > 0.5 ? vtkDataSetAttributes::DUPLICATECELL : 0); };
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->SetInputDataObject(0,
    Blocks({ WithGhosts(Columns(8, 0, 8, Cells::Triangles, 8), beyond),
      Columns(8, 4, 8, Cells::Triangles, 8) }));
  filter->SetSourceData(PointSources({ { 0, 0, 0 } }));
  filter->SetMaximumNumberOfCells(150); // the whole has 128, with ghosts there are 192
  Messages messages(filter);
  messages.Update();
  check.That(Contains(messages.Warning(), "is reached"), "the cap: " + messages.Warning());
  const auto own = [&](unsigned int block, double begin, double end)
  { return TrianglesIn(Block(filter, block), begin, end).size(); };
  const std::size_t cells = own(0, 0.0, 0.5) + own(1, 0.5, 1.0);
  check.That(cells > 128 && cells <= 150, "cells under a cap: " + std::to_string(cells));
}

void CheckDuplicatesWithoutOriginal(Check& check)
{
  const Flag all = [](const Point&)
  { return static_cast<unsigned char>(vtkDataSetAttributes::DUPLICATECELL); };
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->RefineMeshOff();
  filter->SetInputDataObject(0, Blocks({ WithGhosts(Square(4), all), WithGhosts(Square(4), all) }));
  filter->SetSourceTypeToSurfaceBoundary();
  Messages messages(filter);
  messages.Update();
  check.That(messages.Error().empty() && messages.Warning().empty(),
    "duplicates without original: " + messages.Error() + messages.Warning());
  for (const unsigned int i : { 0u, 1u })
  {
    vtkPolyData* block = Block(filter, i);
    check.Equal(static_cast<double>(block->GetNumberOfCells()), 32.0, "cells of a copy");
    for (vtkIdType p = 0; p < block->GetNumberOfPoints(); ++p)
    {
      Point place;
      block->GetPoint(p, place.data());
      check.That(std::abs(block->GetPointData()->GetArray("GeodesicDistance")->GetTuple1(p) -
                   DistanceToBoundaryOfSquare(place)) < 1e-15,
        "duplicates without an original count once");
    }
  }
}

/// Around a hole of hidden cells, from one side to the other.
void CheckHiddenCells(Check& check)
{
  const Flag middle = [](const Point& p)
  {
    const bool isInside = p[0] > 0.25 && p[0] < 0.75 && p[1] > 0.25 && p[1] < 0.75;
    return static_cast<unsigned char>(isInside ? vtkDataSetAttributes::HIDDENCELL : 0);
  };
  for (const Cells cells : { Cells::Triangles, Cells::Quads })
  {
    vtkNew<vtkGeodesicDistanceField> filter;
    filter->RefineMeshOff();
    filter->SetInputData(WithGhosts(Square(8, cells), middle));
    filter->SetSourceData(PointSources({ { 0, 0.5, 0 } }));
    Messages messages(filter);
    messages.Update();
    check.That(messages.Error().empty(), "hidden cells: " + messages.Error());
    vtkPolyData* output = filter->GetOutput();
    check.Equal(static_cast<double>(output->GetNumberOfCells()), 96.0, "cells that are not hidden");
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      const double* p = output->GetPoint(i);
      if (p[0] == 1.0 && p[1] == 0.5)
      {
        const double around = 2.0 * std::hypot(0.25, 0.25) + 0.5;
        check.That(std::abs(Distances(filter)->GetTuple1(i) - around) < 1e-14,
          "the way around hidden cells: " + std::to_string(Distances(filter)->GetTuple1(i)));
      }
      if (p[0] == 0.5 && p[1] == 0.5)
      {
        check.That(std::isinf(Distances(filter)->GetTuple1(i)), "a point among hidden cells");
      }
    }
  }
}

}

int TestGeodesicGhosts(int, char*[])
{
  Check check;
  for (const Cells cells : { Cells::Triangles, Cells::Quads })
  {
    CheckLayers(check, cells, false);
    CheckLayers(check, cells, true);
  }
  CheckCap(check);
  CheckDuplicatesWithoutOriginal(check);
  CheckHiddenCells(check);
  return check.Result();
}
