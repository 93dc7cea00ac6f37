// SPDX-License-Identifier: BSD-3-Clause
// Cell arrays whose offsets cannot be those of cells, as a broken file or script makes them: an
// error names the cell. What can be read, however odd, is read as the same cells elsewhere.
#include "GeodesicTesting.h"

#include "vtkCellData.h"
#include "vtkGeodesicPaths.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <cstdlib>

using namespace GeodesicTesting;

namespace
{

/// What is in a cell array.
struct Arrays
{
  std::vector<vtkIdType> Offsets;
  std::vector<vtkIdType> Ids;
};

template <typename Array>
vtkSmartPointer<Array> ArrayOf(const std::vector<vtkIdType>& values)
{
  auto array = vtkSmartPointer<Array>::New();
  for (const vtkIdType value : values)
  {
    array->InsertNextValue(static_cast<typename Array::ValueType>(value));
  }
  return array;
}

vtkSmartPointer<vtkCellArray> CellsOf(const Arrays& arrays, bool isWide)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  if (isWide)
  {
    cells->SetData(
      ArrayOf<vtkTypeInt64Array>(arrays.Offsets), ArrayOf<vtkTypeInt64Array>(arrays.Ids));
  }
  else
  {
    cells->SetData(
      ArrayOf<vtkTypeInt32Array>(arrays.Offsets), ArrayOf<vtkTypeInt32Array>(arrays.Ids));
  }
  return cells;
}

enum Kind
{
  Verts,
  Lines,
  Polys,
  Strips,
  Kinds
};

void SetCells(vtkPolyData* data, int kind, vtkCellArray* cells)
{
  kind == Verts     ? data->SetVerts(cells)
    : kind == Lines ? data->SetLines(cells)
    : kind == Polys ? data->SetPolys(cells)
                    : data->SetStrips(cells);
}

/// A square with one vertex cell, one line and one strip beside its eight triangles.
vtkSmartPointer<vtkPolyData> Mixed()
{
  auto data = Square(2);
  SetCells(data, Verts, CellsOf({ { 0, 2 }, { 0, 4 } }, true));
  SetCells(data, Lines, CellsOf({ { 0, 3 }, { 1, 4, 8 } }, true));
  SetCells(data, Strips, CellsOf({ { 0, 4 }, { 0, 1, 3, 4 } }, true));
  return data;
}

void CheckNamedCells(Check& check)
{
  struct Bad
  {
    std::string Name;
    int Kind;
    Arrays Cells;
    std::vector<std::string> Words;
  };
  const std::vector<Bad> cases = {
    { "offsets past the end", Polys, { { 0, 3, 7 }, { 0, 1, 4, 0, 4, 3 } },
      { "Cell 3", "polygons", "from 3 to 7", "6", "Repair" } },
    { "decreasing offsets", Polys, { { 0, 3, 2, 6 }, { 0, 1, 4, 0, 4, 3 } },
      { "Cell 3", "from 3 to 2", "Repair" } },
    { "a negative offset", Polys, { { -3, 3, 6 }, { 0, 1, 4, 0, 4, 3 } },
      { "Cell 2", "from -3 to 3" } },
    { "no offsets at all", Polys, { {}, {} }, { "polygons", "cell 2", "empty", "Repair" } },
    { "no offsets of ids", Polys, { {}, { 0, 1, 4 } }, { "polygons", "cell 2", "empty" } },
    { "bad strips", Strips, { { 0, 4, 9 }, { 0, 1, 3, 4 } }, { "Cell 11", "strips" } },
    { "bad lines", Lines, { { 0, 2, 1 }, { 0, 1 } }, { "Cell 2", "lines", "from 2 to 1" } },
    { "bad vertices", Verts, { { 0, 9 }, { 0 } }, { "Cell 0", "vertices", "from 0 to 9" } },
  };
  for (const Bad& bad : cases)
  {
    for (const bool isWide : { false, true })
    {
      for (const int port : { 0, 1 })
      {
        const auto broken = Mixed();
        SetCells(broken, bad.Kind, CellsOf(bad.Cells, isWide));
        std::vector<std::string> words = bad.Words;
        words.push_back("port " + std::to_string(port));
        const Case odd = { bad.Name + (isWide ? ", 64 bits" : ", 32 bits"),
          port == 0 ? broken : Square(2), port == 1 ? broken : PointSources({ { 0, 0, 0 } }),
          words };
        vtkNew<vtkGeodesicDistanceField> filter;
        Messages messages(filter);
        Run(check, filter, messages, odd);
        CheckWords(check, odd, messages.Error());
        CheckOutputsEmpty(check, filter, odd.Name);
      }
    }
  }
}

/// Of targets only the points are looked at.
void CheckTargets(Check& check)
{
  const auto targets = PointSources({ { 1, 1, 0 }, { 0.5, 0, 0 } });
  SetCells(targets, Lines, CellsOf({ { 0, 9, 2 }, { 0, 1 } }, true));
  const auto paths = FilterOn<vtkGeodesicPaths>(Square(2), PointSources({ { 0, 0, 0 } }));
  paths->SetTargetsData(targets);
  RunWithoutError(check, paths, "broken cells of targets");
  check.Equal(paths->GetOutput()->GetNumberOfLines(), 2.0, "paths of targets with broken cells");
}

/// A source of lines, vertices and a triangle, as a grid.
vtkSmartPointer<vtkUnstructuredGrid> Grid(
  const std::vector<int>& types, vtkCellArray* cells, vtkPoints* points)
{
  vtkNew<vtkUnsignedCharArray> typesOfCells;
  for (const int type : types)
  {
    typesOfCells->InsertNextValue(static_cast<unsigned char>(type));
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  grid->SetCells(typesOfCells, cells);
  return grid;
}

void CheckGrids(Check& check)
{
  const auto points = PointSources({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 } });
  const auto expect = [&](const std::vector<int>& types, const Arrays& cells,
                        const std::vector<std::string>& words, const std::string& name)
  {
    const auto filter =
      RefinedField(Square(2), Grid(types, CellsOf(cells, true), points->GetPoints()));
    Messages(filter).ExpectError(check, words, name);
    CheckOutputsEmpty(check, filter, name);
  };
  const std::vector<int> lines = { VTK_LINE, VTK_LINE };
  expect(lines, { { 0, 2, 5 }, { 0, 1, 1, 2 } }, { "Cell 1 of the source", "from 2 to 5" },
    "offsets of a grid past the end");
  expect(lines, { {}, { 0, 1, 1, 2 } }, { "cell 0", "empty" }, "a grid whose offsets are empty");
  expect({ VTK_LINE }, { { 0, 2, 4 }, { 0, 1, 1, 2 } }, { "Cell 1 of the source", "no type" },
    "a grid with a type missing");
  expect({ VTK_LINE, VTK_VERTEX }, { { 0, 2, 3 }, { 0, 1, 7 } },
    { "Cell 1 of the source", "point 7" }, "a grid with a point missing");
}

/// Cells as a list of their points; false where the arrays are not those of cells.
bool Read(
  const Arrays& arrays, vtkIdType numberOfPoints, std::vector<std::vector<vtkIdType>>& cells)
{
  if (arrays.Offsets.empty())
  {
    return false;
  }
  for (std::size_t i = 0; i + 1 < arrays.Offsets.size(); ++i)
  {
    std::vector<vtkIdType>& cell = cells.emplace_back();
    if (arrays.Offsets[i] < 0 || arrays.Offsets[i + 1] < arrays.Offsets[i] ||
      arrays.Offsets[i + 1] > static_cast<vtkIdType>(arrays.Ids.size()))
    {
      return false;
    }
    for (vtkIdType at = arrays.Offsets[i]; at < arrays.Offsets[i + 1]; ++at)
    {
      cell.push_back(arrays.Ids[static_cast<std::size_t>(at)]);
      if (cell.back() < 0 || cell.back() >= numberOfPoints)
      {
        return false;
      }
    }
  }
  return true;
}

class RandomArrays
{
public:
  explicit RandomArrays(unsigned seed)
    : Random(seed)
  {
  }
  vtkIdType Below(vtkIdType end)
  {
    return static_cast<vtkIdType>(this->Random() % static_cast<std::uint64_t>(end));
  }
  /// Those of some cells of a kind, spoiled in one to three ways.
  Arrays Make(int kind, vtkIdType numberOfPoints)
  {
    Arrays arrays = { { 0 }, {} };
    for (vtkIdType cells = 1 + this->Below(6); cells > 0; --cells)
    {
      const vtkIdType size = kind == Polys ? 3 : 1 + this->Below(5);
      for (vtkIdType i = 0; i < size; ++i)
      {
        arrays.Ids.push_back(this->Below(numberOfPoints));
      }
      arrays.Offsets.push_back(static_cast<vtkIdType>(arrays.Ids.size()));
    }
    for (vtkIdType times = 1 + this->Below(3); times > 0; --times)
    {
      this->Spoil(arrays, numberOfPoints);
    }
    return arrays;
  }

private:
  void Spoil(Arrays& arrays, vtkIdType numberOfPoints)
  {
    const auto size = static_cast<vtkIdType>(arrays.Ids.size());
    const vtkIdType way = this->Below(20);
    if (way == 0)
    {
      arrays.Offsets.clear();
    }
    else if (way < 3) // more or fewer cells
    {
      arrays.Offsets.resize(
        static_cast<std::size_t>(1 + this->Below(size + 1)), this->Below(size + 2));
    }
    else if (way < 6)
    {
      arrays.Ids.resize(static_cast<std::size_t>(this->Below(size + 3)), 0);
    }
    else if (way < 9)
    {
      this->Any(arrays.Ids) = this->Below(numberOfPoints + 4) - 2;
    }
    else if (way < 11) // far away
    {
      this->Any(arrays.Offsets) = (way == 9 ? 1 : -1) * (vtkIdType(1) << this->Below(31));
    }
    else // other cells, which may be right
    {
      this->Any(arrays.Offsets) = this->Below(size + 3) - 1;
    }
  }

  vtkIdType& Any(std::vector<vtkIdType>& values)
  {
    return values.empty()
      ? this->Nowhere
      : values[static_cast<std::size_t>(this->Below(static_cast<vtkIdType>(values.size())))];
  }

  vtkIdType Nowhere = 0;
  std::mt19937_64 Random;
};

/// What an execution has given: a message, or the distances and sources of all points.
struct Outcome
{
  std::string Error;
  std::vector<double> Values;
};

Outcome Execute(vtkPolyData* surface, vtkPolyData* source)
{
  const auto filter = PlainField(surface, source);
  filter->GenerateSourceIdsOn();
  Messages messages(filter);
  messages.Update();
  Outcome outcome = { messages.Error(), {} };
  for (const char* name : { "GeodesicDistance", "SourceId" })
  {
    const std::vector<double> values =
      NumbersOf(filter->GetOutput()->GetPointData()->GetArray(name));
    outcome.Values.insert(outcome.Values.end(), values.begin(), values.end());
  }
  return outcome;
}

void CheckRandomArrays(Check& check, unsigned seed)
{
  RandomArrays random(seed);
  const bool isSurface = random.Below(2) == 0;
  const int kind = static_cast<int>(random.Below(Kinds));
  const auto spoiled = isSurface
    ? Square(3)
    : PointSources({ { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, 0.5, 0 }, { 0, 1, 0 }, { 1, 1, 0 } });
  const auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(spoiled);
  const Arrays arrays = random.Make(kind, spoiled->GetNumberOfPoints());
  SetCells(spoiled, kind, CellsOf(arrays, random.Below(2) == 0));
  std::vector<std::vector<vtkIdType>> cells;
  const bool isReadable = Read(arrays, spoiled->GetNumberOfPoints(), cells);
  const auto other = isSurface ? PointSources({ { 0.1, 0.2, 0 } }) : Square(3);
  const auto execute = [&](vtkPolyData* data)
  { return isSurface ? Execute(data, other) : Execute(other, data); };
  const Outcome outcome = execute(spoiled);
  const std::string what = "arrays of seed " + std::to_string(seed) + ": " + outcome.Error;
  if (!isReadable)
  {
    // Ids of lines and vertices that are left out of a surface are not looked at.
    const bool isLeftOut = isSurface && (kind == Verts || kind == Lines);
    check.That(isLeftOut || !outcome.Error.empty(), what + "an error of what cannot be read");
    return;
  }
  SetCells(copy, kind, CellArray(cells));
  const Outcome expected = execute(copy);
  check.That(outcome.Error.empty() == expected.Error.empty() && outcome.Values == expected.Values,
    what + "as of the same cells in arrays of their own");
}

}

int TestGeodesicCellArrays(int, char*[])
{
  Check check;
  CheckNamedCells(check);
  CheckTargets(check);
  CheckGrids(check);
  const char* more = std::getenv("GEODESIC_TEST_SEEDS");
  const unsigned seeds = more ? static_cast<unsigned>(std::atoi(more)) : 300;
  for (unsigned seed = 0; seed < seeds; ++seed)
  {
    CheckRandomArrays(check, seed);
  }
  return check.Result();
}
