// SPDX-License-Identifier: BSD-3-Clause
#include "field/DistanceMatrix.h"

#include "field/DistanceField.h"
#include "field/RetentionAround.h"

#include <algorithm>

namespace geodesic
{

namespace
{

/// The distances of the targets from one source.
std::vector<double> distancesFrom(const TriangleMesh& mesh, const std::vector<SourceCurve>& source,
  const std::vector<SurfacePoint>& targets, double maximumDistance, const Job& job)
{
  std::vector<double> distances(targets.size(), Infinity);
  if (source.empty())
  {
    return distances;
  }
  RetentionAround retention(mesh, targets, maximumDistance);
  FrontOptions options;
  options.job = job;
  FrontResult front = propagate(mesh, source, options, retention);
  const DistanceField field(MeshPartition(mesh), std::move(front), retention.release());
  for (std::size_t i = 0; i < targets.size(); ++i)
  {
    const double distance = field.distance(targets[i]);
    distances[i] = distance <= maximumDistance ? distance : Infinity;
  }
  return distances;
}

using SourceSets = std::vector<std::vector<SourceCurve>>;

/// Solves from each source.
std::vector<std::vector<double>> matrixFromSources(const TriangleMesh& mesh,
  const SourceSets& sources, const std::vector<SurfacePoint>& targets, double maximumDistance,
  const Job& job)
{
  std::vector<std::vector<double>> matrix(sources.size());
  job.longTasks(sources.size(),
    [&](std::size_t source, const Job& part)
    { matrix[source] = distancesFrom(mesh, sources[source], targets, maximumDistance, part); });
  return matrix;
}

/// Solves from each target. The sources are sets of points, so that the shortest path from one to a
/// target is the shortest of those from the target to its points.
std::vector<std::vector<double>> matrixFromTargets(const TriangleMesh& mesh,
  const SourceSets& sources, const std::vector<SurfacePoint>& targets, double maximumDistance,
  const Job& job)
{
  std::vector<SurfacePoint> points;
  std::vector<std::size_t> sourceOfPoint;
  for (std::size_t source = 0; source < sources.size(); ++source)
  {
    for (const SourceCurve& point : sources[source])
    {
      points.push_back(point.points.front());
      sourceOfPoint.push_back(source);
    }
  }
  std::vector<std::vector<double>> matrix(
    sources.size(), std::vector<double>(targets.size(), Infinity));
  job.longTasks(targets.size(),
    [&](std::size_t target, const Job& part)
    {
      const std::vector<SourceCurve> from = { pointCurve(normalized(mesh, targets[target])) };
      const std::vector<double> distances =
        distancesFrom(mesh, from, points, maximumDistance, part);
      for (std::size_t i = 0; i < points.size(); ++i)
      {
        double& least = matrix[sourceOfPoint[i]][target];
        least = std::min(least, distances[i]);
      }
    });
  return matrix;
}

/// Estimates the work of solving from each of some sets of points until others are settled: the sum
/// of the areas that the fronts cover, if they go as far as straight lines.
double estimateWork(const std::vector<std::vector<Vec3>>& sets, const std::vector<Vec3>& others,
  double maximumDistance, const Job& job)
{
  double work = 0.0;
  for (const std::vector<Vec3>& set : sets)
  {
    job.look();
    double farthest = 0.0;
    for (const Vec3& other : others)
    {
      double nearest = Infinity;
      for (const Vec3& point : set)
      {
        nearest = std::min(nearest, norm(other - point));
      }
      farthest = std::max(farthest, nearest);
    }
    const double reach = std::min(farthest, maximumDistance);
    work += set.empty() ? 0.0 : reach * reach;
  }
  return work;
}

/// Whether fewer fronts, with less work in all, go out from the targets than from the sources.
bool isLessFromTargets(const TriangleMesh& mesh, const SourceSets& sources,
  const std::vector<SurfacePoint>& targets, double maximumDistance, const Job& job)
{
  std::size_t count = 0;
  std::vector<std::vector<Vec3>> sets(sources.size());
  std::vector<Vec3> points;
  for (std::size_t source = 0; source < sources.size(); ++source)
  {
    count += sources[source].empty() ? 0 : 1;
    for (const SourceCurve& curve : sources[source])
    {
      if (curve.points.size() != 1 || !curve.coveredFaces.empty())
      {
        return false;
      }
      points.push_back(position(mesh, curve.points.front()));
      sets[source].push_back(points.back());
    }
  }
  if (targets.empty() || targets.size() >= count)
  {
    return false;
  }
  std::vector<Vec3> places;
  std::vector<std::vector<Vec3>> placeSets;
  for (const SurfacePoint& target : targets)
  {
    places.push_back(position(mesh, target));
    placeSets.push_back({ places.back() });
  }
  return estimateWork(placeSets, points, maximumDistance, job) <
    estimateWork(sets, places, maximumDistance, job);
}

} // anonymous namespace

std::vector<std::vector<double>> distanceMatrix(const TriangleMesh& mesh,
  const std::vector<SourceCurve>& curves, Id numberOfSources,
  const std::vector<SurfacePoint>& targets, double maximumDistance, const Job& job)
{
  SourceSets sources(numberOfSources);
  for (const SourceCurve& curve : curves)
  {
    sources[curve.source].push_back(curve);
  }
  const auto solve = isLessFromTargets(mesh, sources, targets, maximumDistance, job)
    ? matrixFromTargets
    : matrixFromSources;
  return solve(mesh, sources, targets, maximumDistance, job);
}

}
