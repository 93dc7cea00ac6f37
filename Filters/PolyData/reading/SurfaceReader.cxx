// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/SurfaceReader.h"

#include "PolyData/Memory.h"
#include "PolyData/ParallelFor.h"
#include "PolyData/ranks/RankSeams.h"
#include "PolyData/ranks/SeamMerger.h"
#include "PolyData/reading/GhostCells.h"
#include "PolyData/reading/PointMerger.h"
#include "PolyData/reading/RemoteDuplicates.h"
#include "PolyData/reading/Triangulator.h"
#include "mesh/Box.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cfloat>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

namespace geodesic
{

namespace
{

// Where the stages end, as fractions of the whole.
constexpr double PointsRead = 0.1;
constexpr double PointsMerged = 0.25;
constexpr double TrianglesRead = 0.4;

/// The diagonal of the bounding box of the points that triangles use: others are not surface, and
/// may lie anywhere.
double diagonalOf(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles,
  Exchange* exchange, const ParallelFor& parallelFor)
{
  Box box = boxOfItems(parallelFor, triangles.size(),
    [&](Box& part, std::size_t i)
    {
      for (const Id corner : triangles[i])
      {
        part.add(points[corner]);
      }
    });
  if (exchange)
  {
    std::vector<double> least = { box.low[0], box.low[1], box.low[2], -box.high[0], -box.high[1],
      -box.high[2] };
    exchange->findLeast(least);
    box = { { least[0], least[1], least[2] }, { -least[3], -least[4], -least[5] } };
  }
  return norm(box.high - box.low);
}

template <typename Visitor>
void forEachCell(vtkCellArray* cells, Visitor&& visit)
{
  const auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    iterator->GetCurrentCell(size, ids);
    visit(size, ids);
  }
}

/// Reads the blocks of one surface, stage by stage.
class SurfaceReader
{
public:
  SurfaceReader(const std::vector<PolyDataBlock>& inputs, const BarrierArrays& barriers,
    Exchange* exchange, const ProgressCallback& callback)
    : inputs_(inputs)
    , barriers_(barriers)
    , exchange_(exchange)
    , callback_(callback)
    , progress_(callback)
    , parallelFor_(smpParallelFor())
    , blocks_(inputs.size())
  {
  }

  PolyDataSurface read(bool mergeCoincidentPoints)
  {
    const vtkIdType faces = this->requireFaces();
    this->progress_.nextUntil(PointsRead);
    this->readPoints();
    this->progress_.nextUntil(PointsMerged);
    if (mergeCoincidentPoints)
    {
      geodesic::mergeCoincidentPoints(
        this->vertices_, this->vertexOfPoint_, this->progress_, this->parallelFor_);
    }
    this->progress_.nextUntil(TrianglesRead);
    this->readTriangles(faces);
    this->scaleVertices();
    if (mergeCoincidentPoints)
    {
      this->mergeSeams();
    }
    if (this->exchange_)
    {
      this->joinRanks(mergeCoincidentPoints);
    }
    this->findCopies();
    this->findBarriers();
    for (std::size_t i = 0; i < this->blocks_.size(); ++i)
    {
      this->keepTriangles(i);
    }
    this->nameVertices();
    const double diagonal =
      diagonalOf(this->vertices_, this->triangles_.corners, this->exchange_, this->parallelFor_);
    if (this->exchange_)
    {
      return this->makePiece(diagonal);
    }
    const std::vector<Triangle> barriers = this->takeBarriers();
    std::unique_ptr<TriangleMesh> mesh = this->makeMesh();
    auto barrierFaces =
      barriers.empty() ? nullptr : std::make_unique<BarrierFaces>(*mesh, barriers);
    this->reportMesh(*mesh, barrierFaces.get());
    return { std::move(mesh), std::move(barrierFaces), std::move(this->vertexOfPoint_),
      std::move(this->blocks_), std::move(this->roles_), this->scale_, diagonal, this->report_ };
  }

private:
  /// Told of cells that have been read.
  using CellsRead = std::function<void(std::size_t cells)>;

  vtkIdType requireFaces() const;
  bool isTrueOnAll(bool condition) const;
  std::string whatThereIsInsteadOfFaces() const;
  void readPoints();
  std::vector<Id> readPoints(std::size_t begin, std::size_t end);
  void requireFinite(const std::vector<Id>& bad) const;
  void readTriangles(vtkIdType faces);
  void readTriangles(std::size_t block, const CellsRead& next);
  bool readPlainTriangles(std::size_t block, const CellsRead& next);
  bool readPlainTriangles(std::size_t block, std::size_t begin, std::size_t end);
  Triangle verticesOf(const Triangle& points) const;
  std::size_t endOfTriangles(std::size_t block) const;
  void scaleVertices();
  void mergeSeams();
  void joinVertices(const std::vector<Id>& same);
  void joinRanks(bool mergeCoincidentPoints);
  SeamBlock wholePiece() const;
  std::vector<std::pair<std::int64_t, Id>> globalIds() const;
  void joinVerticesWithOneLabel();
  void findCopies();
  void findBarriers();
  void keepTriangles(std::size_t block);
  void nameVertices();
  std::vector<Triangle> takeBarriers();
  std::unique_ptr<TriangleMesh> makeMesh();
  void reportMesh(const TriangleMesh& mesh, const BarrierFaces* barriers);
  PolyDataSurface makePiece(double diagonal);
  std::vector<Id> numberUsedVertices();
  void reportPiece(
    const MeshPartition& part, const RemoteVertices& borrowed, const BarriersOnRanks* barriers);
  ProgressCallback meshProgress() const;

  const std::vector<PolyDataBlock>& inputs_;
  const BarrierArrays& barriers_;
  Exchange* exchange_;
  const ProgressCallback& callback_;
  LoopProgress progress_;
  ParallelFor parallelFor_;
  std::vector<SurfaceBlock> blocks_;
  std::vector<Vec3> vertices_;
  std::vector<Id> vertexOfPoint_;
  /// Of the vertices, where there are several ranks.
  RankLabels labels_;
  TriangleList triangles_;
  /// Whether a block has cells that are no triangles.
  std::vector<bool> hasOtherCells_;
  /// Empty where all are open.
  std::vector<TriangleRole> roles_;
  PowerOfTwoScale scale_;
  PolyDataSurface::Report report_;
};

/// How many cells are faces.
///
/// \throws MeshError where there are none.
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

/// With one process, whether it is true.
bool SurfaceReader::isTrueOnAll(bool condition) const
{
  return this->exchange_ ? !this->exchange_->isTrueAnywhere(!condition) : condition;
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

void SurfaceReader::readPoints()
{
  vtkIdType count = 0;
  for (std::size_t i = 0; i < this->inputs_.size(); ++i)
  {
    const vtkIdType own = this->inputs_[i].data->GetNumberOfPoints();
    this->blocks_[i].firstPoint = static_cast<Id>(count);
    this->blocks_[i].numberOfPoints = static_cast<Id>(own);
    count += own;
    if (count >= static_cast<vtkIdType>(NoId))
    {
      throw MeshTooLarge("The surface (input port 0) has " + std::to_string(count) +
        " points, more than 32-bit ids can number. Decimate it or cut it into parts.");
    }
  }
  this->vertices_.resize(static_cast<std::size_t>(count));
  const std::vector<std::vector<Id>> bad =
    resultsOfRanges(this->parallelFor_, this->vertices_.size(), this->progress_,
      [this](std::size_t begin, std::size_t end) { return this->readPoints(begin, end); });
  std::vector<Id> all;
  for (const std::vector<Id>& part : bad)
  {
    all.insert(all.end(), part.begin(), part.end());
  }
  this->requireFinite(all);
}

/// Reads a range of the points of all blocks. \returns those with a coordinate that is not finite.
std::vector<Id> SurfaceReader::readPoints(std::size_t begin, std::size_t end)
{
  std::vector<Id> bad;
  for (std::size_t block = 0; block < this->blocks_.size(); ++block)
  {
    vtkPoints* points = this->inputs_[block].data->GetPoints();
    const std::size_t first = this->blocks_[block].firstPoint;
    const std::size_t last = std::min(end, first + this->blocks_[block].numberOfPoints);
    for (std::size_t i = std::max(begin, first); i < last; ++i)
    {
      points->GetPoint(static_cast<vtkIdType>(i - first), this->vertices_[i].data());
      if (!isFinite(this->vertices_[i]))
      {
        bad.push_back(static_cast<Id>(i));
      }
    }
  }
  return bad;
}

/// \throws MeshError where there are points with a coordinate that is not finite.
void SurfaceReader::requireFinite(const std::vector<Id>& bad) const
{
  if (bad.empty())
  {
    return;
  }
  std::size_t block = 0;
  while (bad.front() >= this->blocks_[block].firstPoint + this->blocks_[block].numberOfPoints)
  {
    ++block;
  }
  const Id first = this->blocks_[block].firstPoint;
  std::vector<vtkIdType> ids;
  for (const Id point : bad)
  {
    if (point - first < this->blocks_[block].numberOfPoints)
    {
      ids.push_back(point - first);
    }
  }
  throw MeshError(capitalized(this->inputs_[block].name) +
    " has coordinates that are NaN or infinite, at point " + listIds(ids) +
    ". Remove or repair these points upstream.");
}

void SurfaceReader::readTriangles(vtkIdType faces)
{
  vtkIdType polygons = 0;
  for (const PolyDataBlock& input : this->inputs_)
  {
    polygons += input.data->GetNumberOfPolys();
  }
  this->triangles_.corners.reserve(static_cast<std::size_t>(polygons));
  this->triangles_.cells.reserve(static_cast<std::size_t>(polygons));
  std::size_t done = 0;
  const auto next = [&](std::size_t cells)
  {
    constexpr std::size_t step = 8192; // after so many it is reported
    const std::size_t reports = (done + step - 1) / step;
    done += cells;
    if ((done + step - 1) / step > reports)
    {
      this->progress_.at(reports * step, static_cast<std::size_t>(faces));
    }
  };
  for (std::size_t i = 0; i < this->inputs_.size(); ++i)
  {
    this->blocks_[i].firstTriangle = static_cast<Id>(this->triangles_.corners.size());
    this->readTriangles(i, next);
  }
  if (this->isTrueOnAll(this->triangles_.corners.empty()))
  {
    throw MeshError("None of the " +
      (this->exchange_ ? std::string() : std::to_string(faces) + " ") +
      "faces of the surface (input port 0) has three different corners. Connect a surface with "
      "triangles or polygons.");
  }
}

void SurfaceReader::readTriangles(std::size_t block, const CellsRead& next)
{
  const PolyDataBlock& input = this->inputs_[block];
  if (this->readPlainTriangles(block, next))
  {
    return;
  }
  const GhostCells ghosts(input.data);
  Triangulator triangulator(
    input, this->blocks_[block].firstPoint, this->vertexOfPoint_, this->triangles_);
  this->report_.droppedVertexCells += ghosts.countOwn(0, input.data->GetNumberOfVerts());
  // vtkPolyData numbers its cells in the order vertices, lines, polygons, strips.
  vtkIdType cell = input.data->GetNumberOfVerts();
  this->report_.droppedLineCells += ghosts.countOwn(cell, cell + input.data->GetNumberOfLines());
  cell += input.data->GetNumberOfLines();
  const auto read = [&](vtkCellArray* cells, auto add)
  {
    forEachCell(cells,
      [&](vtkIdType size, const vtkIdType* ids)
      {
        next(1);
        if (!ghosts.isHidden(cell))
        {
          (triangulator.*add)({ cell, ghosts.isDuplicate(cell) }, size, ids);
        }
        ++cell;
      });
  };
  read(input.data->GetPolys(), &Triangulator::addPolygon);
  read(input.data->GetStrips(), &Triangulator::addStrip);
  this->hasOtherCells_.push_back(triangulator.hasOtherCells());
  this->report_.facesWithRepeatedPoint += triangulator.report().facesWithRepeatedPoint;
  this->report_.polygons += triangulator.report().polygons;
  this->report_.strips += triangulator.report().strips;
}

/// Reads a block whose cells are triangles and nothing else, with three vertices each. \returns
/// whether it is one.
bool SurfaceReader::readPlainTriangles(std::size_t block, const CellsRead& next)
{
  vtkPolyData* data = this->inputs_[block].data;
  const vtkIdType count = data->GetNumberOfPolys();
  if (count != data->GetNumberOfCells() || GhostCells(data).areAny())
  {
    return false;
  }
  TriangleList& triangles = this->triangles_;
  const std::size_t before = triangles.corners.size();
  const std::size_t after = before + static_cast<std::size_t>(count);
  triangles.corners.resize(after);
  triangles.cells.resize(after);
  const std::vector<int> arePlain = resultsOfRanges(this->parallelFor_, after - before,
    [&](std::size_t begin, std::size_t end)
    { return this->readPlainTriangles(block, begin, end) ? 1 : 0; });
  if (std::find(arePlain.begin(), arePlain.end(), 0) != arePlain.end())
  {
    triangles.corners.resize(before);
    triangles.cells.resize(before);
    return false;
  }
  triangles.isDuplicate.resize(after, false);
  this->hasOtherCells_.push_back(false);
  next(after - before);
  return true;
}

/// The same for a range of the cells.
bool SurfaceReader::readPlainTriangles(std::size_t block, std::size_t begin, std::size_t end)
{
  vtkPolyData* data = this->inputs_[block].data;
  const Id firstPoint = this->blocks_[block].firstPoint;
  const auto numberOfPoints = data->GetNumberOfPoints();
  const auto cells = vtk::TakeSmartPointer(data->GetPolys()->NewIterator()); // one a thread
  cells->GoToCell(static_cast<vtkIdType>(begin));
  for (std::size_t i = begin; i < end; ++i, cells->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(size, ids);
    const auto exists = [=](vtkIdType id) { return id >= 0 && id < numberOfPoints; };
    if (size != 3 || !std::all_of(ids, ids + 3, exists))
    {
      return false;
    }
    const auto pointOf = [=](vtkIdType id) { return firstPoint + static_cast<Id>(id); };
    const Triangle triangle = { pointOf(ids[0]), pointOf(ids[1]), pointOf(ids[2]) };
    const Triangle v = this->verticesOf(triangle);
    if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0])
    {
      return false;
    }
    const std::size_t number = this->blocks_[block].firstTriangle + i;
    this->triangles_.corners[number] = triangle;
    this->triangles_.cells[number] = static_cast<vtkIdType>(i);
  }
  return true;
}

/// A triangle's corners, as vertices.
Triangle SurfaceReader::verticesOf(const Triangle& points) const
{
  const auto vertexOf = [this](Id point)
  { return this->vertexOfPoint_.empty() ? point : this->vertexOfPoint_[point]; };
  return { vertexOf(points[0]), vertexOf(points[1]), vertexOf(points[2]) };
}

std::size_t SurfaceReader::endOfTriangles(std::size_t block) const
{
  return block + 1 < this->blocks_.size() ? this->blocks_[block + 1].firstTriangle
                                          : this->triangles_.corners.size();
}

/// Brings the vertices to a size that the engine can compute with. Points that no triangle uses may
/// be anywhere, and are no more than finite then.
///
/// \throws MeshError where there is no such size.
void SurfaceReader::scaleVertices()
{
  constexpr double largestOfAll = 1e290;
  const std::vector<Triangle>& triangles = this->triangles_.corners;
  const std::vector<double> ofRanges = resultsOfRanges(this->parallelFor_, triangles.size(),
    [&](std::size_t begin, std::size_t end)
    {
      double here = 0.0;
      for (std::size_t i = begin; i < end; ++i)
      {
        for (const Id vertex : this->verticesOf(triangles[i]))
        {
          here = std::max(here, largestCoordinate(this->vertices_[vertex]));
        }
      }
      return here;
    });
  double largest = ofRanges.empty() ? 0.0 : *std::max_element(ofRanges.begin(), ofRanges.end());
  if (this->exchange_)
  {
    largest = this->exchange_->largestOf(largest);
  }
  if (largest > largestOfAll || (largest > 0.0 && largest < 1.0 / largestOfAll))
  {
    std::ostringstream message;
    message
      << "The largest coordinate of the surface (input port 0) is " << largest
      << ". Distances can be computed where it is between 1e-290 and 1e290: scale the surface "
         "and the source upstream, for example by the Transform filter.";
    throw MeshError(message.str());
  }
  this->scale_ = PowerOfTwoScale(largest);
  if (!this->scale_.isOne())
  {
    for (Vec3& p : this->vertices_)
    {
      p = this->scale_.toEngine(p);
      for (double& x : p)
      {
        x = std::clamp(x, -DBL_MAX, DBL_MAX);
      }
    }
  }
}

/// Connects blocks whose boundaries meet within the rounding of their coordinates.
void SurfaceReader::mergeSeams()
{
  if (this->blocks_.size() < 2)
  {
    return;
  }
  std::vector<SeamBlock> seams(this->blocks_.size());
  for (std::size_t i = 0; i < seams.size(); ++i)
  {
    vtkPoints* points = this->inputs_[i].data->GetPoints();
    seams[i].precision = points && points->GetDataType() == VTK_FLOAT ? FLT_EPSILON : DBL_EPSILON;
    for (std::size_t t = this->blocks_[i].firstTriangle; t < this->endOfTriangles(i); ++t)
    {
      auto& triangles = this->triangles_.isDuplicate[t] ? seams[i].ghosts : seams[i].triangles;
      triangles.push_back(this->verticesOf(this->triangles_.corners[t]));
    }
  }
  const JoinedVertices joined = geodesic::mergeSeams(this->vertices_, seams);
  if (!joined.same.empty())
  {
    this->joinVertices(joined.same);
    this->report_.joinedSeamPoints = static_cast<vtkIdType>(joined.count);
  }
}

/// Makes one vertex of those that are the same.
///
/// \param same of those that are the same, the one that stays; for each.
void SurfaceReader::joinVertices(const std::vector<Id>& same)
{
  std::vector<Id> numbers(same.size());
  Id count = 0;
  for (Id vertex = 0; vertex < same.size(); ++vertex)
  {
    if (same[vertex] == vertex)
    {
      this->vertices_[count] = this->vertices_[vertex];
      numbers[vertex] = count++;
    }
  }
  for (Id vertex = 0; vertex < same.size(); ++vertex)
  {
    numbers[vertex] = numbers[same[vertex]];
  }
  this->vertices_.resize(count);
  if (this->vertexOfPoint_.empty())
  {
    this->vertexOfPoint_ = std::move(numbers);
    return;
  }
  for (Id& vertex : this->vertexOfPoint_)
  {
    vertex = numbers[vertex];
  }
}

/// Gives the vertices labels: those of different ranks that are one get the same.
void SurfaceReader::joinRanks(bool mergeCoincidentPoints)
{
  RankSeams seams(this->vertices_, *this->exchange_);
  seams.joinSame(mergeCoincidentPoints, this->globalIds());
  if (mergeCoincidentPoints)
  {
    const auto joined = static_cast<vtkIdType>(seams.joinNear(this->wholePiece()));
    // Each rank has counted what its own blocks have; this is counted once.
    this->report_.joinedSeamPoints += this->exchange_->rank() == 0 ? joined : 0;
  }
  this->labels_ = seams.take();
  this->joinVerticesWithOneLabel();
}

/// All faces of this rank.
SeamBlock SurfaceReader::wholePiece() const
{
  SeamBlock piece;
  for (const PolyDataBlock& input : this->inputs_)
  {
    vtkPoints* points = input.data->GetPoints();
    piece.precision = std::max(piece.precision,
      points && points->GetDataType() == VTK_FLOAT ? double(FLT_EPSILON) : DBL_EPSILON);
  }
  for (std::size_t i = 0; i < this->triangles_.corners.size(); ++i)
  {
    auto& triangles = this->triangles_.isDuplicate[i] ? piece.ghosts : piece.triangles;
    triangles.push_back(this->verticesOf(this->triangles_.corners[i]));
  }
  return piece;
}

/// Of all points with their vertices; empty where a rank has points without.
std::vector<std::pair<std::int64_t, Id>> SurfaceReader::globalIds() const
{
  std::vector<std::pair<std::int64_t, Id>> ids;
  bool isComplete = true;
  for (std::size_t block = 0; block < this->blocks_.size(); ++block)
  {
    vtkPolyData* data = this->inputs_[block].data;
    vtkDataArray* array = data->GetPointData()->GetGlobalIds();
    if (!array)
    {
      array = data->GetPointData()->GetArray("GlobalPointIds");
    }
    const vtkIdType count = data->GetNumberOfPoints();
    if (count > 0 && (!array || array->GetNumberOfTuples() < count))
    {
      isComplete = false;
      break;
    }
    for (vtkIdType i = 0; i < count; ++i)
    {
      const Id point = this->blocks_[block].firstPoint + static_cast<Id>(i);
      ids.emplace_back(static_cast<std::int64_t>(array->GetComponent(i, 0)),
        this->vertexOfPoint_.empty() ? point : this->vertexOfPoint_[point]);
    }
  }
  if (!this->isTrueOnAll(isComplete))
  {
    ids.clear();
  }
  return ids;
}

/// Where several vertices of this rank are one with the same vertex of another, they are one.
void SurfaceReader::joinVerticesWithOneLabel()
{
  std::map<RankLabels::Label, Id> first;
  std::vector<Id> same(this->vertices_.size());
  bool isAnySame = false;
  for (Id vertex = 0; vertex < same.size(); ++vertex)
  {
    same[vertex] = vertex;
    if (this->labels_.isShared[vertex])
    {
      same[vertex] = first.emplace(this->labels_.labels[vertex], vertex).first->second;
      isAnySame = isAnySame || same[vertex] != vertex;
    }
  }
  if (!isAnySame)
  {
    return;
  }
  Id count = 0;
  for (Id vertex = 0; vertex < same.size(); ++vertex)
  {
    if (same[vertex] == vertex)
    {
      this->labels_.labels[count] = this->labels_.labels[vertex];
      this->labels_.isShared[count++] = this->labels_.isShared[vertex];
    }
  }
  this->labels_.labels.resize(count);
  this->labels_.isShared.resize(count);
  this->joinVertices(same);
}

/// Finds the triangles that are not surface because they are copies of others.
void SurfaceReader::findCopies()
{
  const auto& marks = this->triangles_.isDuplicate;
  std::vector<std::uint8_t> isCopy;
  if (std::find(marks.begin(), marks.end(), true) != marks.end())
  {
    isCopy = geodesic::findCopies(this->vertexOfPoint_, this->blocks_, this->triangles_);
  }
  if (this->exchange_)
  {
    isCopy.resize(this->triangles_.corners.size(), 0);
    findCopiesOfOthers(this->labels_, this->vertexOfPoint_, this->blocks_, this->triangles_, isCopy,
      *this->exchange_);
  }
  if (std::find(isCopy.begin(), isCopy.end(), 1) != isCopy.end())
  {
    for (const std::uint8_t copy : isCopy)
    {
      this->roles_.push_back(copy != 0 ? TriangleRole::Copy : TriangleRole::Open);
    }
  }
  this->triangles_.isDuplicate = {};
}

/// Finds the triangles that no path enters. One with two corners at a vertex has no inside: it is
/// left to the mesh, which leaves it out.
///
/// \throws MeshError where no other is left, on any rank.
void SurfaceReader::findBarriers()
{
  if (!this->barriers_.isGiven())
  {
    return;
  }
  this->roles_.resize(this->triangles_.corners.size(), TriangleRole::Open);
  for (std::size_t block = 0; block < this->blocks_.size(); ++block)
  {
    for (std::size_t i = this->blocks_[block].firstTriangle; i < this->endOfTriangles(block); ++i)
    {
      const Triangle t = this->verticesOf(this->triangles_.corners[i]);
      const bool hasInside = t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
      if (hasInside && this->roles_[i] == TriangleRole::Open &&
        this->barriers_.isBarrier(block, this->triangles_.cells[i]))
      {
        this->roles_[i] = TriangleRole::Barrier;
      }
    }
  }
  const auto hasRole = [this](TriangleRole role)
  { return std::find(this->roles_.begin(), this->roles_.end(), role) != this->roles_.end(); };
  if (this->isTrueOnAll(!hasRole(TriangleRole::Open)))
  {
    throw MeshError("All faces of the surface (input port 0) are barriers: the cell array " +
      this->barriers_.name() +
      " (BarrierArrayName) is 0 at none of them. Set it to 0 where paths may pass, or choose no "
      "barrier array.");
  }
  if (!hasRole(TriangleRole::Barrier) && !hasRole(TriangleRole::Copy))
  {
    this->roles_ = {};
  }
}

/// Gives a block its triangles: the input's own cells where these are the same.
void SurfaceReader::keepTriangles(std::size_t index)
{
  vtkPolyData* input = this->inputs_[index].data;
  SurfaceBlock& block = this->blocks_[index];
  const std::size_t first = block.firstTriangle;
  const std::size_t last = this->endOfTriangles(index);
  const auto count = static_cast<vtkIdType>(last - first);
  if (!this->hasOtherCells_[index] && count == input->GetNumberOfCells())
  {
    block.triangles = input->GetPolys();
    block.areInputCells = true;
    return;
  }
  constexpr vtkIdType idsATriangle = 4; // three points and an offset
  requireMemory(count + 1, idsATriangle * sizeof(vtkIdType));
  block.triangles = vtkSmartPointer<vtkCellArray>::New();
  block.triangles->AllocateExact(count, 3 * count);
  const auto own = [&block](Id point) { return static_cast<vtkIdType>(point - block.firstPoint); };
  for (std::size_t i = first; i < last; ++i)
  {
    const Triangle& t = this->triangles_.corners[i];
    block.triangles->InsertNextCell({ own(t[0]), own(t[1]), own(t[2]) });
  }
  const auto cells = this->triangles_.cells.begin();
  block.inputCells.assign(
    cells + static_cast<std::ptrdiff_t>(first), cells + static_cast<std::ptrdiff_t>(last));
}

/// From here on the triangles are without copies and have vertices at their corners.
void SurfaceReader::nameVertices()
{
  this->triangles_.cells = {};
  std::vector<Triangle>& triangles = this->triangles_.corners;
  if (this->roles_.empty())
  {
    forRanges(this->parallelFor_, this->vertexOfPoint_.empty() ? 0 : triangles.size(),
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          triangles[i] = this->verticesOf(triangles[i]);
        }
      });
    return;
  }
  std::size_t count = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    if (this->roles_[i] != TriangleRole::Copy)
    {
      triangles[count++] = this->verticesOf(triangles[i]);
    }
  }
  triangles.resize(count);
}

/// Takes the barriers out of the triangles, which are those of the mesh from here on.
std::vector<Triangle> SurfaceReader::takeBarriers()
{
  std::vector<Triangle> barriers;
  std::vector<Triangle>& triangles = this->triangles_.corners;
  std::size_t next = 0;
  std::size_t count = 0;
  for (const TriangleRole role : this->roles_)
  {
    if (role == TriangleRole::Open)
    {
      triangles[count++] = triangles[next++];
    }
    else if (role == TriangleRole::Barrier)
    {
      barriers.push_back(triangles[next++]);
    }
  }
  triangles.resize(this->roles_.empty() ? triangles.size() : count);
  return barriers;
}

std::unique_ptr<TriangleMesh> SurfaceReader::makeMesh()
{
  return std::make_unique<TriangleMesh>(
    std::move(this->vertices_), this->triangles_.corners, this->meshProgress(), this->parallelFor_);
}

ProgressCallback SurfaceReader::meshProgress() const
{
  return [this](double fraction)
  { return !this->callback_ || this->callback_(TrianglesRead + (1.0 - TrianglesRead) * fraction); };
}

void SurfaceReader::reportMesh(const TriangleMesh& mesh, const BarrierFaces* barriers)
{
  Id inBarriers = 0;
  if (barriers)
  {
    for (Id vertex = 0; vertex < mesh.numberOfVertices(); ++vertex)
    {
      const bool isInBarrier = barriers->mesh().cornersAt(vertex).size() > 0;
      inBarriers += isInBarrier && mesh.cornersAt(vertex).size() == 0 ? 1 : 0;
    }
  }
  this->report_.duplicateFaces = mesh.report().duplicateFaces;
  this->report_.zeroAreaFaces = mesh.report().zeroAreaFaces;
  this->report_.isolatedPoints = mesh.report().isolatedVertices - inBarriers;
  this->report_.edges = mesh.numberOfEdges();
}

/// Numbers the vertices that triangles use anew and drops the others. From here on triangles have
/// the new numbers.
///
/// \returns the new number of each vertex, or NoId.
std::vector<Id> SurfaceReader::numberUsedVertices()
{
  std::vector<Id> numbers(this->vertices_.size(), NoId);
  for (const Triangle& triangle : this->triangles_.corners)
  {
    for (const Id vertex : triangle)
    {
      numbers[vertex] = 0;
    }
  }
  Id count = 0;
  for (Id vertex = 0; vertex < numbers.size(); ++vertex)
  {
    if (numbers[vertex] != NoId)
    {
      this->vertices_[count] = this->vertices_[vertex];
      numbers[vertex] = count++;
    }
  }
  this->vertices_.resize(count);
  for (Triangle& triangle : this->triangles_.corners)
  {
    for (Id& vertex : triangle)
    {
      vertex = numbers[vertex];
    }
  }
  return numbers;
}

PolyDataSurface SurfaceReader::makePiece(double diagonal)
{
  BarrierTriangles barrierTriangles(this->takeBarriers(), this->vertices_, this->labels_);
  std::vector<Id> numbers = this->numberUsedVertices();
  RemoteVertices borrowed(this->labels_, numbers, *this->exchange_);
  std::vector<std::uint64_t> keys;
  keys.reserve(this->vertices_.size());
  for (Id vertex = 0; vertex < numbers.size(); ++vertex)
  {
    if (numbers[vertex] != NoId)
    {
      keys.push_back(this->labels_.labels[vertex]);
    }
  }
  this->labels_ = {};
  const auto hasInside = [](const Triangle& t)
  { return t[0] != t[1] && t[1] != t[2] && t[2] != t[0]; };
  const std::vector<Triangle>& triangles = this->triangles_.corners;
  this->report_.duplicateFaces = static_cast<vtkIdType>(
    std::count_if(triangles.begin(), triangles.end(), hasInside)); // less what the part has
  auto part = std::make_unique<MeshPartition>(std::move(this->vertices_),
    std::move(this->triangles_.corners), keys, *this->exchange_, this->meshProgress());
  Id next = part->mesh().numberOfVertices();
  for (Id& number : numbers)
  {
    number = number != NoId ? number : next++;
  }
  std::unique_ptr<BarriersOnRanks> barriers =
    BarriersOnRanks::make(std::move(barrierTriangles), numbers, *part, borrowed);
  this->reportPiece(*part, borrowed, barriers.get());
  if (this->vertexOfPoint_.empty())
  {
    this->vertexOfPoint_ = std::move(numbers);
  }
  else
  {
    for (Id& vertex : this->vertexOfPoint_)
    {
      vertex = numbers[vertex];
    }
  }
  return { std::move(part), std::move(barriers), std::move(borrowed),
    std::move(this->vertexOfPoint_), std::move(this->blocks_), std::move(this->roles_),
    this->scale_, diagonal, this->report_ };
}

/// Counts over all ranks.
void SurfaceReader::reportPiece(
  const MeshPartition& part, const RemoteVertices& borrowed, const BarriersOnRanks* barriers)
{
  const TriangleMesh& mesh = part.mesh();
  PolyDataSurface::Report& own = this->report_;
  own.duplicateFaces -= part.endOfOwnFaces() - part.firstOwnFace();
  for (Id face = part.firstOwnFace(); face < part.endOfOwnFaces(); ++face)
  {
    own.zeroAreaFaces += mesh.shape(face).hasZeroArea() ? 1 : 0;
    for (Id halfedge = 3 * face; halfedge < 3 * face + 3; ++halfedge)
    {
      own.edges += mesh.edgeOf(halfedge) == halfedge ? 1 : 0;
    }
  }
  own.isolatedPoints = barriers ? -static_cast<vtkIdType>(barriers->countInnerVertices()) : 0;
  const std::vector<PolyDataSurface::Report> reports = valuesOfRanks(*this->exchange_, own);
  own = {};
  for (const PolyDataSurface::Report& report : reports)
  {
    own.add(report);
  }
  own.isolatedPoints += borrowed.numberWithoutFace(); // of the faces that are no barriers
}

}

PolyDataSurface readSurface(const std::vector<PolyDataBlock>& blocks, const BarrierArrays& barriers,
  bool mergeCoincidentPoints, Exchange* exchange, const ProgressCallback& progress)
{
  return SurfaceReader(blocks, barriers, exchange, progress).read(mergeCoincidentPoints);
}

}
