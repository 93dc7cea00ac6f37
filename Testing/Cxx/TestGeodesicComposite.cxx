// SPDX-License-Identifier: BSD-3-Clause
// The blocks of a composite surface are one surface with one field, those of a composite source one
// source; the output has the structure of the surface, and refined blocks fit together.
#include "GeodesicTesting.h"

#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkStructuredGrid.h"

#include <set>

using namespace GeodesicTesting;

namespace
{

/// Checks the distances in all blocks against the truth, within a fraction of the largest.
void CheckBlocks(Check& check, vtkDataObject* output, std::size_t expectedBlocks,
  const Distance& truth, const std::string& what, double tolerance = 1e-12)
{
  const std::vector<vtkPolyData*> blocks = LeavesOf(output);
  check.Equal(blocks.size(), expectedBlocks, what + ": blocks with data");
  for (vtkPolyData* block : blocks)
  {
    CheckTruth(check, block, truth, what, tolerance);
  }
}

const std::vector<Point> Line = { { 0.2, 0.3, 0 }, { 0.4, 0.7, 0 } };

/// Two squares side by side, the second named, between them a null block, behind them an empty one.
/// Against the gradient each point comes nearer by as much as it moves, in all blocks.
void CheckGradients(
  Check& check, vtkDataObject* output, const Distance& truth, const std::string& what)
{
  constexpr double step = 1e-3;
  double worst = 0.0;
  for (vtkPolyData* block : LeavesOf(output))
  {
    vtkDataArray* gradients = block->GetPointData()->GetArray("DistanceGradient");
    for (vtkIdType i = 0; gradients && i < block->GetNumberOfPoints(); ++i)
    {
      const Point p = PointAt(block, i);
      const Point gradient = TupleAt(gradients, i);
      const double distance = truth(p);
      const Point nearer = Minus(p, ScaledBy(step)(gradient));
      worst = std::max(worst, distance > step ? std::abs(truth(nearer) - (distance - step)) : 0.0);
    }
    check.That(gradients != nullptr || block->GetNumberOfPoints() == 0, what + ": gradients");
  }
  check.That(worst <= 1e-9, what + ": gradients are off by " + std::to_string(worst));
}

vtkSmartPointer<vtkMultiBlockDataSet> TwoSquares(
  vtkSmartPointer<vtkPolyData> first, vtkSmartPointer<vtkPolyData> second)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  blocks->SetBlock(0, first);
  blocks->SetBlock(1, nullptr);
  blocks->SetBlock(2, second);
  blocks->SetBlock(3, vtkNew<vtkPolyData>());
  blocks->GetMetaData(2u)->Set(vtkCompositeDataSet::NAME(), "wing");
  return blocks;
}

void CheckMultiBlock(Check& check, bool refine)
{
  const std::string name = refine ? "refined blocks" : "blocks";
  auto first = Square(8);
  AddArray<vtkDoubleArray>(first->GetFieldData(), "Title", { 7.0 });
  vtkNew<vtkDoubleArray> numbers;
  numbers->SetName("Number");
  auto second = Moved(Square(8, Cells::Quads), MovedBy(1.0));
  for (vtkIdType i = 0; i < second->GetNumberOfCells(); ++i)
  {
    numbers->InsertNextValue(100.0 + static_cast<double>(i));
  }
  second->GetCellData()->AddArray(numbers);
  const auto surface = TwoSquares(first, second);

  const auto filter = RefinedField(surface, Polyline(Line));
  filter->SetRefineMesh(refine);
  filter->GenerateGradientsOn();
  RunWithoutError(check, filter, name);
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  if (!output)
  {
    check.That(false, name + ": the output is a multiblock");
    return;
  }
  check.That(filter->GetOutput() == nullptr, name + ": there is no single vtkPolyData");
  CheckBlocks(check, output, 3, DistanceTo(Line), name);
  CheckGradients(check, output, DistanceTo(Line), name);
  check.Equal(output->GetNumberOfBlocks(), 4, name + ": blocks of the output");
  check.That(output->GetBlock(1) == nullptr, name + ": a null block stays null");
  check.That(std::string(output->GetMetaData(2u)->Get(vtkCompositeDataSet::NAME())) == "wing",
    name + ": names stay");
  auto* left = vtkPolyData::SafeDownCast(output->GetBlock(0));
  auto* right = vtkPolyData::SafeDownCast(output->GetBlock(2));
  check.That(left->GetFieldData()->HasArray("Title") && !right->GetFieldData()->HasArray("Title"),
    name + ": a block's field data");
  for (vtkDataObject* part : std::initializer_list<vtkDataObject*>{ output, left, right })
  {
    check.That(part->GetFieldData()->HasArray("InterpolationErrorBound") &&
        part->GetFieldData()->HasArray("WindowsPropagatedPerEdge"),
      name + ": field data of the root and of blocks");
  }
  check.That(!left->GetCellData()->HasArray("Number"), name + ": blocks have their own arrays");
  vtkDataArray* handed = right->GetCellData()->GetArray("Number");
  vtkDataArray* originals = right->GetCellData()->GetArray("OriginalCellIds");
  check.That(handed && handed->GetNumberOfTuples() == right->GetNumberOfCells() &&
      (originals != nullptr) == refine,
    name + ": arrays of the second block");
  for (vtkIdType cell = 0; handed && originals && cell < right->GetNumberOfCells(); ++cell)
  {
    check.Equal(handed->GetTuple1(cell), 100.0 + originals->GetTuple1(cell),
      name + ": the data of the original cell in the block");
  }
}

void CheckWarningsCountAllBlocks(Check& check)
{
  const auto withFlatFace = [](vtkSmartPointer<vtkPolyData> data)
  {
    data->GetPolys()->InsertNextCell({ 0, 1, 1 });
    return data;
  };
  const auto filter =
    RefinedField(TwoSquares(withFlatFace(Square(2)), withFlatFace(Moved(Square(2), MovedBy(1.0)))),
      Polyline(Line));
  Messages(filter).ExpectWarning(
    check, { "2 faces with two corners" }, "warnings count all blocks");
}

/// The points at x = 1 of a block, with their distances.
std::set<std::array<double, 4>> SeamOf(vtkPolyData* block, double x, double tolerance)
{
  std::set<std::array<double, 4>> seam;
  vtkDataArray* distances = block->GetPointData()->GetArray("GeodesicDistance");
  for (vtkIdType i = 0; i < block->GetNumberOfPoints(); ++i)
  {
    const double* p = block->GetPoint(i);
    if (std::abs(p[0] - x) <= tolerance)
    {
      seam.insert({ p[0], p[1], p[2], distances->GetTuple1(i) });
    }
  }
  return seam;
}

void CheckRefinedSeams(Check& check)
{
  const auto filter =
    RefinedField(TwoSquares(Square(4), Moved(Square(4, Cells::Quads), MovedBy(1.0))),
      PointSources({ { 0.9, 0.4, 0 } }));
  filter->SetRefinementTolerance(0.0002);
  Messages messages(filter);
  messages.Update();
  const auto leaves = LeavesOf(filter->GetOutputDataObject(0));
  const auto left = SeamOf(leaves.at(0), 1.0, 0.0);
  check.That(left.size() > 10, "the seam is refined");
  check.That(left == SeamOf(leaves.at(1), 1.0, 0.0),
    "both sides of a refined seam have the same points and distances");
  for (vtkPolyData* block : { leaves[0], leaves[1] })
  {
    double area = 0.0;
    for (vtkIdType cell = 0; cell < block->GetNumberOfPolys(); ++cell)
    {
      const std::vector<Point> c = CornersOf(block, cell);
      area += 0.5 * std::abs(Cross(Minus(c[1], c[0]), Minus(c[2], c[0]))[2]);
    }
    check.Near(area, 1.0, 1e-12, "the triangles of a block cover it once");
  }
}

vtkSmartPointer<vtkPartitionedDataSet> Partitions(
  const std::vector<vtkSmartPointer<vtkPolyData>>& parts)
{
  auto set = vtkSmartPointer<vtkPartitionedDataSet>::New();
  for (unsigned int i = 0; i < parts.size(); ++i)
  {
    set->SetPartition(i, parts[i]);
  }
  return set;
}

void CheckKinds(Check& check)
{
  const auto squares = []
  {
    return std::vector<vtkSmartPointer<vtkPolyData>>{ Square(4), Moved(Square(4), MovedBy(1.0)),
      Moved(Square(4), MovedBy(0.0, 1.0)) };
  };
  vtkNew<vtkPartitionedDataSetCollection> collection;
  collection->SetPartitionedDataSet(0, Partitions({ squares()[0], nullptr }));
  collection->SetPartitionedDataSet(1, Partitions({ squares()[1], squares()[2] }));
  collection->GetMetaData(1u)->Set(vtkCompositeDataSet::NAME(), "others");
  const auto inner = Blocks({ squares()[1] });
  const auto innermost = Blocks({ squares()[2] });
  inner->SetBlock(1, innermost);
  const auto nested = Blocks({ squares()[0], inner, vtkNew<vtkMultiBlockDataSet>() });

  const std::vector<std::pair<std::string, vtkSmartPointer<vtkDataObject>>> kinds = {
    { "a partitioned data set", Partitions(squares()) },
    { "a collection", collection.Get() },
    { "nested blocks", nested.Get() },
  };
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->SetSourceData(Polyline(Line));
  Messages messages(filter);
  for (const auto& [name, surface] : kinds)
  {
    filter->SetInputDataObject(0, surface);
    messages.ExpectNoError(check, name);
    vtkDataObject* output = filter->GetOutputDataObject(0);
    check.That(std::string(output->GetClassName()) == surface->GetClassName(),
      name + ": the output is a " + output->GetClassName());
    CheckBlocks(check, output, 3, DistanceTo(Line), name);
  }
  auto* kept = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  check.That(kept && vtkMultiBlockDataSet::SafeDownCast(kept->GetBlock(1)), "nesting stays");

  filter->SetInputData(Square(4));
  messages.Update();
  check.That(filter->GetOutput() != nullptr, "after a composite a vtkPolyData gives one again");
  CheckDistances(check, filter, DistanceTo(Line), "after a composite");
}

void CheckCompositeSource(Check& check)
{
  const auto inner =
    Blocks({ nullptr, Polyline({ { 0.7, 0.1, 0 }, { 0.8, 0.2, 0 } }, false, VTK_FLOAT) });
  const auto source =
    Blocks({ Polyline(Line), vtkNew<vtkPolyData>(), inner, PointSources({ { 0.5, 0.9, 0 } }) });
  const Distance truth = [](const Point& p)
  {
    return std::min({ DistanceTo(Line)(p), DistanceTo({ { 0.7, 0.1, 0 }, { 0.8, 0.2, 0 } })(p),
      DistanceTo({ { 0.5, 0.9, 0 } })(p) });
  };
  const auto filter = PlainField(Square(8), source);
  Messages messages(filter);
  messages.Update();
  check.That(filter->GetOutput() && filter->GetOutput()->GetNumberOfPoints() == 81,
    "with a composite source there is one surface");
  CheckDistances(check, filter, truth, "a composite source", 1e-6);
  vtkPolyData* curves = filter->GetOutput(1);
  check.That(curves && curves->GetNumberOfLines() == 2 && curves->GetNumberOfVerts() == 1,
    "all blocks of the source are on output port 1");

  filter->SetInputDataObject(0, TwoSquares(Square(4), Moved(Square(4), MovedBy(1.0))));
  messages.Update();
  CheckBlocks(check, filter->GetOutputDataObject(0), 3, truth, "both composite", 1e-6);
}

/// Coordinates that two blocks have computed on their own differ by roundings.
void CheckSeamsWithinRoundings(Check& check, int dataType)
{
  const std::string name = dataType == VTK_FLOAT ? "32-bit blocks" : "64-bit blocks";
  const double rounding = dataType == VTK_FLOAT ? 1.2e-7 : 2.2e-16;
  const auto second = [dataType, rounding](double roundings)
  {
    return Moved(Square(4, Cells::Triangles, dataType),
      [=](const Point& p)
      {
        return Point{ 100.0 * (p[0] + 1.0) * (1.0 + roundings * rounding),
          100.0 * p[1] * (1.0 - roundings * rounding), 0.0 };
      });
  };
  const auto first = Moved(Square(4, Cells::Triangles, dataType),
    [](const Point& p) {
      return Point{ 100.0 * p[0], 100.0 * p[1], 0.0 };
    });
  const Point source = { 90.0, 40.0, 0.0 };
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->SetSourceData(PointSources({ source }));
  Messages messages(filter);
  filter->SetInputDataObject(0, TwoSquares(first, second(1.5)));
  messages.Update();
  CheckBlocks(check, filter->GetOutputDataObject(0), 3, DistanceTo({ source }),
    name + " that meet within roundings", dataType == VTK_FLOAT ? 2e-4 : 1e-11);
  const auto leaves = LeavesOf(filter->GetOutputDataObject(0));
  const auto left = SeamOf(leaves.at(0), 100.0, 0.0);
  const auto right = SeamOf(leaves.at(1), 100.0, 0.0);
  check.That(left.size() > 8 && right.size() + 5 == left.size(),
    name + ": new points of the seam have the coordinates of the first block's edge on both sides");
  check.That(std::includes(left.begin(), left.end(), right.begin(), right.end()),
    name + ": and the same distances");

  const auto isReached = [&]()
  {
    vtkDataArray* distances =
      LeavesOf(filter->GetOutputDataObject(0)).at(1)->GetPointData()->GetArray("GeodesicDistance");
    return std::isfinite(distances->GetTuple1(0));
  };
  check.That(isReached(), name + ": the second is reached");
  filter->MergeCoincidentPointsOff();
  messages.Update();
  check.That(!isReached(), name + ": without merging the second is not reached");
  filter->MergeCoincidentPointsOn();
  filter->SetInputDataObject(0, TwoSquares(first, second(50.0)));
  messages.Update();
  check.That(!isReached(), name + ": beyond roundings the second is not reached");
}

/// Points of one block that differ in the last bit are one, as those of two blocks.
void CheckCrackInOneBlock(Check& check)
{
  auto cracked = Soup(Square(1));
  vtkPoints* points = cracked->GetPoints();
  for (vtkIdType i = 3; i < 6; ++i)
  {
    const Point p = PointAt(points, i);
    points->SetPoint(i, p[0] * (1.0 + 2.3e-16), p[1] * (1.0 + 2.3e-16), 1e-16);
  }
  const auto filter =
    PlainField(TwoSquares(cracked, Moved(Square(1), MovedBy(5.0))), PointSources({ { 0, 0, 0 } }));
  Messages messages(filter);
  messages.Update();
  vtkIdType reached = 0;
  vtkPolyData* block = LeavesOf(filter->GetOutputDataObject(0)).at(0);
  for (vtkIdType i = 0; i < 6; ++i)
  {
    reached += std::isfinite(PointValue(block, "GeodesicDistance", i));
  }
  check.Equal(reached, 6.0, "points reached of a block with a crack");
}

void CheckErrors(Check& check)
{
  vtkNew<vtkGeodesicDistanceField> filter;
  Messages messages(filter);
  const auto expect = [&](vtkDataObject* surface, vtkDataObject* source,
                        const std::vector<std::string>& words, const std::string& name)
  {
    filter->SetInputDataObject(0, surface);
    filter->SetSourceData(source);
    messages.ExpectError(check, words, name);
    for (vtkPolyData* leaf : LeavesOf(filter->GetOutputDataObject(0)))
    {
      check.Equal(leaf->GetNumberOfPoints(), 0.0, name + ": no points");
    }
  };
  const auto square = Square(2);
  const auto corner = PointSources({ { 0, 0, 0 } });
  const auto withGrid = TwoSquares(Square(2), Square(2));
  vtkNew<vtkStructuredGrid> structured;
  structured->SetDimensions(2, 2, 2);
  withGrid->SetBlock(2, structured);
  withGrid->GetMetaData(2u)->Set(vtkCompositeDataSet::NAME(), "volume");
  expect(withGrid, corner,
    { "Block 3 (volume) of the surface (input port 0)", "vtkStructuredGrid", "Extract Surface" },
    "a block that is a grid");
  const auto withImage = TwoSquares(Square(2), Square(2));
  withImage->SetBlock(2, vtkNew<vtkImageData>());
  withImage->GetMetaData(2u)->Set(vtkCompositeDataSet::NAME(), "volume");
  expect(square, withImage, { "Block 3 (volume) of the source (input port 1)", "Extract Surface" },
    "an image in the source");
  expect(vtkNew<vtkImageData>(), corner,
    { "The surface (input port 0) is a vtkImageData", "Extract Surface" }, "an image");
  expect(square, vtkNew<vtkImageData>(), { "The source (input port 1) is a vtkImageData" },
    "an image as source");
  expect(vtkNew<vtkMultiBlockDataSet>(), corner, { "no faces" }, "a composite without blocks");
  expect(square, vtkNew<vtkMultiBlockDataSet>(), { "port 1", "empty" }, "a source without blocks");

  const auto withNan = TwoSquares(Square(2), Square(2));
  vtkPolyData::SafeDownCast(withNan->GetBlock(2))->GetPoints()->SetPoint(4, NAN, 0, 0);
  expect(withNan, corner, { "Block 3 (wing) of the surface (input port 0)", "point 4" }, "a NaN");
  const auto badCell = TwoSquares(Square(2), Square(2));
  vtkPolyData::SafeDownCast(badCell->GetBlock(2))->GetPolys()->InsertNextCell({ 0, 1, 99 });
  expect(badCell, corner, { "Cell 8 of block 3 (wing) of the surface", "point 99", "9 points" },
    "a cell that names a missing point");
  vtkNew<vtkPartitionedDataSetCollection> collection;
  collection->SetPartitionedDataSet(0, Partitions({ nullptr }));
  vtkNew<vtkPartitionedDataSet> grids;
  grids->SetPartition(0, structured);
  collection->SetPartitionedDataSet(1, grids);
  collection->GetMetaData(1u)->Set(vtkCompositeDataSet::NAME(), "fluid");
  expect(collection, corner, { "(fluid) of the surface" }, "a grid in a collection");

  filter->SetInputDataObject(0, TwoSquares(Square(2), Moved(Square(2), MovedBy(1.0))));
  messages.Update();
  CheckBlocks(
    check, filter->GetOutputDataObject(0), 3, DistanceTo({ { 0, 0, 0 } }), "after an error");
}

/// A block without faces is no surface, but stays a block.
void CheckBlockOfLines(Check& check)
{
  for (const bool refine : { false, true })
  {
    auto lines = Polyline({ { 3, 0, 0 }, { 4, 0, 0 } });
    AddArray<vtkDoubleArray>(lines->GetCellData(), "Number", { 1.0 });
    const auto filter = RefinedField(TwoSquares(Square(2), lines), PointSources({ { 0, 0, 0 } }));
    filter->SetRefineMesh(refine);
    Messages messages(filter);
    messages.ExpectNoError(check, "a block of lines");
    vtkPolyData* block = LeavesOf(filter->GetOutputDataObject(0)).at(1);
    vtkDataArray* handed = block->GetCellData()->GetArray("Number");
    check.That(block->GetNumberOfPoints() == 2 && block->GetNumberOfCells() == 0 &&
        (!handed || handed->GetNumberOfTuples() == 0),
      "a block of lines keeps its points and has no cells");
    check.That(
      std::isinf(PointValue(block, "GeodesicDistance", 0)), "its points are infinitely far");
    // Executing again takes the structure that was kept.
    filter->SetSourceData(PointSources({ { 1, 0, 0 } }));
    messages.Update();
    check.Equal(LeavesOf(filter->GetOutputDataObject(0)).at(1)->GetNumberOfCells(), 0.0,
      "cells of a block of lines, again");
  }
}

void CheckPieces(Check& check)
{
  const auto filter = RefinedField(
    TwoSquares(Square(2), Moved(Square(2), MovedBy(1.0))), PointSources({ { 0, 0, 0 } }));
  filter->UpdatePiece(1, 2, 0);
  for (vtkPolyData* leaf : LeavesOf(filter->GetOutputDataObject(0)))
  {
    check.Equal(leaf->GetNumberOfPoints(), 0.0, "points of the second piece");
  }
  filter->UpdatePiece(0, 2, 0);
  CheckBlocks(
    check, filter->GetOutputDataObject(0), 3, DistanceTo({ { 0, 0, 0 } }), "the first piece");
}

}

int TestGeodesicComposite(int, char*[])
{
  Check check;
  CheckWarningsCountAllBlocks(check);
  CheckMultiBlock(check, false);
  CheckMultiBlock(check, true);
  CheckRefinedSeams(check);
  CheckKinds(check);
  CheckCompositeSource(check);
  CheckSeamsWithinRoundings(check, VTK_DOUBLE);
  CheckSeamsWithinRoundings(check, VTK_FLOAT);
  CheckCrackInOneBlock(check);
  CheckErrors(check);
  CheckBlockOfLines(check);
  CheckPieces(check);
  return check.Result();
}
