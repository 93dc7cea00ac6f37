// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/SourceCells.h"

#include "PolyData/reading/PolyDataSurface.h"
#include "mesh/SurfaceSnap.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace geodesic
{

namespace
{

/// The vertex of a point of the surface if a point on its scale lies there, within the precision of
/// its coordinates; NoId if not. Points of several blocks or ranks have no numbers in common.
Id vertexIfThere(
  const PolyDataSurface& surface, vtkIdType number, const Vec3& place, double coordinatePrecision)
{
  if (surface.partition.isDistributed() || surface.blocks.size() != 1 || number < 0 ||
    number >= static_cast<vtkIdType>(surface.numberOfPoints) || !(norm(place) < Infinity))
  {
    return NoId;
  }
  const TriangleMesh& mesh = surface.mesh();
  const Id vertex = surface.vertexOf(static_cast<Id>(number));
  if (vertex >= mesh.numberOfVertices() || mesh.cornersAt(vertex).size() == 0)
  {
    return NoId;
  }
  const Id face = someFace(mesh, SurfacePoint::atVertex(vertex));
  const SnappedPoint there = snapToFace(mesh, face, place, coordinatePrecision);
  const bool isThere = there.place.kind == SurfacePoint::Kind::Vertex && there.place.id == vertex &&
    there.distance <= there.tolerance;
  return isThere ? vertex : NoId;
}

/// Adds the cells of one block to those of the blocks before. Numbers are those in the block.
struct SourceBlockReader
{
  const PolyDataBlock& block;
  const PolyDataSurface& surface;
  bool areTargets;
  SourceCells& cells;
  const vtkIdType first = cells.end;
  vtkIdType cell = 0;
  /// Of each point whether a polyline has it.
  std::vector<char> isUsed =
    std::vector<char>(static_cast<std::size_t>(block.data->GetNumberOfPoints()), 0);

  void read()
  {
    vtkPolyData* data = this->block.data;
    if (this->block.isSetOfPoints())
    {
      this->readPoints();
    }
    else
    {
      this->read(data->GetVerts(), &SourceBlockReader::addVertices);
      this->read(data->GetLines(), &SourceBlockReader::addLine);
      this->read(data->GetPolys(), &SourceBlockReader::addPolygon);
      this->read(data->GetStrips(), &SourceBlockReader::addStrip);
      this->cells.end += this->cell;
      this->cells.droppedCells += this->block.droppedCells;
    }
    requireFinite(this->block, this->isUsed.data());
  }

  /// Each point is a source of its own, however many of them a vertex cell has.
  void readPoints()
  {
    vtkPolyData* data = this->block.data;
    forEachCell(data->GetVerts(),
      [&](vtkIdType size, const vtkIdType* ids)
      {
        requirePoints(this->block, this->cell++, size, ids);
        std::for_each(ids, ids + size,
          [this](vtkIdType point) { this->isUsed[static_cast<std::size_t>(point)] = 1; });
      });
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
    {
      if ((data->GetNumberOfVerts() == 0 || this->isUsed[static_cast<std::size_t>(i)]) &&
        this->takeNumber(i))
      {
        this->addVertex(i, i);
      }
    }
    this->cells.end += data->GetNumberOfPoints();
  }

  using Adder = void (SourceBlockReader::*)(vtkIdType, const vtkIdType*);

  void read(vtkCellArray* array, Adder addCell)
  {
    const bool isPolyData = this->block.inputCells.empty();
    forEachCell(array,
      [&](vtkIdType size, const vtkIdType* ids)
      {
        requirePoints(this->block, this->inputCell(), size, ids);
        const bool isTaken = (size > 0 || isPolyData) && this->takeNumber(this->inputCell());
        if (isTaken && size > 0)
        {
          (this->*addCell)(size, ids);
        }
        else if (isTaken)
        {
          this->cells.withoutPoints.push_back(this->cells.numbers.back());
        }
        ++this->cell;
      });
  }

  /// The number in the input of the cell that is being read.
  vtkIdType inputCell() const { return this->block.inputCell(this->cell); }

  /// \returns whether the cell or point counts.
  bool takeNumber(vtkIdType number)
  {
    const std::vector<vtkIdType>& values = this->block.sourceIds;
    const vtkIdType value = values.empty() ? 0 : values[static_cast<std::size_t>(number)];
    if (value < 0 && this->areTargets)
    {
      return false;
    }
    if (value < 0 || value >= SourceIdEnd)
    {
      throw InputError(this->block.name.part(this->block.isSetOfPoints() ? "point" : "cell", number)
                         .atBeginning() +
        (value < 0 ? " has a negative value" : " has a value that is too large") +
        " in the array that names " +
        (this->areTargets ? "targets (TargetIdArrayName)"
                          : "the parts of the source (SourceIdArrayName)") +
        ": ids are from 0 to " + std::to_string(SourceIdEnd - 1) +
        ", as -1 stands for points that are not reached.");
    }
    this->cells.numbers.push_back(this->first + number);
    return true;
  }

  /// \param number of the cell, or point, that it is of.
  LocatedPolyline polylineOf(
    vtkIdType size, const vtkIdType* ids, vtkIdType number, const PartName& name)
  {
    LocatedPolyline line;
    line.name = name;
    line.source = static_cast<Id>(this->first + number);
    for (vtkIdType i = 0; i < size; ++i)
    {
      addPoint(this->block, ids[i], this->surface, this->cells.precision, line);
      this->isUsed[static_cast<std::size_t>(ids[i])] = 1;
    }
    return line;
  }

  void addVertex(vtkIdType point, vtkIdType number)
  {
    const PartName name = this->block.name.part("point", point);
    this->cells.polylines.push_back(this->polylineOf(1, &point, number, name));
    this->cells.polylines.back().pointNames = { name };
  }

  void addVertices(vtkIdType size, const vtkIdType* ids)
  {
    std::for_each(
      ids, ids + size, [this](vtkIdType point) { this->addVertex(point, this->inputCell()); });
  }

  LocatedPolyline curveOf(vtkIdType size, const vtkIdType* ids, bool closed)
  {
    const vtkIdType number = this->inputCell();
    LocatedPolyline curve =
      this->polylineOf(size, ids, number, this->block.name.part("cell", number));
    curve.closed = closed && size > 2;
    return curve;
  }

  void addLine(vtkIdType size, const vtkIdType* ids)
  {
    if (size == 2)
    {
      this->cells.lines.push_back(this->cells.polylines.size());
    }
    const bool closed = size > 3 && ids[0] == ids[size - 1];
    this->cells.polylines.push_back(this->curveOf(closed ? size - 1 : size, ids, closed));
  }

  void addPolygon(vtkIdType size, const vtkIdType* ids)
  {
    if (size > 2)
    {
      this->cells.faces.push_back({ this->curveOf(size, ids, true) });
    }
    else
    {
      this->cells.polylines.push_back(this->curveOf(size, ids, false));
    }
  }

  void addStrip(vtkIdType size, const vtkIdType* ids)
  {
    for (vtkIdType i = 0; i + 2 < size; ++i)
    {
      const vtkIdType odd = i % 2;
      const vtkIdType corners[] = { ids[i], ids[i + 1 + odd], ids[i + 2 - odd] };
      this->addPolygon(3, corners);
    }
  }
};

}

SourceCells readSourceCells(
  const std::vector<PolyDataBlock>& blocks, const PolyDataSurface& surface, bool areTargets)
{
  SourceCells cells;
  cells.precision = coordinatePrecisionOf(blocks);
  for (const PolyDataBlock& block : blocks)
  {
    SourceBlockReader{ block, surface, areTargets, cells }.read();
    cells.values.insert(cells.values.end(), block.sourceIds.begin(), block.sourceIds.end());
    cells.names.insert(cells.names.end(), block.partNames.begin(), block.partNames.end());
  }
  std::sort(cells.numbers.begin(), cells.numbers.end());
  return cells;
}

double coordinatePrecisionOf(const std::vector<PolyDataBlock>& blocks)
{
  double precision = std::numeric_limits<double>::epsilon();
  for (const PolyDataBlock& block : blocks)
  {
    precision = std::max(precision, block.precision());
  }
  return precision;
}

void addPoint(const PolyDataBlock& block, vtkIdType point, const PolyDataSurface& surface,
  double coordinatePrecision, LocatedPolyline& line)
{
  Vec3 p;
  block.data->GetPoint(point, p.data());
  line.points.push_back(surface.scale.toEngine(p));
  if (isFinite(p) && !(norm(line.points.back()) < Infinity))
  {
    throw InputError(block.name.part("point", point).atBeginning() +
      " is too far from the surface for its size. Scale or move it upstream.");
  }
  if (!block.originalPoints.empty())
  {
    line.vertices.push_back(
      vertexIfThere(surface, block.originalPoints[static_cast<std::size_t>(point)],
        line.points.back(), coordinatePrecision));
  }
}

}
