// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/AdaptiveRefinement.h"

#include "Errors.h"
#include "Tolerance.h"
#include "refinement/FaceBounds.h"
#include "refinement/RefinementOutput.h"
#include "refinement/SplitsOfEdges.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>

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
  return !field.knowsInside(face) || field.isCovered(face) ||
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

/// The regions in which the points of faces under refinement lie; each is found once.
class RegionsOfPoints
{
public:
  RegionsOfPoints(const RefinedFaces& faces, const RefinementOptions& options, double tolerance)
    : faces_(faces)
    , options_(options)
    , tolerance_(tolerance)
  {
  }

  /// The longest side of a triangle in an open face that must be split, as there is a border
  /// between its corners; else 0.
  double lengthAtBorder(const FaceTriangles& face, const Triangle& c)
  {
    std::array<Corner, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const FaceTriangles::Point& point = face.points()[c[k]];
      corners[k] = { point.number == NoId ? this->ofInside(face, c[k]) : this->of(point.number),
        point.distance, point.place };
    }
    return this->lengthAtBorder(corners);
  }
  /// The same for a face that is not open, or a triangle between points of its edges.
  double lengthAtBorder(Id face, const Triangle& c)
  {
    const TriangleMesh& mesh = this->faces_.field.mesh();
    const Id frame = longestHalfedge(mesh, face);
    std::array<Corner, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Id point = c[k];
      corners[k] = { this->of(point),
        this->faces_.edges.distanceOf(point, this->faces_.field.vertexDistances()),
        inHalfedgeFrame(mesh, frame, this->faces_.edges.placeOf(point)) };
    }
    return this->lengthAtBorder(corners);
  }

private:
  struct Corner
  {
    SourceRegion region;
    double distance = 0.0;
    Vec2 place;
  };

  double lengthAtBorder(const std::array<Corner, 3>& c) const
  {
    if (!(isBorderBetween(c[0], c[1]) || isBorderBetween(c[1], c[2]) ||
          isBorderBetween(c[2], c[0])))
    {
      return 0.0;
    }
    const double longest = longestEdge({ c[0].place, c[1].place, c[2].place });
    return longest > this->tolerance_ ? longest : 0.0;
  }

  static bool isBorderBetween(const Corner& a, const Corner& b)
  {
    if (a.region.source != b.region.source)
    {
      return true;
    }
    if (a.region.isRight == b.region.isRight)
    {
      return false;
    }
    // Where a straight line crosses the curve between its sides, there is no border. Both ends are
    // then nearer to the crossing than to each other.
    return a.distance + b.distance > (1.0 + tolerance::Tie) * norm(b.place - a.place);
  }

  const SourceRegion& of(Id point)
  {
    if (point >= this->regions_.size())
    {
      this->regions_.resize(
        this->faces_.field.mesh().numberOfVertices() + this->faces_.edges.points().size());
    }
    std::optional<SourceRegion>& region = this->regions_[point];
    if (!region)
    {
      region = this->options_.regionOf(this->faces_.edges.placeOf(point));
    }
    return *region;
  }

  const SourceRegion& ofInside(const FaceTriangles& face, Id point)
  {
    std::vector<std::optional<SourceRegion>>& regions = this->inside_[face.face()];
    regions.resize(std::max<std::size_t>(regions.size(), point + 1));
    if (!regions[point])
    {
      const Barycentric& weights = face.points()[point].weights;
      regions[point] =
        this->options_.regionOf(SurfacePoint::inFace(face.face(), weights[1], weights[2]));
    }
    return *regions[point];
  }

  const RefinedFaces& faces_;
  const RefinementOptions& options_;
  double tolerance_;
  /// Of vertices and points on edges; and for each face, of its own points.
  std::vector<std::optional<SourceRegion>> regions_;
  std::unordered_map<Id, std::vector<std::optional<SourceRegion>>> inside_;
};

/// What does not change while a field is refined to one tolerance after another.
struct Task
{
  const DistanceField& field;
  const RefinementOptions& options;
  /// Faces that this rank does not refine, and those that no rank refines.
  std::vector<std::uint8_t> isFrozen;
  std::vector<std::uint8_t> isFrozenThere;

  const MeshPartition& surface() const { return this->field.surface(); }
};

/// Refines a surface to a tolerance, in rounds. In a round faces with new points on their edges
/// work, each by itself, and ask for more points on edges; then edges get those.
class Refiner
{
public:
  Refiner(const Task& task, double tolerance)
    : task_(task)
    , tolerance_(tolerance)
    , faces_(task.field)
    , splits_(
        task.field, faces_.edges, task.isFrozen, task.isFrozenThere, tolerance, task.options.job)
    , regions_(faces_, task.options, tolerance)
    , numberOfTriangles_(task.surface().endOfOwnFaces() - task.surface().firstOwnFace())
    , bound_(task.surface().exchange().largestOf(task.field.droppedErrorBound()))
  {
  }

  /// \returns whether there is room for the result.
  bool run()
  {
    this->assessFaces();
    if (!this->refineFaces({}))
    {
      return false;
    }
    if (!this->task_.options.regionOf)
    {
      return true;
    }
    this->findBorders();
    return this->refineFaces([this](const FaceTriangles& face, const Triangle& corners)
      { return this->regions_.lengthAtBorder(face, corners); });
  }

  RefinedMesh result(const Job& job)
  {
    const RefinementOptions& options = this->task_.options;
    const MeshPartition& surface = this->task_.surface();
    const bool areVertices = options.cornerPoints.empty() && surface.mesh().numberOfFaces() > 0;
    const std::vector<Id> unknown = this->unknownAtBorders();
    RefinedMesh result = writeOutput(this->faces_, options,
      areVertices ? surface.numberOfOwnVertices() : options.numberOfPoints, job);
    result.errorBound = surface.exchange().largestOf(this->boundOfAll());
    result.unknownAtBorders = unknown;
    return result;
  }

  /// The share of the room beside the surface's own faces that is taken, after run().
  double shareOfRoom() const
  {
    const auto own = static_cast<double>(this->task_.surface().numberOfGlobalFaces());
    return (static_cast<double>(this->trianglesOfAll_) - own) /
      (static_cast<double>(this->task_.options.maximumFaces) - own);
  }

private:
  /// Works in batches. Each batch knows the bound certified by the previous ones, however many
  /// threads there are.
  void assessFaces()
  {
    constexpr Id facesInBatch = 2 * ItemsInRange;
    const Id first = this->task_.surface().firstOwnFace();
    const Id end = this->task_.surface().endOfOwnFaces();
    for (Id face = first; face < end; face += std::min(facesInBatch, end - face))
    {
      this->task_.options.job.reach(FacesAssessed * (face - first) / (end - first));
      this->assessFaces(face, face + std::min(facesInBatch, end - face));
    }
  }

  void assessFaces(Id first, Id end)
  {
    const double known = this->bound_;
    std::vector<QuickError> errors(end - first);
    this->task_.options.job.part(0.0, 0.0).loop(errors.size(),
      [&](std::size_t i)
      {
        const Id face = first + static_cast<Id>(i);
        if (this->task_.isFrozen[face] == 0)
        {
          errors[i] = quickErrorOfFace(this->task_.field, face, this->tolerance_, known);
        }
      });
    for (Id face = first; face < end; ++face)
    {
      const QuickError& error = errors[face - first];
      if (this->task_.isFrozen[face] != 0)
      {
        continue;
      }
      if (error.byWindows == Infinity)
      {
        this->due_.push_back(face);
        continue;
      }
      // Smaller bounds than that of all faces need not be sharp.
      const double bound = error.bySize <= this->bound_ ? error.bySize : error.byWindows;
      this->bound_ = std::max(this->bound_, bound + error.rounding);
    }
  }

  void findBorders()
  {
    const MeshPartition& surface = this->task_.surface();
    for (Id face = surface.firstOwnFace(); face < surface.endOfOwnFaces(); ++face)
    {
      if (this->task_.isFrozen[face] == 0 &&
        (this->faces_.isOpen(face) ||
          this->regions_.lengthAtBorder(face, surface.mesh().triangle(face)) > 0.0))
      {
        this->due_.push_back(face);
      }
    }
  }

  /// \returns whether there is room for the result.
  bool refineFaces(const LengthAtBorder& lengthAtBorder)
  {
    this->openDue();
    std::vector<SplitRequest> requests = this->splits_.measureNew();
    while (this->isAnythingLeft(requests))
    {
      this->takeChanged(this->splits_.split(std::move(requests)));
      this->openDue();
      this->splits_.measureNew(); // faces ask for what these need
      requests = this->work(lengthAtBorder);
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

  /// Whether some rank has faces or edges to refine, and all ranks have room.
  bool isAnythingLeft(const std::vector<SplitRequest>& requests)
  {
    struct State
    {
      std::uint64_t triangles;
      std::uint64_t isAnyLeft;
    };
    const bool isAnyLeft = !requests.empty() || !this->due_.empty();
    const MeshPartition& surface = this->task_.surface();
    this->trianglesOfAll_ = 0;
    bool isAnyLeftOfAll = false;
    for (const State& state :
      valuesOfRanks(surface.exchange(), State{ this->numberOfTriangles_, isAnyLeft ? 1U : 0U }))
    {
      this->trianglesOfAll_ += state.triangles;
      isAnyLeftOfAll = isAnyLeftOfAll || state.isAnyLeft != 0;
      this->isOverfull_ = this->isOverfull_ || state.triangles > MostOfRank;
    }
    const std::uint64_t maximum = this->task_.options.maximumFaces;
    const bool isAnyAdded = this->trianglesOfAll_ > surface.numberOfGlobalFaces();
    this->isOverfull_ = this->isOverfull_ ||
      (maximum > 0 && this->trianglesOfAll_ > maximum && (isAnyLeftOfAll || isAnyAdded));
    return isAnyLeftOfAll && !this->isOverfull_;
  }

  /// Edges have new points: the faces around them are due.
  void takeChanged(const std::vector<Id>& edges)
  {
    this->pointsOn_.resize(this->faces_.edges.size(), 0);
    for (const Id edge : edges)
    {
      const CutEdge& e = this->faces_.edges[edge];
      const auto added = static_cast<Id>(e.points.size()) - this->pointsOn_[edge];
      this->pointsOn_[edge] += added;
      const auto beside = this->task_.options.trianglesBeside.find(e.halfedge);
      Id triangles = beside == this->task_.options.trianglesBeside.end() ? 0 : beside->second;
      forEachFace(this->task_.surface().mesh(), SurfacePoint::onEdge(e.halfedge, 0.5),
        [&](Id face)
        {
          if (this->task_.isFrozen[face] == 0)
          {
            this->due_.push_back(face);
          }
          else
          {
            triangles += this->task_.surface().isOwn(face) ? 1 : 0;
          }
        });
      this->numberOfTriangles_ += static_cast<std::uint64_t>(added) * triangles;
    }
  }

  /// Refines the due faces, each by itself. \returns the points that they need on edges.
  std::vector<SplitRequest> work(const LengthAtBorder& lengthAtBorder)
  {
    const std::vector<Id> due = std::exchange(this->due_, {});
    std::vector<std::vector<SplitRequest>> requests(due.size());
    std::vector<std::uint8_t> isDone(due.size());
    const auto refine = [&](std::size_t task, std::size_t i)
    {
      FaceTriangles& face = this->faces_.triangles(due[i]);
      isDone[i] =
        this->refiners_[task]->refine(face, this->mostPartsOf(due[i]), lengthAtBorder, requests[i])
        ? 1
        : 0;
    };
    for (const Id face : due)
    {
      this->numberOfTriangles_ -= this->faces_.triangles(face).numberOfParts();
    }
    if (lengthAtBorder) // asks for regions, which one thread may do
    {
      this->makeRefiners(1);
      for (std::size_t i = 0; i < due.size(); ++i)
      {
        this->task_.options.job.look();
        refine(0, i);
      }
    }
    else
    {
      this->task_.options.job.loopByTasks(
        due.size(), [this](std::size_t tasks) { this->makeRefiners(tasks); }, refine);
    }
    std::vector<SplitRequest> all;
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

  void makeRefiners(std::size_t count)
  {
    while (this->refiners_.size() < count)
    {
      this->refiners_.push_back(
        std::make_unique<FaceRefiner>(this->task_.field, this->faces_.edges, this->tolerance_));
    }
  }

  /// A limit that no face reaches: triangles as small as the tolerance pass, so that splits leave
  /// no sides much shorter.
  std::uint64_t mostPartsOf(Id face) const
  {
    const double across = this->task_.surface().mesh().shape(face).longest() / this->tolerance_;
    const double most = 1000.0 + 100.0 * across * across;
    const std::uint64_t room =
      this->task_.options.maximumFaces > 0 ? this->task_.options.maximumFaces : MostOfRank;
    return most < static_cast<double>(room) ? static_cast<std::uint64_t>(most) : room;
  }

  /// The errors fall from the initial worst to the tolerance, by about the same factor with each
  /// round.
  void report(const std::vector<SplitRequest>& requests)
  {
    double worst = this->tolerance_;
    for (const SplitRequest& request : requests)
    {
      worst = std::max(worst, request.reason == SplitReason::Error ? request.urgency : 0.0);
    }
    this->worstAtFirst_ = std::max(this->worstAtFirst_, worst);
    const double open = std::log(worst / this->tolerance_);
    const double openAtFirst = std::log(this->worstAtFirst_ / this->tolerance_);
    const double done = openAtFirst > 0.0 ? 1.0 - std::clamp(open / openAtFirst, 0.0, 1.0) : 0.0;
    this->task_.options.job.part(FacesAssessed, FacesSplit).reach(done);
  }

  /// The bound of all triangles, those that are left over the tolerance included.
  double boundOfAll()
  {
    this->makeRefiners(1);
    double bound = this->bound_;
    for (FaceTriangles& face : this->faces_.openFaces())
    {
      for (Id part = 0; part < face.numberOfParts(); ++part)
      {
        const FaceTriangles::Part& p = face.parts()[part];
        bound = std::max(bound,
          p.state == FaceTriangles::State::Passed ? p.bound
                                                  : this->refiners_[0]->tightBound(face, part));
      }
    }
    return bound;
  }

  std::vector<Id> unknownAtBorders()
  {
    std::vector<Id> unknown;
    const MeshPartition& surface = this->task_.surface();
    std::vector<Triangle> triangles;
    for (Id face = surface.firstOwnFace();
         this->task_.options.regionOf && face < surface.endOfOwnFaces(); ++face)
    {
      if (!this->task_.field.isDropped(face))
      {
        continue;
      }
      triangles.clear();
      appendTriangles(this->faces_, face, {}, triangles);
      if (std::any_of(triangles.begin(), triangles.end(),
            [&](const Triangle& corners)
            { return this->regions_.lengthAtBorder(face, corners) > 0.0; }))
      {
        unknown.push_back(face);
      }
    }
    return unknown;
  }

  /// Ids are 3 * triangle + k.
  static constexpr std::uint64_t MostOfRank = NoId / 5;

  const Task& task_;
  double tolerance_;
  RefinedFaces faces_;
  SplitsOfEdges splits_;
  RegionsOfPoints regions_;
  std::vector<std::unique_ptr<FaceRefiner>> refiners_;
  /// Faces with work to do.
  std::vector<Id> due_;
  /// For each edge, how many points have been counted.
  std::vector<Id> pointsOn_;
  std::uint64_t numberOfTriangles_;
  std::uint64_t trianglesOfAll_ = 0;
  bool isOverfull_ = false;
  double bound_;
  double worstAtFirst_ = 0.0;
};

/// Refines to the smallest tolerance for which there is room, found by trial: in the range between
/// one without room and one with room, the next is where triangles in inverse proportion to the
/// tolerance would just fill the room, or the middle of the range's logarithms. A run without room
/// stops early.
std::unique_ptr<Refiner> refineWithinRoom(const Task& task)
{
  constexpr double EnoughOfRoom = 0.97;
  constexpr int MostRuns = 12;
  std::unique_ptr<Refiner> best;
  double fits = Infinity;
  double tooSmall = task.options.tolerance;
  const std::uint64_t maximum = task.options.maximumFaces;
  const bool isRoom = maximum == 0 || maximum >= task.surface().numberOfGlobalFaces();
  double growth = 4.0; // 4, 16, 256 ... times the tolerance until there is room
  for (int run = 0; isRoom && run < MostRuns; ++run)
  {
    double next = growth * task.options.tolerance;
    if (best)
    {
      const double full = fits * best->shareOfRoom();
      next = full > tooSmall ? full : std::sqrt(fits * tooSmall);
    }
    auto refiner = std::make_unique<Refiner>(task, next);
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
    best = std::make_unique<Refiner>(task, Infinity);
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
  std::vector<std::uint8_t> frozen = findFrozen(field, options.job);
  std::vector<std::uint8_t> frozenThere = frozenOnAnyRank(field.surface(), frozen);
  const Task task = { field, options, std::move(frozen), std::move(frozenThere) };
  const Job output = options.job.part(FacesSplit, 1.0);
  auto refiner = std::make_unique<Refiner>(task, options.tolerance);
  if (refiner->run())
  {
    return refiner->result(output);
  }
  refiner.reset();
  RefinedMesh result = refineWithinRoom(task)->result(output);
  result.stoppedAtMaximum = true;
  return result;
}

}
