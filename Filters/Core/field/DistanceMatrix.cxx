// SPDX-License-Identifier: BSD-3-Clause
#include "field/DistanceMatrix.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace geodesic
{

namespace
{

using Matrix = std::vector<std::vector<double>>;

/// Solves from each source.
Matrix matrixFrom(
  const CurveSets& sources, const TargetSets& targets, double maximumDistance, const Job& job)
{
  Matrix matrix(sources.size());
  job.longTasks(sources.size(),
    [&](std::size_t source, const Job& part)
    { matrix[source] = targets.distancesFrom(sources[source], 0, maximumDistance, part); });
  return matrix;
}

/// Solves from each target: a shortest path has the same length from both its ends.
Matrix matrixFromTargets(const TriangleMesh& mesh, const CurveSets& sources,
  const CurveSets& targets, double maximumDistance, const Job& job)
{
  const Matrix rows = matrixFrom(targets, TargetSets(mesh, sources), maximumDistance, job);
  Matrix matrix(sources.size(), std::vector<double>(targets.size()));
  for (std::size_t source = 0; source < sources.size(); ++source)
  {
    for (std::size_t target = 0; target < targets.size(); ++target)
    {
      matrix[source][target] = rows[target][source];
    }
  }
  return matrix;
}

using Places = std::vector<std::vector<Vec3>>;

/// The largest number of points of a curve for an estimate of where it is.
constexpr std::size_t PointsOfCurve = 16;

Places placesOf(const TriangleMesh& mesh, const CurveSets& sets)
{
  Places places(sets.size());
  for (std::size_t set = 0; set < sets.size(); ++set)
  {
    for (const SourceCurve& curve : sets[set])
    {
      const std::size_t step = 1 + curve.points.size() / PointsOfCurve;
      for (std::size_t i = 0; i < curve.points.size(); i += step)
      {
        places[set].push_back(position(mesh, curve.points[i]));
      }
    }
  }
  return places;
}

/// The least distance in space.
double nearestOf(const std::vector<Vec3>& some, const std::vector<Vec3>& others)
{
  double nearest = Infinity;
  for (const Vec3& a : some)
  {
    for (const Vec3& b : others)
    {
      nearest = std::min(nearest, norm(b - a));
    }
  }
  return nearest;
}

/// An estimate of the work of solving from each of some sets until others are settled: the sum of
/// the areas that the fronts cover, if they go as far as straight lines.
///
/// \param reaches how far the farthest of the others is from each.
double workOf(const std::vector<double>& reaches, double maximumDistance)
{
  double work = 0.0;
  for (double reach : reaches)
  {
    reach = std::min(reach, maximumDistance);
    work += reach * reach;
  }
  return work;
}

/// Whether fewer fronts, with less work in all, go out from the targets than from the sources.
bool isLessFromTargets(const TriangleMesh& mesh, const CurveSets& sources, const CurveSets& targets,
  double maximumDistance, const Job& job)
{
  const auto fronts = [](const CurveSets& sets)
  {
    return std::count_if(
      sets.begin(), sets.end(), [](const std::vector<SourceCurve>& set) { return !set.empty(); });
  };
  if (fronts(targets) == 0 || fronts(targets) >= fronts(sources))
  {
    return false;
  }
  const Places some = placesOf(mesh, targets);
  const Places others = placesOf(mesh, sources);
  std::vector<double> fromTargets(some.size(), 0.0);
  std::vector<double> fromSources(others.size(), 0.0);
  for (std::size_t i = 0; i < some.size(); ++i)
  {
    job.look();
    for (std::size_t j = 0; j < others.size(); ++j)
    {
      const double nearest = nearestOf(some[i], others[j]);
      if (nearest < Infinity)
      {
        fromTargets[i] = std::max(fromTargets[i], nearest);
        fromSources[j] = std::max(fromSources[j], nearest);
      }
    }
  }
  return workOf(fromTargets, maximumDistance) < workOf(fromSources, maximumDistance);
}

/// The sets from outside to the middle, so that those left lie ever closer together.
std::vector<std::size_t> fromOutside(const Places& sets)
{
  std::vector<Vec3> centres;
  Vec3 middle{};
  for (const std::vector<Vec3>& set : sets)
  {
    Vec3 centre{};
    for (const Vec3& place : set)
    {
      centre = centre + (1.0 / static_cast<double>(set.size())) * place;
    }
    middle = middle + (1.0 / static_cast<double>(sets.size())) * centre;
    centres.push_back(centre);
  }
  std::vector<std::size_t> order(sets.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::stable_sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b)
    { return norm(centres[a] - middle) > norm(centres[b] - middle); });
  return order;
}

} // anonymous namespace

CurveSets setsOf(const std::vector<SourceCurve>& curves, std::size_t count)
{
  CurveSets sets(count);
  for (const SourceCurve& curve : curves)
  {
    sets[curve.source].push_back(curve);
  }
  return sets;
}

CurveSets setsOf(const std::vector<SurfacePoint>& points)
{
  CurveSets sets;
  for (const SurfacePoint& point : points)
  {
    sets.push_back({ pointCurve(point) });
  }
  return sets;
}

std::vector<std::vector<double>> distanceMatrix(const TriangleMesh& mesh, const CurveSets& sources,
  const CurveSets& targets, double maximumDistance, const Job& job)
{
  return isLessFromTargets(mesh, sources, targets, maximumDistance, job)
    ? matrixFromTargets(mesh, sources, targets, maximumDistance, job)
    : matrixFrom(sources, TargetSets(mesh, targets), maximumDistance, job);
}

std::vector<std::vector<double>> distancesBetween(
  const TriangleMesh& mesh, const CurveSets& sets, double maximumDistance, const Job& job)
{
  const std::vector<std::size_t> order = fromOutside(placesOf(mesh, sets));
  CurveSets ordered;
  for (const std::size_t set : order)
  {
    ordered.push_back(sets[set]);
  }
  const TargetSets targets(mesh, ordered);
  Matrix matrix(sets.size(), std::vector<double>(sets.size()));
  job.longTasks(sets.size(),
    [&](std::size_t i, const Job& part)
    {
      const std::vector<double> distances =
        targets.distancesFrom(ordered[i], static_cast<Id>(i), maximumDistance, part);
      for (std::size_t j = i; j < sets.size(); ++j)
      {
        matrix[order[i]][order[j]] = distances[j];
        matrix[order[j]][order[i]] = distances[j];
      }
    });
  return matrix;
}

}
