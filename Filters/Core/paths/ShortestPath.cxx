// SPDX-License-Identifier: BSD-3-Clause
#include "paths/ShortestPath.h"

#include "Tolerance.h"
#include "field/DistanceField.h"
#include "field/RetentionAround.h"
#include "field/Solve.h"
#include "paths/PathTracer.h"

#include <algorithm>

namespace geodesic
{

namespace
{

/// Of the progress, for the search.
constexpr double ShareOfSearch = 0.7;

/// Relative error of the search. The strip that it leaves is as wide as the root of that; with
/// less, the search takes longer, with more what follows.
constexpr double SearchError = 1e-3;

ProgressCallback part(const ProgressCallback& progress, double begin, double end)
{
  return progress ? [&progress, begin, end](double fraction)
  { return progress(begin + (end - begin) * fraction); }
                  : ProgressCallback();
}

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

/// Keeps what tracing from the second point needs, and narrows the corridor: the sum of what is
/// known of both ways bounds the length of a path.
class StripRetention : public RetentionAround
{
public:
  StripRetention(const TriangleMesh& mesh, const SurfacePoint& second,
    const std::vector<double>& toSecond, double least, Corridor& corridor)
    : RetentionAround(mesh, { second })
    , toSecond_(toSecond)
    , least_(least)
    , corridor_(corridor)
  {
  }

  void advance(const FrontState& front) override
  {
    RetentionAround::advance(front);
    for (const Id vertex : front.settled)
    {
      const double length = front.distances(vertex) + (1.0 + SearchError) * this->toSecond_[vertex];
      this->corridor_.length = std::min(
        this->corridor_.length, std::max(this->least_, (1.0 + tolerance::BoundMargin) * length));
    }
  }

private:
  const std::vector<double>& toSecond_;
  double least_;
  Corridor& corridor_;
};

/// Lower bounds of the way to the second point: what the search from there has found is nowhere too
/// large, save where it has left out what is no part of a path within the length. There, the true
/// distance is over what the way from the first point leaves. Farther than it went nothing is
/// nearer.
std::vector<double> lowerBounds(const TriangleMesh& mesh, const SurfacePoint& first,
  const SurfacePoint& second, const std::vector<double>& toSecond, double length, double reach)
{
  const std::vector<double> fromFirst = distancesInSpace(mesh, first);
  std::vector<double> bounds = distancesInSpace(mesh, second);
  for (Id vertex = 0; vertex < mesh.numberOfVertices(); ++vertex)
  {
    const double found = std::min({ toSecond[vertex], reach, length - fromFirst[vertex] });
    bounds[vertex] = std::max(bounds[vertex], (1.0 - tolerance::BoundMargin) * found);
  }
  return bounds;
}

/// The path by windows that are all kept, in the corridor alone.
std::vector<SurfacePoint> pathThroughWindows(const TriangleMesh& mesh, const SurfacePoint& first,
  const SurfacePoint& second, const Corridor& corridor, const ParallelFor& parallelFor,
  const ProgressCallback& progress)
{
  FrontOptions options;
  options.progress = progress;
  options.corridor = &corridor;
  options.parallelFor = parallelFor;
  return solve(mesh, { pointCurve(first) }, options, KeepWindows::All).path(second);
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
  options.progress = part(progress, 0.0, ShareOfSearch);
  options.relativeError = SearchError;
  RetentionAround search(mesh, { first });
  const std::vector<double> toSecond =
    propagate(mesh, { pointCurve(second) }, options, search).vertexDistances;

  corridor.lowerBounds = lowerBounds(mesh, first, second, toSecond, length, search.reach());
  // Behind faces without area the two may be at one place: a path there has the length of
  // roundings.
  const double least = tolerance::BoundMargin * length;
  corridor.length = std::min(length, std::max(least, (1.0 + SearchError) * search.reach()));
  options.relativeError = 0.0;
  options.keepArrivals = true;
  options.progress = part(progress, ShareOfSearch, 1.0);
  StripRetention strip(mesh, second, toSecond, least, corridor);
  FrontResult front = propagate(mesh, { pointCurve(first) }, options, strip);
  const DistanceField field(MeshPartition(mesh), std::move(front), strip.release());
  std::vector<SurfacePoint> path;
  try
  {
    path = PathTracer(field).trace(second);
  }
  catch (const PathLost&)
  {
    path = pathThroughWindows(
      mesh, first, second, corridor, parallelFor, part(progress, 1.0, 1.0)); // seldom
  }
  std::reverse(path.begin(), path.end());
  return path;
}

}
