// SPDX-License-Identifier: BSD-3-Clause
// Cells that a ghost array marks as duplicates are not surface: they have the values and the
// refinement of what they duplicate, and count once where that is not there. Hidden ones are holes.
#include "BarrierTesting.h"

using namespace GeodesicTesting;

namespace
{

/// The part of a square of n x n cells that has its columns from first to the one before last.
/// From a column on its cells begin with another corner, so that quads may be cut the other way.
vtkSmartPointer<vtkPolyData> Columns(int n, int first, int last, Cells cells, int turnedFrom)
{
  auto whole = Square(n, cells);
  if (cells == Cells::Triangles) // in flat squares both cuts are as good
  {
    MovePoints(whole,
      [](const Point& p) {
        return Point{ p[0], p[1], p[0] * p[1] * (1.0 - p[0]) };
      });
  }
  auto part = Part(whole, [=](const Point& p) { return n * p[0] > first && n * p[0] < last; });
  auto polygons = CellsOf(part->GetPolys());
  for (std::size_t i = 0; i < polygons.size(); ++i)
  {
    if (n * CentreOf(part, static_cast<vtkIdType>(i))[0] > turnedFrom)
    {
      std::rotate(polygons[i].begin(), polygons[i].begin() + 1, polygons[i].end());
    }
  }
  auto turned = vtkSmartPointer<vtkPolyData>::New();
  turned->SetPoints(part->GetPoints());
  turned->SetPolys(CellArrayOf(polygons));
  return turned;
}

/// Two blocks with a layer of each other's cells give what they give without these.
void CheckLayers(Check& check, Cells cells, bool refine)
{
  const std::string name =
    std::string(cells == Cells::Quads ? "quads" : "triangles") + (refine ? ", refined" : "");
  const int n = 8;
  const auto beyond = [](const Point& p) { return p[0] > 0.5; };
  const auto before = [](const Point& p) { return p[0] < 0.5; };
  const auto execute = [&](vtkGeodesicDistanceField* filter, vtkDataObject* surface)
  {
    filter->SetInputDataObject(0, surface);
    filter->SetSourceTypeToSurfaceBoundary();
    filter->SetRefineMesh(refine);
    Messages messages(filter);
    messages.ExpectNoError(check, name);
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
  const auto beyond = [](const Point& p) { return p[0] > 0.5; };
  const auto filter =
    RefinedField(Blocks({ WithGhosts(Columns(8, 0, 8, Cells::Triangles, 8), beyond),
                   Columns(8, 4, 8, Cells::Triangles, 8) }),
      PointSources({ { 0, 0, 0 } }));
  filter->SetMaximumNumberOfCells(150); // the whole has 128, with ghosts there are 192
  Messages(filter).ExpectWarning(check, { "is reached" }, "the cap");
  const auto own = [&](unsigned int block, double begin, double end)
  { return TrianglesIn(Block(filter, block), begin, end).size(); };
  const std::size_t cells = own(0, 0.0, 0.5) + own(1, 0.5, 1.0);
  check.That(cells > 128 && cells <= 150, "cells under a cap: " + std::to_string(cells));
}

void CheckDuplicatesWithoutOriginal(Check& check)
{
  const auto all = [](const Point&) { return true; };
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->RefineMeshOff();
  filter->SetInputDataObject(0, Blocks({ WithGhosts(Square(4), all), WithGhosts(Square(4), all) }));
  filter->SetSourceTypeToSurfaceBoundary();
  Messages(filter).ExpectNothing(check, "duplicates without original");
  for (const unsigned int i : { 0u, 1u })
  {
    vtkPolyData* block = Block(filter, i);
    check.Equal(block->GetNumberOfCells(), 32.0, "cells of a copy");
    CheckTruth(
      check, block, DistanceToBoundaryOfSquare, "duplicates without an original count once", 1e-15);
  }
}

/// Around a hole of hidden cells, from one side to the other.
void CheckHiddenCells(Check& check)
{
  const auto middle = [](const Point& p)
  { return p[0] > 0.25 && p[0] < 0.75 && p[1] > 0.25 && p[1] < 0.75; };
  for (const Cells cells : { Cells::Triangles, Cells::Quads })
  {
    const auto filter =
      PlainField(WithGhosts(Square(8, cells), middle, vtkDataSetAttributes::HIDDENCELL),
        PointSources({ { 0, 0.5, 0 } }));
    RunWithoutError(check, filter, "hidden cells");
    vtkPolyData* output = filter->GetOutput();
    check.Equal(output->GetNumberOfCells(), 96.0, "cells that are not hidden");
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      const double* p = output->GetPoint(i);
      if (p[0] == 1.0 && p[1] == 0.5)
      {
        const double around = 2.0 * std::hypot(0.25, 0.25) + 0.5;
        check.Near(Distances(filter)->GetTuple1(i), around, 1e-14, "the way around hidden cells");
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
