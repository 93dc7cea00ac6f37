// SPDX-License-Identifier: BSD-3-Clause
#include "paths/FacesBetweenPoints.h"

#include "mesh/SurfaceSnap.h"
#include "source/SourceWindowsOfPartition.h"

#include <algorithm>
#include <utility>

namespace geodesic
{

namespace
{

/// Relative error of the fronts. The strip is as wide as the root of the error: with a smaller
/// error the fronts take longer, with a larger one the search in the strip does.
constexpr double SearchError = 1e-3;

/// Keeps no windows, and stops the front when it has reached a point.
class StopAtPoint : public KeepNone
{
public:
  StopAtPoint(const MeshPartition& part, const ReplicatedPatch& patch, const SurfacePoint& point)
  {
    forEachFace(patch.mesh(), point,
      [&](Id face)
      {
        const Id own = patch.faceOfPart(face);
        for (std::size_t k = 0; k < 3 && own != NoId && part.isOwn(own); ++k)
        {
          const Id vertex = part.mesh().triangle(own)[k];
          this->corners_.push_back(
            { vertex, distanceInSpace(patch.mesh(), part.mesh().point(vertex), point) });
        }
      });
    this->length_ = this->corners_.empty() ? 0.0 : Infinity;
  }

  /// The length of a known path to the point; 0 if the point lies on other ranks.
  double reach() const override { return this->length_; }
  bool knowsPoint() const { return !this->corners_.empty(); }

  void advance(const FrontState& front) override
  {
    for (const auto& [vertex, way] : this->corners_)
    {
      this->length_ = std::min(this->length_, front.distances(vertex) + way);
    }
  }

private:
  /// The corners of the point's faces, with their distances from the point.
  std::vector<std::pair<Id, double>> corners_;
  double length_;
};

class Finder
{
public:
  Finder(const MeshPartition& part, const ReplicatedPatch& patch, const ParallelFor& parallelFor)
    : part_(part)
    , patch_(patch)
    , isChosen_(part.mesh().numberOfFaces(), 0)
  {
    this->options_.parallelFor = parallelFor;
  }

  void setProgress(const ProgressCallback& progress) { this->options_.progress = progress; }

  void add(const SurfacePoint& a, const SurfacePoint& b)
  {
    const LowerBounds fromA = waysFrom(this->part_, this->patch_, a, b, this->options_);
    if (fromA.length == Infinity)
    {
      return;
    }
    const LowerBounds fromB = waysFrom(this->part_, this->patch_, b, a, this->options_);
    const double length = std::min(fromA.length, fromB.length);
    const TriangleMesh& mesh = this->part_.mesh();
    for (Id face = this->part_.firstOwnFace(); face < this->part_.endOfOwnFaces(); ++face)
    {
      // From a point of the path in the face to a corner it is no farther than the longest edge.
      const double most = length + 2.0 * mesh.shape(face).longest();
      bool isNear = true;
      for (const Id vertex : mesh.triangle(face))
      {
        isNear = isNear && fromA.atLeast[vertex] + fromB.atLeast[vertex] <= most;
      }
      this->isChosen_[face] |= isNear ? 1 : 0;
    }
  }

  std::vector<Id> faces() const
  {
    std::vector<Id> faces;
    for (Id face = 0; face < this->part_.mesh().numberOfFaces(); ++face)
    {
      if (this->isChosen_[face])
      {
        faces.push_back(face);
      }
    }
    return faces;
  }

private:
  const MeshPartition& part_;
  const ReplicatedPatch& patch_;
  FrontOptions options_;
  std::vector<std::uint8_t> isChosen_;
};

using Pair = std::pair<SurfacePoint, SurfacePoint>;

/// Adds those pairs of places of two points that share no face.
void addFarPairs(const TriangleMesh& mesh, const LocatedPolyline& polyline, std::size_t first,
  std::size_t second, double coordinatePrecision, std::vector<Pair>& pairs)
{
  const auto place = [&](Id face, std::size_t point)
  { return snapToFace(mesh, face, polyline.points[point], coordinatePrecision).place; };
  for (const Id a : polyline.faces[first])
  {
    for (const Id b : polyline.faces[second])
    {
      const Pair pair = { place(a, first), place(b, second) };
      const auto isSame = [&](const Pair& other) {
        return samePlace(mesh, pair.first, other.first) &&
          samePlace(mesh, pair.second, other.second);
      };
      if (commonFace(mesh, pair.first, pair.second) == NoId &&
        std::none_of(pairs.begin(), pairs.end(), isSame))
      {
        pairs.push_back(pair);
      }
    }
  }
}

} // anonymous namespace

LowerBounds waysFrom(const MeshPartition& part, const ReplicatedPatch& patch,
  const SurfacePoint& from, const SurfacePoint& to, FrontOptions options)
{
  const TriangleMesh& mesh = part.mesh();
  options.relativeError = SearchError;
  StopAtPoint stop(part, patch, to);
  LowerBounds ways;
  ways.atLeast = propagate(part,
    sourceWindowsOfPartition(part, patch, makeSourceWindows(patch.mesh(), { pointCurve(from) })),
    options, stop)
                   .vertexDistances;
  const double reach = part.exchange().largestOf(stop.reach());
  ways.length =
    part.exchange().leastOf(stop.knowsPoint() ? stop.reach() : Infinity) / (1.0 - SearchError);
  // Vertices that the front has not settled are beyond its reach; no way is shorter than the
  // distance in space.
  for (Id vertex = 0; vertex < mesh.numberOfVertices(); ++vertex)
  {
    ways.atLeast[vertex] = std::max(std::min(ways.atLeast[vertex], reach),
      distanceInSpace(patch.mesh(), mesh.point(vertex), from));
  }
  return ways;
}

std::vector<Id> facesBetweenPoints(const MeshPartition& part, const ReplicatedPatch& patch,
  const std::vector<LocatedPolyline>& polylines, const SnapOptions& options,
  const ParallelFor& parallelFor, const ProgressCallback& progress)
{
  Finder finder(part, patch, parallelFor);
  std::size_t done = 0;
  for (const LocatedPolyline& polyline : polylines)
  {
    const std::size_t count = polyline.points.size();
    const auto report = [&](double)
    {
      return !progress ||
        progress(static_cast<double>(done) / static_cast<double>(polylines.size()));
    };
    finder.setProgress(report);
    for (std::size_t i = 0; i + 1 < count + (polyline.closed && count > 1 ? 1 : 0); ++i)
    {
      std::vector<Pair> pairs;
      addFarPairs(patch.mesh(), polyline, i, (i + 1) % count, options.coordinatePrecision, pairs);
      for (const Pair& pair : pairs)
      {
        finder.add(pair.first, pair.second);
      }
    }
    ++done;
  }
  return finder.faces();
}

}
