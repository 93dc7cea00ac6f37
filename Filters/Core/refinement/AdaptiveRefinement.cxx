// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/AdaptiveRefinement.h"

#include "Errors.h"
#include "Tolerance.h"
#include "refinement/ClosingCheck.h"
#include "refinement/DeviationRules.h"
#include "refinement/FaceBounds.h"
#include "refinement/RedGreenClosure.h"
#include "refinement/RefinementOutput.h"
#include "refinement/RefinementProgress.h"
#include "refinement/SeamSplits.h"
#include "refinement/ViolationQueue.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace geodesic
{

namespace
{

/// Of the progress, for the first look at all faces, and for the output.
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
std::vector<std::uint8_t> findFrozen(const DistanceField& field, const SurfacePart* part)
{
  std::vector<std::uint8_t> frozen(field.mesh().numberOfFaces());
  for (Id face = 0; face < field.mesh().numberOfFaces(); ++face)
  {
    const bool isElsewhere = part != nullptr && !part->isOwn(face);
    frozen[face] = isElsewhere || isFrozen(field, face) ? 1 : 0;
  }
  return frozen;
}

/// Refines the worst leaf until none is over the tolerance.
///
/// Where ranks have the surface together they refine a batch of leaves, each its own, exchange
/// splits of seams until none needs another, and then look at all that has changed: whether there
/// is room for the batch, and what is over the tolerance now.
class Refiner
{
public:
  Refiner(const DistanceField& field, const RefinementOptions& options);
  RefinedMesh run();

private:
  void assessFaces();
  void assess(Id triangle);
  ClosingCheck::Result closeBest(Id triangle);
  void refineWorst();
  bool refineBatch();
  bool settleSeams();
  void refine(const Violation& violation);
  void close(int round = 0);
  void collectChanged();
  bool hasTooMany() const;
  bool isRoomForAll() const;
  void certifyRest();
  void raiseBound(double bound) { this->bound_ = std::max(this->bound_, bound); }
  double largestOf(double number) const;
  Id numberOfCallersPoints() const;
  void report();
  std::uint64_t maximumTriangles() const;

  const DistanceField& field_;
  const RefinementOptions& options_;
  double tolerance_;
  Exchange* exchange_;
  RedGreenMesh triangles_;
  /// Where ranks have the surface together.
  std::optional<SeamSplits> seams_;
  FaceDistanceCache faces_;
  EdgeDistances distances_;
  PartShapes shapes_;
  DeviationRules rules_;
  RedGreenClosure closure_;
  ClosingCheck check_;
  RefinementProgress progress_;
  ViolationQueue violations_;
  /// The leaves that the batch at hand has changed.
  std::vector<Id> changed_;
  double bound_;
  bool stopped_ = false;
  double worstAtFirst_ = 0.0;
};

Refiner::Refiner(const DistanceField& field, const RefinementOptions& options)
  : field_(field)
  , options_(options)
  , tolerance_(options.tolerance)
  , exchange_(options.part ? &options.part->exchange() : nullptr)
  , triangles_(field.mesh(), findFrozen(field, options.part), options.trianglesBeside, options.part)
  , seams_(
      options.part ? std::make_optional<SeamSplits>(*options.part, this->triangles_) : std::nullopt)
  , faces_(field)
  , distances_(field, this->triangles_, this->faces_)
  , shapes_(this->triangles_, options.tolerance)
  , rules_(this->triangles_, this->distances_, this->shapes_, options.tolerance)
  , closure_(this->triangles_, this->rules_, this->seams_ ? &*this->seams_ : nullptr)
  , check_(field, this->triangles_, this->distances_, this->faces_, options.tolerance)
  , progress_(options.progress)
  , violations_(this->triangles_, this->exchange_)
  , bound_(this->largestOf(field.droppedErrorBound()))
{
}

RefinedMesh Refiner::run()
{
  this->assessFaces();
  this->refineWorst();
  this->certifyRest();
  RefinedMesh result;
  result.errorBound = this->largestOf(this->bound_);
  result.stoppedAtMaximum = this->stopped_;
  writeOutput(
    this->triangles_, { this->options_.cornerPoints, this->numberOfCallersPoints() },
    [this](double written) { this->progress_.at(1.0 - ShareOfOutput * (1.0 - written)); }, result);
  return result;
}

void Refiner::assessFaces()
{
  const TriangleMesh& mesh = this->field_.mesh();
  const Id first = this->triangles_.firstFace();
  const Id end = this->triangles_.endOfFaces();
  for (Id face = first; face < end; ++face)
  {
    this->progress_.at(ShareOfFirstPass * (face - first) / (end - first));
    if (this->triangles_.isFrozen(face))
    {
      continue;
    }
    double largest = 0.0;
    for (const Id vertex : mesh.triangle(face))
    {
      largest = std::max(largest, this->field_.vertexDistances()[vertex]);
    }
    const double rounding = tolerance::FaceRounding * largest;
    const double quick =
      quickErrorOfFace(this->field_, face, this->tolerance_ - rounding, this->bound_);
    if (quick < Infinity)
    {
      this->raiseBound(quick + rounding);
    }
    else
    {
      this->assess(face);
    }
  }
}

void Refiner::assess(Id triangle)
{
  const ClosingCheck::Result check = this->closeBest(triangle);
  if (check.passed)
  {
    this->raiseBound(check.bound);
    return;
  }
  const double error = std::max(check.sample, check.limit);
  this->violations_.push({ error, triangle, this->triangles_.splitEdges(triangle), check.limit });
}

// Flips the inner edges of a leaf: of the ways that pass, the one of the best shapes, and where
// none does that of the smallest error. Ways of bad shapes are taken where there is no other.
ClosingCheck::Result Refiner::closeBest(Id triangle)
{
  const Id face = this->triangles_.faceOf(triangle);
  const double allowed = this->shapes_.allowedAngle(face, this->rules_.largestAround(triangle));
  const Id ways = RedGreenMesh::waysToClose(this->triangles_.splitEdges(triangle));
  std::array<std::pair<double, Id>, 4> order;
  for (Id way = 0; way < ways; ++way)
  {
    const double angle = this->shapes_.smallestAngle(face, this->triangles_.closing(triangle, way));
    order[way] = { -angle, way };
  }
  std::sort(order.begin(), order.begin() + ways);
  ClosingCheck::Result best;
  for (Id i = 0; i < ways && (i == 0 || -order[i].first >= allowed); ++i)
  {
    const Id way = order[i].second;
    const ClosingCheck::Result check =
      this->check_.check(triangle, this->triangles_.closing(triangle, way), false);
    if (i == 0 || check.passed || check.sample < best.sample)
    {
      this->triangles_.setWay(triangle, way);
      best = check;
    }
    if (best.passed)
    {
      break;
    }
  }
  return best;
}

void Refiner::refineWorst()
{
  while (this->violations_.takeBatch())
  {
    this->worstAtFirst_ = std::max(this->worstAtFirst_, this->violations_.worst());
    const Id edgesBefore = this->triangles_.numberOfEdges();
    this->triangles_.begin();
    if (!this->refineBatch())
    {
      this->triangles_.rollBack();
      this->distances_.forget(edgesBefore);
      this->closure_.forget();
      if (!this->violations_.putBack())
      {
        this->stopped_ = true;
        return;
      }
      continue;
    }
    for (const Id triangle : this->changed_)
    {
      this->assess(triangle);
      if (this->seams_)
      {
        this->report(); // there are many
      }
    }
  }
}

// Returns whether there is room for what has come of it.
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
  if (!this->seams_)
  {
    return !this->hasTooMany();
  }
  if (!this->settleSeams() || !this->isRoomForAll())
  {
    return false;
  }
  this->collectChanged();
  return true;
}

// Until no rank asks for a split or has made one. Returns whether none has too many triangles.
bool Refiner::settleSeams()
{
  SeamSplits::State state = SeamSplits::State::Going;
  while (state == SeamSplits::State::Going)
  {
    int last = 0;
    const auto inRound = [&](int round)
    {
      if (round != last)
      {
        this->close(last);
        last = round;
      }
    };
    state = this->seams_->exchange(
      this->hasTooMany(),
      [&](Id edge, int round, const RedGreenMesh::Placement& placement)
      {
        inRound(round);
        this->triangles_.split(edge, placement);
        this->report();
      },
      [&](Id edge, int round)
      {
        inRound(round);
        if (!this->triangles_.isSplit(edge))
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

// Each leaf once, and none that was split after it had been changed.
void Refiner::collectChanged()
{
  std::sort(this->changed_.begin(), this->changed_.end());
  this->changed_.erase(
    std::unique(this->changed_.begin(), this->changed_.end()), this->changed_.end());
  this->changed_.erase(std::remove_if(this->changed_.begin(), this->changed_.end(),
                         [this](Id triangle) { return !this->triangles_.isLeaf(triangle); }),
    this->changed_.end());
}

bool Refiner::hasTooMany() const
{
  return this->triangles_.numberOfTriangles() > this->maximumTriangles();
}

// On all ranks together.
bool Refiner::isRoomForAll() const
{
  if (this->options_.maximumFaces == 0)
  {
    return true;
  }
  return sumOverRanks(*this->exchange_, this->triangles_.numberOfTriangles()).all <=
    this->options_.maximumFaces;
}

Id Refiner::numberOfCallersPoints() const
{
  if (!this->options_.cornerPoints.empty() || this->field_.mesh().numberOfFaces() == 0)
  {
    return this->options_.numberOfPoints;
  }
  return this->options_.part != nullptr ? this->options_.part->numberOfOwnVertices()
                                        : this->field_.mesh().numberOfVertices();
}

double Refiner::largestOf(double number) const
{
  return this->exchange_ == nullptr ? number : this->exchange_->largestOf(number);
}

std::uint64_t Refiner::maximumTriangles() const
{
  constexpr std::uint64_t numberable = NoId / 5; // ids are 3 * part + k, and parts have parts
  return this->options_.maximumFaces > 0 ? std::min(this->options_.maximumFaces, numberable)
                                         : numberable;
}

// Splits the edges that are over the limit; where there are none, it is the inside, and one split
// into four gets the new edges there.
void Refiner::refine(const Violation& violation)
{
  const Id triangle = violation.triangle;
  bool isOver = false;
  for (Id k = 0; k < 3; ++k)
  {
    const Id edge = this->triangles_.edge(triangle, k);
    if (!this->triangles_.isSplit(edge) &&
      this->distances_.deviation(edge).largest() > violation.limit)
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

// Where refinement has stopped at its maximum.
void Refiner::certifyRest()
{
  this->violations_.takeAll(
    [this](const Violation& rest)
    {
      const Id way = this->triangles_.wayOf(rest.triangle);
      const RedGreenMesh::Closing closing = this->triangles_.closing(rest.triangle, way);
      this->raiseBound(this->check_.check(rest.triangle, closing, true).bound);
    });
}

// The errors fall from the worst at first to the tolerance, by about the same factor with each
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
