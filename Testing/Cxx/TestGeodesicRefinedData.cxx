// SPDX-License-Identifier: BSD-3-Clause
// What the input knows at its points and cells is carried over to the refined surface: numbers are
// interpolated, strings and ids taken from the nearest corner, ghosts stay ghosts.
#include "GeodesicTesting.h"

#include "vtkBitArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

using namespace GeodesicTesting;

namespace
{

const std::vector<Point> Line = { { 0.1, 0.2, 0 }, { 0.7, 0.35, 0 }, { 0.65, 0.9, 0 } };

template <typename Array>
vtkSmartPointer<Array> Named(const char* name, vtkIdType tuples, int components = 1)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  return array;
}

void AddPointData(vtkPolyData* surface)
{
  const vtkIdType count = surface->GetNumberOfPoints();
  const auto heat = Named<vtkFloatArray>("Heat", count);
  const auto flow = Named<vtkDoubleArray>("Flow", count, 3);
  const auto rank = Named<vtkIntArray>("Rank", count);
  const auto label = Named<vtkStringArray>("Label", count);
  const auto id = Named<vtkIdTypeArray>("Id", count);
  const auto bit = Named<vtkBitArray>("Bit", count);
  const auto global = Named<vtkIdTypeArray>("Global", count);
  const auto pedigree = Named<vtkIntArray>("Pedigree", count);
  const auto ghost = Named<vtkUnsignedCharArray>(vtkDataSetAttributes::GhostArrayName(), count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const Point p = PointAt(surface, i);
    heat->SetValue(i, static_cast<float>(2.0 * p[0] + 3.0 * p[1]));
    flow->SetTuple3(i, p[0], p[1], 1.0);
    rank->SetValue(i, static_cast<int>(1000.0 * p[0]));
    label->SetValue(i, "point " + std::to_string(i));
    id->SetValue(i, 7 * i);
    bit->SetValue(i, static_cast<int>(i % 2));
    global->SetValue(i, i);
    pedigree->SetValue(i, static_cast<int>(11 * i));
    ghost->SetValue(i, p[0] > 0.6 ? vtkDataSetAttributes::DUPLICATEPOINT : 0);
  }
  for (vtkAbstractArray* array :
    std::initializer_list<vtkAbstractArray*>{ heat, flow, rank, label, id, bit, ghost })
  {
    surface->GetPointData()->AddArray(array);
  }
  surface->GetPointData()->SetGlobalIds(global);
  surface->GetPointData()->SetPedigreeIds(pedigree);
  surface->GetPointData()->SetActiveVectors("Flow");
}

void AddCellData(vtkPolyData* surface)
{
  const vtkIdType count = surface->GetNumberOfCells();
  const auto number = Named<vtkDoubleArray>("Number", count);
  const auto label = Named<vtkStringArray>("CellLabel", count);
  const auto global = Named<vtkIdTypeArray>("GlobalCell", count);
  const auto ghost = Named<vtkUnsignedCharArray>(vtkDataSetAttributes::GhostArrayName(), count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    number->SetValue(i, 0.5 * static_cast<double>(i));
    label->SetValue(i, "cell " + std::to_string(i));
    global->SetValue(i, i);
    ghost->SetValue(i, i % 3 == 0 ? vtkDataSetAttributes::DUPLICATECELL : 0);
  }
  surface->GetCellData()->AddArray(number);
  surface->GetCellData()->AddArray(label);
  surface->GetCellData()->SetGlobalIds(global);
  surface->GetCellData()->AddArray(ghost);
}

/// The input's point at the place that is nearest to a point of the cell, among the cell's corners.
vtkIdType Nearest(vtkPolyData* surface, vtkIdType cell, const Point& p, double& lead)
{
  const std::vector<vtkIdType> ids = IdsOf(surface->GetPolys(), cell);
  // In barycentric coordinates, since that is what interpolation uses.
  const std::vector<Point> c = PlacesOf(surface, ids);
  const auto area = [](const Point& a, const Point& b, const Point& d)
  { return (b[0] - a[0]) * (d[1] - a[1]) - (b[1] - a[1]) * (d[0] - a[0]); };
  std::array<std::pair<double, vtkIdType>, 3> weights;
  for (std::size_t k = 0; k < 3; ++k)
  {
    weights[k] = { area(c[(k + 1) % 3], c[(k + 2) % 3], p) / area(c[0], c[1], c[2]), ids[k] };
  }
  std::sort(weights.begin(), weights.end());
  lead = weights[2].first - weights[1].first;
  return weights[2].second;
}

void CheckPoint(Check& check, vtkPolyData* surface, vtkPolyData* output, vtkIdType cell,
  vtkIdType point, const std::string& name)
{
  vtkPointData* data = output->GetPointData();
  const Point p = PointAt(output, point);
  const auto value = [&](const char* array) { return data->GetArray(array)->GetTuple1(point); };
  check.That(std::abs(value("Heat") - 2.0 * p[0] - 3.0 * p[1]) < 1e-5, name + ": a float");
  const double* flow = data->GetArray("Flow")->GetTuple3(point);
  check.That(std::abs(flow[0] - p[0]) + std::abs(flow[1] - p[1]) + std::abs(flow[2] - 1.0) < 1e-12,
    name + ": a vector");
  check.Near(value("Rank"), 1000.0 * p[0], 0.5 + 1e-9, name + ": an integer");

  double lead = 0.0;
  const vtkIdType nearest = Nearest(surface, cell, p, lead);
  if (lead < 1e-9)
  {
    return; // two are as near
  }
  const auto* label = vtkStringArray::SafeDownCast(data->GetAbstractArray("Label"));
  check.That(
    const_cast<vtkStringArray*>(label)->GetValue(point) == "point " + std::to_string(nearest),
    name + ": a string");
  check.Equal(value("Id"), 7.0 * static_cast<double>(nearest), name + ": an id");
  check.Equal(value("Bit"), nearest % 2, name + ": a bit");
  check.Equal(value("Pedigree"), 11.0 * static_cast<double>(nearest), name + ": a pedigree id");
}

void CheckGhostPoint(Check& check, vtkPolyData* surface, vtkPolyData* output, vtkIdType cell,
  vtkIdType point, const std::string& name)
{
  vtkNew<vtkIdList> ids;
  surface->GetPolys()->GetCellAtId(cell, ids);
  const Point p = PointAt(output, point);
  bool all = true;
  bool any = false;
  for (vtkIdType k = 0; k < 3; ++k)
  {
    const bool ghost = surface->GetPoint(ids->GetId(k))[0] > 0.6;
    all = all && ghost;
    any = any || ghost;
  }
  const bool isGhost =
    output->GetPointData()->GetArray(vtkDataSetAttributes::GhostArrayName())->GetTuple1(point) ==
    1.0;
  check.That((isGhost || !all) && (any || !isGhost) && (!isGhost || p[0] > 0.6),
    name + ": a ghost among ghosts only");
}

void CheckCells(Check& check, vtkPolyData* output, vtkDataArray* originals, const std::string& name)
{
  vtkCellData* data = output->GetCellData();
  auto* labels = vtkStringArray::SafeDownCast(data->GetAbstractArray("CellLabel"));
  vtkDataArray* ghosts = data->GetArray(vtkDataSetAttributes::GhostArrayName());
  check.That(labels && ghosts && data->HasArray("Number"), name + ": cell data");
  check.That(!data->GetGlobalIds() && !data->HasArray("GlobalCell"), name + ": no global cell ids");
  for (vtkIdType cell = 0; labels && ghosts && cell < output->GetNumberOfCells(); ++cell)
  {
    const auto original = static_cast<vtkIdType>(originals->GetTuple1(cell));
    check.Equal(data->GetArray("Number")->GetTuple1(cell), 0.5 * static_cast<double>(original),
      name + ": a cell's number");
    check.That(
      labels->GetValue(cell) == "cell " + std::to_string(original), name + ": a cell's string");
    check.Equal(ghosts->GetTuple1(cell), original % 3 == 0 ? 1.0 : 0.0, name + ": a ghost cell");
  }
}

void CheckSurface(Check& check, vtkSmartPointer<vtkPolyData> surface, const std::string& name)
{
  AddPointData(surface);
  AddCellData(surface);
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(surface);
  const vtkMTimeType before = surface->GetMTime();
  const auto filter = RefinedField(surface, Polyline(Line));
  RunWithoutError(check, filter, name);
  check.That(surface->GetMTime() == before, name + ": the input is not modified");

  vtkPolyData* output = filter->GetOutput();
  vtkPointData* data = output->GetPointData();
  vtkDataArray* originals = output->GetCellData()->GetArray("OriginalCellIds");
  check.That(output->GetNumberOfPoints() > 2 * surface->GetNumberOfPoints(), name + ": new points");
  check.That(!data->GetGlobalIds() && !data->HasArray("Global"), name + ": no global ids");
  check.That(data->GetPedigreeIds() && data->GetVectors() == data->GetArray("Flow"),
    name + ": attributes stay attributes");
  check.That(data->GetScalars() == Distances(filter), name + ": the distance is the scalars");
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    check.Equal(data->GetAbstractArray(i)->GetNumberOfTuples(), output->GetNumberOfPoints(),
      name + ": values of an array");
  }
  for (vtkIdType cell = 0; originals && cell < output->GetNumberOfCells(); ++cell)
  {
    for (const vtkIdType id : IdsOf(output->GetPolys(), cell))
    {
      const auto original = static_cast<vtkIdType>(originals->GetTuple1(cell));
      CheckPoint(check, copy, output, original, id, name);
      CheckGhostPoint(check, copy, output, original, id, name);
    }
  }
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    check.Equal(data->GetArray("Id")->GetTuple1(i), 7.0 * static_cast<double>(i),
      name + ": a value of the input's points");
  }
  CheckCells(check, output, originals, name);
}

void CheckArrayOfOriginals(Check& check)
{
  auto surface = Square(2);
  const auto mine = Named<vtkDoubleArray>("OriginalCellIds", surface->GetNumberOfCells());
  mine->Fill(-1.0);
  surface->GetCellData()->AddArray(mine);
  const auto filter = RefinedField(surface, Polyline(Line));
  Messages(filter).ExpectWarning(check, { "already has a cell array named OriginalCellIds" },
    "an existing array of cells is told");
  check.That(
    surface->GetCellData()->GetArray("OriginalCellIds") == mine.Get(), "the input keeps it");
  vtkDataArray* originals = filter->GetOutput()->GetCellData()->GetArray("OriginalCellIds");
  check.Equal(originals->GetRange()[1], 7.0, "the last original cell");
}

// Without refinement the triangles of one polygon would share its global id, too.
void CheckGlobalIdsOfPolygons(Check& check)
{
  for (const Cells cells : { Cells::Triangles, Cells::Quads })
  {
    const auto surface = Square(2, cells);
    AddCellData(surface);
    const auto filter = PlainField(surface, Polyline(Line));
    filter->Update();
    const bool areCellsKept = cells == Cells::Triangles;
    check.That((filter->GetOutput()->GetCellData()->GetGlobalIds() != nullptr) == areCellsKept,
      areCellsKept ? "triangles keep global ids" : "the triangles of quads have no global ids");
  }
}

}

int TestGeodesicRefinedData(int, char*[])
{
  Check check;
  CheckSurface(check, Square(4), "a square");
  CheckSurface(check, Soup(Square(4)), "soup");
  CheckArrayOfOriginals(check);
  CheckGlobalIdsOfPolygons(check);
  return check.Result();
}
