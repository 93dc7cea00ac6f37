// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/GridSurface.h"

#include "PolyData/Memory.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkFieldData.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

namespace geodesic
{

namespace
{

/// What a surface makes of cells of a type.
enum class CellKind : unsigned char
{
  Polygon,
  Pixel,
  Strip,
  QuadraticPolygon,
  Curved,
  Vertex,
  Line,
  Empty,
  Volume,
  Foreign
};

/// \returns null for a type that VTK does not know.
vtkSmartPointer<vtkCell> cellOfType(int type)
{
  return vtk::TakeSmartPointer(vtkGenericCell::InstantiateCell(type));
}

/// \param cell of the type; null if VTK does not know it.
CellKind kindOf(int type, vtkCell* cell)
{
  switch (type)
  {
    case VTK_TRIANGLE:
    case VTK_QUAD:
    case VTK_POLYGON:
      return CellKind::Polygon;
    case VTK_PIXEL:
      return CellKind::Pixel;
    case VTK_TRIANGLE_STRIP:
      return CellKind::Strip;
    case VTK_QUADRATIC_POLYGON:
      return CellKind::QuadraticPolygon;
    case VTK_EMPTY_CELL:
      return CellKind::Empty;
    default:
      break;
  }
  constexpr CellKind ofDimension[] = { CellKind::Vertex, CellKind::Line, CellKind::Curved,
    CellKind::Volume };
  return cell ? ofDimension[cell->GetCellDimension()] : CellKind::Foreign;
}

struct CellType
{
  CellKind kind;
  /// Below this number of points VTK reads points that are not there.
  vtkIdType leastSize;
};

const CellType& cellType(int type)
{
  static const std::array<CellType, 256> types = []
  {
    std::array<CellType, 256> made{};
    for (std::size_t i = 0; i < made.size(); ++i)
    {
      const vtkSmartPointer<vtkCell> cell = cellOfType(static_cast<int>(i));
      made[i] = { kindOf(static_cast<int>(i), cell), cell ? cell->GetNumberOfPoints() : 0 };
    }
    return made;
  }();
  return types[static_cast<unsigned char>(type)];
}

/// Cells of one kind, and their numbers in the grid.
struct CellsOfKind
{
  vtkNew<vtkCellArray> cells;
  std::vector<vtkIdType> numbers;

  void add(vtkIdType number, vtkIdType size, const vtkIdType* ids)
  {
    this->cells->InsertNextCell(size, ids);
    this->numbers.push_back(number);
  }
};

/// Gives a vtkPolyData the cells of a grid.
class GridReader
{
public:
  GridReader(vtkUnstructuredGrid* grid, PolyDataBlock block)
    : grid_(grid)
    , block_(std::move(block))
  {
  }

  PolyDataBlock readSource()
  {
    vtkIdType next = 0;
    forEachCell(this->grid_->GetCells(),
      [&](vtkIdType size, const vtkIdType* ids)
      {
        const vtkIdType cell = next++;
        const int type = this->grid_->GetCellType(cell);
        const CellKind kind = this->kindOfCell(cell);
        const bool isLine = type == VTK_LINE || type == VTK_POLY_LINE;
        if (kind == CellKind::Polygon || kind == CellKind::Pixel)
        {
          this->addFace(kind, cell, size, ids);
        }
        else if (kind == CellKind::Vertex || kind == CellKind::Strip)
        {
          (kind == CellKind::Vertex ? this->vertices_ : this->strips_).add(cell, size, ids);
        }
        else
        {
          this->lines_.add(cell, isLine ? size : 0, ids);
          this->block_.droppedCells += isLine || kind == CellKind::Empty ? 0 : 1;
        }
      });
    this->giveCells();
    return std::move(this->block_);
  }

  PolyDataBlock readSurface()
  {
    if (this->grid_->GetNumberOfCells() > 0)
    {
      const Found found = this->look();
      if (found.arePolygons)
      {
        this->block_.data->SetPolys(this->grid_->GetCells());
      }
      else
      {
        this->readCells(found);
      }
    }
    return std::move(this->block_);
  }

private:
  /// What cells the grid has.
  struct Found
  {
    bool arePolygons = true;
    bool isAnySplit = false;
  };

  CellKind kindOfCell(vtkIdType cell) const
  {
    return cellType(this->grid_->GetCellType(cell)).kind;
  }

  /// \throws InputError
  Found look() const
  {
    Found found;
    for (vtkIdType cell = 0; cell < this->grid_->GetNumberOfCells(); ++cell)
    {
      const CellKind kind = this->kindOfCell(cell);
      if (kind == CellKind::Volume || kind == CellKind::Foreign)
      {
        this->throwNoFace(cell);
      }
      found.arePolygons = found.arePolygons && kind == CellKind::Polygon;
      found.isAnySplit = found.isAnySplit || kind == CellKind::Strip || kind == CellKind::Curved;
    }
    return found;
  }

  [[noreturn]] void throwNoFace(vtkIdType cell) const
  {
    const int type = this->grid_->GetCellType(cell);
    const vtkSmartPointer<vtkCell> like = cellOfType(type);
    const std::string which = this->block_.name.part("cell", cell).atBeginning();
    throw InputError(like ? which + " is three-dimensional, a " + like->GetClassName() +
          " (cell type " + std::to_string(type) +
          "): apply Extract Surface first (vtkDataSetSurfaceFilter or vtkGeometryFilter). The "
          "cells of a vtkUnstructuredGrid have to be two-dimensional."
                          : which + " is of type " + std::to_string(type) +
          ", which VTK does not know. Repair the cells upstream.");
  }

  void readCells(const Found& found)
  {
    this->allocate(found);
    vtkIdType next = 0;
    forEachCell(this->grid_->GetCells(),
      [&](vtkIdType size, const vtkIdType* ids)
      {
        const vtkIdType cell = next++;
        const CellKind kind = this->kindOfCell(cell);
        if (kind == CellKind::Vertex || kind == CellKind::Line)
        {
          (kind == CellKind::Line ? this->lines_ : this->vertices_).add(cell, 0, ids);
        }
        else if (kind != CellKind::Empty)
        {
          this->addFace(kind, cell, size, ids);
        }
      });
    this->block_.numberOfInputCells = next;
    this->giveCells();
  }

  /// In the order in which vtkPolyData numbers its cells.
  void giveCells()
  {
    std::vector<vtkIdType>& numbers = this->block_.inputCells;
    for (const CellsOfKind* kind :
      { &this->vertices_, &this->lines_, &this->polygons_, &this->strips_ })
    {
      numbers.insert(numbers.end(), kind->numbers.begin(), kind->numbers.end());
    }
    this->block_.data->SetVerts(this->vertices_.cells);
    this->block_.data->SetLines(this->lines_.cells);
    this->block_.data->SetPolys(this->polygons_.cells);
    this->block_.data->SetStrips(this->strips_.cells);
  }

  /// A cell that is split has at most two triangles for each of its points: a Lagrange
  /// quadrilateral of (n + 1) x (n + 1) points has 2 n x n.
  void allocate(const Found& found)
  {
    const vtkIdType cells = this->grid_->GetNumberOfCells();
    const vtkIdType ids = this->grid_->GetCells()->GetNumberOfConnectivityIds();
    const vtkIdType most = found.isAnySplit ? cells + 2 * ids : cells;
    const vtkIdType mostIds = found.isAnySplit ? 6 * ids : ids;
    requireMemory(3 * most + mostIds, sizeof(vtkIdType));
    this->polygons_.cells->AllocateExact(most, mostIds);
    this->polygons_.numbers.reserve(static_cast<std::size_t>(most));
  }

  void addFace(CellKind kind, vtkIdType cell, vtkIdType size, const vtkIdType* ids)
  {
    switch (kind)
    {
      case CellKind::Pixel:
        this->addPixel(cell, size, ids);
        break;
      case CellKind::QuadraticPolygon:
        this->addQuadraticPolygon(cell, size, ids);
        break;
      case CellKind::Strip:
        this->cutStrip(size, ids);
        this->addTriangles(cell);
        break;
      case CellKind::Curved:
        this->cutCurved(cell, size, ids);
        this->addTriangles(cell);
        break;
      default:
        this->polygons_.add(cell, size, ids);
        break;
    }
  }

  /// The corners of a pixel stand in rows.
  void addPixel(vtkIdType cell, vtkIdType size, const vtkIdType* ids)
  {
    const bool isPixel = size == 4;
    const vtkIdType around[] = { 0, 1, 3, 2 };
    this->addReordered(cell, size, [&](vtkIdType i) { return ids[isPixel ? around[i] : i]; });
  }

  /// Between the corners, which come first, are the points on the edges.
  void addQuadraticPolygon(vtkIdType cell, vtkIdType size, const vtkIdType* ids)
  {
    const vtkIdType corners = (size + 1) / 2;
    this->addReordered(cell, size, [&](vtkIdType i) { return ids[i / 2 + (i % 2) * corners]; });
  }

  /// \param idAt the point at each place of the outline: (vtkIdType) -> vtkIdType.
  template <typename IdAt>
  void addReordered(vtkIdType cell, vtkIdType size, const IdAt& idAt)
  {
    this->corners_->SetNumberOfIds(size);
    for (vtkIdType i = 0; i < size; ++i)
    {
      this->corners_->SetId(i, idAt(i));
    }
    this->polygons_.add(cell, size, this->corners_->GetPointer(0));
  }

  /// Adds those whose corners are given. A cell without triangles is no face, but counted among
  /// those that are left out.
  void addTriangles(vtkIdType cell)
  {
    const vtkIdType count = this->corners_->GetNumberOfIds();
    for (vtkIdType i = 0; i + 2 < count; i += 3)
    {
      this->polygons_.add(cell, 3, this->corners_->GetPointer(i));
    }
    if (count < 3)
    {
      this->polygons_.add(cell, 0, nullptr);
    }
  }

  void cutStrip(vtkIdType size, const vtkIdType* ids)
  {
    this->corners_->Reset();
    for (vtkIdType i = 0; i + 2 < size; ++i)
    {
      const vtkIdType odd = i % 2;
      for (const vtkIdType id : { ids[i + odd], ids[i + 1 - odd], ids[i + 2] })
      {
        this->corners_->InsertNextId(id);
      }
    }
  }

  /// \throws InputError
  void cutCurved(vtkIdType cell, vtkIdType size, const vtkIdType* ids)
  {
    requirePoints<InputError>(this->block_, cell, size, ids);
    this->corners_->Reset();
    if (size >= cellType(this->grid_->GetCellType(cell)).leastSize)
    {
      this->grid_->GetCell(cell, this->cell_);
      this->cell_->Triangulate(0, this->corners_, this->places_);
    }
    const vtkIdType* corners = this->corners_->GetPointer(0);
    const auto isCorner = [corners, end = corners + this->corners_->GetNumberOfIds()](vtkIdType id)
    { return std::find(corners, end, id) != end; };
    if (!std::all_of(ids, ids + size, isCorner))
    {
      throw InputError(this->block_.name.part("cell", cell).atBeginning() + " is of type " +
        std::to_string(this->grid_->GetCellType(cell)) +
        " and cannot be cut into triangles through its points, of which there are " +
        std::to_string(size) + ". Repair the cells upstream.");
    }
  }

  vtkUnstructuredGrid* grid_;
  PolyDataBlock block_;
  CellsOfKind vertices_;
  CellsOfKind lines_;
  CellsOfKind polygons_;
  CellsOfKind strips_;
  /// For the current cell, if it is not taken as it is.
  vtkNew<vtkIdList> corners_;
  vtkNew<vtkPoints> places_;
  vtkNew<vtkGenericCell> cell_;
};

}

PolyDataBlock surfaceOfGrid(vtkUnstructuredGrid* grid, const PartName& name)
{
  PolyDataBlock block{ vtkSmartPointer<vtkPolyData>::New(), name, {} };
  block.data->SetPoints(grid->GetPoints());
  block.data->GetPointData()->ShallowCopy(grid->GetPointData());
  block.data->GetCellData()->ShallowCopy(grid->GetCellData());
  block.data->GetFieldData()->ShallowCopy(grid->GetFieldData());
  return GridReader(grid, std::move(block)).readSurface();
}

PolyDataBlock sourceOfGrid(vtkUnstructuredGrid* grid, PolyDataBlock points)
{
  return GridReader(grid, std::move(points)).readSource();
}

}
