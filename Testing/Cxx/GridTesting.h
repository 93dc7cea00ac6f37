// SPDX-License-Identifier: BSD-3-Clause
// What the tests of unstructured grids share: one surface as a grid of cells of many kinds and as a
// vtkPolyData of polygons, and outputs that are the same bit for bit.
#ifndef GridTesting_h
#define GridTesting_h

#include "GeodesicTesting.h"
#include "RandomBarriers.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <cstring>

namespace GeodesicTesting
{

/// A cell of a grid and the polygons that it stands for; none of lines and vertices.
struct GridCell
{
  int Type;
  std::vector<vtkIdType> Ids;
  std::vector<std::vector<vtkIdType>> Faces;
  int Barrier = 0;
  unsigned char Ghost = 0;
};

inline vtkSmartPointer<vtkUnstructuredGrid> GridOf(
  const std::vector<Point>& positions, const std::vector<GridCell>& cells)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(PointSources(positions)->GetPoints());
  for (const GridCell& cell : cells)
  {
    grid->InsertNextCell(cell.Type, static_cast<vtkIdType>(cell.Ids.size()), cell.Ids.data());
  }
  return grid;
}

/// Gives a data set the arrays "barrier" and "number" (of the grid's cell), and ghost flags where
/// there are any, with one value for each of some cells of the grid.
inline void AddCellArrays(const std::vector<GridCell>& cells, const std::vector<std::size_t>& some,
  vtkDataSetAttributes* data)
{
  const auto valuesOf = [&](const auto& valueOf)
  {
    std::vector<vtkIdType> values;
    for (const std::size_t cell : some)
    {
      values.push_back(valueOf(cells[cell]));
    }
    return values;
  };
  const auto ghostOf = [](const GridCell& cell) { return cell.Ghost; };
  AddArray<vtkIntArray>(
    data, "barrier", valuesOf([](const GridCell& cell) { return cell.Barrier; }));
  AddArray<vtkIdTypeArray>(data, "number", some);
  if (std::any_of(cells.begin(), cells.end(), ghostOf))
  {
    AddArray<vtkUnsignedCharArray>(data, vtkDataSetAttributes::GhostArrayName(), valuesOf(ghostOf));
  }
}

inline void AddPointArray(vtkDataSet* data)
{
  AddArrayOf<vtkIntArray>(data->GetPointData(), "point", data->GetNumberOfPoints(),
    [&](vtkIdType i) { return static_cast<int>(i); });
}

/// One surface, twice.
struct GridAndPolyData
{
  std::vector<Point> Positions;
  std::vector<GridCell> Cells;

  vtkSmartPointer<vtkUnstructuredGrid> Grid() const
  {
    auto grid = GridOf(this->Positions, this->Cells);
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < this->Cells.size(); ++i)
    {
      all.push_back(i);
    }
    AddCellArrays(this->Cells, all, grid->GetCellData());
    AddPointArray(grid);
    return grid;
  }
  /// Takes the barrier values of lines and other cells that are no faces away.
  void LeaveFacesOnly(vtkUnstructuredGrid* grid) const
  {
    vtkNew<vtkIntArray> barriers;
    barriers->SetName("barrier");
    for (const GridCell& cell : this->Cells)
    {
      if (!cell.Faces.empty())
      {
        barriers->InsertNextValue(cell.Barrier);
      }
    }
    grid->GetCellData()->AddArray(barriers);
  }
  /// \param hasOwnNumbers whether "number" is that of its own cells.
  vtkSmartPointer<vtkPolyData> PolyData(bool hasOwnNumbers = false) const
  {
    auto data = PointSources(this->Positions);
    vtkNew<vtkCellArray> polys;
    std::vector<std::size_t> cellsOfPolys;
    for (std::size_t i = 0; i < this->Cells.size(); ++i)
    {
      for (const std::vector<vtkIdType>& face : this->Cells[i].Faces)
      {
        polys->InsertNextCell(static_cast<vtkIdType>(face.size()), face.data());
        cellsOfPolys.push_back(i);
      }
    }
    data->SetPolys(polys);
    AddCellArrays(this->Cells, cellsOfPolys, data->GetCellData());
    vtkDataArray* numbers = data->GetCellData()->GetArray("number");
    for (vtkIdType i = 0; hasOwnNumbers && i < data->GetNumberOfCells(); ++i)
    {
      numbers->SetTuple1(i, static_cast<double>(i));
    }
    AddPointArray(data);
    return data;
  }
};

/// What kinds of cells a grid has.
enum class GridKind
{
  Triangles,
  Polygons,
  /// Pixels and strips, too, and between the faces lines, vertices and empty cells.
  All
};

/// Joins triangles of a random mesh in twos, and puts other cells between them.
class GridMaker
{
public:
  GridMaker(const RandomBarriers& made, GridKind kind, bool hasGhosts, geodesictest::Random& random)
    : Made(made)
    , Kind(kind)
    , HasGhosts(hasGhosts)
    , Rand(random)
    , IsUsed(made.whole.triangles.size(), false)
  {
    for (std::size_t f = 0; f < made.whole.triangles.size(); ++f)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        const geodesictest::Triangle& t = made.whole.triangles[f];
        this->FaceOf[{ t[k], t[(k + 1) % 3] }] = f;
      }
    }
  }

  GridAndPolyData Make()
  {
    this->Surface.Positions = this->Made.whole.points;
    for (std::size_t f = 0; f < this->IsUsed.size(); ++f)
    {
      if (this->Kind == GridKind::All)
      {
        this->AddOthers();
      }
      if (!this->IsUsed[f])
      {
        this->AddFace(f);
      }
    }
    return std::move(this->Surface);
  }

private:
  int OneOf(const std::vector<int>& types) { return types[this->Rand.below(types.size())]; }

  void Add(int type, std::vector<vtkIdType> ids, std::vector<std::vector<vtkIdType>> faces,
    std::size_t face)
  {
    GridCell cell{ type, std::move(ids), std::move(faces) };
    cell.Barrier = this->Made.isBarrier[face] ? -3 : 0;
    if (this->HasGhosts && this->Rand.chance(0.15))
    {
      cell.Ghost = this->Rand.chance(0.5) ? vtkDataSetAttributes::DUPLICATECELL
                                          : vtkDataSetAttributes::HIDDENCELL;
    }
    this->Surface.Cells.push_back(std::move(cell));
  }

  /// Whose barrier values and ghost flags say nothing.
  void AddOthers()
  {
    while (this->Rand.chance(0.2))
    {
      const std::size_t face = this->Rand.below(this->IsUsed.size());
      const geodesictest::Triangle& t = this->Made.whole.triangles[face];
      const int type = this->OneOf({ VTK_VERTEX, VTK_POLY_VERTEX, VTK_LINE, VTK_POLY_LINE,
        VTK_QUADRATIC_EDGE, VTK_EMPTY_CELL });
      const std::size_t size = type == VTK_EMPTY_CELL ? 0
        : type == VTK_VERTEX                          ? 1
        : type == VTK_LINE                            ? 2
                                                      : 3;
      this->Add(type, std::vector<vtkIdType>(t.begin(), t.begin() + size), {}, face);
    }
  }

  void AddFace(std::size_t f)
  {
    const geodesictest::Triangle& t = this->Made.whole.triangles[f];
    this->IsUsed[f] = true;
    const std::size_t k = this->Rand.below(3);
    const vtkIdType x = t[k], u = t[(k + 1) % 3], v = t[(k + 2) % 3];
    const auto beside = this->FaceOf.find({ v, u });
    if (this->Kind != GridKind::Triangles && this->Rand.chance(0.5) &&
      beside != this->FaceOf.end() && !this->IsUsed[beside->second] &&
      this->Made.isBarrier[beside->second] == this->Made.isBarrier[f])
    {
      const geodesictest::Triangle& other = this->Made.whole.triangles[beside->second];
      const vtkIdType y = vtkIdType(other[0] + other[1] + other[2]) - u - v;
      if (y != x)
      {
        this->IsUsed[beside->second] = true;
        this->AddFour(f, x, u, y, v);
        return;
      }
    }
    this->Add(
      this->Kind == GridKind::Triangles ? VTK_TRIANGLE : this->OneOf({ VTK_TRIANGLE, VTK_POLYGON }),
      { x, u, v }, { { x, u, v } }, f);
  }

  /// A quad x, u, y, v that is cut between u and v where it is a strip.
  void AddFour(std::size_t f, vtkIdType x, vtkIdType u, vtkIdType y, vtkIdType v)
  {
    std::vector<int> types = { VTK_QUAD, VTK_POLYGON };
    if (this->Kind == GridKind::All)
    {
      types.push_back(VTK_PIXEL);
      if (!this->HasGhosts) // of cells the ghosts of which are found as wholes
      {
        types.push_back(VTK_TRIANGLE_STRIP);
      }
    }
    const int type = this->OneOf(types);
    if (type == VTK_TRIANGLE_STRIP)
    {
      this->Add(type, { x, u, v, y }, { { x, u, v }, { v, u, y } }, f);
      return;
    }
    const std::vector<vtkIdType> around = { x, u, y, v };
    this->Add(
      type, type == VTK_PIXEL ? std::vector<vtkIdType>{ x, u, v, y } : around, { around }, f);
  }

  const RandomBarriers& Made;
  const GridKind Kind;
  const bool HasGhosts;
  geodesictest::Random& Rand;
  std::vector<bool> IsUsed;
  std::map<std::pair<vtkIdType, vtkIdType>, std::size_t> FaceOf;
  GridAndPolyData Surface;
};

/// "OriginalCellIds" of the grid's output are the grid's cells, which "number" of the other is.
inline void CompareArrays(
  Check& check, vtkFieldData* ofGrid, vtkFieldData* ofPolyData, const std::string& what)
{
  check.Equal(ofGrid->GetNumberOfArrays(), ofPolyData->GetNumberOfArrays(), what + ": arrays");
  for (int i = 0; i < ofGrid->GetNumberOfArrays(); ++i)
  {
    const std::string name = ofGrid->GetArray(i)->GetName();
    vtkDataArray* other = ofPolyData->GetArray(name == "OriginalCellIds" ? "number" : name.c_str());
    check.That(AreSame(ofGrid->GetArray(i), other), what + ": the array " + name);
  }
}

inline void ComparePolyData(
  Check& check, vtkPolyData* ofGrid, vtkPolyData* ofPolyData, const std::string& what)
{
  const auto places = [](vtkPolyData* data)
  { return data->GetPoints() ? data->GetPoints()->GetData() : nullptr; };
  check.That(AreSame(places(ofGrid), places(ofPolyData)), what + ": points");
  const auto compareCells = [&](vtkCellArray* a, vtkCellArray* b)
  {
    vtkNew<vtkIdTypeArray> idsOfA, idsOfB;
    a->ExportLegacyFormat(idsOfA);
    b->ExportLegacyFormat(idsOfB);
    check.That(AreSame(idsOfA, idsOfB), what + ": cells");
  };
  compareCells(ofGrid->GetVerts(), ofPolyData->GetVerts());
  compareCells(ofGrid->GetLines(), ofPolyData->GetLines());
  compareCells(ofGrid->GetPolys(), ofPolyData->GetPolys());
  CompareArrays(check, ofGrid->GetPointData(), ofPolyData->GetPointData(), what + ", points");
  CompareArrays(check, ofGrid->GetCellData(), ofPolyData->GetCellData(), what + ", cells");
  CompareArrays(check, ofGrid->GetFieldData(), ofPolyData->GetFieldData(), what + ", field data");
}

}

#endif
