// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/SourcesAndTargets.h"

#include "PolyData/reading/CoveredFaces.h"
#include "PolyData/reading/CutSourceFaces.h"
#include "PolyData/reading/LineChains.h"
#include "PolyData/reading/PolyDataSurface.h"
#include "PolyData/reading/SourceFaces.h"
#include "mesh/SurfaceSnap.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <set>
#include <sstream>
#include <string>
#include <utility>

namespace geodesic
{

namespace
{

/// A number as an Id, or another one if it is none.
Id idOr(vtkIdType number, Id other)
{
  return number >= 0 && number < static_cast<vtkIdType>(NoId) ? static_cast<Id>(number) : other;
}

/// The vertex of a point of the surface if a point in space lies there, within the precision of its
/// coordinates; NoId if not. Points of several blocks or ranks have no numbers in common.
Id vertexIfThere(
  const PolyDataSurface& surface, Id number, const Vec3& place, double coordinatePrecision)
{
  if (surface.partition.isDistributed() || surface.blocks.size() != 1 ||
    number >= surface.numberOfPoints)
  {
    return NoId;
  }
  const TriangleMesh& mesh = surface.mesh();
  const Id vertex = surface.vertexOf(number);
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

/// Makes vertices of the numbers of the surface's points.
void findVertices(const PolyDataSurface& surface, double coordinatePrecision, LocatedPolyline& line)
{
  for (std::size_t i = 0; i < line.vertices.size(); ++i)
  {
    line.vertices[i] =
      vertexIfThere(surface, line.vertices[i], line.points[i], coordinatePrecision);
  }
}

/// \throws SourceError if a point is too far away.
void scalePoints(
  const PolyDataSurface& surface, double coordinatePrecision, std::vector<LocatedPolyline>& lines)
{
  for (LocatedPolyline& line : lines)
  {
    for (std::size_t i = 0; i < line.points.size(); ++i)
    {
      line.points[i] = surface.scale.toEngine(line.points[i]);
      if (!(norm(line.points[i]) < Infinity))
      {
        throw SourceError(line.nameOfPoint(i).atBeginning() +
          " is too far from the surface for its size. Scale or move the source upstream.");
      }
    }
    findVertices(surface, coordinatePrecision, line);
  }
}

/// Takes the curves out of the cells of one block. Ids are numbers of cells and points.
struct SourceBlockReader
{
  const PolyDataBlock& block;
  /// The polylines of the blocks before; this block adds its own.
  SourcePolylines& sources;
  /// Whether a negative id stands for no part.
  bool isNegativeNone = false;
  const Id firstSource = static_cast<Id>(sources.idEnd);
  vtkIdType cell = 0;
  std::vector<char> isUsed{};

  /// \returns of each point whether a curve has it.
  std::vector<char> read()
  {
    vtkPolyData* source = this->block.data;
    const auto before = static_cast<std::ptrdiff_t>(this->sources.ids.size());
    this->isUsed.assign(static_cast<std::size_t>(source->GetNumberOfPoints()), 0);
    if (this->block.isSetOfPoints())
    {
      this->readPoints();
      return std::move(this->isUsed);
    }
    this->read(source->GetVerts(), &SourceBlockReader::addVertices);
    this->read(source->GetLines(), &SourceBlockReader::addLine);
    this->read(source->GetPolys(), &SourceBlockReader::addPolygon);
    this->read(source->GetStrips(), &SourceBlockReader::addStrip);
    std::sort(this->sources.ids.begin() + before, this->sources.ids.end());
    this->sources.idEnd += this->cell;
    this->sources.droppedCells += this->block.droppedCells;
    return std::move(this->isUsed);
  }

  using Adder = void (SourceBlockReader::*)(vtkIdType, const vtkIdType*);

  /// Each point is a source of its own, however many of them a vertex cell has.
  void readPoints()
  {
    vtkPolyData* source = this->block.data;
    forEachCell(source->GetVerts(),
      [&](vtkIdType size, const vtkIdType* ids)
      {
        requirePoints<SourceError>(this->block, this->cell++, size, ids);
        this->usePoints(size, ids);
      });
    for (vtkIdType i = 0; i < source->GetNumberOfPoints(); ++i)
    {
      if (!this->isNone(i) &&
        (source->GetNumberOfVerts() == 0 || this->isUsed[static_cast<std::size_t>(i)]))
      {
        this->addPoint(i, this->sourceOf(i));
        this->sources.ids.push_back(this->sourceOf(i));
      }
    }
    this->sources.idEnd += source->GetNumberOfPoints();
  }

  void read(vtkCellArray* cells, Adder add)
  {
    const bool isPolyData = this->block.inputCells.empty();
    forEachCell(cells,
      [&](vtkIdType size, const vtkIdType* ids)
      {
        requirePoints<SourceError>(this->block, this->inputCell(), size, ids);
        const bool isPart = !this->isNone(this->inputCell());
        if (size > 0 && isPart)
        {
          (this->*add)(size, ids);
        }
        if ((size > 0 || isPolyData) &&
          isPart) // a cell of a vtkPolyData is a source without points, too
        {
          this->sources.ids.push_back(this->sourceOf(this->inputCell()));
        }
        ++this->cell;
      });
  }

  /// The cell that is being read.
  vtkIdType inputCell() const
  {
    const std::vector<vtkIdType>& numbers = this->block.inputCells;
    return numbers.empty() ? this->cell : numbers[static_cast<std::size_t>(this->cell)];
  }

  /// \param number of a cell, or a point, of the input; of sourceOf(), too.
  bool isNone(vtkIdType number) const
  {
    return this->isNegativeNone && this->block.sourceIds[static_cast<std::size_t>(number)] < 0;
  }
  Id sourceOf(vtkIdType number) const { return this->firstSource + static_cast<Id>(number); }

  void usePoints(vtkIdType size, const vtkIdType* ids)
  {
    for (vtkIdType i = 0; i < size; ++i)
    {
      this->isUsed[static_cast<std::size_t>(ids[i])] = 1;
    }
  }

  LocatedPolyline& addPolyline(vtkIdType size, const vtkIdType* ids, PartName name, Id source)
  {
    this->usePoints(size, ids);
    LocatedPolyline& line = this->sources.polylines.emplace_back();
    line.name = std::move(name);
    line.source = source;
    line.points.resize(static_cast<std::size_t>(size));
    for (vtkIdType i = 0; i < size; ++i)
    {
      this->block.data->GetPoint(ids[i], line.points[static_cast<std::size_t>(i)].data());
    }
    for (vtkIdType i = 0; i < size && !this->block.originalPoints.empty(); ++i)
    {
      line.vertices.push_back(
        idOr(this->block.originalPoints[static_cast<std::size_t>(ids[i])], NoId));
    }
    return line;
  }

  void addPoint(vtkIdType point, Id source)
  {
    LocatedPolyline& line =
      this->addPolyline(1, &point, this->block.name.part("point", point), source);
    line.pointNames = { line.name };
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
    const vtkIdType number = this->inputCell();
    this->addPolyline(size, ids, this->block.name.part("cell", number), this->sourceOf(number))
      .closed = closed && size > 2;
  }

  void addLine(vtkIdType size, const vtkIdType* ids)
  {
    if (size == 2)
    {
      this->sources.lines.push_back(this->sources.polylines.size());
    }
    const bool closed = size > 3 && ids[0] == ids[size - 1];
    this->addCurve(closed ? size - 1 : size, ids, closed);
  }

  void addPolygon(vtkIdType size, const vtkIdType* ids)
  {
    this->addCurve(size, ids, true);
    if (size > 2)
    {
      this->sources.faces.push_back(std::move(this->sources.polylines.back()));
      this->sources.polylines.pop_back();
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

/// The values that name the parts of a source, by the numbers of cells and points over all blocks;
/// empty if none do.
///
/// \param ids of all that are sources, ascending.
/// \param array what the array names, and the property that chooses it, for messages.
/// \throws SourceError if a value of one of these is no id.
std::vector<vtkIdType> namesOfParts(const std::vector<PolyDataBlock>& source,
  const std::vector<vtkIdType>& ids, const std::string& array)
{
  std::vector<vtkIdType> names;
  auto id = ids.begin();
  for (const PolyDataBlock& block : source)
  {
    const auto first = static_cast<vtkIdType>(names.size());
    names.insert(names.end(), block.sourceIds.begin(), block.sourceIds.end());
    for (; id != ids.end() && *id < static_cast<vtkIdType>(names.size()); ++id)
    {
      const vtkIdType name = names[static_cast<std::size_t>(*id)];
      if (name < 0 || name >= SourceIdEnd)
      {
        throw SourceError(
          block.name.part(block.isSetOfPoints() ? "point" : "cell", *id - first).atBeginning() +
          (name < 0 ? " has a negative value" : " has a value that is too large") +
          " in the array that names " + array + ": ids are from 0 to " +
          std::to_string(SourceIdEnd - 1) + ", as -1 stands for points that are not reached.");
      }
    }
  }
  return names;
}

/// Makes sources of the cells and points that were read: those with one id are one.
///
/// \param names the ids of cells and points; if empty, their numbers.
/// \param called what these are called; empty: nothing.
void makeSources(const std::vector<vtkIdType>& names, const std::vector<std::string>& called,
  SourcePolylines& sources)
{
  const auto nameOf = [&names](vtkIdType number)
  { return names.empty() ? number : names[static_cast<std::size_t>(number)]; };
  std::vector<vtkIdType>& ids = sources.ids;
  const std::vector<vtkIdType> numbers = ids;
  std::transform(ids.begin(), ids.end(), ids.begin(), nameOf);
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  const auto placeOf = [&](vtkIdType number)
  { return std::lower_bound(ids.begin(), ids.end(), nameOf(number)) - ids.begin(); };
  for (std::vector<LocatedPolyline>* lines : { &sources.polylines, &sources.faces })
  {
    for (LocatedPolyline& line : *lines)
    {
      line.source = static_cast<Id>(placeOf(line.source));
    }
  }
  sources.names.resize(called.empty() ? 0 : ids.size());
  for (auto number = numbers.rbegin(); !called.empty() && number != numbers.rend(); ++number)
  {
    sources.names[static_cast<std::size_t>(placeOf(*number))] =
      called[static_cast<std::size_t>(*number)];
  }
  sources.idEnd = names.empty() ? sources.idEnd : ids.back() + 1;
}

void removeIds(const std::vector<Id>& gone, std::vector<vtkIdType>& ids)
{
  ids.erase(std::remove_if(ids.begin(), ids.end(),
              [&gone](vtkIdType id)
              { return std::binary_search(gone.begin(), gone.end(), static_cast<Id>(id)); }),
    ids.end());
}

std::set<Id> sourcesOf(const std::vector<LocatedPolyline>& lines)
{
  std::set<Id> sources;
  for (const LocatedPolyline& line : lines)
  {
    sources.insert(line.source);
  }
  return sources;
}

/// Joins lines of one name to curves.
void joinLines(const std::vector<vtkIdType>& names, SourcePolylines& sources)
{
  std::vector<vtkIdType> parts;
  for (std::size_t i = 0; !names.empty() && i < sources.lines.size(); ++i)
  {
    parts.push_back(names[sources.polylines[sources.lines[i]].source]);
  }
  removeIds(joinLines(sources.polylines, sources.lines, parts), sources.ids);
}

/// Makes regions of faces of one name; without names, of those with a common edge, if they are
/// joined.
void joinFaces(const std::vector<vtkIdType>& names, bool areJoined, SourcePolylines& sources)
{
  std::vector<LocatedPolyline> parts;
  std::vector<std::size_t> firstParts;
  for (const std::vector<LocatedPolyline>& ofFace : sources.partsOfFaces)
  {
    firstParts.push_back(parts.size());
    parts.insert(parts.end(), ofFace.begin(), ofFace.end());
  }
  std::vector<vtkIdType> values;
  for (const LocatedPolyline& part : parts)
  {
    values.push_back(names.empty() ? static_cast<vtkIdType>(part.source) : names[part.source]);
  }
  const std::vector<Id> gone =
    makeRegions(parts, values, areJoined && names.empty(), sources.polylines);
  for (std::size_t face = 0; face < sources.faces.size(); ++face)
  {
    sources.faces[face].source = parts[firstParts[face]].source;
  }
  if (names.empty())
  {
    removeIds(gone, sources.ids);
  }
}

/// Leaves out faces that lie in barriers, which are no faces of the surface. All ranks call this
/// together.
///
/// \throws SourceError if they are all of the source.
void leaveOutBarriers(const PolyDataSurface& surface, double coordinatePrecision,
  PolylineLocator& locator, const Job& job, SourcePolylines& sources)
{
  if (!surface.barriers || sources.faces.empty())
  {
    return;
  }
  const std::vector<LocatedPolyline> inside = pointsInside(sources.faces);
  const LocatedPlaces located = locator.locate(inside, coordinatePrecision, job);
  // Thin faces, too, lie in one or in the other: no rim.
  const std::vector<RankAddress> barriers =
    surface.barriers->barriersAt(located.places, located.faces, coordinatePrecision, 0.0);
  std::size_t left = 0;
  for (std::size_t i = 0; i < inside.size(); ++i)
  {
    if (barriers[located.indexOf(inside[i].points.front())].id == NoId)
    {
      std::swap(sources.faces[left], sources.faces[i]);
      std::swap(sources.partsOfFaces[left], sources.partsOfFaces[i]);
      ++left;
    }
  }
  sources.faces.resize(left);
  sources.partsOfFaces.resize(left);
  if (sources.faces.empty() && sources.polylines.empty())
  {
    throw SourceError("All of the source (input port 1) lies in barriers (BarrierArrayName), which "
                      "no path may leave. Choose faces outside of barriers.");
  }
}

/// The sources that had faces before and have none left, ascending.
std::vector<Id> sourcesWithoutFaces(
  const std::set<Id>& before, const std::vector<LocatedPolyline>& faces)
{
  const std::set<Id> left = sourcesOf(faces);
  std::vector<Id> gone;
  std::set_difference(
    before.begin(), before.end(), left.begin(), left.end(), std::back_inserter(gone));
  return gone;
}

/// The polylines and faces of all blocks, on the surface's scale.
///
/// \throws SourceError
SourcePolylines readPolylines(
  const std::vector<PolyDataBlock>& source, const PolyDataSurface& surface, bool isNegativeNone)
{
  SourcePolylines result;
  for (const PolyDataBlock& block : source)
  {
    const std::vector<char> used = SourceBlockReader{ block, result, isNegativeNone }.read();
    const std::string bad = whereNotFinite(block, used.data());
    if (!bad.empty())
    {
      throw SourceError(bad);
    }
  }
  const double precision = coordinatePrecisionOf(source);
  scalePoints(surface, precision, result.polylines);
  scalePoints(surface, precision, result.faces);
  return result;
}

/// Makes sources of polylines and faces.
///
/// \param array as namesOfParts().
void makeParts(const std::vector<PolyDataBlock>& source, const std::string& array,
  bool areLinesJoined, SourcePolylines& result)
{
  const std::vector<vtkIdType> names = namesOfParts(source, result.ids, array);
  if (areLinesJoined)
  {
    joinLines(names, result);
  }
  joinFaces(names, areLinesJoined, result);
  std::vector<std::string> called;
  for (const PolyDataBlock& block : source)
  {
    called.insert(called.end(), block.partNames.begin(), block.partNames.end());
  }
  makeSources(names, called, result);
}

/// \throws SourceError
[[noreturn]] void throwEmpty(const SourcePolylines& sources)
{
  if (sources.droppedCells > 0)
  {
    throw SourceError(
      "The source (input port 1) has no vertex, line or flat face with points among its " +
      std::to_string(sources.droppedCells) +
      " cells. Apply Extract Surface to it for its faces, Feature Edges after that for its edges, "
      "or take some of its points by Extract Selection.");
  }
  throw SourceError(
    "The source (input port 1) is empty: it has no points that a line or vertex uses. Connect a "
    "curve with at least one point, or set Source Type to Surface Boundary.");
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

/// The share of the job for finding the closest faces.
constexpr double Located = 0.8;

/// The targets, as polylines of one point each.
std::vector<LocatedPolyline> readPoints(
  const std::vector<PolyDataBlock>& blocks, const PartName& name, const PolyDataSurface& surface)
{
  std::vector<LocatedPolyline> points;
  const double precision = coordinatePrecisionOf(blocks);
  for (const PolyDataBlock& block : blocks)
  {
    for (vtkIdType i = 0; i < block.data->GetNumberOfPoints(); ++i)
    {
      Vec3 p;
      block.data->GetPoint(i, p.data());
      LocatedPolyline& point = points.emplace_back();
      point.points = { surface.scale.toEngine(p) };
      if (isFinite(p) && !(norm(point.points.front()) < Infinity))
      {
        throw InputError(block.name.part("point", i).atBeginning() +
          " is too far from the surface for its size. Scale or move it upstream.");
      }
      if (isFinite(p) && !block.originalPoints.empty())
      {
        point.vertices = { idOr(block.originalPoints[static_cast<std::size_t>(i)], NoId) };
        findVertices(surface, precision, point);
      }
    }
    if (const std::string bad = whereNotFinite(block); !bad.empty())
    {
      throw InputError(bad);
    }
  }
  if (points.empty())
  {
    throw InputError(
      name.atBeginning() + " is empty: there are no points. Connect at least one point.");
  }
  return points;
}

/// Where a rank would put a target.
struct OwnPlace
{
  SnappedPoint point;
  /// The rank with the least has the target.
  double order = Infinity;
};

/// If several faces are equally close, chooses one in which the point lies on a vertex, or else on
/// an edge, or else the first one, as putOntoSurface() does with a single point.
OwnPlace snapToOwnFace(const MeshPartition& surface, const Vec3& point,
  const std::vector<ClosestFace>& closest, double coordinatePrecision)
{
  OwnPlace best;
  for (std::size_t k = 0; k < closest.size(); ++k)
  {
    if (closest[k].face.rank == surface.exchange().rank())
    {
      const SnappedPoint here =
        snapToFace(surface.mesh(), closest[k].face.id, point, coordinatePrecision);
      const auto kind = static_cast<std::size_t>(here.place.kind);
      const auto order = static_cast<double>(kind * closest.size() + k);
      best = order < best.order ? OwnPlace{ here, order } : best;
    }
  }
  return best;
}

}

SourcePolylines readSource(const std::vector<PolyDataBlock>& source, const PolyDataSurface& surface,
  bool areLinesJoined, PolylineLocator& locator, const Job& job)
{
  SourcePolylines result = readPolylines(source, surface, false);
  if (result.polylines.empty() && result.faces.empty())
  {
    throwEmpty(result);
  }
  const std::set<Id> before = sourcesOf(result.faces);
  result.partsOfFaces = cutAtFacesWithoutArea(result.faces);
  leaveOutBarriers(surface, coordinatePrecisionOf(source), locator, job, result);
  if (areLinesJoined && !arePartsNamed(source))
  {
    removeIds(sourcesWithoutFaces(before, result.faces), result.ids);
  }
  makeParts(source, "the parts of the source (SourceIdArrayName)", areLinesJoined, result);
  return result;
}

SourcePolylines readTargetSets(
  const std::vector<PolyDataBlock>& blocks, const PartName& name, const PolyDataSurface& surface)
{
  SourcePolylines result = readPolylines(blocks, surface, true);
  if (result.polylines.empty() && result.faces.empty())
  {
    throw InputError(name.atBeginning() +
      " has no target: no point, line or flat face has a value of at least 0 in the array of "
      "TargetIdArrayName. Negative values stand for none.");
  }
  result.partsOfFaces = cutAtFacesWithoutArea(result.faces);
  makeParts(blocks, "targets (TargetIdArrayName)", true, result);
  return result;
}

std::vector<RankAddress> barriersAt(
  const PolyDataSurface& surface, const LocatedPlaces& located, double coordinatePrecision)
{
  return surface.barriers
    ? surface.barriers->barriersAt(located.places, located.faces, coordinatePrecision)
    : std::vector<RankAddress>(located.places.size(), RankAddress{ 0, NoId });
}

void leaveOutPointsInBarriers(
  const LocatedPlaces& located, const std::vector<RankAddress>& barriers, SourcePolylines& read)
{
  std::vector<bool> isRegion(read.ids.size(), false); // the first point may stand for all of one
  for (const LocatedPolyline& face : read.faces)
  {
    isRegion[face.source] = true;
  }
  const auto isOut = [&](const LocatedPolyline& line)
  {
    return line.points.size() == 1 && !isRegion[line.source] &&
      barriers[located.indexOf(line.points.front())].id != NoId;
  };
  std::vector<LocatedPolyline>& lines = read.polylines;
  lines.erase(std::remove_if(lines.begin(), lines.end(), isOut), lines.end());
}

void requireOutsideBarriers(const PolyDataSurface& surface,
  const std::vector<PolyDataBlock>& surfaceBlocks, const std::vector<LocatedPolyline>& polylines,
  const LocatedPlaces& located, const std::vector<RankAddress>& barriers)
{
  for (const LocatedPolyline& line : polylines)
  {
    for (std::size_t i = 0; i < line.points.size(); ++i)
    {
      const RankAddress& face = barriers[located.indexOf(line.points[i])];
      if (face.id != NoId)
      {
        const Vec3 place = surface.scale.toUser(line.points[i]);
        std::ostringstream text;
        text << line.nameOfPoint(i).atBeginning() << ", at (" << place[0] << ", " << place[1]
             << ", " << place[2] << "), lies in a barrier (BarrierArrayName): it is closest to "
             << nameOfBarrier(surface, surfaceBlocks, face)
             << ", which no path may leave. Move it out of the barrier, or onto its rim.";
        throw SourceError(text.str());
      }
    }
  }
}

bool arePartsNamed(const std::vector<PolyDataBlock>& source)
{
  return std::any_of(source.begin(), source.end(),
    [](const PolyDataBlock& block) { return !block.sourceIds.empty(); });
}

double coordinatePrecisionOf(const std::vector<PolyDataBlock>& source)
{
  double precision = std::numeric_limits<double>::epsilon();
  for (const PolyDataBlock& block : source)
  {
    precision = std::max(precision, block.precision());
  }
  return precision;
}

Targets readTargets(const std::vector<PolyDataBlock>& blocks, const PartName& name,
  const PolyDataSurface& surface, PolylineLocator& locator, const Job& job)
{
  const std::vector<LocatedPolyline> points = readPoints(blocks, name, surface);
  const double precision = coordinatePrecisionOf(blocks);
  const LocatedPlaces located = locator.locate(points, precision, job.part(0.0, Located));
  const std::vector<RankAddress> barriers = barriersAt(surface, located, precision);
  const Job snapping = job.part(Located, 1.0);
  std::vector<OwnPlace> own;
  std::vector<double> orders;
  for (std::size_t i = 0; i < located.places.size(); ++i)
  {
    snapping.reachItem(i, located.places.size());
    own.push_back(snapToOwnFace(surface.partition, located.places[i], located.faces[i], precision));
    orders.push_back(own.back().order);
  }
  surface.exchange().findLeast(orders);
  Targets targets;
  targets.count = points.size();
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const std::size_t place = located.indexOf(points[i].points.front());
    if (own[place].order < Infinity && own[place].order == orders[place] &&
      barriers[place].id == NoId)
    {
      targets.numbers.push_back(i);
      const Id vertex = points[i].vertexOf(0);
      targets.places.push_back(
        vertex == NoId ? own[place].point.place : SurfacePoint::atVertex(vertex));
      targets.snapDistances.push_back(own[place].point.distance);
    }
  }
  return targets;
}

}
