// SPDX-License-Identifier: BSD-3-Clause
#include "field/PathsOnRanks.h"

#include "Errors.h"
#include "field/PathInStrip.h"
#include "field/PathStrip.h"
#include "field/PathTracer.h"
#include "field/RetentionAround.h"
#include "source/CurvesInFaces.h"
#include "source/SourceWindowsOfPart.h"

#include <algorithm>
#include <string>
#include <utility>

namespace geodesic
{

namespace
{

/// Of the progress, for the front; what is left is for tracing.
constexpr double FrontDone = 0.5;

constexpr RankAddress NoFace = { -1, NoId };

/// A path on its way over ranks.
struct Journey
{
  /// Where its target is, and which one.
  int home = 0;
  Id target = 0;
  TracedPath path;
  /// How many of the points at hand the target's rank knows.
  std::size_t told = 0;
  /// While it searches around an edge: the ranks that are still to be asked, and the best so far.
  bool isSearching = false;
  std::vector<int> toAsk;
  double nearest = Infinity;
  int nearestRank = 0;
};

/// What the target's rank is told.
enum class Status : std::uint8_t
{
  OnItsWay,
  Whole,
  Lost
};

void putPoint(Message& message, const SurfacePart& part, Id face, const SurfacePoint& point)
{
  const PointInFace p = pointInFace(part, face, point);
  put(message, p.face);
  put(message, p.point);
}

/// \param face that holds the last point, on this rank and on the one that it goes to.
void putJourney(Message& message, const SurfacePart& part, const Journey& journey, Id face)
{
  const TracedPath& path = journey.path;
  put(message, journey.home);
  put(message, journey.target);
  putPoint(message, part, face, path.points.back());
  put(message, path.left);
  put(message, path.whole);
  put(message, path.length);
  put(message, path.steps);
  put(message, path.stepsBesideEnd);
  put(message, path.next);
  const bool isOnLeg = path.next == TracedPath::Next::BehindExit;
  put(message, isOnLeg ? part.addressOf(TriangleMesh::faceOf(path.leg.exit)) : NoFace);
  put(message, path.leg.exit % 3);
  put(message, path.leg.ray);
  put(message, path.leg.origin);
  const bool isFromFace = path.next == TracedPath::Next::Search && path.without != NoId;
  put(message, isFromFace ? part.addressOf(path.without) : NoFace);
  put(message, journey.isSearching);
  put(message, journey.toAsk.size());
  put(message, journey.toAsk.data(), journey.toAsk.size());
  put(message, journey.nearest);
  put(message, journey.nearestRank);
}

Journey getJourney(MessageReader& reader, const SurfacePart& part)
{
  Journey journey;
  TracedPath& path = journey.path;
  journey.home = reader.get<int>();
  journey.target = reader.get<Id>();
  const auto address = reader.get<RankAddress>();
  path.points = { pointOfPart(part, address, reader.get<SurfacePoint>()) };
  path.faces = { faceOfPart(part, address) };
  journey.told = 1;
  path.left = reader.get<double>();
  path.whole = reader.get<double>();
  path.length = reader.get<double>();
  path.steps = reader.get<std::uint64_t>();
  path.stepsBesideEnd = reader.get<int>();
  path.next = reader.get<TracedPath::Next>();
  const auto exitFace = reader.get<RankAddress>();
  const Id k = reader.get<Id>();
  path.leg.exit = exitFace.rank < 0 ? NoId : 3 * faceOfPart(part, exitFace) + k;
  path.leg.ray = reader.get<Window>();
  path.leg.origin = reader.get<Id>();
  const auto without = reader.get<RankAddress>();
  path.without = without.rank < 0 ? NoId : faceOfPart(part, without);
  journey.isSearching = reader.get<bool>();
  journey.toAsk.resize(reader.get<std::size_t>());
  reader.get(journey.toAsk.data(), journey.toAsk.size());
  journey.nearest = reader.get<double>();
  journey.nearestRank = reader.get<int>();
  return journey;
}

/// Follows paths from rank to rank.
class Journeys
{
public:
  Journeys(const DistanceField& field, const SurfacePatch& patch,
    const std::vector<SourceCurve>& curves, const std::vector<SurfacePoint>& targets,
    const PathsOptions& options)
    : field_(field)
    , part_(*field.part())
    , patch_(patch)
    , curves_(patch.mesh(), curves)
    , targets_(targets)
    , options_(options)
    , tracer_(field)
    , found_(targets.size())
    , paths_(targets.size())
  {
  }

  /// All ranks together, until all paths are at their ends or lost.
  void run();

  std::vector<PathInSpace>& paths() { return this->paths_; }
  const std::vector<Id>& lost() const { return this->lost_; }

private:
  /// What has become of a journey on this rank.
  struct Outcome
  {
    Status status = Status::OnItsWay;
    /// A face that holds its last point, and the rank that it goes to.
    Id face = NoId;
    int rank = 0;
  };

  void begin();
  Outcome advance(Journey& journey) const;
  bool searchAround(Journey& journey, Outcome& outcome) const;
  Id faceOfRank(const SurfacePoint& point, int rank) const;
  void send(const Journey& journey, const Outcome& outcome, std::vector<Message>& reports,
    std::vector<Message>& handedOver) const;
  void takeReport(MessageReader& reader);
  Id sourceAtEnd(const TracedPath& path) const;
  void report() const;

  const DistanceField& field_;
  const SurfacePart& part_;
  const SurfacePatch& patch_;
  CurvesInFaces curves_;
  const std::vector<SurfacePoint>& targets_;
  const PathsOptions& options_;
  PathTracer tracer_;
  /// Paths that are on this rank.
  std::vector<Journey> here_;
  /// Of this rank's targets: what has been found, the paths, and those that are lost.
  std::vector<std::vector<PointInFace>> found_;
  std::vector<PathInSpace> paths_;
  std::vector<Id> lost_;
  std::size_t finished_ = 0;
};

void Journeys::begin()
{
  for (Id target = 0; target < this->targets_.size(); ++target)
  {
    Journey journey;
    journey.home = this->part_.exchange().rank();
    journey.target = target;
    journey.path = this->tracer_.begin(this->targets_[target]);
    if (!journey.path.points.empty())
    {
      this->here_.push_back(std::move(journey));
    }
  }
}

void Journeys::report() const
{
  const double done = this->targets_.empty()
    ? 0.0
    : static_cast<double>(this->finished_) / static_cast<double>(this->targets_.size());
  if (this->options_.progress && !this->options_.progress(FrontDone + (1.0 - FrontDone) * done))
  {
    throw Aborted();
  }
}

void Journeys::run()
{
  Exchange& exchange = this->part_.exchange();
  this->begin();
  std::vector<double> least = { 0.0 };
  while (least.front() == 0.0)
  {
    this->report();
    std::vector<Outcome> outcomes(this->here_.size());
    forAll(this->options_.parallelFor, this->here_.size(),
      [&](std::size_t i) { outcomes[i] = this->advance(this->here_[i]); });
    std::vector<Message> messages = exchange.noMessages();
    std::vector<Message> handedOver = exchange.noMessages();
    for (std::size_t i = 0; i < this->here_.size(); ++i)
    {
      this->send(this->here_[i], outcomes[i], messages, handedOver);
    }
    this->here_.clear();
    least.front() = 1.0;
    for (std::size_t rank = 0; rank < messages.size(); ++rank)
    {
      least.front() = handedOver[rank].empty() ? least.front() : 0.0;
      messages[rank].insert(messages[rank].end(), handedOver[rank].begin(), handedOver[rank].end());
    }
    readEach(exchange.step(std::move(messages), least),
      [this](int, MessageReader& reader)
      {
        if (reader.get<bool>())
        {
          this->takeReport(reader);
        }
        else
        {
          this->here_.push_back(getJourney(reader, this->part_));
        }
      });
  }
}

Journeys::Outcome Journeys::advance(Journey& journey) const
{
  Outcome outcome;
  try
  {
    for (;;)
    {
      outcome.face = this->tracer_.follow(journey.path);
      if (journey.path.isWhole())
      {
        outcome.status = Status::Whole;
        return outcome;
      }
      if (outcome.face != NoId)
      {
        outcome.rank = this->part_.ownerOf(outcome.face).rank;
        const bool isOnLeg = journey.path.next == TracedPath::Next::BehindExit;
        outcome.face = isOnLeg ? TriangleMesh::faceOf(journey.path.leg.exit) : outcome.face;
        return outcome;
      }
      if (!this->searchAround(journey, outcome))
      {
        return outcome;
      }
    }
  }
  catch (const PathLost&)
  {
    outcome.status = Status::Lost;
    return outcome;
  }
}

// Asks the ranks around an edge one after another, then goes on where the path is nearest. Returns
// whether that is here.
bool Journeys::searchAround(Journey& journey, Outcome& outcome) const
{
  const int self = this->part_.exchange().rank();
  const SurfacePoint& point = journey.path.points.back();
  if (!journey.isSearching)
  {
    journey.isSearching = true;
    journey.nearest = Infinity;
    forEachFace(this->part_.mesh(), point,
      [&](Id face)
      {
        if (face != journey.path.without)
        {
          journey.toAsk.push_back(this->part_.addressOf(face).rank);
        }
      });
    std::sort(journey.toAsk.begin(), journey.toAsk.end());
    journey.toAsk.erase(
      std::unique(journey.toAsk.begin(), journey.toAsk.end()), journey.toAsk.end());
  }
  const auto own = std::find(journey.toAsk.begin(), journey.toAsk.end(), self);
  if (own != journey.toAsk.end())
  {
    journey.toAsk.erase(own);
    const double distance = this->tracer_.searchHere(journey.path);
    const bool isNearer = distance < journey.nearest ||
      (distance == journey.nearest && distance < Infinity && self < journey.nearestRank);
    journey.nearest = isNearer ? distance : journey.nearest;
    journey.nearestRank = isNearer ? self : journey.nearestRank;
  }
  if (journey.toAsk.empty() && !(journey.nearest < Infinity))
  {
    throw PathLost("A shortest path was to be followed through faces whose windows are not known.");
  }
  outcome.rank = journey.toAsk.empty() ? journey.nearestRank : journey.toAsk.front();
  if (outcome.rank != self)
  {
    outcome.face = point.kind == SurfacePoint::Kind::Edge ? TriangleMesh::faceOf(point.id)
                                                          : this->faceOfRank(point, outcome.rank);
    return false;
  }
  journey.isSearching = false;
  this->tracer_.goOnHere(journey.path);
  return true;
}

// A face around a point that a rank owns.
Id Journeys::faceOfRank(const SurfacePoint& point, int rank) const
{
  Id found = NoId;
  forEachFace(this->part_.mesh(), point,
    [&](Id face) { found = this->part_.addressOf(face).rank == rank ? face : found; });
  return found;
}

void Journeys::send(const Journey& journey, const Outcome& outcome, std::vector<Message>& reports,
  std::vector<Message>& handedOver) const
{
  Message& message = reports[static_cast<std::size_t>(journey.home)];
  const TracedPath& path = journey.path;
  put(message, true);
  put(message, journey.target);
  put(message, outcome.status);
  put(message, path.points.size() - journey.told);
  for (std::size_t i = journey.told; i < path.points.size(); ++i)
  {
    put(message, pointInFace(this->part_, path.faces[i], path.points[i]));
  }
  put(message, path.whole);
  put(message, outcome.status == Status::Whole ? this->sourceAtEnd(path) : NoId);
  if (outcome.status == Status::OnItsWay)
  {
    Message& next = handedOver[indexOf(outcome.rank)];
    put(next, false);
    putJourney(next, this->part_, journey, outcome.face);
  }
}

// The faces of the source are on the patch.
Id Journeys::sourceAtEnd(const TracedPath& path) const
{
  const Id face = path.faces.back();
  const Id onPatch = this->patch_.faceAt(this->part_.addressOf(face));
  return onPatch == NoId ? NoId
                         : this->curves_.sourceAt(fromBarycentric(this->patch_.mesh(), onPatch,
                             barycentric(this->part_.mesh(), path.points.back(), face)));
}

void Journeys::takeReport(MessageReader& reader)
{
  const Id target = reader.get<Id>();
  const auto status = reader.get<Status>();
  std::vector<PointInFace>& found = this->found_[target];
  for (auto left = reader.get<std::size_t>(); left > 0; --left)
  {
    found.push_back(reader.get<PointInFace>());
  }
  const auto whole = reader.get<double>();
  const Id source = reader.get<Id>();
  if (status == Status::Whole)
  {
    this->paths_[target] = { cleanedPlaces(found, whole), source };
  }
  else if (status == Status::Lost)
  {
    this->lost_.push_back(target);
  }
  if (status != Status::OnItsWay)
  {
    found = {};
    ++this->finished_;
  }
}

/// Windows in faces of other ranks around targets on edges are kept there.
void keepAroundSeams(
  const SurfacePart& part, const std::vector<SurfacePoint>& targets, RetentionAround& retention)
{
  std::vector<Message> messages = part.exchange().noMessages();
  for (const SurfacePoint& target : targets)
  {
    const SurfacePoint point = normalized(part.mesh(), target);
    if (point.kind == SurfacePoint::Kind::Edge)
    {
      forEachFace(part.mesh(), point,
        [&](Id face)
        {
          const RankAddress address = part.addressOf(face);
          put(messages[indexOf(address.rank)], address.id);
        });
    }
  }
  readEach(part.exchange().step(std::move(messages)),
    [&](int, MessageReader& reader) { retention.keepForOthers(reader.get<Id>()); });
}

/// The targets whose paths are lost on any rank, in one order on all.
std::vector<std::pair<TargetOnRank, Id>> gatherLost(
  const DistanceField& field, const std::vector<SurfacePoint>& targets, const std::vector<Id>& lost)
{
  const SurfacePart& part = *field.part();
  Message message;
  for (const Id target : lost)
  {
    Id own = NoId;
    forEachFace(
      part.mesh(), targets[target], [&](Id face) { own = part.isOwn(face) ? face : own; });
    put(message, target);
    put(message,
      TargetOnRank{ part.addressOf(own), barycentric(part.mesh(), targets[target], own),
        field.distance(targets[target]) });
  }
  std::vector<std::pair<TargetOnRank, Id>> all;
  readEach(part.exchange().tellAll(message),
    [&](int, MessageReader& reader)
    {
      const Id target = reader.get<Id>();
      all.emplace_back(reader.get<TargetOnRank>(), target);
    });
  return all;
}

} // anonymous namespace

std::vector<PathInSpace> pathsOnRanks(const SurfacePart& part, const SurfacePatch& patch,
  const std::vector<SourceCurve>& curves, const std::vector<SurfacePoint>& targets,
  const PathsOptions& options)
{
  RetentionAround retention(part.mesh(), targets);
  keepAroundSeams(part, targets, retention);
  FrontOptions frontOptions;
  frontOptions.keepArrivals = true;
  frontOptions.part = &part;
  frontOptions.parallelFor = options.parallelFor;
  if (options.progress)
  {
    frontOptions.progress = [&options](double fraction)
    { return options.progress(FrontDone * fraction); };
  }
  FrontResult front = propagate(part.mesh(),
    sourceWindowsOfPart(part, patch, makeSourceWindows(patch.mesh(), curves)), frontOptions,
    retention);
  const DistanceField field(part.mesh(), std::move(front), retention.release());

  Journeys journeys(field, patch, curves, targets, options);
  journeys.run();
  const KnownDistances known{ field.vertexDistances(),
    part.exchange().largestOf(retention.reach()) };
  const ProgressCallback atEnd = [&options](double)
  { return !options.progress || options.progress(1.0); };
  for (const auto& [target, number] : gatherLost(field, targets, journeys.lost()))
  {
    PathInSpace path = pathInStrip(part, patch, curves, target, known, options.parallelFor, atEnd);
    if (target.face.rank != part.exchange().rank())
    {
      continue;
    }
    if (path.points.empty())
    {
      throw Error("The shortest path from target " + std::to_string(number) +
        " could not be followed. Please report this with the surface, the source and the "
        "targets.");
    }
    journeys.paths()[number] = std::move(path);
  }
  return std::move(journeys.paths());
}

}
