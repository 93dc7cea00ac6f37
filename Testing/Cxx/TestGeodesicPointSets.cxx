// SPDX-License-Identifier: BSD-3-Clause
// Data sets other than curves as sources and targets: vertex cells only are a set of points, grids
// give their vertices and lines, any other data with points its points.
#include "GeodesicTesting.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkGeodesicContour.h"
#include "vtkGeodesicDistanceMatrix.h"
#include "vtkGeodesicPaths.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPointSet.h"
#include "vtkStructuredGrid.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

using namespace GeodesicTesting;

namespace
{

const std::vector<Point> FourPoints = { { 0.1, 0.2, 0 }, { 0.9, 0.7, 0 }, { 0.4, 0.35, 0 },
  { 0.2, 0.8, 0 } };

using CellsOfPoints = std::vector<std::vector<vtkIdType>>;

vtkSmartPointer<vtkPolyData> WithVertices(
  const std::vector<Point>& positions, const CellsOfPoints& cells)
{
  auto data = PointSources(positions);
  data->SetVerts(CellArray(cells));
  return data;
}

struct GridCell
{
  int Type;
  std::vector<vtkIdType> Points;
};

vtkSmartPointer<vtkUnstructuredGrid> Grid(
  const std::vector<Point>& positions, const std::vector<GridCell>& cells)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(PointSources(positions)->GetPoints());
  for (const GridCell& cell : cells)
  {
    grid->InsertNextCell(cell.Type, static_cast<vtkIdType>(cell.Points.size()), cell.Points.data());
  }
  return grid;
}

/// An index of points in the plane z = 0, as a curved grid has them.
vtkSmartPointer<vtkStructuredGrid> CurvedGrid()
{
  auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
  grid->SetDimensions(2, 2, 1);
  grid->SetPoints(PointSources(FourPoints)->GetPoints());
  return grid;
}

double Between(const Point& a, const Point& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

std::vector<vtkIdType> Ids(vtkDataArray* array)
{
  std::vector<vtkIdType> ids;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    ids.push_back(static_cast<vtkIdType>(array->GetTuple1(i)));
  }
  return ids;
}

/// Checks what all filters give for a source whose points are sources of their own.
///
/// \param ids of the sources.
/// \param positions of these.
void CheckPoints(Check& check, vtkDataObject* source, const std::vector<vtkIdType>& ids,
  const std::vector<Point>& positions, const std::string& what)
{
  const auto surface = Square(8);
  const auto field = PlainField(surface, source);
  field->GenerateSourceIdsOn();
  Messages(field).ExpectNothing(check, what);
  vtkDataArray* nearest = field->GetOutput()->GetPointData()->GetArray("SourceId");
  for (vtkIdType i = 0; nearest && i < surface->GetNumberOfPoints(); ++i)
  {
    const Point p = PointAt(surface, i);
    const auto at = std::find(ids.begin(), ids.end(), vtkIdType(nearest->GetTuple1(i)));
    const bool isOne = at != ids.end();
    check.That(isOne, what + ": SourceId is that of a source");
    double least = 1e9;
    for (const Point& position : positions)
    {
      least = std::min(least, Between(p, position));
    }
    check.Near(Distances(field)->GetTuple1(i), least, 1e-14, what + ": the distance");
    check.That(isOne && Between(p, positions[std::size_t(at - ids.begin())]) < least + 1e-14,
      what + ": SourceId is that of the nearest");
  }
  auto* curves = OutputOf(field, 1);
  check.That(Ids(curves->GetCellData()->GetArray("SourceId")) == ids, what + ": ids on port 1");

  const std::vector<Point> targets = { { 0.5, 0.5, 0 }, { 1, 0.25, 0 } };
  const auto matrix = FilterOn<vtkGeodesicDistanceMatrix>(surface, source);
  matrix->SetTargetsData(PointSources(targets));
  matrix->Update();
  vtkTable* table = matrix->GetOutput();
  check.Equal(double(table->GetNumberOfColumns()), double(ids.size() + 1), what + ": columns");
  for (std::size_t s = 0; s < ids.size(); ++s)
  {
    auto* column = vtkDoubleArray::SafeDownCast(
      table->GetColumnByName(("Source" + std::to_string(ids[s])).c_str()));
    for (std::size_t t = 0; t < targets.size(); ++t)
    {
      check.That(column &&
          std::abs(column->GetValue(vtkIdType(t)) - Between(targets[t], positions[s])) < 1e-14,
        what + ": the distance from source " + std::to_string(ids[s]));
    }
  }
  const auto paths = FilterOn<vtkGeodesicPaths>(surface, source);
  paths->SetTargetsData(PointSources(positions));
  paths->Update();
  check.That(Ids(paths->GetOutput()->GetCellData()->GetArray("SourceId")) == ids,
    what + ": each source is nearest to itself");
}

/// However points are given, they are the same sources.
void CheckSetsOfPoints(Check& check)
{
  const std::vector<vtkIdType> all = { 0, 1, 2, 3 };
  const auto expect = [&](vtkDataObject* source, const std::string& what)
  { CheckPoints(check, source, all, FourPoints, what); };
  expect(PointSources(FourPoints), "points without cells");
  expect(WithVertices(FourPoints, { { 0, 1, 2, 3 } }), "one poly-vertex");
  expect(WithVertices(FourPoints, { { 3 }, { 1 }, { 0 }, { 2 } }), "vertices in another order");
  expect(WithVertices(FourPoints, { { 3, 1, 0 }, {}, { 2, 3 } }), "vertices with points twice");
  expect(CurvedGrid(), "a structured grid");
  expect(Grid(FourPoints, {}), "an unstructured grid without cells");
  expect(Grid(FourPoints,
           { { VTK_VERTEX, { 2 } }, { VTK_POLY_VERTEX, { 0, 1 } }, { VTK_VERTEX, { 3 } } }),
    "an unstructured grid of vertices");
  vtkNew<vtkPointSet> points;
  points->SetPoints(PointSources(FourPoints)->GetPoints());
  expect(points, "a vtkPointSet");

  const auto blocks = Blocks(
    { WithVertices({ FourPoints[0], FourPoints[1] }, { { 0, 1 } }), vtkNew<vtkUnstructuredGrid>(),
      Grid({ FourPoints[2], FourPoints[3] }, { { VTK_POLY_VERTEX, { 0, 1 } } }) });
  expect(blocks, "blocks");
  vtkNew<vtkPartitionedDataSet> partitions;
  partitions->SetPartition(0, Grid(FourPoints, { { VTK_POLY_VERTEX, { 0, 1, 2, 3 } } }));
  expect(partitions, "a partitioned data set");
  CheckPoints(check, WithVertices(FourPoints, { { 3 }, { 1 } }), { 1, 3 },
    { FourPoints[1], FourPoints[3] }, "points that no vertex cell has are no sources");
}

/// The loops of the boundary are numbered after all points.
void CheckBoundaryAfterPoints(Check& check)
{
  const auto matrix =
    FilterOn<vtkGeodesicDistanceMatrix>(Square(4), WithVertices(FourPoints, { { 0, 2 } }));
  matrix->SetSourceTypeToCurveAndBoundary();
  matrix->Update();
  vtkTable* table = matrix->GetOutput();
  check.Equal(double(table->GetNumberOfRows()), 4.0, "all points are targets");
  check.Equal(double(table->GetNumberOfColumns()), 4.0, "points and the boundary: columns");
  auto* loop = vtkDoubleArray::SafeDownCast(table->GetColumnByName("Source4"));
  for (vtkIdType i = 0; i < 4; ++i)
  {
    const double truth = DistanceToBoundaryOfSquare(FourPoints[std::size_t(i)]);
    check.That(loop && std::abs(loop->GetValue(i) - truth) < 1e-15, "the boundary's column");
  }
}

/// Lines, vertices and other cells in any order: ids are those of the grid's cells.
vtkSmartPointer<vtkUnstructuredGrid> MixedGrid()
{
  return Grid({ { 0.1, 0.1, 0 }, { 0.1, 0.9, 0 }, { 0.5, 0.5, 0 }, { 0.9, 0.1, 0 }, { 0.9, 0.5, 0 },
                { 0.9, 0.9, 0 }, { 0.7, 0.5, 0 } },
    { { VTK_TETRA, { 0, 2, 6, 1 } }, { VTK_POLY_LINE, { 3, 4, 5 } }, { VTK_VERTEX, { 2 } },
      { VTK_EMPTY_CELL, {} }, { VTK_LINE, { 0, 1 } }, { VTK_POLY_VERTEX, { 6 } } });
}

void CheckLinesOfGrids(Check& check)
{
  const auto surface = Square(8);
  const auto field = RefinedField(surface, MixedGrid());
  field->GenerateSourceIdsOn();
  Messages(field).ExpectWarning(
    check, { "1 cell of the source left out" }, "a solid in a grid is told");
  const std::vector<std::pair<vtkIdType, Distance>> parts = {
    { 1, DistanceTo({ { 0.9, 0.1, 0 }, { 0.9, 0.9, 0 } }) }, { 2, DistanceTo({ { 0.5, 0.5, 0 } }) },
    { 4, DistanceTo({ { 0.1, 0.1, 0 }, { 0.1, 0.9, 0 } }) }, { 5, DistanceTo({ { 0.7, 0.5, 0 } }) }
  };
  const auto truth = [&](const Point& p)
  {
    double least = 1e9;
    for (const auto& [id, distance] : parts)
    {
      least = std::min(least, distance(p));
    }
    return least;
  };
  CheckDistances(check, field, truth, "lines and vertices of a grid");
  vtkDataArray* nearest = field->GetOutput()->GetPointData()->GetArray("SourceId");
  for (vtkIdType i = 0; i < field->GetOutput()->GetNumberOfPoints(); ++i)
  {
    const Point p = PointAt(field->GetOutput(), i);
    const auto id = vtkIdType(nearest->GetTuple1(i));
    const auto part =
      std::find_if(parts.begin(), parts.end(), [id](const auto& one) { return one.first == id; });
    check.That(part != parts.end() && part->second(p) < truth(p) + 1e-14, "a cell of the grid");
  }
  auto* curves = OutputOf(field, 1);
  const std::vector<vtkIdType> vertices = { 2, 5, 1, 4 }; // then lines
  check.That(Ids(curves->GetCellData()->GetArray("SourceId")) == vertices, "a grid's ids, port 1");

  const auto matrix = FilterOn<vtkGeodesicDistanceMatrix>(surface, MixedGrid());
  matrix->SetTargetsData(PointSources({ { 0.5, 0.6, 0 } }));
  matrix->Update();
  check.Equal(
    double(matrix->GetOutput()->GetNumberOfColumns()), 5.0, "columns of a grid's sources");
  for (const auto& [id, distance] : parts)
  {
    auto* column = vtkDoubleArray::SafeDownCast(
      matrix->GetOutput()->GetColumnByName(("Source" + std::to_string(id)).c_str()));
    check.That(column && std::abs(column->GetValue(0) - distance({ 0.5, 0.6, 0 })) < 1e-15,
      "the column of a grid's cell");
  }

  const auto contour = FilterOn<vtkGeodesicContour>(
    surface, Grid({ { 0, 0.5, 0 }, { 1, 0.5, 0 } }, { { VTK_LINE, { 0, 1 } } }));
  contour->SetValue(0, 0.25);
  contour->Update();
  check.Equal(double(contour->GetOutput()->GetNumberOfLines()), 2.0, "lines beside a grid's line");
}

/// The points of any data are targets, whatever its cells are.
void CheckTargets(Check& check)
{
  const auto volume = Grid({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0.5, 0.5, 0 } },
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_VERTEX, { 0 } } });
  const auto paths = FilterOn<vtkGeodesicPaths>(Square(4), PointSources({ { 0, 0, 0 } }));
  const auto blocks = Blocks({ CurvedGrid(), volume });
  paths->SetTargetsData(blocks);
  Messages(paths).ExpectNothing(check, "grids of targets");
  check.That(Ids(paths->GetOutput()->GetCellData()->GetArray("TargetId")) ==
      std::vector<vtkIdType>{ 0, 1, 2, 3, 4, 5, 6, 7 },
    "grids of targets: ids");
  vtkDataArray* lengths = paths->GetOutput()->GetCellData()->GetArray("GeodesicDistance");
  for (vtkIdType i = 0; i < 4 && lengths; ++i)
  {
    check.Near(lengths->GetTuple1(i), Between(FourPoints[std::size_t(i)], { 0, 0, 0 }), 1e-14,
      "a structured grid of targets");
  }
}

/// One that keeps its precision is put onto the surface as a vtkPolyData is.
void CheckPrecision(Check& check)
{
  const auto surface = ChangedSphere(24, 16, [](const Point& p) { return p; });
  auto points = PointSources({}, VTK_FLOAT);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); i += 7)
  {
    points->GetPoints()->InsertNextPoint(surface->GetPoint(i));
  }
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(points->GetPoints());
  const auto field = PlainField(surface, grid);
  field->Update();
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); i += 7)
  {
    check.Equal(Distances(field)->GetTuple1(i), 0.0, "a rounded vertex is that vertex");
  }
}

void CheckWhatCannotBeUsed(Check& check)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 3, 3);
  const auto solid =
    Grid({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 1, 1, 1 } }, { { VTK_TETRA, { 0, 1, 2, 3 } } });
  const auto blocks = Blocks({ solid, image });
  const auto solids = Blocks({ solid, vtkNew<vtkUnstructuredGrid>() });
  struct Bad
  {
    vtkSmartPointer<vtkDataObject> Data;
    std::vector<std::string> Words;
  };
  const auto expect = [&](int port, const Bad& bad)
  {
    const auto paths = FilterOn<vtkGeodesicPaths>(Square(2), PointSources({ { 0, 0, 0 } }));
    paths->SetTargetsData(PointSources({ { 1, 1, 0 } }));
    paths->SetInputDataObject(port, bad.Data);
    Messages messages(paths);
    messages.Update();
    for (const std::string& word : bad.Words)
    {
      check.That(Contains(messages.Error(), word),
        "port " + std::to_string(port) + " says \"" + word + "\": " + messages.Error());
    }
    check.Equal(double(paths->GetOutput()->GetNumberOfPoints()), 0.0, "no points after an error");
  };
  for (const int port : { 1, 2 })
  {
    const std::string name = "input port " + std::to_string(port);
    expect(port, { image.Get(), { name, "vtkImageData", "no points of its own" } });
    expect(port, { blocks.Get(), { name, "Block 2", "vtkImageData", "Extract Surface" } });
    expect(port, { vtkNew<vtkTable>().Get(), { name, "vtkTable", "Table To Points" } });
    expect(port, { vtkNew<vtkUnstructuredGrid>().Get(), { name, "empty" } });
  }
  const std::vector<std::string> words = { "input port 1", "no vertex, line or flat face",
    "1 cells", "Extract Surface", "Extract Selection" };
  expect(1, { solid, words });
  expect(1, { solids.Get(), words });
}

}

int TestGeodesicPointSets(int, char*[])
{
  Check check;
  CheckSetsOfPoints(check);
  CheckBoundaryAfterPoints(check);
  CheckLinesOfGrids(check);
  CheckTargets(check);
  CheckPrecision(check);
  CheckWhatCannotBeUsed(check);
  return check.Result();
}
