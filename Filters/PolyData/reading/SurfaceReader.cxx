// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/ParallelFor.h"
#include "PolyData/ranks/RankSeams.h"
#include "PolyData/reading/PolyDataSurface.h"
#include "PolyData/reading/TriangleReader.h"
#include "mesh/Box.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cfloat>
#include <cstdint>
#include <map>
#include <numeric>
#include <sstream>
#include <string>
#include <unordered_map>
#include <utility>

namespace geodesic
{

namespace
{

using Label = RankLabels::Label;

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
  void copy(const std::vector<Id>& some, std::vector<Vec3>& points, std::vector<Label>& keys) const
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
    std::vector<Label>& known = this->labels.labels;
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

/// The faces that all blocks have, which may be none.
vtkIdType countFaces(const std::vector<PolyDataBlock>& inputs)
{
  vtkIdType faces = 0;
  for (const PolyDataBlock& input : inputs)
  {
    faces += input.data->GetNumberOfPolys() + input.data->GetNumberOfStrips();
  }
  return faces;
}

/// \throws MeshError that says what there is instead of faces.
[[noreturn]] void throwWithoutFaces(const std::vector<PolyDataBlock>& inputs)
{
  const std::string name = "The surface (input port 0) ";
  const std::string advice = "Connect a surface with triangles or polygons.";
  vtkIdType points = 0;
  vtkIdType cells = 0;
  for (const PolyDataBlock& input : inputs)
  {
    points += input.data->GetNumberOfPoints();
    cells += input.data->GetNumberOfCells();
  }
  if (cells > 0)
  {
    throw MeshError(name + "has no faces, but lines or vertices: is it the source? " + advice);
  }
  if (points > 0)
  {
    throw MeshError(name + "has " + std::to_string(points) +
      " points and no faces. PLY files of triangle strips are read so: save them as triangles. " +
      advice);
  }
  throw MeshError(name + "is empty: it has no faces. " + advice);
}

/// The size at which the engine can compute with a surface.
///
/// \param largest the largest coordinate of its triangles.
/// \throws MeshError if there is no such size.
PowerOfTwoScale requireScale(double largest)
{
  constexpr double largestOfAll = 1e290;
  if (largest > largestOfAll || (largest > 0.0 && largest < 1.0 / largestOfAll))
  {
    std::ostringstream message;
    message << "The largest coordinate of the surface (input port 0) is " << largest
            << ". Distances can be computed where it is between 1e-290 and 1e290: scale the "
               "surface and the source upstream, for example by the Transform filter.";
    throw MeshError(message.str());
  }
  return PowerOfTwoScale(largest);
}

/// What all ranks report together of a mesh.
SurfaceReport reportOfAllRanks(SurfaceReport own, const MeshPartition& partition)
{
  const TriangleMesh& mesh = partition.mesh();
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
  for (const SurfaceReport& report : valuesOfRanks(partition.exchange(), own))
  {
    all.droppedVertexCells += report.droppedVertexCells;
    all.droppedLineCells += report.droppedLineCells;
    all.facesWithRepeatedPoint += report.facesWithRepeatedPoint;
    all.joinedSeamPoints += report.joinedSeamPoints;
    all.edges += report.edges;
  }
  return all;
}

/// Reads the blocks of one surface, stage by stage.
class SurfaceReader
{
public:
  SurfaceReader(const std::vector<PolyDataBlock>& inputs, bool mergeCoincidentPoints,
    Exchange& exchange, const ProgressCallback& callback)
    : inputs_(inputs)
    , mergesPoints_(mergeCoincidentPoints)
    , exchange_(exchange)
    , callback_(callback)
    , parallelFor_(smpParallelFor())
  {
  }

  SurfaceContents read()
  {
    LoopProgress progress(this->callback_);
    const vtkIdType numberOfFaces = countFaces(this->inputs_);
    if (this->isTrueOnAll(numberOfFaces == 0))
    {
      throwWithoutFaces(this->inputs_);
    }
    this->numberPoints();
    progress.nextUntil(PointsRead);
    this->readPoints(progress);
    progress.nextUntil(PointsMerged);
    if (this->mergesPoints_)
    {
      this->vertices_.join(firstAtPlaces(this->vertices_.positions, progress, this->parallelFor_));
    }
    progress.nextUntil(TrianglesRead);
    this->triangles_ = readTriangles(this->inputs_, this->vertices_.of, numberOfFaces, progress,
      this->parallelFor_, this->blocks_, this->report_);
    if (this->isTrueOnAll(this->triangles_.corners.empty()))
    {
      const bool isAlone = this->exchange_.numberOfRanks() == 1;
      throw MeshError("None of the " + (isAlone ? std::to_string(numberOfFaces) + " " : "") +
        "faces of the surface (input port 0) has three different corners. Connect a surface with "
        "triangles or polygons.");
    }
    this->scaleVertices();
    if (this->mergesPoints_ && this->inputs_.size() > 1)
    {
      this->joinBlocks();
    }
    if (this->exchange_.numberOfRanks() > 1)
    {
      this->joinRanks();
    }
    this->findRoles();
    keepTriangles(this->inputs_, this->triangles_, this->blocks_);
    return this->makeSurface(this->takeFaces());
  }

private:
  bool isTrueOnAll(bool condition) const { return !this->exchange_.isTrueAnywhere(!condition); }

  /// Numbers the points of all blocks.
  void numberPoints()
  {
    vtkIdType count = 0;
    for (const PolyDataBlock& input : this->inputs_)
    {
      SurfaceBlock& block = this->blocks_.emplace_back();
      block.firstPoint = static_cast<Id>(count);
      block.numberOfPoints = static_cast<Id>(input.data->GetNumberOfPoints());
      count += input.data->GetNumberOfPoints();
      if (count >= static_cast<vtkIdType>(NoId))
      {
        throw MeshTooLarge("The surface (input port 0) has " + std::to_string(count) +
          " points, more than 32-bit ids can number. Decimate it or cut it into parts.");
      }
    }
    this->vertices_.positions.resize(static_cast<std::size_t>(count));
  }

  /// \throws MeshError if a coordinate is not finite.
  void readPoints(const LoopProgress& progress)
  {
    std::vector<Vec3>& positions = this->vertices_.positions;
    const auto readRange = [&](std::size_t begin, std::size_t end)
    {
      std::size_t bad = NoId;
      for (std::size_t block = 0; block < this->blocks_.size(); ++block)
      {
        vtkPoints* points = this->inputs_[block].data->GetPoints();
        const std::size_t first = this->blocks_[block].firstPoint;
        const std::size_t last = std::min(end, first + this->blocks_[block].numberOfPoints);
        for (std::size_t i = std::max(begin, first); i < last; ++i)
        {
          points->GetPoint(static_cast<vtkIdType>(i - first), positions[i].data());
          bad = isFinite(positions[i]) ? bad : std::min(bad, block);
        }
      }
      return bad;
    };
    const std::vector<std::size_t> bad =
      resultsOfRanges(this->parallelFor_, positions.size(), progress, readRange);
    const auto first = std::min_element(bad.begin(), bad.end());
    if (first != bad.end() && *first < this->blocks_.size())
    {
      throw MeshError(whereNotFinite(this->inputs_[*first]));
    }
  }

  Box boxOf(const std::vector<Triangle>& triangles, const VertexOfPoint& vertexOf) const
  {
    return boxOfItems(this->parallelFor_, triangles.size(),
      [&](Box& part, std::size_t i)
      {
        for (const Id vertex : vertexOf(triangles[i]))
        {
          part.add(this->vertices_.positions[vertex]);
        }
      });
  }

  /// Brings the vertices to a size that the engine can compute with. Points that no triangle uses
  /// may be anywhere; they only stay finite.
  void scaleVertices()
  {
    const std::vector<Triangle>& triangles = this->triangles_.corners;
    const double largest = this->exchange_.largestOf(
      triangles.empty() ? 0.0 : this->boxOf(triangles, this->vertices_.of).largestCoordinate());
    this->scale_ = requireScale(largest);
    if (!this->scale_.isOne())
    {
      for (Vec3& p : this->vertices_.positions)
      {
        for (double& x : p)
        {
          x = std::clamp(this->scale_.toEngine(x), -DBL_MAX, DBL_MAX);
        }
      }
    }
    this->largestCoordinate_ = this->scale_.toEngine(largest);
  }

  /// Triangles from the first to before the last, for joining seams.
  SeamBlock seamBlock(std::size_t first, std::size_t last, double precision) const
  {
    SeamBlock seam;
    seam.precision = precision;
    for (std::size_t i = first; i < last; ++i)
    {
      (this->triangles_.isDuplicate[i] ? seam.ghosts : seam.triangles)
        .push_back(this->vertices_.of(this->triangles_.corners[i]));
    }
    return seam;
  }

  /// \returns JoinedVertices::same
  std::map<Label, Label> findSeams(std::vector<SeamBlock> blocks, Exchange& exchange)
  {
    JoinedVertices joined = mergeSeams(this->vertices_.positions, this->vertices_.labels,
      std::move(blocks), this->largestCoordinate_, exchange);
    // All ranks of the exchange have counted the same.
    this->report_.joinedSeamPoints +=
      exchange.rank() == 0 ? static_cast<vtkIdType>(joined.count) : 0;
    return std::move(joined.same);
  }

  /// Connects blocks whose boundaries meet within the rounding of their coordinates.
  void joinBlocks()
  {
    std::vector<SeamBlock> seams;
    for (std::size_t i = 0; i < this->inputs_.size(); ++i)
    {
      seams.push_back(this->seamBlock(this->triangles_.firstOfBlock[i],
        this->triangles_.firstOfBlock[i + 1], this->inputs_[i].precision()));
    }
    std::vector<Id> same(this->vertices_.positions.size());
    std::iota(same.begin(), same.end(), Id(0));
    for (const auto& [vertex, other] : this->findSeams(std::move(seams), OneRank::instance()))
    {
      same[vertex] = static_cast<Id>(other);
    }
    this->vertices_.join(same);
  }

  /// Labels the vertices: vertices of different ranks that are one get the same label. If several
  /// vertices of this rank get the same, they are one, too.
  void joinRanks()
  {
    RankLabels& labels = this->vertices_.labels;
    labels = joinSameVertices(
      this->vertices_.positions, this->mergesPoints_, this->globalIds(), this->exchange_);
    std::map<Label, Label> seams;
    if (this->mergesPoints_)
    {
      double precision = 0.0;
      for (const PolyDataBlock& input : this->inputs_)
      {
        precision = std::max(precision, input.precision());
      }
      seams = this->findSeams(
        { this->seamBlock(0, this->triangles_.corners.size(), precision) }, this->exchange_);
    }
    std::unordered_map<Label, Id> first;
    std::vector<Id> same(this->vertices_.positions.size());
    for (Id vertex = 0; vertex < same.size(); ++vertex)
    {
      if (const auto seam = seams.find(labels.of(vertex)); seam != seams.end())
      {
        labels.labels[vertex] = seam->second | RankLabels::Shared;
      }
      same[vertex] =
        labels.isSharedAt(vertex) ? first.emplace(labels.of(vertex), vertex).first->second : vertex;
    }
    this->vertices_.join(same);
  }

  /// A global id and a vertex for each point; empty if points of any rank have no global ids.
  std::vector<std::pair<std::int64_t, Id>> globalIds() const
  {
    std::vector<std::pair<std::int64_t, Id>> ids;
    bool isComplete = true;
    for (std::size_t block = 0; block < this->blocks_.size() && isComplete; ++block)
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
          this->vertices_.of(this->blocks_[block].firstPoint + static_cast<Id>(i)));
      }
    }
    if (!this->isTrueOnAll(isComplete))
    {
      ids.clear();
    }
    return ids;
  }

  /// Finds the triangles that are not open.
  ///
  /// \throws MeshError if no open triangle is left on any rank, where this one has barriers.
  void findRoles()
  {
    this->roles_ =
      findCopies(this->vertices_.labels, this->vertices_.of, this->triangles_, this->exchange_);
    const char* name = nullptr;
    for (std::size_t block = 0; block < this->inputs_.size(); ++block)
    {
      if (vtkDataArray* values = this->inputs_[block].barriers)
      {
        name = values->GetName();
        this->findBarriers(block);
      }
    }
    const auto open = std::count(this->roles_.begin(), this->roles_.end(), TriangleRole::Open);
    const bool isAnyOpen = open > 0 || this->roles_.size() < this->triangles_.corners.size();
    if (this->isTrueOnAll(!isAnyOpen) && name)
    {
      throw MeshError(
        std::string("All faces of the surface (input port 0) are barriers: the cell array ") +
        name +
        " (BarrierArrayName) is 0 at none of them. Set it to 0 where paths may pass, or choose no "
        "barrier array.");
    }
    if (static_cast<std::size_t>(open) == this->roles_.size())
    {
      this->roles_ = std::vector<TriangleRole>();
    }
  }

  /// A triangle with two corners at one vertex has no inside: it is left to the mesh, which leaves
  /// it out.
  void findBarriers(std::size_t block)
  {
    this->roles_.resize(this->triangles_.corners.size(), TriangleRole::Open);
    for (std::size_t i = this->triangles_.firstOfBlock[block];
         i < this->triangles_.firstOfBlock[block + 1]; ++i)
    {
      if (this->roles_[i] == TriangleRole::Open &&
        hasThreeVertices(this->vertices_.of(this->triangles_.corners[i])) &&
        this->inputs_[block].barriers->GetComponent(this->triangles_.cells[i], 0) != 0.0)
      {
        this->roles_[i] = TriangleRole::Barrier;
      }
    }
  }

  /// Takes the faces, in the memory of the triangles.
  Faces takeFaces()
  {
    Faces faces;
    faces.open = std::move(this->triangles_.corners);
    this->triangles_ = {};
    std::vector<Triangle>& open = faces.open;
    forRanges(this->parallelFor_, this->vertices_.of.isIdentity() ? 0 : open.size(),
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          open[i] = this->vertices_.of(open[i]);
        }
      });
    std::size_t count = 0;
    for (std::size_t i = 0; i < this->roles_.size(); ++i)
    {
      if (this->roles_[i] == TriangleRole::Open)
      {
        open[count++] = open[i];
      }
      else if (this->roles_[i] == TriangleRole::Barrier)
      {
        faces.barriers.push_back(open[i]);
      }
    }
    open.resize(this->roles_.empty() ? open.size() : count);
    return faces;
  }

  /// The diagonal of the bounding box of the points that faces use. Other points are not surface,
  /// and may lie anywhere.
  double diagonalOf(const Faces& faces) const
  {
    Box box = this->boxOf(faces.open, {});
    box.add(this->boxOf(faces.barriers, {}));
    std::vector<double> least = { box.low[0], box.low[1], box.low[2], -box.high[0], -box.high[1],
      -box.high[2] };
    this->exchange_.findLeast(least);
    return norm(Vec3{ -least[3], -least[4], -least[5] } - Vec3{ least[0], least[1], least[2] });
  }

  /// Makes the meshes of the open faces and of the barriers.
  SurfaceContents makeSurface(Faces faces)
  {
    const double diagonal = this->diagonalOf(faces);
    const std::size_t count = this->vertices_.positions.size();
    std::vector<Id> inBarriers = numberUsedVertices(faces.barriers, count);
    std::vector<Vec3> barrierPoints;
    std::vector<std::uint64_t> barrierKeys;
    this->vertices_.copy(inBarriers, barrierPoints, barrierKeys);
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
      this->vertices_.copy(used, points, keys);
      this->vertices_.positions = std::move(points);
    }
    BorrowedValues remote = remoteVertices(this->vertices_.labels, numbers, this->exchange_);
    this->vertices_.labels = {};
    MeshPartition partition(std::move(this->vertices_.positions), faces.open, keys, this->exchange_,
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
    this->vertices_.of.renumber(std::move(numbers));
    const SurfaceReport report = reportOfAllRanks(this->report_, partition);
    return { std::move(partition), std::move(remote), std::move(barriers), std::move(inBarriers),
      std::move(this->vertices_.of), std::move(this->blocks_), std::move(this->roles_),
      this->scale_, diagonal, report };
  }

  const std::vector<PolyDataBlock>& inputs_;
  bool mergesPoints_;
  Exchange& exchange_;
  const ProgressCallback& callback_;
  ParallelFor parallelFor_;
  std::vector<SurfaceBlock> blocks_;
  Vertices vertices_;
  TriangleList triangles_;
  /// Of the triangles; empty if all are open.
  std::vector<TriangleRole> roles_;
  PowerOfTwoScale scale_;
  /// Of the triangles of all ranks, on the mesh's scale.
  double largestCoordinate_ = 0.0;
  SurfaceReport report_;
};

}

PolyDataSurface readSurface(const std::vector<PolyDataBlock>& blocks, bool mergeCoincidentPoints,
  Exchange& exchange, const ProgressCallback& progress)
{
  return PolyDataSurface(SurfaceReader(blocks, mergeCoincidentPoints, exchange, progress).read());
}

}
