// SPDX-License-Identifier: BSD-3-Clause
#include "paths/PathsOnRanks.h"

#include "Errors.h"
#include "field/RetentionAround.h"
#include "paths/PathInStrip.h"
#include "paths/PathStrip.h"
#include "paths/PathTracer.h"
#include "source/CurvesInFaces.h"
#include "source/SourceWindowsOfPartition.h"

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
struct PathInTransit
{
  /// Where its target is, and which one.
  int targetRank = 0;
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

void putPoint(Message& message, const MeshPartition& part, Id face, const SurfacePoint& point)
{
  const PointInFace p = pointInFace(part, face, point);
  put(message, p.face);
  put(message, p.point);
}

/// \param face that holds the last point, on this rank and on the one that it goes to.
void putInTransit(
  Message& message, const MeshPartition& part, const PathInTransit& transit, Id face)
{
  const TracedPath& path = transit.path;
  put(message, transit.targetRank);
  put(message, transit.target);
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
  put(message, transit.isSearching);
  put(message, transit.toAsk.size());
  put(message, transit.toAsk.data(), transit.toAsk.size());
  put(message, transit.nearest);
  put(message, transit.nearestRank);
}

PathInTransit getInTransit(MessageReader& reader, const MeshPartition& part)
{
  PathInTransit transit;
  TracedPath& path = transit.path;
  transit.targetRank = reader.get<int>();
  transit.target = reader.get<Id>();
  const auto address = reader.get<RankAddress>();
  path.points = { pointOfPart(part, address, reader.get<SurfacePoint>()) };
  path.faces = { part.faceAt(address) };
  transit.told = 1;
  path.left = reader.get<double>();
  path.whole = reader.get<double>();
  path.length = reader.get<double>();
  path.steps = reader.get<std::uint64_t>();
  path.stepsBesideEnd = reader.get<int>();
  path.next = reader.get<TracedPath::Next>();
  const auto exitFace = reader.get<RankAddress>();
  const Id k = reader.get<Id>();
  path.leg.exit = exitFace.rank < 0 ? NoId : 3 * part.faceAt(exitFace) + k;
  path.leg.ray = reader.get<Window>();
  path.leg.origin = reader.get<Id>();
  const auto without = reader.get<RankAddress>();
  path.without = without.rank < 0 ? NoId : part.faceAt(without);
  transit.isSearching = reader.get<bool>();
  transit.toAsk.resize(reader.get<std::size_t>());
  reader.get(transit.toAsk.data(), transit.toAsk.size());
  transit.nearest = reader.get<double>();
  transit.nearestRank = reader.get<int>();
  return transit;
}

/// Follows paths from rank to rank.
class PathsInTransit
{
public:
  PathsInTransit(const DistanceField& field, const ReplicatedPatch& patch,
    const std::vector<SourceCurve>& curves, const std::vector<SurfacePoint>& targets,
    const PathsOptions& options)
    : field_(field)
    , part_(field.surface())
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
  /// What has become of a transit on this rank.
  struct Outcome
  {
    Status status = Status::OnItsWay;
    /// A face that holds its last point, and the rank that it goes to.
    Id face = NoId;
    int rank = 0;
  };

  void begin();
  Outcome advance(PathInTransit& transit) const;
  bool searchAround(PathInTransit& transit, Outcome& outcome) const;
  Id faceOfRank(const SurfacePoint& point, int rank) const;
  void send(const PathInTransit& transit, const Outcome& outcome, std::vector<Message>& reports,
    std::vector<Message>& forwarded) const;
  void takeReport(MessageReader& reader);
  Id sourceAtEnd(const TracedPath& path) const;
  void report() const;

  const DistanceField& field_;
  const MeshPartition& part_;
  const ReplicatedPatch& patch_;
  CurvesInFaces curves_;
  const std::vector<SurfacePoint>& targets_;
  const PathsOptions& options_;
  PathTracer tracer_;
  /// Paths that are on this rank.
  std::vector<PathInTransit> here_;
  /// Of this rank's targets: what has been found, the paths, and those that are lost.
  std::vector<std::vector<PointInFace>> found_;
  std::vector<PathInSpace> paths_;
  std::vector<Id> lost_;
  std::size_t finished_ = 0;
};

void PathsInTransit::begin()
{
  for (Id target = 0; target < this->targets_.size(); ++target)
  {
    PathInTransit transit;
    transit.targetRank = this->part_.exchange().rank();
    transit.target = target;
    transit.path = this->tracer_.begin(this->targets_[target]);
    if (!transit.path.points.empty())
    {
      this->here_.push_back(std::move(transit));
    }
  }
}

void PathsInTransit::report() const
{
  const double done = this->targets_.empty()
    ? 0.0
    : static_cast<double>(this->finished_) / static_cast<double>(this->targets_.size());
  if (this->options_.progress && !this->options_.progress(FrontDone + (1.0 - FrontDone) * done))
  {
    throw Aborted();
  }
}

void PathsInTransit::run()
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
    std::vector<Message> forwarded = exchange.noMessages();
    for (std::size_t i = 0; i < this->here_.size(); ++i)
    {
      this->send(this->here_[i], outcomes[i], messages, forwarded);
    }
    this->here_.clear();
    least.front() = 1.0;
    for (std::size_t rank = 0; rank < messages.size(); ++rank)
    {
      least.front() = forwarded[rank].empty() ? least.front() : 0.0;
      messages[rank].insert(messages[rank].end(), forwarded[rank].begin(), forwarded[rank].end());
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
          this->here_.push_back(getInTransit(reader, this->part_));
        }
      });
  }
}

PathsInTransit::Outcome PathsInTransit::advance(PathInTransit& transit) const
{
  Outcome outcome;
  try
  {
    for (;;)
    {
      outcome.face = this->tracer_.follow(transit.path);
      if (transit.path.isWhole())
      {
        outcome.status = Status::Whole;
        return outcome;
      }
      if (outcome.face != NoId)
      {
        outcome.rank = this->part_.ownerOf(outcome.face).rank;
        const bool isOnLeg = transit.path.next == TracedPath::Next::BehindExit;
        outcome.face = isOnLeg ? TriangleMesh::faceOf(transit.path.leg.exit) : outcome.face;
        return outcome;
      }
      if (!this->searchAround(transit, outcome))
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
bool PathsInTransit::searchAround(PathInTransit& transit, Outcome& outcome) const
{
  const int self = this->part_.exchange().rank();
  const SurfacePoint& point = transit.path.points.back();
  if (!transit.isSearching)
  {
    transit.isSearching = true;
    transit.nearest = Infinity;
    forEachFace(this->part_.mesh(), point,
      [&](Id face)
      {
        if (face != transit.path.without)
        {
          transit.toAsk.push_back(this->part_.addressOf(face).rank);
        }
      });
    std::sort(transit.toAsk.begin(), transit.toAsk.end());
    transit.toAsk.erase(
      std::unique(transit.toAsk.begin(), transit.toAsk.end()), transit.toAsk.end());
  }
  const auto own = std::find(transit.toAsk.begin(), transit.toAsk.end(), self);
  if (own != transit.toAsk.end())
  {
    transit.toAsk.erase(own);
    const double distance = this->tracer_.searchHere(transit.path);
    const bool isNearer = distance < transit.nearest ||
      (distance == transit.nearest && distance < Infinity && self < transit.nearestRank);
    transit.nearest = isNearer ? distance : transit.nearest;
    transit.nearestRank = isNearer ? self : transit.nearestRank;
  }
  if (transit.toAsk.empty() && !(transit.nearest < Infinity))
  {
    throw PathLost("A shortest path was to be followed through faces whose windows are not known.");
  }
  outcome.rank = transit.toAsk.empty() ? transit.nearestRank : transit.toAsk.front();
  if (outcome.rank != self)
  {
    outcome.face = point.kind == SurfacePoint::Kind::Edge ? TriangleMesh::faceOf(point.id)
                                                          : this->faceOfRank(point, outcome.rank);
    return false;
  }
  transit.isSearching = false;
  this->tracer_.goOnHere(transit.path);
  return true;
}

// A face around a point that a rank owns.
Id PathsInTransit::faceOfRank(const SurfacePoint& point, int rank) const
{
  Id found = NoId;
  forEachFace(this->part_.mesh(), point,
    [&](Id face) { found = this->part_.addressOf(face).rank == rank ? face : found; });
  return found;
}

void PathsInTransit::send(const PathInTransit& transit, const Outcome& outcome,
  std::vector<Message>& reports, std::vector<Message>& forwarded) const
{
  Message& message = reports[static_cast<std::size_t>(transit.targetRank)];
  const TracedPath& path = transit.path;
  put(message, true);
  put(message, transit.target);
  put(message, outcome.status);
  put(message, path.points.size() - transit.told);
  for (std::size_t i = transit.told; i < path.points.size(); ++i)
  {
    put(message, pointInFace(this->part_, path.faces[i], path.points[i]));
  }
  put(message, path.whole);
  put(message, outcome.status == Status::Whole ? this->sourceAtEnd(path) : NoId);
  if (outcome.status == Status::OnItsWay)
  {
    Message& next = forwarded[rankIndex(outcome.rank)];
    put(next, false);
    putInTransit(next, this->part_, transit, outcome.face);
  }
}

// The faces of the source are on the patch.
Id PathsInTransit::sourceAtEnd(const TracedPath& path) const
{
  const Id face = path.faces.back();
  const Id onPatch = this->patch_.faceAt(this->part_.addressOf(face));
  return onPatch == NoId ? NoId
                         : this->curves_.sourceAt(fromBarycentric(this->patch_.mesh(), onPatch,
                             barycentric(this->part_.mesh(), path.points.back(), face)));
}

void PathsInTransit::takeReport(MessageReader& reader)
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
  const MeshPartition& part, const std::vector<SurfacePoint>& targets, RetentionAround& retention)
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
          put(messages[rankIndex(address.rank)], address.id);
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
  const MeshPartition& part = field.surface();
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

std::vector<PathInSpace> pathsOnRanks(const MeshPartition& part, const ReplicatedPatch& patch,
  const std::vector<SourceCurve>& curves, const std::vector<SurfacePoint>& targets,
  const PathsOptions& options)
{
  RetentionAround retention(part.mesh(), targets);
  keepAroundSeams(part, targets, retention);
  FrontOptions frontOptions;
  frontOptions.keepArrivals = true;
  frontOptions.parallelFor = options.parallelFor;
  if (options.progress)
  {
    frontOptions.progress = [&options](double fraction)
    { return options.progress(FrontDone * fraction); };
  }
  FrontResult front =
    propagate(part, sourceWindowsOfPartition(part, patch, makeSourceWindows(patch.mesh(), curves)),
      frontOptions, retention);
  const DistanceField field(part, std::move(front), retention.release());

  PathsInTransit paths(field, patch, curves, targets, options);
  paths.run();
  const KnownDistances known{ field.vertexDistances(),
    part.exchange().largestOf(retention.reach()) };
  const ProgressCallback atEnd = [&options](double)
  { return !options.progress || options.progress(1.0); };
  for (const auto& [target, number] : gatherLost(field, targets, paths.lost()))
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
    paths.paths()[number] = std::move(path);
  }
  return std::move(paths.paths());
}

}
