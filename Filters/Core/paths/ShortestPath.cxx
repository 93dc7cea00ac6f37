// SPDX-License-Identifier: BSD-3-Clause
#include "paths/ShortestPath.h"

#include "Tolerance.h"
#include "field/DistanceField.h"
#include "field/RetentionAround.h"
#include "field/Solve.h"
#include "paths/PathInWindows.h"
#include "paths/PathTracer.h"

#include <algorithm>

namespace geodesic
{

namespace
{

/// The fraction of the progress at which the search ends.
constexpr double ShareOfSearch = 0.7;

/// Relative error of the search. The strip is as wide as the root of the error: with a smaller
/// error the search takes longer, with a larger one the exact front does.
constexpr double SearchError = 1e-3;

std::vector<double> distancesInSpace(const TriangleMesh& mesh, const SurfacePoint& point)
{
  std::vector<double> distances;
  distances.reserve(mesh.numberOfVertices());
  for (Id vertex = 0; vertex < mesh.numberOfVertices(); ++vertex)
  {
    distances.push_back(distanceInSpace(mesh, mesh.point(vertex), point));
  }
  return distances;
}

/// Keeps what tracing from the second point needs. The distance of a vertex and its way to the
/// second point add up to a path: the corridor need be no longer.
class StripRetention : public RetentionAround
{
public:
  /// \param least a length below which roundings decide.
  StripRetention(const TriangleMesh& mesh, const SurfacePoint& second,
    const std::vector<double>& toSecond, double least)
    : RetentionAround(mesh, { second })
    , toSecond_(toSecond)
    , least_(least)
  {
    this->keepAroundIrregularEdges();
  }

  double longestPath() const override { return this->longestPath_; }

  void advance(const FrontState& front) override
  {
    RetentionAround::advance(front);
    for (const Id vertex : front.settled)
    {
      const double length = front.distances(vertex) + (1.0 + SearchError) * this->toSecond_[vertex];
      this->longestPath_ = std::min(
        this->longestPath_, std::max(this->least_, (1.0 + tolerance::BoundMargin) * length));
    }
  }

private:
  const std::vector<double>& toSecond_;
  double least_;
  double longestPath_ = Infinity;
};

/// Lower bounds of the distance to the second point. The distances that the search from there has
/// found are lower bounds, except where it left out what no path within the length passes: there
/// the distance exceeds what the way from the first point leaves of the length. Beyond the reach of
/// the search, the reach is a lower bound.
///
/// \param searched the corridor of the search.
std::vector<double> lowerBounds(const TriangleMesh& mesh, const SurfacePoint& second,
  const std::vector<double>& toSecond, double reach, const Corridor& searched)
{
  std::vector<double> bounds = distancesInSpace(mesh, second);
  for (Id vertex = 0; vertex < mesh.numberOfVertices(); ++vertex)
  {
    const double found =
      std::min({ toSecond[vertex], reach, searched.length - searched.lowerBounds[vertex] });
    bounds[vertex] = std::max(bounds[vertex], (1.0 - tolerance::BoundMargin) * found);
  }
  return bounds;
}

} // anonymous namespace

std::vector<SurfacePoint> shortestPath(const TriangleMesh& mesh, const SurfacePoint& first,
  const SurfacePoint& second, double length, const ParallelFor& parallelFor,
  const ProgressCallback& progress)
{
  Corridor corridor{ distancesInSpace(mesh, first), length };
  FrontOptions options;
  options.corridor = &corridor;
  options.parallelFor = parallelFor;
  options.progress = progressBetween(progress, 0.0, ShareOfSearch);
  options.relativeError = SearchError;
  RetentionAround search(mesh, { first });
  const std::vector<double> toSecond =
    propagate(mesh, { pointCurve(second) }, options, search).vertexDistances;

  corridor.lowerBounds = lowerBounds(mesh, second, toSecond, search.reach(), corridor);
  // The two points may be at one place, behind faces without area: there a path is as long as
  // roundings.
  const double least = tolerance::BoundMargin * length;
  corridor.length = std::min(length, std::max(least, (1.0 + SearchError) * search.reach()));
  options.relativeError = 0.0;
  options.keepArrivals = true;
  options.progress = progressBetween(progress, ShareOfSearch, 1.0);
  StripRetention strip(mesh, second, toSecond, least);
  FrontResult front = propagate(mesh, { pointCurve(first) }, options, strip);
  const DistanceField field(MeshPartition(mesh), std::move(front), strip.release());
  std::vector<SurfacePoint> path;
  try
  {
    path = PathTracer(field).trace(second);
  }
  catch (const PathLost&)
  {
    // Seldom: by windows that are all kept, in the corridor alone.
    corridor.length = std::min(corridor.length, strip.longestPath());
    options.keepArrivals = false;
    options.progress = progressBetween(progress, 1.0, 1.0);
    path = pathInWindows(solve(mesh, { pointCurve(first) }, options, KeepWindows::All), second);
  }
  std::reverse(path.begin(), path.end());
  return path;
}

}
