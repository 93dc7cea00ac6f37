// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/SurfaceReader.h"

#include "PolyData/Hash.h"
#include "PolyData/ranks/PieceVertices.h"
#include "PolyData/reading/Cracks.h"
#include "PolyData/reading/Seams.h"
#include "PolyData/reading/SurfaceParts.h"
#include "PolyData/reading/TriangleReader.h"
#include "PolyData/reading/TriangleRoles.h"
#include "mesh/Box.h"
#include "mesh/GroupedItems.h"

#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstdint>
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
constexpr double TrianglesRead = 0.35;
constexpr double SeamsJoined = 0.5;

/// For each point the first one at exactly its place. By hashes rather than a point locator, whose
/// buckets degenerate where most points crowd in a corner of the bounding box.
std::vector<Id> firstAtPlaces(const std::vector<Vec3>& points, const Job& job)
{
  const auto count = static_cast<Id>(points.size());
  Id keys = 1;
  while (keys < count && keys < (NoId >> 1))
  {
    keys *= 2;
  }
  std::vector<Id> hashes(count);
  job.part(0.0, 0.3).loop(
    count, [&](std::size_t i) { hashes[i] = static_cast<Id>(hashOf(points[i]) & (keys - 1)); });
  const GroupedItems byHash =
    groupItems(count, keys, job.part(0.3, 0.5), [&hashes](Id point) { return hashes[point]; });
  std::vector<Id>& first = hashes; // no longer needed
  job.part(0.5, 1.0).ranges(keys,
    [&](std::size_t begin, std::size_t end)
    {
      for (Id key = static_cast<Id>(begin); key < end; ++key)
      {
        for (const Id point : byHash.at(key))
        {
          // Places that are not finite are no places; their hashes are often equal.
          const auto isThere = [&](Id other)
          { return other == point || (first[other] == other && points[other] == points[point]); };
          const IdRange candidates = byHash.at(key);
          first[point] = isFinite(points[point])
            ? *std::find_if(candidates.begin(), candidates.end(), isThere)
            : point;
        }
      }
    });
  return hashes;
}

Vec3 roundedToSingle(const Vec3& p)
{
  Vec3 rounded;
  std::transform(p.begin(), p.end(), rounded.begin(),
    [](double x) { return std::abs(x) <= FLT_MAX ? double(static_cast<float>(x)) : Infinity; });
  return rounded;
}

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

/// Reads the blocks of one surface, stage by stage.
struct SurfaceReader
{
  const std::vector<PolyDataBlock>& inputs;
  const PointMerging merging;
  Exchange& exchange;
  const Job& job;
  /// What is read so far.
  PolyDataSurface surface{};
  /// Whether a point has a coordinate that is NaN or infinite.
  bool isAnyNotFinite = false;
  PieceVertices vertices{};
  TriangleList triangles{};
  /// Of the triangles of all ranks, on the mesh's scale.
  double largestCoordinate = 0.0;

  PolyDataSurface read()
  {
    const vtkIdType numberOfFaces = countFaces(this->inputs);
    if (this->isTrueOnAll(numberOfFaces == 0))
    {
      throwWithoutFaces(this->inputs);
    }
    this->numberPoints();
    this->readPoints(this->job.part(0.0, PointsRead));
    if (this->merging.isWanted)
    {
      this->vertices.join(
        firstAtPlaces(this->vertices.positions, this->job.part(PointsRead, PointsMerged)));
    }
    this->triangles = readTriangles(this->inputs, this->vertices.of, numberOfFaces,
      this->job.part(PointsMerged, TrianglesRead), this->surface.blocks, this->surface.report);
    this->requireFiniteCorners();
    if (this->isTrueOnAll(this->triangles.corners.empty()))
    {
      const bool isAlone = this->exchange.numberOfRanks() == 1;
      throw MeshError("None of the " + (isAlone ? std::to_string(numberOfFaces) + " " : "") +
        "faces of the surface (input port 0) has three different corners. Connect a surface with "
        "triangles or polygons.");
    }
    const Job joining = this->job.part(TrianglesRead, SeamsJoined);
    joining.reach(0.0);
    std::vector<double> precisions = this->storedPrecisions();
    this->scaleVertices();
    this->vertices.joinRanks(
      this->inputs, this->surface.blocks, this->merging.isWanted, this->exchange);
    joining.reach(0.3);
    if (this->merging.isWanted)
    {
      this->joinSeams(std::move(precisions));
    }
    joining.reach(1.0);
    this->surface.roles = findRoles(this->inputs, this->vertices, this->triangles, this->exchange);
    keepTriangles(this->inputs, this->triangles, this->surface.blocks);
    this->surface.useBlocks(this->inputs);
    this->makeParts();
    this->makeMeshes();
    return std::move(this->surface);
  }

  bool isTrueOnAll(bool condition) const { return !this->exchange.isTrueAnywhere(!condition); }

  /// Numbers the points of all blocks.
  void numberPoints()
  {
    vtkIdType count = 0;
    for (const PolyDataBlock& input : this->inputs)
    {
      SurfaceBlock& block = this->surface.blocks.emplace_back();
      block.firstPoint = static_cast<Id>(count);
      block.numberOfPoints = static_cast<Id>(input.data->GetNumberOfPoints());
      count += input.data->GetNumberOfPoints();
      if (count >= static_cast<vtkIdType>(NoId))
      {
        throw MeshTooLarge("The surface (input port 0) has " + std::to_string(count) +
          " points, more than 32-bit ids can number. Decimate it or cut it into parts.");
      }
    }
    this->surface.numberOfPoints = static_cast<Id>(count);
    this->vertices.positions.resize(this->surface.numberOfPoints);
  }

  void readPoints(const Job& stretch)
  {
    std::vector<Vec3>& positions = this->vertices.positions;
    const auto readRange = [&](std::size_t begin, std::size_t end)
    {
      int areFinite = 1;
      for (std::size_t block = 0; block < this->inputs.size(); ++block)
      {
        vtkPoints* points = this->inputs[block].data->GetPoints();
        const std::size_t first = this->surface.blocks[block].firstPoint;
        const std::size_t last = std::min(end, first + this->surface.blocks[block].numberOfPoints);
        for (std::size_t i = std::max(begin, first); i < last; ++i)
        {
          points->GetPoint(static_cast<vtkIdType>(i - first), positions[i].data());
          areFinite = isFinite(positions[i]) ? areFinite : 0;
        }
      }
      return areFinite;
    };
    const std::vector<int> areFinite = stretch.resultsOfRanges(positions.size(), readRange);
    this->isAnyNotFinite = std::find(areFinite.begin(), areFinite.end(), 0) != areFinite.end();
  }

  /// Other points may be anywhere: depth images and scans mark what they have not seen by NaN.
  ///
  /// \throws InputError if the corner of a triangle is not finite.
  void requireFiniteCorners() const
  {
    for (std::size_t i = 0; this->isAnyNotFinite && i < this->inputs.size(); ++i)
    {
      const SurfaceBlock& block = this->surface.blocks[i];
      std::vector<char> isUsed(block.numberOfPoints, 0);
      for (std::size_t t = this->triangles.firstOfBlock[i]; t < this->triangles.firstOfBlock[i + 1];
           ++t)
      {
        for (const Id point : this->triangles.corners[t])
        {
          isUsed[point - block.firstPoint] = 1;
        }
      }
      requireFinite(this->inputs[i], isUsed.data());
    }
  }

  Box boxOf(const std::vector<Triangle>& corners, const VertexOfPoint& vertexOf) const
  {
    return boxOfItems(this->job.part(TrianglesRead, TrianglesRead), corners.size(),
      [&](Box& part, std::size_t i)
      {
        for (const Id vertex : vertexOf(corners[i]))
        {
          part.add(this->vertices.positions[vertex]);
        }
      });
  }

  /// Brings the vertices to a size that the engine can compute with. Points that no triangle uses
  /// may be anywhere; they only become finite.
  void scaleVertices()
  {
    const std::vector<Triangle>& corners = this->triangles.corners;
    const Box box = this->boxOf(corners, this->vertices.of);
    const double largest =
      this->exchange.largestOf(corners.empty() ? 0.0 : box.largestCoordinate());
    const PowerOfTwoScale scale = this->surface.scale = requireScale(largest);
    if (!scale.isOne() || this->isAnyNotFinite)
    {
      for (Vec3& p : this->vertices.positions)
      {
        for (double& x : p)
        {
          x = std::isnan(x) ? DBL_MAX : std::clamp(scale.toEngine(x), -DBL_MAX, DBL_MAX);
        }
      }
    }
    this->largestCoordinate = scale.toEngine(largest);
  }

  /// The relative precision with which the coordinates of each block are stored. If all of double
  /// precision are values of single precision, that counts: they come from such a file.
  std::vector<double> storedPrecisions() const
  {
    std::vector<double> precisions;
    for (const PolyDataBlock& input : this->inputs)
    {
      precisions.push_back(input.precision());
    }
    const bool areSingle = precisions.empty() ||
      *std::min_element(precisions.begin(), precisions.end()) == FLT_EPSILON ||
      std::all_of(this->vertices.positions.begin(), this->vertices.positions.end(),
        [](const Vec3& p) { return !isFinite(p) || p == roundedToSingle(p); });
    if (this->isTrueOnAll(areSingle))
    {
      std::fill(precisions.begin(), precisions.end(), FLT_EPSILON);
    }
    return precisions;
  }

  /// Joins vertices that only the precision of coordinates, or the user's tolerance, keeps apart.
  void joinSeams(std::vector<double> precisions)
  {
    const std::uint64_t joined =
      mergeSeams({ this->vertices, this->triangles, std::move(precisions), this->largestCoordinate,
                   this->surface.scale.toEngine(this->merging.tolerance) },
        this->exchange);
    // All ranks have counted the same.
    this->surface.report.joinedSeamPoints =
      this->exchange.rank() == 0 ? static_cast<vtkIdType>(joined) : 0;
  }

  /// From here on the triangles are parts, on vertices.
  void makeParts()
  {
    std::vector<Triangle>& corners = this->triangles.corners;
    const auto toVertices = [&]
    {
      this->job.part(TrianglesRead, TrianglesRead)
        .loop(this->vertices.of.isIdentity() ? 0 : corners.size(),
          [&](std::size_t i) { corners[i] = this->vertices.of(corners[i]); });
    };
    toVertices();
    cutTriangles(corners, this->exchange, this->vertices, this->surface,
      this->job.part(SeamsJoined, SeamsJoined));
    if (!this->surface.corners.empty())
    {
      corners = this->surface.corners;
      toVertices();
    }
    this->surface.numberOfParts = static_cast<Id>(corners.size());
  }

  /// Leaves only the open ones of the parts.
  ///
  /// \returns the barriers.
  std::vector<Triangle> takeBarriers(std::vector<Triangle>& parts)
  {
    std::vector<Triangle> barriers;
    std::vector<Id>& openParts = this->surface.openParts;
    const std::vector<TriangleRole>& roles = this->surface.roles;
    for (Id i = 0; i < roles.size(); ++i)
    {
      if (roles[i] == TriangleRole::Open)
      {
        parts[openParts.size()] = parts[i];
        openParts.push_back(i);
      }
      else if (roles[i] == TriangleRole::Barrier)
      {
        barriers.push_back(parts[i]);
        this->surface.barrierParts.push_back(i);
      }
    }
    parts.resize(roles.empty() ? parts.size() : openParts.size());
    return barriers;
  }

  /// Finds the bounding box of the points that faces use, on all ranks. Other points are not
  /// surface, and may lie anywhere.
  void findBox(const std::vector<Triangle>& open, const std::vector<Triangle>& barriers)
  {
    Box own = this->boxOf(open, {});
    own.add(this->boxOf(barriers, {}));
    Box& whole = this->surface.box;
    for (const Box& box : valuesOfRanks(this->exchange, own))
    {
      whole.add(box);
    }
    this->surface.diagonal = norm(whole.high - whole.low);
  }

  /// Makes the meshes of the open faces, for which they take the memory of the triangles, and of
  /// the barriers.
  void makeMeshes()
  {
    std::vector<Triangle> open = std::move(this->triangles.corners);
    this->triangles = {};
    std::vector<Triangle> barriers = this->takeBarriers(open);
    this->findBox(open, barriers);
    std::vector<Id>& inBarriers = this->surface.barrierVertices;
    inBarriers = numberUsedVertices(barriers, this->vertices.positions.size());
    std::vector<Vec3> barrierPoints;
    std::vector<std::uint64_t> barrierKeys;
    this->vertices.copy(inBarriers, barrierPoints, barrierKeys);
    std::vector<std::uint64_t> keys;
    std::vector<Id> numbers = this->vertices.keepUsed(open, this->exchange, keys);
    this->surface.valuesElsewhere = this->vertices.valuesElsewhere(numbers, this->exchange);
    this->vertices.labels = {};
    MeshPartition& partition = this->surface.partition;
    partition = MeshPartition(std::move(this->vertices.positions), open, keys, this->exchange,
      this->job.part(SeamsJoined, 1.0));
    Id next = partition.mesh().numberOfVertices();
    for (Id& number : numbers)
    {
      number = number != NoId ? number : next++;
    }
    for (Id& vertex : inBarriers)
    {
      vertex = numbers.empty() ? vertex : numbers[vertex];
    }
    if (this->exchange.isTrueAnywhere(!barriers.empty()))
    {
      this->surface.barriers = std::make_unique<BarrierFaces>(
        partition, MeshPartition(std::move(barrierPoints), barriers, barrierKeys, this->exchange));
    }
    this->vertices.of.renumber(std::move(numbers));
    this->surface.vertexOf = std::move(this->vertices.of);
    if (this->merging.isWanted)
    {
      findCracks(partition, this->surface.diagonal, this->surface.report);
    }
    this->surface.report.addRanks(partition);
  }
};

}

PolyDataSurface readSurface(const std::vector<PolyDataBlock>& blocks, const PointMerging& merging,
  Exchange& exchange, const Job& job)
{
  return SurfaceReader{ blocks, merging, exchange, job }.read();
}

}
