// SPDX-License-Identifier: BSD-3-Clause
// An array of the source names its parts (SourceIdArrayName): landmarks with labels, curves of many
// cells, regions. Equal values are one source. GEODESIC_TEST_SEEDS=FIRST,COUNT takes other random
// meshes.
#include "BarrierTesting.h"
#include "LineTesting.h"

#include "Seeds.h"
#include "truth/RandomMeshKinds.h"

#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkLongLongArray.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

using namespace GeodesicTesting;

namespace
{

using geodesictest::Random;

constexpr const char* Name = "label";

vtkSmartPointer<vtkDataArray> Labels(const std::vector<long long>& values)
{
  auto labels = vtkSmartPointer<vtkLongLongArray>::New();
  labels->SetName(Name);
  for (const long long value : values)
  {
    labels->InsertNextValue(value);
  }
  return labels;
}

vtkSmartPointer<vtkPolyData> Landmarks(
  const std::vector<Point>& points, const std::vector<long long>& labels)
{
  auto source = PointSources(points);
  source->GetPointData()->AddArray(Labels(labels));
  return source;
}

vtkSmartPointer<vtkPolyData> LabelledLines(
  const std::vector<Segment>& lines, const std::vector<long long>& labels)
{
  auto source = LinesOf(lines);
  source->GetCellData()->AddArray(Labels(labels));
  return source;
}

double LengthTo(const Point& p, const std::vector<Point>& line)
{
  return DistanceTo(line)(p);
}

//------------------------------------------------------------------------------
/// Every point has the label of the nearest landmark, whatever the size of the labels.
void CheckLandmarks(Check& check)
{
  const std::vector<Point> points = { { 0.1, 0.2, 0 }, { 0.9, 0.1, 0 }, { 0.2, 0.9, 0 },
    { 0.8, 0.75, 0 }, { 0.45, 0.5, 0 } };
  const std::vector<long long> labels = { 7, 614454277, 7, 9007199254740990, 0 };
  const auto filter = RefinedField(Square(16), Landmarks(points, labels));
  filter->SetSourceIdArrayName(Name);
  filter->GenerateSourceIdsOn();
  filter->GenerateSourceAngleOn();
  RunWithoutError(check, filter, "landmarks");
  vtkDataArray* ids = filter->GetOutput()->GetPointData()->GetArray("SourceId");
  for (vtkIdType i = 0; ids && i < ids->GetNumberOfTuples(); ++i)
  {
    const Point p = PointAt(filter->GetOutput(), i);
    double least = 2.0;
    double ofLabel = 2.0;
    for (std::size_t k = 0; k < points.size(); ++k)
    {
      const double distance = LengthTo(p, { points[k] });
      least = std::min(least, distance);
      ofLabel =
        static_cast<double>(labels[k]) == ids->GetTuple1(i) ? std::min(ofLabel, distance) : ofLabel;
    }
    check.That(ofLabel <= least + 1e-12, "the label is that of a nearest landmark");
  }
  vtkFieldData* data = filter->GetOutput()->GetFieldData();
  check.That(NumbersOf(data->GetArray("SourceFrameId")) ==
        std::vector<double>{ 0.0, 7.0, 614454277.0, 9007199254740990.0 } &&
      data->GetArray("SourceFrame")->GetNumberOfTuples() == 4,
    "each label has one frame");
  check.That(NumbersOf(OutputOf(filter, 1)->GetCellData()->GetArray("SourceId")) ==
      std::vector<double>(labels.begin(), labels.end()),
    "the labels of points on the surface");
}

/// Two curves of many cells that cross and share cells' ends; a line of one value ends where
/// another value begins.
void CheckCurves(Check& check)
{
  const std::vector<Point> first = { { 0.1, 0.15, 0 }, { 0.3, 0.3, 0 }, { 0.5, 0.5, 0 },
    { 0.7, 0.4, 0 }, { 0.9, 0.6, 0 } };
  const std::vector<Point> second = { { 0.2, 0.8, 0 }, { 0.4, 0.6, 0 }, { 0.5, 0.5, 0 },
    { 0.6, 0.2, 0 } };
  std::vector<Segment> lines;
  std::vector<long long> labels;
  for (std::size_t i = 0; i < 4; ++i)
  {
    lines.push_back({ first[i], first[i + 1] });
    labels.push_back(40);
    if (i < 3)
    {
      lines.push_back({ second[i], second[i + 1] });
      labels.push_back(30);
    }
  }
  lines.push_back({ first[4], { 0.95, 0.9, 0 } });
  labels.push_back(50);
  const auto source = LabelledLines(lines, labels);
  const auto filter = PlainField(Square(16), source);
  filter->SetSourceIdArrayName(Name);
  filter->GenerateSourceIdsOn();
  filter->GenerateSourceArcLengthOn();
  filter->SetSourceTypeToCurveAndBoundary();
  filter->Update();
  vtkPolyData* curves = OutputOf(filter, 1);
  check.Equal(curves->GetNumberOfLines(), 4.0, "curves of three labels");
  check.That(NumbersOf(curves->GetCellData()->GetArray("SourceId")) ==
      std::vector<double>{ 40.0, 30.0, 50.0, 51.0 },
    "their labels, by their lowest cells");
  check.That(std::abs(PointValue(curves, "SourceArcLength", 0)) == 0.0, "arc lengths begin at 0");

  const auto matrix = FilterOn<vtkGeodesicDistanceMatrix>(Square(16), source);
  matrix->SetTargetsData(Square(4));
  matrix->SetSourceIdArrayName(Name);
  matrix->Update();
  check.Equal(matrix->GetOutput()->GetNumberOfColumns(), 4.0, "columns");
  const auto targets = Square(4);
  const std::vector<std::pair<const char*, std::vector<Point>>> truths = { { "Source30", second },
    { "Source40", first }, { "Source50", { first[4], { 0.95, 0.9, 0 } } } };
  for (const auto& [column, line] : truths)
  {
    auto* values = vtkDataArray::SafeDownCast(matrix->GetOutput()->GetColumnByName(column));
    check.That(values, std::string("a column ") + column);
    for (vtkIdType i = 0; values && i < values->GetNumberOfTuples(); ++i)
    {
      const Point p = PointAt(targets, i);
      check.Near(values->GetTuple1(i), LengthTo(p, line), 1e-12,
        std::string(column) + " is the distance from all lines of that label");
    }
  }

  const auto paths = FilterOn<vtkGeodesicPaths>(Square(16), source);
  paths->SetTargetsData(targets);
  paths->SetSourceIdArrayName(Name);
  paths->Update();
  vtkCellData* ofPaths = paths->GetOutput()->GetCellData();
  for (vtkIdType i = 0; i < paths->GetOutput()->GetNumberOfLines(); ++i)
  {
    const Point p =
      PointAt(targets, static_cast<vtkIdType>(ofPaths->GetArray("TargetId")->GetTuple1(i)));
    double ofLabel = 2.0;
    for (const auto& [column, line] : truths)
    {
      ofLabel = std::string("Source") +
            std::to_string(static_cast<int>(ofPaths->GetArray("SourceId")->GetTuple1(i))) ==
          column
        ? LengthTo(p, line)
        : ofLabel;
    }
    check.Near(ofPaths->GetArray("GeodesicDistance")->GetTuple1(i), ofLabel, 1e-12,
      "a path ends on the curve with its label");
  }
}

//------------------------------------------------------------------------------
/// A column between regions is the least of the columns of their points, in any data set.
void CheckRegions(Check& check)
{
  const geodesictest::Seeds seeds = geodesictest::seedsOfTest(3);
  for (const geodesictest::MeshKind& kind : geodesictest::meshKinds())
  {
    for (std::uint64_t seed = seeds.first; seed < seeds.end(); ++seed)
    {
      const std::string what = std::string(kind.name) + ", seed " + std::to_string(seed);
      Random random(seed);
      const geodesictest::PlainMesh mesh = kind.make(random.between(30, 120), random);
      std::vector<Point> points;
      std::vector<long long> labels;
      for (int i = 0; i < 12; ++i)
      {
        points.push_back(geodesictest::position(mesh, geodesictest::randomPoint(mesh, random)));
        labels.push_back(random.chance(0.3) ? 5 : random.between(0, 3));
      }
      const auto half = static_cast<std::ptrdiff_t>(random.between(1, 11));
      const auto blocks = Blocks({ Landmarks({ points.begin(), points.begin() + half },
                                     { labels.begin(), labels.begin() + half }),
        vtkNew<vtkPolyData>(),
        Landmarks(
          { points.begin() + half, points.end() }, { labels.begin() + half, labels.end() }) });
      const auto surface = Mesh(mesh.points, mesh.triangles);
      const auto named = FilterOn<vtkGeodesicDistanceMatrix>(surface, blocks);
      const auto single = FilterOn<vtkGeodesicDistanceMatrix>(surface, blocks);
      named->SetSourceIdArrayName(Name);
      RunWithoutError(check, named, what);
      single->Update();
      for (const long long label : std::set<long long>(labels.begin(), labels.end()))
      {
        const std::string column = "Source" + std::to_string(label);
        auto* values =
          vtkDataArray::SafeDownCast(named->GetOutput()->GetColumnByName(column.c_str()));
        check.That(values, what + ": a column " + column);
        for (vtkIdType row = 0; values && row < values->GetNumberOfTuples(); ++row)
        {
          double least = std::numeric_limits<double>::infinity();
          for (std::size_t k = 0; k < labels.size(); ++k)
          {
            least = labels[k] == label
              ? std::min(least,
                  single->GetOutput()->GetValue(row, static_cast<vtkIdType>(k) + 1).ToDouble())
              : least;
          }
          check.That(values->GetTuple1(row) == least ||
              std::abs(values->GetTuple1(row) - least) < 1e-12 * (1.0 + least),
            what + ": the distance from a region is that from its nearest point");
        }
      }
    }
  }
}

/// A grid's cells have numbers of their own: dropped ones count.
void CheckGrid(Check& check)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(
    PointSources({ { 0.1, 0.1, 0 }, { 0.2, 0.3, 0 }, { 0.8, 0.8, 0 }, { 0.9, 0.2, 0 } })
      ->GetPoints());
  const std::array<vtkIdType, 4> ids = { 0, 1, 2, 3 };
  grid->InsertNextCell(VTK_QUADRATIC_EDGE, 3, ids.data());
  grid->InsertNextCell(VTK_LINE, 2, ids.data());
  grid->InsertNextCell(VTK_VERTEX, 1, ids.data() + 3);
  grid->InsertNextCell(VTK_VERTEX, 1, ids.data() + 2);
  grid->GetCellData()->AddArray(Labels({ -1, 12, 10, 12 }));
  const auto matrix = FilterOn<vtkGeodesicDistanceMatrix>(Square(8), grid);
  matrix->SetSourceIdArrayName(Name);
  RunWithoutError(check, matrix, "a grid");
  vtkTable* table = matrix->GetOutput();
  check.That(ColumnsOf(table) == std::vector<std::string>{ "TargetId", "Source10", "Source12" },
    "a grid's columns");
  check.Equal(table->GetValue(2, 2).ToDouble(), 0.0, "a vertex and a line of one label");
}

//------------------------------------------------------------------------------
void CheckError(Check& check, vtkDataObject* source, const std::vector<std::string>& words)
{
  const auto filter = PlainField(Square(4), source);
  filter->SetSourceIdArrayName(Name);
  Messages messages(filter);
  messages.ExpectError(check, words, "a bad array of ids");
  CheckOutputsEmpty(check, filter, "a bad array of ids");
  filter->SetSourceIdArrayName("None");
  messages.ExpectNoError(check, "without the array");
}

void CheckErrors(Check& check)
{
  const std::vector<Point> points = { { 0.1, 0.2, 0 }, { 0.9, 0.1, 0 } };
  CheckError(check, PointSources(points),
    { "The source (input port 1) has no point array named label", "SourceIdArrayName" });
  auto line = Polyline(points);
  line->GetPointData()->AddArray(Labels({ 1, 2 }));
  CheckError(check, line, { "has no cell array named label", "but a point array named label" });
  const auto blocks = Blocks({ Landmarks(points, { 1, 2 }), Polyline(points) });
  CheckError(
    check, blocks, { "Block 2 of the source (input port 1) has no cell array named label" });
  CheckError(check, Landmarks(points, { 4, -3 }),
    { "Point 1 of the source (input port 1) has a negative value" });
  CheckError(check, LabelledLines({ { points[0], points[1] } }, { 9007199254740992 }),
    { "Cell 0 of the source (input port 1) has a value that is too large" });
  CheckError(check, Landmarks(points, { 4 }), { "has 1 values for 2 points" });
  auto pairs = PointSources(points);
  AddArray<vtkIntArray>(pairs->GetPointData(), Name, { 1, 1, 1, 1 })->SetNumberOfComponents(2);
  CheckError(check, pairs, { "has 2 components" });
  auto real = PointSources(points);
  auto* numbers = AddArray<vtkDoubleArray>(real->GetPointData(), Name, { 1.5, 1.5 });
  CheckError(check, real,
    { "is a vtkDoubleArray with a value that is no whole number, where whole numbers are needed" });
  numbers->Fill(std::numeric_limits<double>::quiet_NaN());
  CheckError(check, real, { "is a vtkDoubleArray with a value that is no whole number" });
  numbers->Fill(1e300);
  CheckError(check, real, { "Point 0 of the source (input port 1) has a value that is too large" });
  auto text = PointSources(points);
  vtkNew<vtkStringArray> words;
  words->SetName(Name);
  words->SetNumberOfValues(2);
  text->GetPointData()->AddArray(words);
  CheckError(check, text, { "is a vtkStringArray" });
}

/// As ParaView's calculator makes them.
void CheckWholeNumbers(Check& check)
{
  auto source = PointSources({ { 0.1, 0.2, 0 }, { 0.9, 0.1, 0 } });
  AddArray<vtkDoubleArray>(source->GetPointData(), Name, { 7.0, 4.0 });
  const auto matrix = FilterOn<vtkGeodesicDistanceMatrix>(Square(4), source);
  matrix->SetSourceIdArrayName(Name);
  RunWithoutError(check, matrix, "whole numbers");
  vtkTable* table = matrix->GetOutput();
  for (const int id : { 4, 7 })
  {
    vtkAbstractArray* column = table->GetColumnByName(("Source" + std::to_string(id)).c_str());
    check.That(column && column->GetVariantValue(id == 7 ? 0 : 1).ToDouble() == 0.0,
      "the column of a whole number");
  }
}

/// If the boundary is the source, the array does not matter.
void CheckBoundary(Check& check)
{
  const auto filter = PlainField(Square(4), PointSources({ { 0.1, 0.2, 0 } }));
  filter->SetSourceIdArrayName(Name);
  filter->SetSourceTypeToSurfaceBoundary();
  filter->GenerateSourceIdsOn();
  RunWithoutError(check, filter, "the boundary");
  check.Equal(PointValue(filter->GetOutput(), "SourceId", 0), 0.0, "the boundary's id");
}

}

int TestGeodesicSourceNames(int, char*[])
{
  Check check;
  CheckLandmarks(check);
  CheckCurves(check);
  CheckRegions(check);
  CheckGrid(check);
  CheckErrors(check);
  CheckWholeNumbers(check);
  CheckBoundary(check);
  return check.Result();
}
