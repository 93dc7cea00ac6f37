// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/PolyDataSource.h"

#include "Errors.h"
#include "PolyData/CellLoop.h"
#include "PolyData/Memory.h"
#include "PolyData/reading/PolyDataSurface.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cfloat>
#include <sstream>
#include <string>

namespace geodesic
{

namespace
{

/// The points of one curve of the source, numbered through all blocks.
struct Chain
{
  std::vector<std::size_t> points;
  bool closed = false;
  std::string name;
  Id source = 0;
};

/// Takes the curves out of the cells of one block.
class ChainReader
{
public:
  /// \param firstPoint the number of the block's point 0 among those of all blocks.
  /// \param chains to which curves are added.
  /// \param sources of the blocks before, to which those of this one are added.
  ChainReader(const PolyDataBlock& block, std::size_t firstPoint, std::vector<Chain>& chains,
    SourcePolylines& sources)
    : block_(block)
    , firstPoint_(firstPoint)
    , firstSource_(sources.numberOfSources)
    , chains_(chains)
    , firstChain_(chains.size())
    , sources_(sources)
  {
  }

  void read()
  {
    vtkPolyData* source = this->block_.data;
    if (source->GetNumberOfCells() == source->GetNumberOfVerts())
    {
      this->readPoints();
      return;
    }
    this->read(source->GetVerts(), &ChainReader::addVertices);
    this->read(source->GetLines(), &ChainReader::addLine);
    this->read(source->GetPolys(), &ChainReader::addPolygon);
    this->read(source->GetStrips(), &ChainReader::addStrip);
    this->block_.inputCells.empty() ? this->addIdsOfCells() : this->addIdsOfChains();
    this->sources_.numberOfSources += static_cast<Id>(this->cell_);
    this->sources_.droppedCells += this->block_.droppedCells;
  }

private:
  using Adder = void (ChainReader::*)(vtkIdType, const vtkIdType*);

  /// Each point is a source of its own, however many of them a vertex cell has.
  void readPoints()
  {
    const vtkIdType count = this->block_.data->GetNumberOfPoints();
    this->isSource_.assign(
      static_cast<std::size_t>(count), this->block_.data->GetNumberOfVerts() == 0);
    this->read(this->block_.data->GetVerts(), &ChainReader::markPoints);
    for (vtkIdType i = 0; i < count; ++i)
    {
      if (this->isSource_[static_cast<std::size_t>(i)])
      {
        this->addPoint(i, this->sourceOf(i));
      }
    }
    this->addIdsOfChains();
    this->sources_.numberOfSources += static_cast<Id>(count);
  }

  /// Cells without points are sources, too.
  void addIdsOfCells()
  {
    for (vtkIdType i = 0; i < this->cell_; ++i)
    {
      this->sources_.ids.push_back(this->sourceOf(i));
    }
  }

  void addIdsOfChains()
  {
    std::vector<Id>& ids = this->sources_.ids;
    const auto before = static_cast<std::ptrdiff_t>(ids.size());
    for (std::size_t i = this->firstChain_; i < this->chains_.size(); ++i)
    {
      ids.push_back(this->chains_[i].source);
    }
    std::sort(ids.begin() + before, ids.end());
    ids.erase(std::unique(ids.begin() + before, ids.end()), ids.end());
  }

  void markPoints(vtkIdType size, const vtkIdType* ids)
  {
    for (vtkIdType i = 0; i < size; ++i)
    {
      this->isSource_[static_cast<std::size_t>(ids[i])] = true;
    }
  }

  void read(vtkCellArray* cells, Adder add)
  {
    forEachCell(cells,
      [&](vtkIdType size, const vtkIdType* ids)
      {
        requirePoints<SourceError>(this->block_, this->inputCell(), size, ids);
        if (size > 0)
        {
          (this->*add)(size, ids);
        }
        ++this->cell_;
      });
  }

  std::size_t pointOf(vtkIdType id) const
  {
    return this->firstPoint_ + static_cast<std::size_t>(id);
  }

  /// The cell that is being read.
  vtkIdType inputCell() const
  {
    const std::vector<vtkIdType>& numbers = this->block_.inputCells;
    return numbers.empty() ? this->cell_ : numbers[static_cast<std::size_t>(this->cell_)];
  }

  /// \param number of a cell, or a point, of the input.
  Id sourceOf(vtkIdType number) const { return this->firstSource_ + static_cast<Id>(number); }

  void addPoint(vtkIdType point, Id source)
  {
    this->chains_.push_back({ { this->pointOf(point) }, false,
      "point " + std::to_string(point) + " of " + this->block_.name, source });
  }

  void addVertices(vtkIdType size, const vtkIdType* ids)
  {
    for (vtkIdType i = 0; i < size; ++i)
    {
      this->addPoint(ids[i], this->sourceOf(this->inputCell()));
    }
  }

  void addChain(const std::vector<vtkIdType>& ids, bool closed)
  {
    Chain& chain = this->chains_.emplace_back();
    for (const vtkIdType id : ids)
    {
      chain.points.push_back(this->pointOf(id));
    }
    chain.closed = closed && ids.size() > 2;
    chain.name = "cell " + std::to_string(this->inputCell()) + " of " + this->block_.name;
    chain.source = this->sourceOf(this->inputCell());
  }

  void addLine(vtkIdType size, const vtkIdType* ids)
  {
    const bool closed = size > 3 && ids[0] == ids[size - 1];
    this->addChain({ ids, ids + (closed ? size - 1 : size) }, closed);
  }

  void addPolygon(vtkIdType size, const vtkIdType* ids)
  {
    this->addChain({ ids, ids + size }, true);
  }

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
    this->addChain(outline, true);
  }

  const PolyDataBlock& block_;
  std::size_t firstPoint_;
  Id firstSource_;
  std::vector<Chain>& chains_;
  /// Of this block.
  std::size_t firstChain_;
  SourcePolylines& sources_;
  vtkIdType cell_ = 0;
  /// Of a set of points.
  std::vector<bool> isSource_;
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

/// \param cell the barrier, as nameOfBarrier() says.
SourceError liesInBarrier(const PolyDataSurface& surface, const LocatedPolyline& line,
  std::size_t point, const std::string& cell)
{
  return SourceError('P' + nameOfPoint(line, point).substr(1) + ", at " +
    textOf(surface.scale().toUser(line.points[point])) +
    ", lies in a barrier (BarrierArrayName): it is closest to " + cell +
    ", which no path may leave. Move it out of the barrier, or onto its rim.");
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
  return surface.partition().isDistributed() ? name + " on rank " + std::to_string(face.rank)
                                             : name;
}

std::vector<char> usedPoints(const std::vector<Chain>& chains, std::size_t numberOfPoints)
{
  std::vector<char> used(numberOfPoints, 0);
  for (const Chain& chain : chains)
  {
    for (const std::size_t point : chain.points)
    {
      used[point] = 1;
    }
  }
  return used;
}

}

std::string nameOfPoint(const LocatedPolyline& line, std::size_t point)
{
  const bool isNamed = line.name.compare(0, 5, "point") == 0;
  return isNamed ? line.name : "point " + std::to_string(point) + " of " + line.name;
}

SourcePolylines readSource(const std::vector<PolyDataBlock>& source, const PowerOfTwoScale& scale)
{
  std::vector<Chain> chains;
  std::vector<Vec3> points;
  std::vector<std::size_t> firstPoints;
  SourcePolylines result;
  for (const PolyDataBlock& block : source)
  {
    firstPoints.push_back(points.size());
    ChainReader(block, points.size(), chains, result).read();
    for (vtkIdType i = 0; i < block.data->GetNumberOfPoints(); ++i)
    {
      block.data->GetPoint(i, points.emplace_back().data());
    }
  }
  if (chains.empty())
  {
    throwEmpty(result);
  }
  const std::vector<char> used = usedPoints(chains, points.size());
  for (std::size_t i = 0; i < source.size(); ++i)
  {
    const std::string bad = whereNotFinite(source[i], used.data() + firstPoints[i]);
    if (!bad.empty())
    {
      throw SourceError(bad);
    }
  }

  result.polylines.reserve(chains.size());
  for (Chain& chain : chains)
  {
    LocatedPolyline line;
    line.closed = chain.closed;
    line.name = std::move(chain.name);
    line.source = chain.source;
    for (const std::size_t point : chain.points)
    {
      line.points.push_back(scale.toEngine(points[point]));
      if (!(norm(line.points.back()) < Infinity))
      {
        throw SourceError("Point " + std::to_string(line.points.size() - 1) + " of " + line.name +
          " is too far from the surface for its size. Scale or move the source upstream.");
      }
    }
    result.polylines.push_back(std::move(line));
  }
  return result;
}

void requireOutsideBarriers(const PolyDataSurface& surface,
  const std::vector<PolyDataBlock>& surfaceBlocks, const std::vector<LocatedPolyline>& polylines,
  const LocatedPlaces& located, double coordinatePrecision)
{
  if (!surface.hasBarriers())
  {
    return;
  }
  const std::vector<RankAddress> barriers =
    surface.barriers()->barriersAt(located.places, located.faces, coordinatePrecision);
  for (const LocatedPolyline& line : polylines)
  {
    for (std::size_t i = 0; i < line.points.size(); ++i)
    {
      const RankAddress& face = barriers[located.indexOf(line.points[i])];
      if (face.id != NoId)
      {
        throw liesInBarrier(surface, line, i, nameOfBarrier(surface, surfaceBlocks, face));
      }
    }
  }
}

SnapOptions snapOptionsFor(const std::vector<PolyDataBlock>& source)
{
  SnapOptions options;
  for (const PolyDataBlock& block : source)
  {
    if (block.data->GetNumberOfPoints() > 0 && block.data->GetPoints()->GetDataType() == VTK_FLOAT)
    {
      options.coordinatePrecision = FLT_EPSILON;
    }
  }
  return options;
}

void writeCurves(const TriangleMesh& mesh, const PowerOfTwoScale& scale,
  const std::vector<SourceCurve>& curves, const std::vector<std::vector<double>>& arcLengths,
  vtkPolyData* output)
{
  vtkIdType size = 0;
  for (const SourceCurve& curve : curves)
  {
    size += static_cast<vtkIdType>(curve.points.size());
  }
  // A point, its arc length, its id and an offset, twice while an array grows to twice its size.
  requireMemory(size, 4 * (4 * sizeof(double) + 2 * sizeof(vtkIdType)));
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkCellArray> lines;
  std::vector<Id> sourcesOfVertices;
  std::vector<Id> sourcesOfLines;
  vtkNew<vtkDoubleArray> lengths;
  lengths->SetName("SourceArcLength");
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    const SourceCurve& curve = curves[c];
    const bool closed = curve.isClosed();
    const auto count = static_cast<vtkIdType>(curve.points.size());
    const vtkIdType first = points->GetNumberOfPoints();
    vtkCellArray* cells = count > 1 ? lines : vertices;
    (count > 1 ? sourcesOfLines : sourcesOfVertices).push_back(curve.source);
    cells->InsertNextCell(static_cast<int>(count));
    for (vtkIdType i = 0; i < count; ++i)
    {
      if (closed && i > 0 && i + 1 == count)
      {
        cells->InsertCellPoint(first);
        continue;
      }
      const auto at = static_cast<std::size_t>(i);
      cells->InsertCellPoint(
        points->InsertNextPoint(scale.toUser(position(mesh, curve.points[at])).data()));
      if (!arcLengths.empty())
      {
        lengths->InsertNextValue(arcLengths[c][at]);
      }
    }
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
  output->SetLines(lines);
  if (!arcLengths.empty())
  {
    output->GetPointData()->AddArray(lengths);
  }

  vtkNew<vtkIdTypeArray> sources; // in the order of the cells: vertices come first
  sources->SetName("SourceId");
  for (const std::vector<Id>* ids : { &sourcesOfVertices, &sourcesOfLines })
  {
    for (const Id id : *ids)
    {
      sources->InsertNextValue(static_cast<vtkIdType>(id));
    }
  }
  output->GetCellData()->AddArray(sources);
}

}
