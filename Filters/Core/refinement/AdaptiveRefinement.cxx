// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/AdaptiveRefinement.h"

#include "Errors.h"
#include "refinement/FaceBounds.h"
#include "refinement/FaceRefiner.h"
#include "refinement/RefinementOutput.h"
#include "refinement/SplitsOfEdges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

namespace geodesic
{

namespace
{

/// The stretch of the job that ends with SurfaceRefiner::run(); the output follows.
constexpr double JobOfRun = 0.9;

/// Where the first pass over all faces ends in the job.
constexpr double FacesAssessed = 0.3;

/// The most triangles of one rank: ids are 3 * triangle + k.
constexpr std::uint64_t MostOfRank = NoId / 5;

/// Refines a surface to a tolerance, in rounds. In a round faces with new points on their edges
/// work, each by itself, and ask for more points on edges; then edges get those. All ranks
/// construct and call this together.
class SurfaceRefiner
{
public:
  /// All arguments must outlive this.
  SurfaceRefiner(const DistanceField& field, const RefinementOptions& options, double tolerance)
    : options_(options)
    , surface_(field.surface())
    , tolerance_(tolerance)
    , faces_(field, options.job)
    , splits_(faces_, tolerance, options.job)
    , bound_(surface_.exchange().largestOf(field.droppedErrorBound()))
  {
  }

  /// \returns whether there is room for the result.
  bool run()
  {
    this->assessFaces();
    if (!this->refineFaces(nullptr) || !this->options_.regions)
    {
      return !this->isOverfull_;
    }
    this->findBorders();
    return this->refineFaces(this->options_.regions);
  }

  /// The share of the room beside the surface's own faces that is taken, after run().
  double shareOfRoom() const
  {
    const auto own = static_cast<double>(this->surface_.numberOfGlobalFaces());
    return (static_cast<double>(this->trianglesOfAll_) - own) /
      (static_cast<double>(this->options_.maximumFaces) - own);
  }

  RefinedMesh result(const Job& job)
  {
    RefinedMesh result = writeOutput(this->faces_, this->options_, job);
    for (const FaceTriangles& face : this->faces_.openFaces())
    {
      for (const FaceTriangles::Part& part : face.parts())
      {
        this->bound_ = std::max(this->bound_, part.bound);
      }
    }
    result.errorBound = this->surface_.exchange().largestOf(this->bound_);
    result.unknownAtBorders = this->unknownAtBorders();
    return result;
  }

private:
  bool isAtBorder(Id face, const Triangle& corners) const
  {
    return this->faces_.lengthAtBorder(face, corners, *this->options_.regions, this->tolerance_) >
      0.0;
  }

  void assessFaces()
  {
    const Id first = this->surface_.firstOwnFace();
    std::vector<double> bounds(this->surface_.endOfOwnFaces() - first);
    this->options_.job.part(0.0, FacesAssessed)
      .loop(bounds.size(),
        [&](std::size_t i)
        {
          const Id face = first + static_cast<Id>(i);
          bounds[i] = this->faces_.isFrozen(face)
            ? 0.0
            : quickBoundOfFace(this->faces_.field, face, this->tolerance_);
        });
    for (std::size_t i = 0; i < bounds.size(); ++i)
    {
      if (bounds[i] == Infinity)
      {
        this->due_.push_back(first + static_cast<Id>(i));
      }
      else
      {
        this->bound_ = std::max(this->bound_, bounds[i]);
      }
    }
  }

  void findBorders()
  {
    for (Id face = this->surface_.firstOwnFace(); face < this->surface_.endOfOwnFaces(); ++face)
    {
      if (!this->faces_.isFrozen(face) &&
        (this->faces_.isOpen(face) || this->isAtBorder(face, this->surface_.mesh().triangle(face))))
      {
        this->due_.push_back(face);
      }
    }
  }

  bool refineFaces(SourceRegions* regions)
  {
    this->openDue();
    std::vector<EdgeSplit> requests = this->splits_.measureNew();
    while (this->isAnythingLeft(requests))
    {
      this->splits_.split(std::move(requests));
      this->takeNewPoints();
      this->openDue();
      this->splits_.measureNew(); // faces ask for what these need
      requests = this->work(regions);
      this->report(requests);
    }
    return !this->isOverfull_;
  }

  void openDue()
  {
    std::sort(this->due_.begin(), this->due_.end());
    this->due_.erase(std::unique(this->due_.begin(), this->due_.end()), this->due_.end());
    for (const Id face : this->due_)
    {
      if (!this->faces_.isOpen(face))
      {
        this->faces_.open(face);
      }
    }
  }

  // Whether some rank has faces or edges to refine, and all ranks have room.
  bool isAnythingLeft(const std::vector<EdgeSplit>& requests)
  {
    struct State
    {
      std::uint64_t triangles;
      std::uint64_t isAnyLeft;
    };
    std::uint64_t triangles =
      this->surface_.endOfOwnFaces() - this->surface_.firstOwnFace() + this->closing_;
    for (const FaceTriangles& face : this->faces_.openFaces())
    {
      triangles += face.numberOfParts() - 1;
    }
    const bool isAnyLeft = !requests.empty() || !this->due_.empty();
    this->trianglesOfAll_ = 0;
    bool isAnyLeftOfAll = false;
    for (const State& state :
      valuesOfRanks(this->surface_.exchange(), State{ triangles, isAnyLeft ? 1U : 0U }))
    {
      this->trianglesOfAll_ += state.triangles;
      isAnyLeftOfAll = isAnyLeftOfAll || state.isAnyLeft != 0;
      this->isOverfull_ = this->isOverfull_ || state.triangles > MostOfRank;
    }
    const std::uint64_t maximum = this->options_.maximumFaces;
    const bool isAnyAdded = this->trianglesOfAll_ > this->surface_.numberOfGlobalFaces();
    this->isOverfull_ = this->isOverfull_ ||
      (maximum > 0 && this->trianglesOfAll_ > maximum && (isAnyLeftOfAll || isAnyAdded));
    return isAnyLeftOfAll && !this->isOverfull_;
  }

  // The faces around new points on edges are due.
  void takeNewPoints()
  {
    const TriangleMesh& mesh = this->surface_.mesh();
    const std::vector<PointOnEdge>& points = this->faces_.edges.points();
    for (; this->points_ < points.size(); ++this->points_)
    {
      const Id halfedge = this->faces_.edges[points[this->points_].edge].halfedge;
      const auto beside = this->options_.trianglesBeside.find(mesh.edgeOf(halfedge));
      this->closing_ += beside == this->options_.trianglesBeside.end() ? 0 : beside->second;
      forEachFace(mesh, SurfacePoint::onEdge(halfedge, 0.5),
        [&](Id face)
        {
          if (!this->faces_.isFrozen(face))
          {
            this->due_.push_back(face);
          }
          else
          {
            this->closing_ += this->surface_.isOwn(face) ? 1 : 0;
          }
        });
    }
  }

  // Refines the due faces, each by itself. Returns the points that they need on edges.
  std::vector<EdgeSplit> work(SourceRegions* regions)
  {
    const std::vector<Id> due = std::exchange(this->due_, {});
    std::vector<std::vector<EdgeSplit>> requests(due.size());
    std::vector<std::uint8_t> isDone(due.size());
    const auto refine = [&](std::size_t task, std::size_t i)
    {
      std::unique_ptr<FaceRefiner>& refiner = this->refiners_[task];
      if (!refiner)
      {
        refiner = std::make_unique<FaceRefiner>(this->faces_, this->tolerance_);
      }
      FaceTriangles& face = this->faces_.triangles(due[i]);
      isDone[i] = refiner->refine(face, regions, requests[i]) ? 1 : 0;
    };
    if (regions) // asks for regions, which one thread may do
    {
      for (std::size_t i = 0; i < due.size(); ++i)
      {
        this->options_.job.look();
        refine(0, i);
      }
    }
    else
    {
      this->options_.job.loopByTasks(due.size(), refine);
    }
    std::vector<EdgeSplit> all;
    for (std::size_t i = 0; i < due.size(); ++i)
    {
      all.insert(all.end(), requests[i].begin(), requests[i].end());
      if (isDone[i] == 0)
      {
        this->due_.push_back(due[i]);
      }
    }
    return all;
  }

  // The errors fall from the initial worst to the tolerance, by about the same factor with each
  // round.
  void report(const std::vector<EdgeSplit>& requests)
  {
    double worst = this->tolerance_;
    for (const EdgeSplit& request : requests)
    {
      worst = std::max(worst, request.reason == SplitReason::Error ? request.urgency : 0.0);
    }
    this->worstAtFirst_ = std::max(this->worstAtFirst_, worst);
    const double open = std::log(worst / this->tolerance_);
    const double openAtFirst = std::log(this->worstAtFirst_ / this->tolerance_);
    const double done = openAtFirst > 0.0 ? 1.0 - std::clamp(open / openAtFirst, 0.0, 1.0) : 0.0;
    this->options_.job.part(FacesAssessed, JobOfRun).reach(done);
  }

  std::vector<Id> unknownAtBorders()
  {
    std::vector<Id> unknown;
    std::vector<Triangle> triangles;
    for (Id face = this->surface_.firstOwnFace();
         this->options_.regions && face < this->surface_.endOfOwnFaces(); ++face)
    {
      if (!this->faces_.field.isDropped(face))
      {
        continue;
      }
      triangles.clear();
      appendTriangles(this->faces_, face, triangles);
      if (std::any_of(triangles.begin(), triangles.end(),
            [&](const Triangle& corners) { return this->isAtBorder(face, corners); }))
      {
        unknown.push_back(face);
      }
    }
    return unknown;
  }

  const RefinementOptions& options_;
  const MeshPartition& surface_;
  double tolerance_;
  RefinedFaces faces_;
  SplitsOfEdges splits_;
  /// One for each task that has run.
  std::array<std::unique_ptr<FaceRefiner>, Job::MostTasks> refiners_;
  /// Faces with work to do.
  std::vector<Id> due_;
  /// How many points on edges have been counted.
  std::size_t points_ = 0;
  /// The triangles that these have added to faces and triangles that are not refined.
  std::uint64_t closing_ = 0;
  std::uint64_t trianglesOfAll_ = 0;
  bool isOverfull_ = false;
  double bound_;
  double worstAtFirst_ = 0.0;
};

/// Refines to the smallest tolerance for which there is room, found by trial: in the range between
/// one without room and one with room, the next is where triangles in inverse proportion to the
/// tolerance would just fill the room, or the middle of the range's logarithms. A run without room
/// stops early.
std::unique_ptr<SurfaceRefiner> refineWithinRoom(
  const DistanceField& field, const RefinementOptions& options)
{
  constexpr double EnoughOfRoom = 0.97;
  constexpr int MostRuns = 16;
  std::unique_ptr<SurfaceRefiner> best;
  double fits = Infinity;
  double tooSmall = options.tolerance;
  const std::uint64_t maximum = options.maximumFaces;
  const bool isRoom = maximum == 0 || maximum >= field.surface().numberOfGlobalFaces();
  double growth = 4.0; // 4, 16, 256 ... times the tolerance until there is room
  for (int run = 0; isRoom && run < MostRuns; ++run)
  {
    double next = growth * options.tolerance;
    if (best)
    {
      const double full = fits * best->shareOfRoom();
      next = full > tooSmall ? full : std::sqrt(fits * tooSmall);
    }
    auto refiner = std::make_unique<SurfaceRefiner>(field, options, next);
    if (!refiner->run())
    {
      tooSmall = next;
      growth *= growth;
      continue;
    }
    best = std::move(refiner);
    fits = next;
    if (best->shareOfRoom() >= EnoughOfRoom)
    {
      break;
    }
  }
  if (!best) // the surface as it is
  {
    best = std::make_unique<SurfaceRefiner>(field, options, Infinity);
    best->run();
  }
  return best;
}

void requireUsable(const DistanceField& field, const RefinementOptions& options)
{
  if (!(options.tolerance > 0.0) || !(options.tolerance < Infinity))
  {
    throw Error("The refinement tolerance is " + std::to_string(options.tolerance) +
      "; give a positive number.");
  }
  if (!field.hasWindows())
  {
    throw Error("A field is to be refined, but the solve kept no windows; solve for refinement.");
  }
  if (options.tolerance < field.droppedTolerance())
  {
    throw Error("The refinement tolerance is " + std::to_string(options.tolerance) +
      ", but windows were kept for " + std::to_string(field.droppedTolerance()) + " only.");
  }
  if (!options.cornerPoints.empty() && options.cornerPoints.size() != field.mesh().numberOfFaces())
  {
    throw Error("Refinement was given points for the corners of " +
      std::to_string(options.cornerPoints.size()) + " faces, but the mesh has " +
      std::to_string(field.mesh().numberOfFaces()) + ".");
  }
}

} // anonymous namespace

RefinedMesh refine(const DistanceField& field, const RefinementOptions& options)
{
  requireUsable(field, options);
  const Job output = options.job.part(JobOfRun, 1.0);
  auto refiner = std::make_unique<SurfaceRefiner>(field, options, options.tolerance);
  if (refiner->run())
  {
    return refiner->result(output);
  }
  refiner.reset();
  RefinedMesh result = refineWithinRoom(field, options)->result(output);
  result.stoppedAtMaximum = true;
  return result;
}

}
