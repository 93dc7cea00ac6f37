// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/AdaptiveRefinement.h"

#include "Errors.h"
#include "refinement/DeviationRules.h"
#include "refinement/FaceBounds.h"
#include "refinement/LeafClosings.h"
#include "refinement/RedGreenClosure.h"
#include "refinement/RefinementOutput.h"
#include "refinement/SeamSplits.h"
#include "refinement/ViolationQueue.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace geodesic
{

namespace
{

/// Shares of the progress: of the first pass over all faces, and of the output.
constexpr double ShareOfFirstPass = 0.3;
constexpr double ShareOfOutput = 0.1;

bool isFrozen(const DistanceField& field, Id face)
{
  for (const Id vertex : field.mesh().triangle(face))
  {
    if (!(field.vertexDistances()[vertex] < Infinity))
    {
      return true;
    }
  }
  return !field.knowsInside(face);
}

/// The faces of other ranks are all frozen.
std::vector<std::uint8_t> findFrozen(const DistanceField& field, const ParallelFor& parallelFor)
{
  std::vector<std::uint8_t> frozen(field.mesh().numberOfFaces());
  forRanges(parallelFor, frozen.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (Id face = static_cast<Id>(begin); face < end; ++face)
      {
        frozen[face] = !field.surface().isOwn(face) || isFrozen(field, face) ? 1 : 0;
      }
    });
  return frozen;
}

/// Refines the worst leaf until none is over the tolerance.
///
/// The ranks that share the surface refine a batch of leaves, each its own; exchange splits of
/// seams until no rank needs another; and then assess all changed leaves: whether there is room for
/// the batch, and which leaves are over the tolerance now. In one process a batch is one leaf.
class Refiner
{
public:
  Refiner(const DistanceField& field, const RefinementOptions& options);
  RefinedMesh run();

private:
  void assessFaces();
  void assessFaces(Id first, Id end);
  void take(Id leaf, const LeafClosings::Closed& closed);
  void pushIfAtBorder(Id leaf);
  std::vector<Id> unknownAtBorders();
  void refineWorst();
  bool refineBatch();
  bool settleSeams();
  void refine(const Violation& violation);
  void close(int round = 0);
  bool hasTooMany() const;
  bool isRoomForAll() const;
  void certifyRest();
  void raiseBound(double bound) { this->bound_ = std::max(this->bound_, bound); }
  Id numberOfCallersPoints() const;
  void report();
  std::uint64_t maximumTriangles() const;

  const DistanceField& field_;
  const RefinementOptions& options_;
  double tolerance_;
  RedGreenMesh triangles_;
  SeamSplits seams_;
  RefinementProgress progress_;
  RefinementWorkers workers_;
  DeviationRules rules_;
  RedGreenClosure closure_;
  LeafClosings closings_;
  ViolationQueue violations_;
  RegionsOfPoints regions_;
  /// The leaves that the current batch has changed.
  std::vector<Id> changed_;
  double bound_;
  bool stopped_ = false;
  double worstAtFirst_ = 0.0;
};

Refiner::Refiner(const DistanceField& field, const RefinementOptions& options)
  : field_(field)
  , options_(options)
  , tolerance_(options.tolerance)
  , triangles_(field.surface(), findFrozen(field, options.parallelFor), options.trianglesBeside)
  , seams_(field.surface(), this->triangles_)
  , progress_(options.progress)
  , workers_(field, this->triangles_, options.parallelFor, this->progress_)
  , rules_(this->triangles_, this->workers_, options.tolerance)
  , closure_(this->triangles_, this->rules_, this->seams_)
  , closings_(this->triangles_, this->workers_, this->rules_, options.tolerance)
  , violations_(this->triangles_, field.surface())
  , regions_(
      this->triangles_, this->workers_.first().distances, options.regionOf, options.tolerance)
  , bound_(field.surface().exchange().largestOf(field.droppedErrorBound()))
{
}

RefinedMesh Refiner::run()
{
  this->assessFaces();
  this->refineWorst();
  this->certifyRest();
  const std::vector<Id> unknown = this->unknownAtBorders();
  RefinedMesh result = writeOutput(this->triangles_, this->options_, this->numberOfCallersPoints(),
    [this](double written)
    {
      this->progress_.tell(1.0 - ShareOfOutput * (1.0 - written));
      return true;
    });
  result.errorBound = this->field_.surface().exchange().largestOf(this->bound_);
  result.stoppedAtMaximum = this->stopped_;
  result.unknownAtBorders = unknown;
  return result;
}

// Works in batches. Each batch knows the bound certified by the previous ones, however many threads
// there are.
void Refiner::assessFaces()
{
  constexpr Id facesInBatch = 2 * ItemsInRange;
  const Id first = this->triangles_.firstFace();
  const Id end = this->triangles_.endOfFaces();
  for (Id face = first; face < end; face += std::min(facesInBatch, end - face))
  {
    this->progress_.tell(ShareOfFirstPass * (face - first) / (end - first));
    this->assessFaces(face, face + std::min(facesInBatch, end - face));
  }
}

void Refiner::assessFaces(Id first, Id end)
{
  const double known = this->bound_;
  std::vector<QuickError> errors(end - first);
  this->workers_.run(errors.size(),
    [&](RefinementWorker&, std::size_t i)
    {
      const Id face = first + static_cast<Id>(i);
      if (!this->triangles_.isFrozen(face))
      {
        errors[i] = quickErrorOfFace(this->field_, face, this->tolerance_, known);
      }
    });
  std::vector<Id> others;
  for (Id face = first; face < end; ++face)
  {
    if (!this->triangles_.isFrozen(face) &&
      (errors[face - first].byWindows == Infinity ||
        this->regions_.lengthAtBorder(face, this->field_.mesh().triangle(face)) > 0.0))
    {
      others.push_back(face);
    }
  }
  const std::vector<LeafClosings::Closed>& closed = this->closings_.findBest(others);
  std::size_t next = 0;
  for (Id face = first; face < end; ++face)
  {
    const QuickError& error = errors[face - first];
    if (next < others.size() && others[next] == face)
    {
      this->take(face, closed[next++]);
    }
    else if (!this->triangles_.isFrozen(face))
    {
      // smaller bounds than that of all faces need not be sharp
      const double bound = error.bySize <= this->bound_ ? error.bySize : error.byWindows;
      this->raiseBound(bound + error.rounding);
    }
  }
}

// Closes a leaf, and queues it if it is over the tolerance.
void Refiner::take(Id leaf, const LeafClosings::Closed& closed)
{
  this->triangles_.setWay(leaf, closed.way);
  const LeafClosings::Check& check = closed.check;
  if (check.passed)
  {
    this->raiseBound(check.bound);
    this->pushIfAtBorder(leaf);
    return;
  }
  const double error = std::max(check.sample, check.limit);
  this->violations_.push({ error, leaf, this->triangles_.splitEdges(leaf), check.limit });
}

// With an error below that of any leaf over the tolerance, larger for larger triangles.
void Refiner::pushIfAtBorder(Id leaf)
{
  double longest = 0.0;
  this->triangles_.closeLeaf(leaf,
    [&](Id face, const Triangle& corners)
    { longest = std::max(longest, this->regions_.lengthAtBorder(face, corners)); });
  if (longest > 0.0)
  {
    const double error = 0.5 * this->tolerance_ * longest / (longest + this->tolerance_);
    this->violations_.push({ error, leaf, this->triangles_.splitEdges(leaf), Infinity });
  }
}

std::vector<Id> Refiner::unknownAtBorders()
{
  std::vector<Id> faces;
  if (this->options_.regionOf)
  {
    this->triangles_.forEachTriangle(
      [&](Id face, const Triangle& corners)
      {
        const bool isNew = faces.empty() || faces.back() != face;
        if (isNew && this->field_.isDropped(face) &&
          this->regions_.lengthAtBorder(face, corners) > 0.0)
        {
          faces.push_back(face);
        }
      });
  }
  return faces;
}

void Refiner::refineWorst()
{
  while (this->violations_.takeBatch())
  {
    this->worstAtFirst_ = std::max(this->worstAtFirst_, this->violations_.worst());
    this->triangles_.begin();
    if (!this->refineBatch())
    {
      this->triangles_.rollBack();
      this->workers_.forgetNewEdges();
      this->regions_.forgetNewPoints();
      this->closure_.forget();
      if (!this->violations_.putBack())
      {
        this->stopped_ = true;
        return;
      }
      continue;
    }
    const std::vector<LeafClosings::Closed>& closed = this->closings_.findBest(this->changed_);
    for (std::size_t i = 0; i < closed.size(); ++i)
    {
      this->take(this->changed_[i], closed[i]);
    }
  }
}

// Returns whether there is room for the result.
bool Refiner::refineBatch()
{
  this->changed_.clear();
  for (const Violation& violation : this->violations_.batch())
  {
    if (this->violations_.isOpen(violation) && !this->hasTooMany())
    {
      this->refine(violation);
      this->close();
      this->report();
    }
  }
  const bool isRoom = this->settleSeams() && this->isRoomForAll();
  this->triangles_.keepLeaves(this->changed_);
  return isRoom;
}

// Repeats until no rank asks for a split or has made one. Returns whether no rank has too many
// triangles.
bool Refiner::settleSeams()
{
  SeamSplits::State state = SeamSplits::State::Going;
  while (state == SeamSplits::State::Going)
  {
    int last = 0;
    state = this->seams_.exchange(this->hasTooMany(),
      [&](Id edge, int round, const RedGreenMesh::Placement* decided)
      {
        if (round != last)
        {
          this->close(last);
          last = round;
        }
        if (decided)
        {
          this->triangles_.split(edge, *decided);
          this->report();
        }
        else if (!this->triangles_.isSplit(edge))
        {
          this->closure_.split(edge, round);
        }
      });
    this->close(last);
  }
  return state == SeamSplits::State::Settled;
}

void Refiner::close(int round)
{
  const std::vector<Id> changed = this->closure_.close(round);
  this->changed_.insert(this->changed_.end(), changed.begin(), changed.end());
}

bool Refiner::hasTooMany() const
{
  return this->triangles_.numberOfTriangles() > this->maximumTriangles();
}

// Over all ranks together.
bool Refiner::isRoomForAll() const
{
  if (this->options_.maximumFaces == 0)
  {
    return true;
  }
  return sumOverRanks(this->field_.surface().exchange(), this->triangles_.numberOfTriangles())
           .all <= this->options_.maximumFaces;
}

Id Refiner::numberOfCallersPoints() const
{
  if (!this->options_.cornerPoints.empty() || this->field_.mesh().numberOfFaces() == 0)
  {
    return this->options_.numberOfPoints;
  }
  return this->field_.surface().numberOfOwnVertices();
}

std::uint64_t Refiner::maximumTriangles() const
{
  constexpr std::uint64_t numberable = NoId / 5; // ids are 3 * part + k, and parts have parts
  return this->options_.maximumFaces > 0 ? std::min(this->options_.maximumFaces, numberable)
                                         : numberable;
}

// Splits the edges that are over the limit. If there is none, the error is inside, and splitting
// into four makes new edges there.
void Refiner::refine(const Violation& violation)
{
  const Id triangle = violation.triangle;
  bool isOver = false;
  for (Id k = 0; k < 3; ++k)
  {
    const Id edge = this->triangles_.ensureEdge(triangle, k);
    if (!this->triangles_.isSplit(edge) &&
      this->workers_.deviation(edge).largest() > violation.limit)
    {
      this->closure_.split(edge);
      isOver = true;
    }
  }
  if (!isOver)
  {
    this->closure_.splitIntoFour(triangle);
  }
}

// For the case that refinement has stopped at its maximum.
void Refiner::certifyRest()
{
  this->violations_.takeAll(
    [this](const Violation& rest) { this->raiseBound(this->closings_.tightBound(rest.triangle)); });
}

// The errors fall from the initial worst to the tolerance, by about the same factor with each
// level.
void Refiner::report()
{
  const double open = std::log(this->violations_.worst() / this->tolerance_);
  const double openAtFirst = std::log(this->worstAtFirst_ / this->tolerance_);
  const double done = openAtFirst > 0.0 ? 1.0 - std::clamp(open / openAtFirst, 0.0, 1.0) : 0.0;
  this->progress_.at(ShareOfFirstPass + (1.0 - ShareOfFirstPass - ShareOfOutput) * done);
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
  return Refiner(field, options).run();
}

}
