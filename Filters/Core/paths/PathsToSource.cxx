// SPDX-License-Identifier: BSD-3-Clause
#include "paths/PathsToSource.h"

#include "Errors.h"
#include "Tolerance.h"
#include "field/DistanceField.h"
#include "field/RetentionAround.h"
#include "paths/CleanPath.h"
#include "paths/PathInWindows.h"
#include "paths/PathTracer.h"
#include "source/CurvesInFaces.h"

#include <algorithm>
#include <cstdint>
#include <string>

namespace geodesic
{

namespace
{

/// Of the progress, for the front and for tracing; what is left is for paths that got lost.
constexpr double FrontDone = 0.5;
constexpr double TracingDone = 0.9;

/// How many paths are traced between two reports, and how many by one task.
constexpr std::size_t PathsPerReport = 256;
constexpr std::size_t PathsPerTask = 8;

class PathFinder
{
public:
  PathFinder(const TriangleMesh& mesh, const std::vector<SourceCurve>& sources,
    const std::vector<SurfacePoint>& targets, const PathsOptions& options)
    : mesh_(mesh)
    , sources_(sources)
    , targets_(targets)
    , options_(options)
    , curves_(mesh, sources)
    , paths_(targets.size())
    , isLost_(targets.size(), 0)
  {
  }

  std::vector<PathToSource> run()
  {
    RetentionAround retention(this->mesh_, this->targets_);
    FrontOptions options;
    options.keepArrivals = true;
    options.parallelFor = this->options_.parallelFor;
    options.progress = this->part(0.0, FrontDone);
    FrontResult front = propagate(this->mesh_, this->sources_, options, retention);
    const DistanceField field(MeshPartition(this->mesh_), std::move(front), retention.release());
    this->traceAll(field);
    this->findLost(field, retention.reach());
    return std::move(this->paths_);
  }

private:
  ProgressCallback part(double begin, double end) const
  {
    const ProgressCallback& progress = this->options_.progress;
    return progress ? [&progress, begin, end](double fraction)
    { return progress(begin + (end - begin) * fraction); }
                    : ProgressCallback();
  }

  void report(double fraction) const
  {
    if (this->options_.progress && !this->options_.progress(fraction))
    {
      throw Aborted();
    }
  }

  void traceAll(const DistanceField& field)
  {
    const PathTracer tracer(field);
    const std::size_t count = this->targets_.size();
    for (std::size_t first = 0; first < count; first += PathsPerReport)
    {
      this->report(FrontDone +
        (TracingDone - FrontDone) * static_cast<double>(first) / static_cast<double>(count));
      const std::size_t last = std::min(count, first + PathsPerReport);
      const std::size_t tasks = (last - first + PathsPerTask - 1) / PathsPerTask;
      const auto task = [&](std::size_t number)
      {
        const std::size_t begin = first + number * PathsPerTask;
        for (std::size_t i = begin; i < std::min(last, begin + PathsPerTask); ++i)
        {
          this->trace(field, tracer, i);
        }
      };
      forAll(this->options_.parallelFor, tasks, task);
    }
  }

  void trace(const DistanceField& field, const PathTracer& tracer, std::size_t index)
  {
    try
    {
      this->take(index, tracer.trace(this->targets_[index]), field.distance(this->targets_[index]));
    }
    catch (const PathLost&)
    {
      this->isLost_[index] = 1;
    }
  }

  void findLost(const DistanceField& field, double reach)
  {
    const KnownDistances known{ field.vertexDistances(), reach };
    const auto count = static_cast<double>(this->targets_.size());
    for (std::size_t i = 0; i < this->targets_.size(); ++i)
    {
      if (this->isLost_[i])
      {
        const double done = TracingDone + (1.0 - TracingDone) * static_cast<double>(i) / count;
        this->report(done);
        const double distance = field.distance(this->targets_[i]);
        const std::vector<SurfacePoint> points = pathInWindows(this->mesh_, this->sources_,
          this->targets_[i], distance, known, this->options_.parallelFor, this->part(done, done));
        if (points.empty())
        {
          throw Error("The shortest path from target " + std::to_string(i) +
            " could not be followed. Please report this with the surface, the source and the "
            "targets.");
        }
        this->take(i, points, distance);
        this->paths_[i].wasLost = true;
      }
    }
  }

  void take(std::size_t index, const std::vector<SurfacePoint>& points, double distance)
  {
    if (points.empty())
    {
      return;
    }
    PathToSource& path = this->paths_[index];
    path.points = points.size() == 1
      ? std::vector<SurfacePoint>(2, points.front())
      : cleanedPath(this->mesh_, points, points.front(), points.back(), distance);
    path.source = this->curves_.sourceAt(path.points.back());
  }

  const TriangleMesh& mesh_;
  const std::vector<SourceCurve>& sources_;
  const std::vector<SurfacePoint>& targets_;
  const PathsOptions& options_;
  CurvesInFaces curves_;
  std::vector<PathToSource> paths_;
  /// One byte a target, so that tasks may write side by side.
  std::vector<std::uint8_t> isLost_;
};

} // anonymous namespace

std::vector<PathToSource> pathsToSource(const TriangleMesh& mesh,
  const std::vector<SourceCurve>& sources, const std::vector<SurfacePoint>& targets,
  const PathsOptions& options)
{
  return PathFinder(mesh, sources, targets, options).run();
}

}
