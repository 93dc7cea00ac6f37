// SPDX-License-Identifier: BSD-3-Clause
#include "field/DistanceMatrix.h"

#include "field/DistanceField.h"
#include "field/RetentionAround.h"

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

} // anonymous namespace

std::vector<std::vector<double>> distanceMatrix(const TriangleMesh& mesh,
  const std::vector<SourceCurve>& curves, Id numberOfSources,
  const std::vector<SurfacePoint>& targets, double maximumDistance, const Job& job)
{
  std::vector<std::vector<SourceCurve>> sources(numberOfSources);
  for (const SourceCurve& curve : curves)
  {
    sources[curve.source].push_back(curve);
  }
  std::vector<std::vector<double>> matrix(numberOfSources);
  job.longTasks(numberOfSources,
    [&](std::size_t source, const Job& part)
    { matrix[source] = distancesFrom(mesh, sources[source], targets, maximumDistance, part); });
  return matrix;
}

}
