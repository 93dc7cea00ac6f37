// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/PolyDataSource.h"

#include "Errors.h"
#include "PolyData/reading/PolyDataSurface.h"

#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <sstream>
#include <string>

namespace geodesic
{

namespace
{

/// Takes the curves out of the cells of one block.
class BlockReader
{
public:
  /// \param sources of the blocks before, to which those of this one are added.
  BlockReader(const PolyDataBlock& block, SourcePolylines& sources)
    : block_(block)
    , firstSource_(sources.numberOfSources)
    , sources_(sources)
  {
  }

  /// \returns of each point whether a curve has it.
  std::vector<char> read()
  {
    vtkPolyData* source = this->block_.data;
    const auto before = static_cast<std::ptrdiff_t>(this->sources_.ids.size());
    this->isUsed_.assign(static_cast<std::size_t>(source->GetNumberOfPoints()), 0);
    if (source->GetNumberOfCells() == source->GetNumberOfVerts())
    {
      this->readPoints();
      return std::move(this->isUsed_);
    }
    this->read(source->GetVerts(), &BlockReader::addVertices);
    this->read(source->GetLines(), &BlockReader::addLine);
    this->read(source->GetPolys(), &BlockReader::addPolygon);
    this->read(source->GetStrips(), &BlockReader::addStrip);
    std::sort(this->sources_.ids.begin() + before, this->sources_.ids.end());
    this->sources_.numberOfSources += static_cast<Id>(this->cell_);
    this->sources_.droppedCells += this->block_.droppedCells;
    return std::move(this->isUsed_);
  }

private:
  using Adder = void (BlockReader::*)(vtkIdType, const vtkIdType*);

  /// Each point is a source of its own, however many of them a vertex cell has.
  void readPoints()
  {
    vtkPolyData* source = this->block_.data;
    forEachCell(source->GetVerts(),
      [&](vtkIdType size, const vtkIdType* ids)
      {
        requirePoints<SourceError>(this->block_, this->cell_++, size, ids);
        this->usePoints(size, ids);
      });
    for (vtkIdType i = 0; i < source->GetNumberOfPoints(); ++i)
    {
      if (source->GetNumberOfVerts() == 0 || this->isUsed_[static_cast<std::size_t>(i)])
      {
        this->addPoint(i, this->sourceOf(i));
        this->sources_.ids.push_back(this->sourceOf(i));
      }
    }
    this->sources_.numberOfSources += static_cast<Id>(source->GetNumberOfPoints());
  }

  void read(vtkCellArray* cells, Adder add)
  {
    const bool isPolyData = this->block_.inputCells.empty();
    forEachCell(cells,
      [&](vtkIdType size, const vtkIdType* ids)
      {
        requirePoints<SourceError>(this->block_, this->inputCell(), size, ids);
        if (size > 0)
        {
          (this->*add)(size, ids);
        }
        if (size > 0 || isPolyData) // a cell of a vtkPolyData is a source without points, too
        {
          this->sources_.ids.push_back(this->sourceOf(this->inputCell()));
        }
        ++this->cell_;
      });
  }

  /// The cell that is being read.
  vtkIdType inputCell() const
  {
    const std::vector<vtkIdType>& numbers = this->block_.inputCells;
    return numbers.empty() ? this->cell_ : numbers[static_cast<std::size_t>(this->cell_)];
  }

  /// \param number of a cell, or a point, of the input.
  Id sourceOf(vtkIdType number) const { return this->firstSource_ + static_cast<Id>(number); }

  void usePoints(vtkIdType size, const vtkIdType* ids)
  {
    for (vtkIdType i = 0; i < size; ++i)
    {
      this->isUsed_[static_cast<std::size_t>(ids[i])] = 1;
    }
  }

  LocatedPolyline& addPolyline(
    vtkIdType size, const vtkIdType* ids, const std::string& name, Id source)
  {
    this->usePoints(size, ids);
    LocatedPolyline& line = this->sources_.polylines.emplace_back();
    line.name = name + " of " + this->block_.name;
    line.source = source;
    line.points.resize(static_cast<std::size_t>(size));
    for (vtkIdType i = 0; i < size; ++i)
    {
      this->block_.data->GetPoint(ids[i], line.points[static_cast<std::size_t>(i)].data());
    }
    return line;
  }

  void addPoint(vtkIdType point, Id source)
  {
    this->addPolyline(1, &point, "point " + std::to_string(point), source);
  }

  void addVertices(vtkIdType size, const vtkIdType* ids)
  {
    for (vtkIdType i = 0; i < size; ++i)
    {
      this->addPoint(ids[i], this->sourceOf(this->inputCell()));
    }
  }

  void addCurve(vtkIdType size, const vtkIdType* ids, bool closed)
  {
    const vtkIdType cell = this->inputCell();
    this->addPolyline(size, ids, "cell " + std::to_string(cell), this->sourceOf(cell)).closed =
      closed && size > 2;
  }

  void addLine(vtkIdType size, const vtkIdType* ids)
  {
    const bool closed = size > 3 && ids[0] == ids[size - 1];
    this->addCurve(closed ? size - 1 : size, ids, closed);
  }

  void addPolygon(vtkIdType size, const vtkIdType* ids) { this->addCurve(size, ids, true); }

  /// The outline runs along the even points and back along the odd ones.
  void addStrip(vtkIdType size, const vtkIdType* ids)
  {
    std::vector<vtkIdType> outline;
    for (vtkIdType i = 0; i < size; i += 2)
    {
      outline.push_back(ids[i]);
    }
    for (vtkIdType i = size - 1 - size % 2; i > 0; i -= 2)
    {
      outline.push_back(ids[i]);
    }
    this->addCurve(size, outline.data(), true);
  }

  const PolyDataBlock& block_;
  Id firstSource_;
  SourcePolylines& sources_;
  vtkIdType cell_ = 0;
  std::vector<char> isUsed_;
};

/// \throws SourceError
[[noreturn]] void throwEmpty(const SourcePolylines& sources)
{
  if (sources.droppedCells > 0)
  {
    throw SourceError("The source (input port 1) has no line or vertex with points among its " +
      std::to_string(sources.droppedCells) +
      " cells. Apply Extract Surface to it for the outlines of its faces, Feature Edges after that "
      "for its edges, or take some of its points by Extract Selection.");
  }
  throw SourceError(
    "The source (input port 1) is empty: it has no points that a line or vertex uses. Connect a "
    "curve with at least one point, or set Source Type to Surface Boundary.");
}

std::string textOf(const Vec3& p)
{
  std::ostringstream text;
  text << '(' << p[0] << ", " << p[1] << ", " << p[2] << ')';
  return text.str();
}

/// "cell 17 of the surface (input port 0)", as the rank of a barrier calls it. All ranks call this
/// together.
std::string nameOfBarrier(const PolyDataSurface& surface,
  const std::vector<PolyDataBlock>& surfaceBlocks, const RankAddress& face)
{
  Exchange& exchange = surface.exchange();
  Message message;
  if (face.rank == exchange.rank())
  {
    const std::string own = surface.nameOfCell(surface.triangleOfBarrier(face.id), surfaceBlocks);
    put(message, own.data(), own.size());
  }
  const Message answer = exchange.tellAll(message)[rankIndex(face.rank)];
  std::string name(answer.size(), ' ');
  MessageReader(answer).get(name.data(), name.size());
  return surface.partition.isDistributed() ? name + " on rank " + std::to_string(face.rank) : name;
}

}

std::string nameOfPoint(const LocatedPolyline& line, std::size_t point)
{
  const bool isNamed = line.name.compare(0, 5, "point") == 0;
  return isNamed ? line.name : "point " + std::to_string(point) + " of " + line.name;
}

SourcePolylines readSource(const std::vector<PolyDataBlock>& source, const PowerOfTwoScale& scale)
{
  SourcePolylines result;
  std::vector<std::vector<char>> used;
  for (const PolyDataBlock& block : source)
  {
    used.push_back(BlockReader(block, result).read());
  }
  if (result.polylines.empty())
  {
    throwEmpty(result);
  }
  for (std::size_t i = 0; i < source.size(); ++i)
  {
    const std::string bad = whereNotFinite(source[i], used[i].data());
    if (!bad.empty())
    {
      throw SourceError(bad);
    }
  }
  for (LocatedPolyline& line : result.polylines)
  {
    for (std::size_t i = 0; i < line.points.size(); ++i)
    {
      line.points[i] = scale.toEngine(line.points[i]);
      if (!(norm(line.points[i]) < Infinity))
      {
        throw SourceError("Point " + std::to_string(i) + " of " + line.name +
          " is too far from the surface for its size. Scale or move the source upstream.");
      }
    }
  }
  return result;
}

std::vector<RankAddress> barriersAt(
  const PolyDataSurface& surface, const LocatedPlaces& located, double coordinatePrecision)
{
  return surface.barriers
    ? surface.barriers->barriersAt(located.places, located.faces, coordinatePrecision)
    : std::vector<RankAddress>(located.places.size(), RankAddress{ 0, NoId });
}

void requireOutsideBarriers(const PolyDataSurface& surface,
  const std::vector<PolyDataBlock>& surfaceBlocks, const std::vector<LocatedPolyline>& polylines,
  const LocatedPlaces& located, double coordinatePrecision)
{
  const std::vector<RankAddress> barriers = barriersAt(surface, located, coordinatePrecision);
  for (const LocatedPolyline& line : polylines)
  {
    for (std::size_t i = 0; i < line.points.size(); ++i)
    {
      const RankAddress& face = barriers[located.indexOf(line.points[i])];
      if (face.id != NoId)
      {
        throw SourceError('P' + nameOfPoint(line, i).substr(1) + ", at " +
          textOf(surface.scale.toUser(line.points[i])) +
          ", lies in a barrier (BarrierArrayName): it is closest to " +
          nameOfBarrier(surface, surfaceBlocks, face) +
          ", which no path may leave. Move it out of the barrier, or onto its rim.");
      }
    }
  }
}

SnapOptions snapOptionsFor(const std::vector<PolyDataBlock>& source)
{
  SnapOptions options;
  for (const PolyDataBlock& block : source)
  {
    options.coordinatePrecision = std::max(options.coordinatePrecision, block.precision());
  }
  return options;
}

}
