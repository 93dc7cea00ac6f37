// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/SurfaceReader.h"

#include "PolyData/ParallelFor.h"
#include "PolyData/ranks/RankSeams.h"
#include "PolyData/ranks/SeamMerger.h"
#include "PolyData/reading/Duplicates.h"
#include "PolyData/reading/PointMerger.h"
#include "PolyData/reading/TriangleReader.h"
#include "mesh/Box.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cfloat>
#include <cstdint>
#include <numeric>
#include <sstream>
#include <string>
#include <unordered_map>
#include <utility>

namespace geodesic
{

namespace
{

// Where the stages end, as fractions of the whole.
constexpr double PointsRead = 0.1;
constexpr double PointsMerged = 0.25;
constexpr double TrianglesRead = 0.4;

/// The vertices of this rank's blocks.
struct Vertices
{
  std::vector<Vec3> positions;
  VertexOfPoint of;
  RankLabels labels;

  /// Appends the places and the labels of some vertices.
  void copy(const std::vector<Id>& some, std::vector<Vec3>& points,
    std::vector<RankLabels::Label>& keys) const
  {
    for (const Id vertex : some)
    {
      points.push_back(this->positions[vertex]);
      keys.push_back(this->labels.of(vertex));
    }
  }

  /// Makes one vertex of those that are the same.
  ///
  /// \param same for each vertex the one of the same that stays.
  void join(const std::vector<Id>& same)
  {
    Id count = 0;
    while (count < same.size() && same[count] == count)
    {
      ++count;
    }
    if (count == same.size())
    {
      return;
    }
    std::vector<RankLabels::Label>& known = this->labels.labels;
    std::vector<Id> numbers(same.size());
    std::iota(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(count), Id(0));
    for (Id vertex = count; vertex < same.size(); ++vertex)
    {
      if (same[vertex] == vertex)
      {
        this->positions[count] = this->positions[vertex];
        if (!known.empty())
        {
          known[count] = known[vertex];
        }
        numbers[vertex] = count++;
      }
    }
    for (Id vertex = 0; vertex < same.size(); ++vertex)
    {
      numbers[vertex] = numbers[same[vertex]];
    }
    this->positions.resize(count);
    known.resize(known.empty() ? 0 : count);
    this->of.renumber(std::move(numbers));
  }
};

/// The faces of the surface, on vertices.
struct Faces
{
  std::vector<Triangle> open;
  std::vector<Triangle> barriers;
};

double precisionOf(const PolyDataBlock& block)
{
  vtkPoints* points = block.data->GetPoints();
  return points && points->GetDataType() == VTK_FLOAT ? double(FLT_EPSILON) : DBL_EPSILON;
}

/// Triangles from the first to before the last, for joining seams.
SeamBlock seamBlock(const Vertices& vertices, const TriangleList& triangles, std::size_t first,
  std::size_t last, double precision)
{
  SeamBlock seam;
  seam.precision = precision;
  for (std::size_t i = first; i < last; ++i)
  {
    (triangles.isDuplicate[i] ? seam.ghosts : seam.triangles)
      .push_back(vertices.of(triangles.corners[i]));
  }
  return seam;
}

/// Reads the blocks of one surface, stage by stage.
class SurfaceReader
{
public:
  SurfaceReader(const std::vector<PolyDataBlock>& inputs, const BarrierArrays& barriers,
    Exchange& exchange, const ProgressCallback& callback)
    : inputs_(inputs)
    , barriers_(barriers)
    , exchange_(exchange)
    , callback_(callback)
    , parallelFor_(smpParallelFor())
  {
  }

  SurfaceContents read(bool mergeCoincidentPoints)
  {
    LoopProgress progress(this->callback_);
    const vtkIdType numberOfFaces = this->requireFaces();
    std::vector<SurfaceBlock> blocks = this->numberPoints();
    Vertices vertices;
    progress.nextUntil(PointsRead);
    vertices.positions = this->readPoints(blocks, progress);
    progress.nextUntil(PointsMerged);
    if (mergeCoincidentPoints)
    {
      vertices.join(firstAtPlaces(vertices.positions, progress, this->parallelFor_));
    }
    progress.nextUntil(TrianglesRead);
    TriangleList triangles = readTriangles(this->inputs_, vertices.of, numberOfFaces, progress,
      this->parallelFor_, blocks, this->report_);
    this->requireTriangles(triangles, numberOfFaces);
    const PowerOfTwoScale scale = this->scaleVertices(triangles, vertices);
    if (mergeCoincidentPoints)
    {
      this->joinBlocks(triangles, vertices);
    }
    if (this->exchange_.numberOfRanks() > 1)
    {
      this->joinRanks(mergeCoincidentPoints, blocks, triangles, vertices);
    }
    std::vector<TriangleRole> roles = this->findRoles(vertices, triangles);
    keepTriangles(this->inputs_, triangles, blocks);
    Faces faces = this->takeFaces(std::move(triangles), roles, vertices);
    const double diagonal = this->diagonalOf(vertices, faces);
    SurfaceContents surface = this->makeSurface(std::move(vertices), std::move(faces));
    surface.blocks = std::move(blocks);
    surface.roles = std::move(roles);
    surface.scale = scale;
    surface.diagonal = diagonal;
    surface.report = this->reportOfAllRanks(surface.partition);
    return surface;
  }

private:
  bool isTrueOnAll(bool condition) const { return !this->exchange_.isTrueAnywhere(!condition); }
  vtkIdType requireFaces() const;
  std::string whatThereIsInsteadOfFaces() const;
  std::vector<SurfaceBlock> numberPoints() const;
  std::vector<Vec3> readPoints(
    const std::vector<SurfaceBlock>& blocks, const LoopProgress& progress) const;
  void requireTriangles(const TriangleList& triangles, vtkIdType numberOfFaces) const;
  PowerOfTwoScale scaleVertices(const TriangleList& triangles, Vertices& vertices);
  void joinBlocks(const TriangleList& triangles, Vertices& vertices);
  void joinRanks(bool mergeCoincidentPoints, const std::vector<SurfaceBlock>& blocks,
    const TriangleList& triangles, Vertices& vertices);
  void joinSeamsOfRanks(const TriangleList& triangles, Vertices& vertices);
  std::vector<std::pair<std::int64_t, Id>> globalIds(
    const std::vector<SurfaceBlock>& blocks, const Vertices& vertices) const;
  std::vector<TriangleRole> findRoles(const Vertices& vertices, TriangleList& triangles) const;
  void findBarriers(const Vertices& vertices, const TriangleList& triangles,
    std::vector<TriangleRole>& roles) const;
  Faces takeFaces(
    TriangleList triangles, const std::vector<TriangleRole>& roles, const Vertices& vertices) const;
  double diagonalOf(const Vertices& vertices, const Faces& faces) const;
  SurfaceContents makeSurface(Vertices vertices, Faces faces) const;
  SurfaceReport reportOfAllRanks(const MeshPartition& partition) const;

  const std::vector<PolyDataBlock>& inputs_;
  const BarrierArrays& barriers_;
  Exchange& exchange_;
  const ProgressCallback& callback_;
  ParallelFor parallelFor_;
  /// Of the triangles of all ranks, on the mesh's scale.
  double largestCoordinate_ = 0.0;
  SurfaceReport report_;
};

/// How many cells are faces.
///
/// \throws MeshError if no rank has any.
vtkIdType SurfaceReader::requireFaces() const
{
  vtkIdType faces = 0;
  for (const PolyDataBlock& input : this->inputs_)
  {
    faces += input.data->GetNumberOfPolys() + input.data->GetNumberOfStrips();
  }
  if (this->isTrueOnAll(faces == 0))
  {
    throw MeshError(this->whatThereIsInsteadOfFaces());
  }
  return faces;
}

std::string SurfaceReader::whatThereIsInsteadOfFaces() const
{
  const std::string name = "The surface (input port 0) ";
  const std::string advice = "Connect a surface with triangles or polygons.";
  vtkIdType points = 0;
  vtkIdType cells = 0;
  for (const PolyDataBlock& input : this->inputs_)
  {
    points += input.data->GetNumberOfPoints();
    cells += input.data->GetNumberOfCells();
  }
  if (cells > 0)
  {
    return name + "has no faces, but lines or vertices: is it the source? " + advice;
  }
  if (points > 0)
  {
    return name + "has " + std::to_string(points) +
      " points and no faces. PLY files of triangle strips are read so: save them as triangles. " +
      advice;
  }
  return name + "is empty: it has no faces. " + advice;
}

/// Numbers the points of all blocks.
std::vector<SurfaceBlock> SurfaceReader::numberPoints() const
{
  std::vector<SurfaceBlock> blocks;
  vtkIdType count = 0;
  for (const PolyDataBlock& input : this->inputs_)
  {
    const vtkIdType own = input.data->GetNumberOfPoints();
    SurfaceBlock& block = blocks.emplace_back();
    block.firstPoint = static_cast<Id>(count);
    block.numberOfPoints = static_cast<Id>(own);
    count += own;
    if (count >= static_cast<vtkIdType>(NoId))
    {
      throw MeshTooLarge("The surface (input port 0) has " + std::to_string(count) +
        " points, more than 32-bit ids can number. Decimate it or cut it into parts.");
    }
  }
  return blocks;
}

/// \throws MeshError if a coordinate is not finite.
std::vector<Vec3> SurfaceReader::readPoints(
  const std::vector<SurfaceBlock>& blocks, const LoopProgress& progress) const
{
  const std::size_t count =
    blocks.empty() ? 0 : blocks.back().firstPoint + std::size_t(blocks.back().numberOfPoints);
  std::vector<Vec3> positions(count);
  const auto read = [&](std::size_t begin, std::size_t end)
  {
    std::size_t bad = NoId;
    for (std::size_t block = 0; block < blocks.size(); ++block)
    {
      vtkPoints* points = this->inputs_[block].data->GetPoints();
      const std::size_t first = blocks[block].firstPoint;
      const std::size_t last = std::min(end, first + blocks[block].numberOfPoints);
      for (std::size_t i = std::max(begin, first); i < last; ++i)
      {
        points->GetPoint(static_cast<vtkIdType>(i - first), positions[i].data());
        bad = isFinite(positions[i]) ? bad : std::min(bad, block);
      }
    }
    return bad;
  };
  const std::vector<std::size_t> bad = resultsOfRanges(this->parallelFor_, count, progress, read);
  const auto first = std::min_element(bad.begin(), bad.end());
  if (first != bad.end() && *first < blocks.size())
  {
    throw MeshError(whereNotFinite(this->inputs_[*first]));
  }
  return positions;
}

/// \throws MeshError if no rank has a triangle.
void SurfaceReader::requireTriangles(const TriangleList& triangles, vtkIdType numberOfFaces) const
{
  if (this->isTrueOnAll(triangles.corners.empty()))
  {
    const bool isAlone = this->exchange_.numberOfRanks() == 1;
    throw MeshError("None of the " + (isAlone ? std::to_string(numberOfFaces) + " " : "") +
      "faces of the surface (input port 0) has three different corners. Connect a surface with "
      "triangles or polygons.");
  }
}

/// Brings the vertices to a size that the engine can compute with. Points that no triangle uses may
/// be anywhere; they only stay finite.
///
/// \throws MeshError if there is no such size.
PowerOfTwoScale SurfaceReader::scaleVertices(const TriangleList& triangles, Vertices& vertices)
{
  constexpr double largestOfAll = 1e290;
  const std::vector<double> ofRanges = resultsOfRanges(this->parallelFor_, triangles.corners.size(),
    [&](std::size_t begin, std::size_t end)
    {
      double here = 0.0;
      for (std::size_t i = begin; i < end; ++i)
      {
        for (const Id vertex : vertices.of(triangles.corners[i]))
        {
          here = std::max(here, largestCoordinate(vertices.positions[vertex]));
        }
      }
      return here;
    });
  const double largest = this->exchange_.largestOf(
    ofRanges.empty() ? 0.0 : *std::max_element(ofRanges.begin(), ofRanges.end()));
  if (largest > largestOfAll || (largest > 0.0 && largest < 1.0 / largestOfAll))
  {
    std::ostringstream message;
    message << "The largest coordinate of the surface (input port 0) is " << largest
            << ". Distances can be computed where it is between 1e-290 and 1e290: scale the "
               "surface and the source upstream, for example by the Transform filter.";
    throw MeshError(message.str());
  }
  const PowerOfTwoScale scale(largest);
  if (!scale.isOne())
  {
    for (Vec3& p : vertices.positions)
    {
      p = scale.toEngine(p);
      for (double& x : p)
      {
        x = std::clamp(x, -DBL_MAX, DBL_MAX);
      }
    }
  }
  this->largestCoordinate_ = scale.toEngine(largest);
  return scale;
}

/// Connects blocks whose boundaries meet within the rounding of their coordinates.
void SurfaceReader::joinBlocks(const TriangleList& triangles, Vertices& vertices)
{
  if (this->inputs_.size() < 2)
  {
    return;
  }
  std::vector<SeamBlock> seams;
  for (std::size_t i = 0; i < this->inputs_.size(); ++i)
  {
    seams.push_back(seamBlock(vertices, triangles, triangles.firstOfBlock[i],
      triangles.firstOfBlock[i + 1], precisionOf(this->inputs_[i])));
  }
  const JoinedVertices joined = mergeSeams(vertices.positions, vertices.labels, std::move(seams),
    this->largestCoordinate_, OneRank::instance());
  std::vector<Id> same(vertices.positions.size());
  std::iota(same.begin(), same.end(), Id(0));
  for (const auto& [vertex, other] : joined.same)
  {
    same[vertex] = static_cast<Id>(other);
  }
  vertices.join(same);
  this->report_.joinedSeamPoints = static_cast<vtkIdType>(joined.count);
}

/// Labels the vertices: vertices of different ranks that are one get the same label. If several
/// vertices of this rank get the same, they are one, too.
void SurfaceReader::joinRanks(bool mergeCoincidentPoints, const std::vector<SurfaceBlock>& blocks,
  const TriangleList& triangles, Vertices& vertices)
{
  vertices.labels = joinSameVertices(
    vertices.positions, mergeCoincidentPoints, this->globalIds(blocks, vertices), this->exchange_);
  if (mergeCoincidentPoints)
  {
    this->joinSeamsOfRanks(triangles, vertices);
  }
  std::unordered_map<RankLabels::Label, Id> first;
  std::vector<Id> same(vertices.positions.size());
  for (Id vertex = 0; vertex < same.size(); ++vertex)
  {
    same[vertex] = vertices.labels.isSharedAt(vertex)
      ? first.emplace(vertices.labels.of(vertex), vertex).first->second
      : vertex;
  }
  vertices.join(same);
}

void SurfaceReader::joinSeamsOfRanks(const TriangleList& triangles, Vertices& vertices)
{
  double precision = 0.0;
  for (const PolyDataBlock& input : this->inputs_)
  {
    precision = std::max(precision, precisionOf(input));
  }
  const JoinedVertices joined = mergeSeams(vertices.positions, vertices.labels,
    { seamBlock(vertices, triangles, 0, triangles.corners.size(), precision) },
    this->largestCoordinate_, this->exchange_);
  for (Id vertex = 0; vertex < vertices.positions.size() && !joined.same.empty(); ++vertex)
  {
    const auto found = joined.same.find(vertices.labels.of(vertex));
    if (found != joined.same.end())
    {
      vertices.labels.labels[vertex] = found->second | RankLabels::Shared;
    }
  }
  // All ranks have counted the same.
  this->report_.joinedSeamPoints +=
    this->exchange_.rank() == 0 ? static_cast<vtkIdType>(joined.count) : 0;
}

/// A global id and a vertex for each point; empty if points of any rank have no global ids.
std::vector<std::pair<std::int64_t, Id>> SurfaceReader::globalIds(
  const std::vector<SurfaceBlock>& blocks, const Vertices& vertices) const
{
  std::vector<std::pair<std::int64_t, Id>> ids;
  bool isComplete = true;
  for (std::size_t block = 0; block < blocks.size() && isComplete; ++block)
  {
    vtkPolyData* data = this->inputs_[block].data;
    vtkDataArray* array = data->GetPointData()->GetGlobalIds();
    if (!array)
    {
      array = data->GetPointData()->GetArray("GlobalPointIds");
    }
    const vtkIdType count = data->GetNumberOfPoints();
    isComplete = count == 0 || (array && array->GetNumberOfTuples() >= count);
    for (vtkIdType i = 0; i < count && isComplete; ++i)
    {
      ids.emplace_back(static_cast<std::int64_t>(array->GetComponent(i, 0)),
        vertices.of(blocks[block].firstPoint + static_cast<Id>(i)));
    }
  }
  if (!this->isTrueOnAll(isComplete))
  {
    ids.clear();
  }
  return ids;
}

/// Finds the triangles that are not open. \returns nothing if all are.
std::vector<TriangleRole> SurfaceReader::findRoles(
  const Vertices& vertices, TriangleList& triangles) const
{
  std::vector<TriangleRole> roles =
    findCopies(vertices.labels, vertices.of, triangles, this->exchange_);
  if (this->barriers_.isGiven())
  {
    this->findBarriers(vertices, triangles, roles);
  }
  return roles;
}

/// A triangle with two corners at one vertex has no inside: it is left to the mesh, which leaves it
/// out.
///
/// \throws MeshError if no open triangle is left on any rank.
void SurfaceReader::findBarriers(
  const Vertices& vertices, const TriangleList& triangles, std::vector<TriangleRole>& roles) const
{
  roles.resize(triangles.corners.size(), TriangleRole::Open);
  for (std::size_t block = 0; block + 1 < triangles.firstOfBlock.size(); ++block)
  {
    for (std::size_t i = triangles.firstOfBlock[block]; i < triangles.firstOfBlock[block + 1]; ++i)
    {
      if (roles[i] == TriangleRole::Open && hasThreeVertices(vertices.of(triangles.corners[i])) &&
        this->barriers_.isBarrier(block, triangles.cells[i]))
      {
        roles[i] = TriangleRole::Barrier;
      }
    }
  }
  const auto open = std::count(roles.begin(), roles.end(), TriangleRole::Open);
  if (this->isTrueOnAll(open == 0))
  {
    throw MeshError("All faces of the surface (input port 0) are barriers: the cell array " +
      this->barriers_.name() +
      " (BarrierArrayName) is 0 at none of them. Set it to 0 where paths may pass, or choose no "
      "barrier array.");
  }
  if (static_cast<std::size_t>(open) == roles.size())
  {
    std::vector<TriangleRole>().swap(roles);
  }
}

/// Takes the faces, in the memory of the triangles.
Faces SurfaceReader::takeFaces(
  TriangleList triangles, const std::vector<TriangleRole>& roles, const Vertices& vertices) const
{
  Faces faces;
  faces.open = std::move(triangles.corners);
  std::vector<Triangle>& open = faces.open;
  forRanges(this->parallelFor_, vertices.of.isIdentity() ? 0 : open.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        open[i] = vertices.of(open[i]);
      }
    });
  std::size_t count = 0;
  for (std::size_t i = 0; i < roles.size(); ++i)
  {
    if (roles[i] == TriangleRole::Open)
    {
      open[count++] = open[i];
    }
    else if (roles[i] == TriangleRole::Barrier)
    {
      faces.barriers.push_back(open[i]);
    }
  }
  open.resize(roles.empty() ? open.size() : count);
  return faces;
}

/// The diagonal of the bounding box of the points that faces use. Other points are not surface, and
/// may lie anywhere.
double SurfaceReader::diagonalOf(const Vertices& vertices, const Faces& faces) const
{
  Box box;
  for (const std::vector<Triangle>* triangles : { &faces.open, &faces.barriers })
  {
    box.add(boxOfItems(this->parallelFor_, triangles->size(),
      [&](Box& part, std::size_t i)
      {
        for (const Id corner : (*triangles)[i])
        {
          part.add(vertices.positions[corner]);
        }
      }));
  }
  std::vector<double> least = { box.low[0], box.low[1], box.low[2], -box.high[0], -box.high[1],
    -box.high[2] };
  this->exchange_.findLeast(least);
  return norm(Vec3{ -least[3], -least[4], -least[5] } - Vec3{ least[0], least[1], least[2] });
}

/// Makes the meshes of the open faces and of the barriers.
SurfaceContents SurfaceReader::makeSurface(Vertices vertices, Faces faces) const
{
  const std::size_t count = vertices.positions.size();
  std::vector<Id> inBarriers = numberUsedVertices(faces.barriers, count);
  std::vector<Vec3> barrierPoints;
  std::vector<std::uint64_t> barrierKeys;
  vertices.copy(inBarriers, barrierPoints, barrierKeys);
  // One process keeps the other vertices, too: points need no table then.
  std::vector<Id> numbers;
  std::vector<std::uint64_t> keys;
  if (this->exchange_.numberOfRanks() > 1)
  {
    const std::vector<Id> used = numberUsedVertices(faces.open, count);
    numbers.assign(count, NoId);
    for (std::size_t i = 0; i < used.size(); ++i)
    {
      numbers[used[i]] = static_cast<Id>(i);
    }
    std::vector<Vec3> points;
    vertices.copy(used, points, keys);
    vertices.positions = std::move(points);
  }
  BorrowedValues remote = remoteVertices(vertices.labels, numbers, this->exchange_);
  vertices.labels = {};
  MeshPartition partition(std::move(vertices.positions), faces.open, keys, this->exchange_,
    progressBetween(this->callback_, TrianglesRead, 1.0), this->parallelFor_);
  Id next = partition.mesh().numberOfVertices();
  for (Id& number : numbers)
  {
    number = number != NoId ? number : next++;
  }
  for (Id& vertex : inBarriers)
  {
    vertex = numbers.empty() ? vertex : numbers[vertex];
  }
  std::unique_ptr<BarrierFaces> barriers;
  if (this->exchange_.isTrueAnywhere(!faces.barriers.empty()))
  {
    barriers = std::make_unique<BarrierFaces>(partition,
      MeshPartition(std::move(barrierPoints), faces.barriers, barrierKeys, this->exchange_));
  }
  vertices.of.renumber(std::move(numbers));
  return { std::move(partition), std::move(remote), std::move(barriers), std::move(inBarriers),
    std::move(vertices.of), {}, {}, {}, 0.0, {} };
}

SurfaceReport SurfaceReader::reportOfAllRanks(const MeshPartition& partition) const
{
  const TriangleMesh& mesh = partition.mesh();
  SurfaceReport own = this->report_;
  if (!partition.isDistributed())
  {
    own.edges = mesh.numberOfEdges();
    return own;
  }
  // An edge counts on the rank that owns its first face.
  const Id end = 3 * partition.endOfOwnFaces();
  for (Id halfedge = 3 * partition.firstOwnFace(); halfedge < end; ++halfedge)
  {
    own.edges += mesh.edgeOf(halfedge) == halfedge ? 1 : 0;
  }
  SurfaceReport all;
  for (const SurfaceReport& report : valuesOfRanks(this->exchange_, own))
  {
    all.droppedVertexCells += report.droppedVertexCells;
    all.droppedLineCells += report.droppedLineCells;
    all.facesWithRepeatedPoint += report.facesWithRepeatedPoint;
    all.joinedSeamPoints += report.joinedSeamPoints;
    all.edges += report.edges;
  }
  return all;
}

}

PolyDataSurface readSurface(const std::vector<PolyDataBlock>& blocks, const BarrierArrays& barriers,
  bool mergeCoincidentPoints, Exchange& exchange, const ProgressCallback& progress)
{
  return PolyDataSurface(
    SurfaceReader(blocks, barriers, exchange, progress).read(mergeCoincidentPoints));
}

}
