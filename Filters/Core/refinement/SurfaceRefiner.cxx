// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/SurfaceRefiner.h"

#include "refinement/FaceBounds.h"
#include "refinement/RefinementOutput.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace geodesic
{

namespace
{

/// Where the first pass over all faces ends in the job.
constexpr double FacesAssessed = 0.3;

/// The most triangles of one rank: ids are 3 * triangle + k.
constexpr std::uint64_t MostOfRank = NoId / 5;

} // anonymous namespace

SurfaceRefiner::SurfaceRefiner(
  const DistanceField& field, const RefinementOptions& options, double tolerance)
  : options_(options)
  , surface_(field.surface())
  , tolerance_(tolerance)
  , faces_(field, options.job)
  , splits_(faces_, tolerance, options.job)
  , numberOfTriangles_(surface_.endOfOwnFaces() - surface_.firstOwnFace())
  , bound_(surface_.exchange().largestOf(field.droppedErrorBound()))
{
}

bool SurfaceRefiner::run()
{
  this->assessFaces();
  if (!this->refineFaces(nullptr) || !this->options_.regions)
  {
    return !this->isOverfull_;
  }
  this->findBorders();
  return this->refineFaces(this->options_.regions);
}

RefinedMesh SurfaceRefiner::result(const Job& job)
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

double SurfaceRefiner::shareOfRoom() const
{
  const auto own = static_cast<double>(this->surface_.numberOfGlobalFaces());
  return (static_cast<double>(this->trianglesOfAll_) - own) /
    (static_cast<double>(this->options_.maximumFaces) - own);
}

// Works in batches. Each batch knows the bound certified by the previous ones, as smaller bounds
// need not be sharp.
void SurfaceRefiner::assessFaces()
{
  const Id end = this->surface_.endOfOwnFaces();
  const Id count = end - this->surface_.firstOwnFace();
  std::vector<double> bounds;
  for (Id left = count; left > 0; left -= std::min<Id>(left, 2 * ItemsInRange))
  {
    this->options_.job.reach(FacesAssessed * (count - left) / count);
    bounds.assign(std::min<Id>(left, 2 * ItemsInRange), 0.0);
    this->options_.job.part(0.0, 0.0).loop(bounds.size(),
      [&](std::size_t i)
      {
        const Id face = end - left + static_cast<Id>(i);
        if (!this->faces_.isFrozen(face))
        {
          bounds[i] = quickBoundOfFace(this->faces_.field, face, this->tolerance_, this->bound_);
        }
      });
    for (std::size_t i = 0; i < bounds.size(); ++i)
    {
      if (bounds[i] == Infinity)
      {
        this->due_.push_back(end - left + static_cast<Id>(i));
      }
      else
      {
        this->bound_ = std::max(this->bound_, bounds[i]);
      }
    }
  }
}

void SurfaceRefiner::findBorders()
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

bool SurfaceRefiner::refineFaces(SourceRegions* regions)
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

void SurfaceRefiner::openDue()
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
bool SurfaceRefiner::isAnythingLeft(const std::vector<EdgeSplit>& requests)
{
  struct State
  {
    std::uint64_t triangles;
    std::uint64_t isAnyLeft;
  };
  const bool isAnyLeft = !requests.empty() || !this->due_.empty();
  this->trianglesOfAll_ = 0;
  bool isAnyLeftOfAll = false;
  for (const State& state : valuesOfRanks(
         this->surface_.exchange(), State{ this->numberOfTriangles_, isAnyLeft ? 1U : 0U }))
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
void SurfaceRefiner::takeNewPoints()
{
  const TriangleMesh& mesh = this->surface_.mesh();
  const std::vector<PointOnEdge>& points = this->faces_.edges.points();
  for (; this->points_ < points.size(); ++this->points_)
  {
    const Id halfedge = this->faces_.edges[points[this->points_].edge].halfedge;
    const auto beside = this->options_.trianglesBeside.find(mesh.edgeOf(halfedge));
    this->numberOfTriangles_ += beside == this->options_.trianglesBeside.end() ? 0 : beside->second;
    forEachFace(mesh, SurfacePoint::onEdge(halfedge, 0.5),
      [&](Id face)
      {
        if (!this->faces_.isFrozen(face))
        {
          this->due_.push_back(face);
        }
        else
        {
          this->numberOfTriangles_ += this->surface_.isOwn(face) ? 1 : 0;
        }
      });
  }
}

// Refines the due faces, each by itself. Returns the points that they need on edges.
std::vector<EdgeSplit> SurfaceRefiner::work(SourceRegions* regions)
{
  const std::vector<Id> due = std::exchange(this->due_, {});
  std::vector<std::vector<EdgeSplit>> requests(due.size());
  std::vector<std::uint8_t> isDone(due.size());
  const auto refine = [&](std::size_t task, std::size_t i)
  {
    FaceTriangles& face = this->faces_.triangles(due[i]);
    isDone[i] = this->refiners_[task]->refine(face, regions, requests[i]) ? 1 : 0;
  };
  for (const Id face : due)
  {
    this->numberOfTriangles_ -= this->faces_.triangles(face).numberOfParts();
  }
  if (regions) // asks for regions, which one thread may do
  {
    this->makeRefiners(1);
    for (std::size_t i = 0; i < due.size(); ++i)
    {
      this->options_.job.look();
      refine(0, i);
    }
  }
  else
  {
    this->options_.job.loopByTasks(
      due.size(), [this](std::size_t tasks) { this->makeRefiners(tasks); }, refine);
  }
  std::vector<EdgeSplit> all;
  for (std::size_t i = 0; i < due.size(); ++i)
  {
    this->numberOfTriangles_ += this->faces_.triangles(due[i]).numberOfParts();
    all.insert(all.end(), requests[i].begin(), requests[i].end());
    if (isDone[i] == 0)
    {
      this->due_.push_back(due[i]);
    }
  }
  return all;
}

void SurfaceRefiner::makeRefiners(std::size_t count)
{
  const std::uint64_t room =
    this->options_.maximumFaces > 0 ? this->options_.maximumFaces : MostOfRank;
  while (this->refiners_.size() < count)
  {
    this->refiners_.push_back(std::make_unique<FaceRefiner>(this->faces_, this->tolerance_, room));
  }
}

// The errors fall from the initial worst to the tolerance, by about the same factor with each
// round.
void SurfaceRefiner::report(const std::vector<EdgeSplit>& requests)
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

std::vector<Id> SurfaceRefiner::unknownAtBorders()
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

}
