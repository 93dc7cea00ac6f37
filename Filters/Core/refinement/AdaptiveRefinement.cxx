// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/AdaptiveRefinement.h"

#include "Errors.h"
#include "Tolerance.h"
#include "refinement/DeviationRules.h"
#include "refinement/FaceBounds.h"
#include "refinement/LeafClosings.h"
#include "refinement/RedGreenClosure.h"
#include "refinement/RefinementOutput.h"
#include "refinement/ViolationQueue.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace geodesic
{

namespace
{

/// Where the steps of the job end: the first pass over all faces, and the splits. The output
/// follows.
constexpr double FacesAssessed = 0.3;
constexpr double FacesSplit = 0.9;

bool isFrozen(const DistanceField& field, Id face)
{
  const Triangle& corners = field.mesh().triangle(face);
  return !field.knowsInside(face) ||
    std::any_of(corners.begin(), corners.end(),
      [&](Id corner) { return !(field.vertexDistances()[corner] < Infinity); });
}

/// The faces of other ranks are all frozen.
std::vector<std::uint8_t> findFrozen(const DistanceField& field, const Job& job)
{
  std::vector<std::uint8_t> frozen(field.mesh().numberOfFaces());
  job.part(0.0, 0.0).loop(frozen.size(),
    [&](std::size_t i)
    {
      const Id face = static_cast<Id>(i);
      frozen[face] = !field.surface().isOwn(face) || isFrozen(field, face) ? 1 : 0;
    });
  return frozen;
}

/// The regions in which the points of a mesh under refinement lie; each is found once. No splits
/// that may be taken back are pending then, so that points keep their numbers.
class RegionsOfPoints
{
public:
  RegionsOfPoints(const RedGreenMesh& triangles, const DistancesInFaces& distances,
    const RefinementOptions& options)
    : triangles_(triangles)
    , distances_(distances)
    , options_(options)
  {
  }

  /// The longest edge of a triangle in a face that must be split, as there is a border between its
  /// corners; else 0.
  double lengthAtBorder(Id face, const Triangle& c)
  {
    if (!this->options_.regionOf ||
      !(this->isBorderBetween(face, c[0], c[1]) || this->isBorderBetween(face, c[1], c[2]) ||
        this->isBorderBetween(face, c[2], c[0])))
    {
      return 0.0;
    }
    const double longest = longestEdge({ this->triangles_.inPlane(c[0], face),
      this->triangles_.inPlane(c[1], face), this->triangles_.inPlane(c[2], face) });
    return longest > this->options_.tolerance ? longest : 0.0;
  }

private:
  bool isBorderBetween(Id face, Id a, Id b)
  {
    const SourceRegion ofA = this->of(a);
    const SourceRegion ofB = this->of(b);
    if (ofA.source != ofB.source)
    {
      return true;
    }
    if (ofA.isRight == ofB.isRight)
    {
      return false;
    }
    // Where a straight line crosses the curve between its sides, there is no border. Both ends are
    // then nearer to the crossing than to each other.
    const double length =
      norm(this->triangles_.inPlane(b, face) - this->triangles_.inPlane(a, face));
    return this->distances_.atPoint(a) + this->distances_.atPoint(b) >
      (1.0 + tolerance::Tie) * length;
  }

  SourceRegion of(Id point)
  {
    if (point >= this->regions_.size())
    {
      this->regions_.resize(this->numberOfPoints());
    }
    std::optional<SourceRegion>& region = this->regions_[point];
    if (!region)
    {
      region = this->options_.regionOf(this->triangles_.place(point));
    }
    return *region;
  }

  std::size_t numberOfPoints() const
  {
    return this->triangles_.numberOfInputPoints() + this->triangles_.points().size();
  }

  const RedGreenMesh& triangles_;
  const DistancesInFaces& distances_;
  const RefinementOptions& options_;
  std::vector<std::optional<SourceRegion>> regions_;
};

/// Refines the worst leaf until none is over the tolerance.
///
/// The ranks that share the surface refine a batch of leaves, each its own; exchange splits of
/// seams until no rank needs another; and then assess all changed leaves: whether there is room for
/// the batch, and which leaves are over the tolerance now. In one process a batch is one leaf.
class Refiner
{
public:
  Refiner(const DistanceField& field, const RefinementOptions& options)
    : field_(field)
    , options_(options)
    , triangles_(field.surface(), findFrozen(field, options.job), options.trianglesBeside)
    , workers_(field, this->triangles_, options.tolerance, options.job)
    , rules_(this->triangles_, this->workers_, options.tolerance)
    , closure_(field.surface(), this->triangles_, this->rules_)
    , closings_(this->triangles_, this->workers_, this->rules_, options.tolerance)
    , violations_(this->triangles_, field.surface())
    , regions_(this->triangles_, this->workers_.first().distances, options)
    , bound_(field.surface().exchange().largestOf(field.droppedErrorBound()))
  {
  }

  RefinedMesh run()
  {
    this->assessFaces();
    this->refineWorst();
    // those left where refinement has stopped at its maximum
    this->violations_.takeAll([this](const Violation& rest)
      { this->raiseBound(this->closings_.tightBound(rest.triangle)); });
    const std::vector<Id> unknown = this->unknownAtBorders();
    const bool areVertices =
      this->options_.cornerPoints.empty() && this->field_.mesh().numberOfFaces() > 0;
    RefinedMesh result = writeOutput(this->triangles_, this->options_,
      areVertices ? this->field_.surface().numberOfOwnVertices() : this->options_.numberOfPoints,
      this->options_.job.part(FacesSplit, 1.0));
    result.errorBound = this->field_.surface().exchange().largestOf(this->bound_);
    result.stoppedAtMaximum = this->stopped_;
    result.unknownAtBorders = unknown;
    return result;
  }

private:
  /// Works in batches. Each batch knows the bound certified by the previous ones, however many
  /// threads there are.
  void assessFaces()
  {
    constexpr Id facesInBatch = 2 * ItemsInRange;
    const Id first = this->triangles_.firstFace();
    const Id end = this->triangles_.endOfFaces();
    for (Id face = first; face < end; face += std::min(facesInBatch, end - face))
    {
      this->options_.job.reach(FacesAssessed * (face - first) / (end - first));
      this->assessFaces(face, face + std::min(facesInBatch, end - face));
    }
  }

  void assessFaces(Id first, Id end)
  {
    const double known = this->bound_;
    std::vector<QuickError> errors(end - first);
    this->workers_.run(errors.size(),
      [&](RefinementWorker&, std::size_t i)
      {
        const Id face = first + static_cast<Id>(i);
        if (!this->triangles_.isFrozen(face))
        {
          errors[i] = quickErrorOfFace(this->field_, face, this->options_.tolerance, known);
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
    const std::vector<LeafClosings::Check> checks = this->closings_.findBest(others);
    std::size_t next = 0;
    for (Id face = first; face < end; ++face)
    {
      const QuickError& error = errors[face - first];
      if (next < others.size() && others[next] == face)
      {
        this->take(face, checks[next++]);
      }
      else if (!this->triangles_.isFrozen(face))
      {
        // smaller bounds than that of all faces need not be sharp
        const double bound = error.bySize <= this->bound_ ? error.bySize : error.byWindows;
        this->raiseBound(bound + error.rounding);
      }
    }
  }

  /// Closes a leaf, and queues it if it is over the tolerance or at a border.
  void take(Id leaf, const LeafClosings::Check& check)
  {
    this->triangles_.setWay(leaf, check.way);
    if (!check.passed)
    {
      this->violations_.push(std::max(check.sample, check.limit), leaf, check.limit);
      return;
    }
    this->raiseBound(check.bound);
    if (!this->options_.regionOf)
    {
      return;
    }
    double longest = 0.0;
    this->triangles_.closeTriangle(leaf,
      [&](Id face, const Triangle& corners)
      { longest = std::max(longest, this->regions_.lengthAtBorder(face, corners)); });
    if (longest > 0.0)
    {
      // below the error of any leaf over the tolerance, and larger for larger triangles
      const double tolerance = this->options_.tolerance;
      this->violations_.push(0.5 * tolerance * longest / (longest + tolerance), leaf, Infinity);
    }
  }

  std::vector<Id> unknownAtBorders()
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

  void refineWorst()
  {
    while (this->violations_.takeBatch())
    {
      this->worstAtFirst_ = std::max(this->worstAtFirst_, this->violations_.worst());
      this->triangles_.begin();
      if (!this->refineBatch())
      {
        this->triangles_.rollBack();
        this->workers_.forgetNewEdges();
        this->closure_.forget();
        if (!this->violations_.putBack())
        {
          this->stopped_ = true;
          return;
        }
        continue;
      }
      const std::vector<Id> changed = this->closure_.takeChanged();
      const std::vector<LeafClosings::Check> checks = this->closings_.findBest(changed);
      for (std::size_t i = 0; i < changed.size(); ++i)
      {
        this->take(changed[i], checks[i]);
      }
    }
  }

  /// Returns whether there is room for the result.
  bool refineBatch()
  {
    constexpr std::uint64_t numberable = NoId / 5; // ids are 3 * part + k, and parts have parts
    const std::uint64_t maximum = this->options_.maximumFaces;
    const std::uint64_t most = maximum > 0 ? std::min(maximum, numberable) : numberable;
    for (const Violation& violation : this->violations_.batch())
    {
      if (this->violations_.isOpen(violation) && this->triangles_.numberOfTriangles() <= most)
      {
        this->refine(violation);
        this->closure_.close();
        this->report();
      }
    }
    return this->closure_.exchangeSplits(most, [this]() { this->report(); }) &&
      (maximum == 0 ||
        sumOverRanks(this->field_.surface().exchange(), this->triangles_.numberOfTriangles()).all <=
          maximum);
  }

  /// Splits the worst of the edges, or parts of edges, that are over the limit. If there is none,
  /// the error is inside, where new edges are needed.
  void refine(const Violation& violation)
  {
    const Id leaf = violation.triangle;
    this->overLimit_.clear();
    double worst = 0.0;
    this->triangles_.forEachPartOfEdges(leaf,
      [&](Id edge)
      {
        const double deviation = this->workers_.deviation(edge).largest();
        if (deviation > violation.limit)
        {
          this->overLimit_.push_back(edge);
          worst = std::max(worst, deviation);
        }
      });
    const bool isThin = this->triangles_.isThin(leaf);
    if (isThin)
    {
      // smaller errors wait until those of other leaves are as small
      this->overLimit_.erase(
        std::remove_if(this->overLimit_.begin(), this->overLimit_.end(),
          [&](Id edge) { return this->workers_.deviation(edge).largest() < 0.5 * worst; }),
        this->overLimit_.end());
    }
    // where a strip is as wide as its triangles are long, more points would make these thin again
    if (this->overLimit_.empty() ||
      (isThin && this->triangles_.pointsOnEdges(leaf) > 0 &&
        this->triangles_.isAnyAsShortAsWide(leaf, this->overLimit_)))
    {
      this->closure_.splitInside(leaf);
      return;
    }
    for (const Id edge : this->overLimit_)
    {
      this->split(edge);
    }
  }

  /// Splits an edge, and its halves as long as they certainly must be.
  void split(Id edge)
  {
    if (this->closure_.split(edge))
    {
      const Id halves = this->triangles_.edgeData(edge).halves;
      for (const Id half : { halves, halves + 1 })
      {
        if (this->rules_.mustSplit(half))
        {
          this->split(half);
        }
      }
    }
  }

  void raiseBound(double bound) { this->bound_ = std::max(this->bound_, bound); }

  /// The errors fall from the initial worst to the tolerance, by about the same factor with each
  /// level.
  void report()
  {
    const double open = std::log(this->violations_.worst() / this->options_.tolerance);
    const double openAtFirst = std::log(this->worstAtFirst_ / this->options_.tolerance);
    const double done = openAtFirst > 0.0 ? 1.0 - std::clamp(open / openAtFirst, 0.0, 1.0) : 0.0;
    constexpr unsigned stepsPerReport = 256;
    if (this->steps_++ % stepsPerReport == 0)
    {
      this->options_.job.part(FacesAssessed, FacesSplit).reach(done);
    }
  }

  const DistanceField& field_;
  const RefinementOptions& options_;
  RedGreenMesh triangles_;
  RefinementWorkers workers_;
  DeviationRules rules_;
  RedGreenClosure closure_;
  LeafClosings closings_;
  ViolationQueue violations_;
  RegionsOfPoints regions_;
  /// Parts of the edges of the leaf that is refined.
  std::vector<Id> overLimit_;
  double bound_;
  bool stopped_ = false;
  double worstAtFirst_ = 0.0;
  unsigned steps_ = 0;
};

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
