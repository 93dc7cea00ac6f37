// SPDX-License-Identifier: BSD-3-Clause
#include "field/DistanceMatrix.h"

#include "field/DistanceField.h"
#include "field/RetentionAround.h"
#include "field/WatchedTasks.h"

namespace geodesic
{

namespace
{

/// The distances of the targets from one source.
std::vector<double> distancesFrom(const TriangleMesh& mesh, const std::vector<SourceCurve>& source,
  const std::vector<SurfacePoint>& targets, double maximumDistance,
  const ProgressCallback& progress)
{
  std::vector<double> distances(targets.size(), Infinity);
  if (source.empty())
  {
    return distances;
  }
  RetentionAround retention(mesh, targets, maximumDistance);
  FrontOptions options;
  options.progress = progress;
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
  const std::vector<SurfacePoint>& targets, const MatrixOptions& options)
{
  std::vector<std::vector<SourceCurve>> sources(numberOfSources);
  for (const SourceCurve& curve : curves)
  {
    sources[curve.source].push_back(curve);
  }
  std::vector<std::vector<double>> matrix(numberOfSources);
  const auto task = [&](std::size_t source, const ProgressCallback& progress)
  {
    matrix[source] =
      distancesFrom(mesh, sources[source], targets, options.maximumDistance, progress);
  };
  runWatched(numberOfSources, task, options.parallelFor, options.progress);
  return matrix;
}

}
