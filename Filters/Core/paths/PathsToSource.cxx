// SPDX-License-Identifier: BSD-3-Clause
#include "paths/PathsToSource.h"

#include "Errors.h"
#include "field/RetentionAround.h"
#include "paths/PathCorridor.h"
#include "paths/PathInStrip.h"
#include "paths/PathInWindows.h"
#include "paths/PathsOnRanks.h"
#include "source/SourceWindows.h"

#include <algorithm>
#include <string>
#include <utility>

namespace geodesic
{

namespace
{

/// Where the steps of the job end: the front and tracing. What is left is for paths that got lost.
constexpr double FrontDone = 0.5;
constexpr double TracingDone = 0.9;

/// How many paths are traced at a time.
constexpr std::size_t PathsAtATime = 256;

/// Follows the paths of this rank's targets.
class PathFinder
{
public:
  PathFinder(const DistanceField& field, const ReplicatedPatch& patch,
    const std::vector<SourceCurve>& curves, const std::vector<SurfacePoint>& targets,
    const Job& job, const TakePath& take)
    : field_(field)
    , curves_(curves)
    , feet_(field, patch, curves)
    , targets_(targets)
    , job_(job)
    , take_(take)
    , onRanks_(field, feet_, curves, job)
  {
  }

  /// All ranks together, until all paths are at their ends or lost.
  void run()
  {
    this->traceOwn();
    this->onRanks_.follow([this](const PathToSource& path)
      { path.points.empty() ? this->lost_.push_back(path.target) : this->take_(path); });
    std::sort(this->lost_.begin(), this->lost_.end());
  }

  /// The targets whose paths got lost, ascending.
  const std::vector<Id>& lost() const { return this->lost_; }

private:
  struct OwnPath
  {
    TracedPath traced;
    /// The points that are handed on. The end is told by the last of those traced.
    std::vector<SurfacePoint> cleaned;
  };

  void traceOwn()
  {
    const std::size_t count = this->targets_.size();
    const Job tracing = this->job_.part(FrontDone, TracingDone);
    for (std::size_t first = 0; first < count; first += PathsAtATime)
    {
      tracing.reach(static_cast<double>(first) / static_cast<double>(count));
      std::vector<OwnPath> paths(std::min(PathsAtATime, count - first));
      tracing.tasks(
        paths.size(), [&](std::size_t i) { paths[i] = this->trace(this->targets_[first + i]); });
      for (std::size_t i = 0; i < paths.size(); ++i)
      {
        this->handOn(static_cast<Id>(first + i), std::move(paths[i]));
      }
    }
  }

  OwnPath trace(const SurfacePoint& target) const
  {
    TracedPath path = beginPath(this->field_, target);
    followPath(this->field_, path);
    std::vector<SurfacePoint> cleaned;
    if (path.next == PathState::Next::End)
    {
      cleaned = cleanedPath(this->field_.mesh(), path.points, path.whole);
    }
    return { std::move(path), std::move(cleaned) };
  }

  void handOn(Id target, OwnPath own)
  {
    const TracedPath& path = own.traced;
    if (path.isOnItsWay())
    {
      this->onRanks_.add(target, path);
    }
    else if (path.next == PathState::Next::Lost)
    {
      this->lost_.push_back(target);
    }
    else if (!path.points.empty())
    {
      this->take_({ target, std::move(own.cleaned), endOf(path, this->feet_, this->curves_),
        &this->field_.surface() });
    }
  }

  const DistanceField& field_;
  const std::vector<SourceCurve>& curves_;
  FootFinder feet_;
  const std::vector<SurfacePoint>& targets_;
  const Job& job_;
  const TakePath& take_;
  /// Follows the paths that leave this rank; in one process there are none.
  PathsOnRanks onRanks_;
  std::vector<Id> lost_;
};

} // anonymous namespace

PathEnd endOf(const TracedPath& path, FootFinder& feet, const std::vector<SourceCurve>& curves)
{
  const SurfacePoint& last = path.points.back();
  const SurfacePoint& before = path.points.size() > 1 ? path.points.end()[-2] : last;
  const Foot foot = feet.footAt(last, before, path.faces.back(), path.piece, path.whole);
  return foot.isKnown() ? PathEnd{ curves[foot.curve].source, feet.arcLengthOf(foot),
    path.whole > 0.0 ? feet.angleOf(foot) : 0.0 }
                        : PathEnd();
}

void pathsToSource(const MeshPartition& part, const ReplicatedPatch& patch,
  const std::vector<SourceCurve>& curves, const std::vector<SurfacePoint>& targets, const Job& job,
  const TakePath& take)
{
  RetentionAround retention(part.mesh(), targets);
  retention.keepForPaths(part);
  FrontOptions frontOptions;
  frontOptions.keepArrivals = true;
  frontOptions.keepAngles = true;
  frontOptions.job = job.part(0.0, FrontDone);
  FrontResult front = propagate(
    part, makeSourceWindows(part, patch, curves, frontOptions.job), frontOptions, retention);
  const DistanceField field(part, std::move(front), retention.release());

  PathFinder paths(field, patch, curves, targets, job, take);
  paths.run();

  const double searchedTo = part.exchange().largestOf(retention.neededDistance());
  const std::vector<double> toSource = lowerBoundsOf(field.vertexDistances(), searchedTo);
  const std::vector<TargetOnRank> lost = gatherTargets(field, targets, paths.lost());
  for (std::size_t i = 0; i < lost.size(); ++i)
  {
    const double done = static_cast<double>(i) / static_cast<double>(lost.size());
    const double fraction = TracingDone + (1.0 - TracingDone) * done;
    job.reach(fraction);
    const std::optional<PathToSource> found =
      pathInStrip(part, patch, curves, lost[i], toSource, job.part(fraction, fraction));
    if (found && found->points.empty())
    {
      throw Error("The shortest path from target " + std::to_string(found->target) +
        " could not be followed. Please report this with the surface, the source and the targets.");
    }
    if (found)
    {
      take(*found);
    }
  }
}

}
