// SPDX-License-Identifier: BSD-3-Clause
// Names of the matrix's columns (SourceNameArrayName) and rows (TargetNameArrayName), and from
// which side it is solved.
#include "GeodesicTesting.h"
#include "LineTesting.h"

#include "vtkDoubleArray.h"
#include "vtkGeodesicDistanceMatrix.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkSignedCharArray.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <sstream>

using namespace GeodesicTesting;

namespace
{

constexpr const char* Name = "label";

using Words = std::vector<std::string>;

vtkSmartPointer<vtkAbstractArray> Strings(const Words& values)
{
  const auto array = vtkSmartPointer<vtkStringArray>::New();
  array->SetName(Name);
  for (const std::string& value : values)
  {
    array->InsertNextValue(value);
  }
  return array;
}

template <typename Array>
vtkSmartPointer<vtkAbstractArray> Numbers(const std::vector<int>& values, int components = 1)
{
  const auto array = vtkSmartPointer<Array>::New();
  array->SetName(Name);
  array->SetNumberOfComponents(components);
  for (const int value : values)
  {
    array->InsertNextValue(static_cast<typename Array::ValueType>(value));
  }
  return array;
}

/// Points along a diagonal, with an array.
vtkSmartPointer<vtkPolyData> Landmarks(int count, vtkAbstractArray* array)
{
  std::vector<Point> points;
  for (int i = 0; i < count; ++i)
  {
    points.push_back({ 0.1 + 0.8 * i / count, 0.2 + 0.7 * i / count, 0.0 });
  }
  auto data = PointSources(points);
  data->GetPointData()->AddArray(array);
  return data;
}

vtkSmartPointer<vtkGeodesicDistanceMatrix> MatrixOf(
  vtkDataObject* source, vtkDataObject* targets = nullptr)
{
  auto matrix = vtkSmartPointer<vtkGeodesicDistanceMatrix>::New();
  matrix->SetInputData(Square(4));
  matrix->SetSourceData(source);
  matrix->SetTargetsData(targets);
  matrix->SetSourceNameArrayName(Name);
  return matrix;
}

std::string Joined(const Words& words)
{
  std::string text;
  for (const std::string& word : words)
  {
    text += "[" + word + "]";
  }
  return text;
}

/// Checks the columns behind TargetId.
void CheckColumns(
  Check& check, vtkGeodesicDistanceMatrix* matrix, const Words& expected, const std::string& what)
{
  RunWithoutError(check, matrix, what);
  Words all = { "TargetId" };
  all.insert(all.end(), expected.begin(), expected.end());
  const Words columns = ColumnsOf(matrix->GetOutput());
  check.That(columns == all, what + ": " + Joined(columns) + " for " + Joined(all));
}

void CheckTargetNames(Check& check, vtkTable* table, const Words& expected, const std::string& what)
{
  auto* names = vtkStringArray::SafeDownCast(table->GetColumnByName("TargetName"));
  check.That(names && names == table->GetColumn(1), what + ": TargetName comes second");
  Words found;
  for (vtkIdType i = 0; names && i < names->GetNumberOfValues(); ++i)
  {
    found.push_back(names->GetValue(i));
  }
  check.That(found == expected, what + ": " + Joined(found) + " for " + Joined(expected));
}

void CheckPoints(Check& check)
{
  const auto matrix = MatrixOf(Landmarks(3, Strings({ "Cz", "left ear", "Pz" })));
  CheckColumns(check, matrix, { "Cz", "left ear", "Pz" }, "strings");
  const auto numbers = Landmarks(3, Numbers<vtkIntArray>({ 10, -7, 0 }));
  CheckColumns(check, MatrixOf(numbers), { "10", "-7", "0" }, "numbers");
  const auto bytes = Landmarks(2, Numbers<vtkSignedCharArray>({ 65, -1 }));
  CheckColumns(check, MatrixOf(bytes), { "65", "-1" }, "bytes are numbers");
  const auto twice = Landmarks(7, Strings({ "Cz", "Cz", "", "TargetId", "Cz_4", "Cz", "Source6" }));
  CheckColumns(check, MatrixOf(twice),
    { "Cz", "Cz_1", "Source2", "TargetId_3", "Cz_4", "Cz_5", "Source6" }, "names are unique");
  CheckColumns(check, MatrixOf(Landmarks(3, Strings({ "a", "a_2", "a" }))), { "a", "a_2", "a_2_2" },
    "names are unique with their numbers, too");
  matrix->SetSourceNameArrayName("None");
  CheckColumns(check, matrix, { "Source0", "Source1", "Source2" }, "none");
  matrix->SetSourceNameArrayName(nullptr);
  CheckColumns(check, matrix, { "Source0", "Source1", "Source2" }, "null");
}

/// Cells have names of their own, also those that are joined, without points or of one id, and
/// loops of the boundary have none.
void CheckCells(Check& check)
{
  const std::vector<Segment> lines = { Segment{ Point{ 0.1, 0.1, 0 }, Point{ 0.2, 0.1, 0 } },
    Segment{ Point{ 0.5, 0.5, 0 }, Point{ 0.6, 0.5, 0 } },
    Segment{ Point{ 0.2, 0.1, 0 }, Point{ 0.3, 0.1, 0 } } };
  auto source = LinesOf(lines);
  source->GetCellData()->AddArray(Strings({ "first", "second", "third" }));
  AddArray<vtkIntArray>(source->GetCellData(), "ids", { 8, 4, 4 });
  const auto matrix = MatrixOf(source);
  matrix->SetSourceTypeToCurveAndBoundary();
  CheckColumns(check, matrix, { "first", "second", "Source3" }, "joined lines");
  matrix->JoinLinesOff();
  CheckColumns(check, matrix, { "first", "second", "third", "Source3" }, "lines");
  matrix->SetSourceIdArrayName("ids");
  CheckColumns(check, matrix, { "second", "first", "Source9" }, "lines of one id");
  matrix->SetSourceTypeToSurfaceBoundary();
  CheckColumns(check, matrix, { "Source0" }, "the boundary alone");

  const auto blocks =
    Blocks({ Landmarks(2, Strings({ "a", "b" })), vtkNew<vtkPolyData>(), source });
  CheckColumns(check, MatrixOf(blocks), { "a", "b", "first", "second" }, "blocks");
}

void CheckTargets(Check& check)
{
  const auto points = Landmarks(3, Strings({ "Cz", "Cz", "" }));
  const auto matrix = MatrixOf(points);
  matrix->SetTargetNameArrayName(Name);
  CheckColumns(check, matrix, { "TargetName", "Cz", "Cz_1", "Source2" }, "targets of the source");
  CheckTargetNames(check, matrix->GetOutput(), { "Cz", "Cz", "" }, "targets of the source");
  matrix->SetSourceTypeToSurfaceBoundary();
  CheckColumns(check, matrix, { "TargetName", "Source0" }, "the points are no source");

  const auto blocks = Blocks({ Landmarks(2, Numbers<vtkIntArray>({ 5, 6 })), vtkNew<vtkPolyData>(),
    Landmarks(1, Strings({ "c" })) });
  const auto ofBlocks = MatrixOf(points, blocks);
  ofBlocks->SetTargetNameArrayName(Name);
  CheckColumns(check, ofBlocks, { "TargetName", "Cz", "Cz_1", "Source2" }, "blocks");
  CheckTargetNames(check, ofBlocks->GetOutput(), { "5", "6", "c" }, "blocks");
}

void CheckTargetPositions(Check& check)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  const std::vector<Point> places = { { 0.25, 0.5, 0 }, { 0.5, 0.125, 0 }, { 0.75, 1, 0.0625 } };
  blocks->SetBlock(0, PointSources({ places[0], places[1] }));
  blocks->SetBlock(1, vtkNew<vtkPolyData>());
  blocks->SetBlock(2, PointSources({ places[2] }));
  const auto one = PointSources({ { 0.5, 0.5, 0 } });
  for (const auto& matrix : { MatrixOf(blocks), MatrixOf(one, blocks) })
  {
    matrix->SetSourceNameArrayName(nullptr);
    matrix->GenerateTargetPositionsOn();
    matrix->Update();
    vtkTable* table = matrix->GetOutput();
    auto* positions = vtkDataArray::SafeDownCast(table->GetColumnByName("TargetPosition"));
    check.That(positions && positions == table->GetColumn(1), "TargetPosition comes second");
    check.Equal(table->GetNumberOfRows(), 3.0, "three targets");
    for (vtkIdType i = 0; positions && i < 3; ++i)
    {
      const Point p = TupleAt(positions, i);
      check.That(p == places[static_cast<std::size_t>(i)], "a target is where it was");
    }
  }
  const auto without = MatrixOf(PointSources(places));
  without->SetSourceNameArrayName(nullptr);
  CheckColumns(check, without, { "Source0", "Source1", "Source2" }, "off by default");
  CheckColumns(check, MatrixOf(Landmarks(1, Strings({ "TargetPosition" }))), { "TargetPosition_0" },
    "a landmark with the name of the column");
}

void CheckError(Check& check, vtkGeodesicDistanceMatrix* matrix, const Words& words)
{
  Messages(matrix).ExpectError(check, words, "a bad array of names");
  check.Equal(matrix->GetOutput()->GetNumberOfColumns(), 0.0, "the output is empty");
}

void CheckErrors(Check& check)
{
  const auto good = Landmarks(2, Strings({ "a", "b" }));
  const auto unnamed = PointSources({ { 0.5, 0.5, 0 } });
  CheckError(check, MatrixOf(unnamed),
    { "The source (input port 1) has no point array named label, by which SourceNameArrayName" });
  auto ofCells = PointSources({ { 0.5, 0.5, 0 }, { 0.7, 0.5, 0 } });
  ofCells->GetCellData()->AddArray(Strings({ "a", "b" }));
  CheckError(check, MatrixOf(ofCells), { "but a cell array named label" });
  CheckError(check, MatrixOf(Landmarks(2, Numbers<vtkDoubleArray>({ 1, 2 }))),
    { "is a vtkDoubleArray, where strings or whole numbers are needed" });
  CheckError(check, MatrixOf(Landmarks(2, Numbers<vtkIntArray>({ 1, 2, 3, 4 }, 2))),
    { "(SourceNameArrayName)", "has 2 components" });
  CheckError(check, MatrixOf(Landmarks(2, Strings({ "a" }))), { "has 1 values for 2 points" });
  const auto matrix = MatrixOf(good, unnamed);
  matrix->SetTargetNameArrayName(Name);
  CheckError(check, matrix,
    { "The set of targets (input port 2) has no point array named label, by which "
      "TargetNameArrayName names its points" });
  matrix->SetTargetNameArrayName("");
  CheckColumns(check, matrix, { "a", "b" }, "after an error");
  std::ostringstream printed;
  matrix->Print(printed);
  check.That(Contains(printed.str(), "SourceNameArrayName: label"), "PrintSelf tells the name");
}

/// Many points as sources of few targets are solved from the targets: the table has the bits of the
/// one in which these are the sources.
void CheckFewTargets(Check& check)
{
  const auto surface = WavySphere(30, 20);
  const auto some = [&](int first, int step)
  {
    std::vector<Point> points;
    for (vtkIdType i = first; i < surface->GetNumberOfPoints(); i += step)
    {
      surface->GetPoint(i, points.emplace_back().data());
    }
    return PointSources(points);
  };
  const auto many = some(0, 23);
  const auto few = some(7, 301);
  const auto there = MatrixOf(many, few);
  const auto back = MatrixOf(few, many);
  for (const auto& matrix : { there, back })
  {
    matrix->SetInputData(surface);
    matrix->SetSourceNameArrayName(nullptr);
    matrix->Update();
  }
  for (vtkIdType i = 0; i < many->GetNumberOfPoints(); ++i)
  {
    for (vtkIdType k = 0; k < few->GetNumberOfPoints(); ++k)
    {
      check.Equal(there->GetOutput()->GetValue(k, i + 1).ToDouble(),
        back->GetOutput()->GetValue(i, k + 1).ToDouble(), "solved from the same side");
    }
  }
}

}

int TestGeodesicMatrixNames(int, char*[])
{
  Check check;
  CheckPoints(check);
  CheckCells(check);
  CheckTargets(check);
  CheckTargetPositions(check);
  CheckErrors(check);
  CheckFewTargets(check);
  return check.Result();
}
