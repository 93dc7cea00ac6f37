// SPDX-License-Identifier: BSD-3-Clause
#include "paths/PathsToSource.h"

#include "Errors.h"
#include "field/RetentionAround.h"
#include "mesh/ReplicatedPatch.h"
#include "paths/PathInStrip.h"
#include "paths/PathInWindows.h"
#include "paths/PathTracer.h"
#include "source/SourceWindows.h"

#include <algorithm>
#include <map>
#include <string>
#include <tuple>
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

/// A point of a path, and a face that holds it and the point before.
struct SentPathPoint
{
  SentFace face;
  FacePoint point;
};

using Next = PathState::Next;

/// A path on its way over ranks.
struct PathInTransit
{
  /// The rank that asks for it, and which of that rank's targets it begins at.
  int targetRank = 0;
  Id target = 0;
  TracedPath path;
  /// How many of the points at hand have been sent to the target's rank.
  std::size_t sent = 0;
  /// While the path searches around an edge: the ranks that were not yet asked, and of those that
  /// were the one through whose faces the path is shortest, the lowest of several.
  std::vector<int> toAsk;
  double shortest = Infinity;
  int rankOfShortest = 0;
  /// On its way: the rank that it goes to, and a face of both ranks that holds its last point and,
  /// if it goes on behind an exit, the exit.
  int rank = 0;
  Id face = NoId;
};

void putInTransit(Message& message, const MeshPartition& part, const PathInTransit& transit)
{
  const TracedPath& path = transit.path;
  put(message, transit.targetRank);
  put(message, transit.target);
  put(message, part.addressOf(transit.face));
  put(message, toFacePoint(part.mesh(), transit.face, path.points.back()));
  put(message, static_cast<const PathState&>(path));
  put(message, path.without == NoId ? RankAddress{ -1, NoId } : part.addressOf(path.without));
  putAll(message, transit.toAsk);
  put(message, transit.shortest);
  put(message, transit.rankOfShortest);
}

/// The path has one point, the last one.
PathInTransit getInTransit(MessageReader& reader, const MeshPartition& part)
{
  PathInTransit transit;
  TracedPath& path = transit.path;
  transit.targetRank = reader.get<int>();
  transit.target = reader.get<Id>();
  const Id face = part.faceAt(reader.get<RankAddress>());
  path.faces = { face };
  path.points = { fromFacePoint(part.mesh(), face, reader.get<FacePoint>()) };
  transit.sent = 1;
  static_cast<PathState&>(path) = reader.get<PathState>();
  path.exit = TriangleMesh::inCopy(path.exit, face);
  const auto without = reader.get<RankAddress>();
  path.without = without.rank < 0 ? NoId : part.faceAt(without);
  transit.toAsk = reader.getAll<int>();
  transit.shortest = reader.get<double>();
  transit.rankOfShortest = reader.get<int>();
  return transit;
}

/// Follows paths over ranks. In one process none ever leaves.
class PathFinder
{
public:
  PathFinder(const DistanceField& field, const PathEnds& ends,
    const std::vector<SurfacePoint>& targets, const Job& job, const TakePath& take)
    : field_(field)
    , part_(field.surface())
    , ends_(ends)
    , targets_(targets)
    , job_(job)
    , take_(take)
  {
  }

  /// All ranks together, until all paths are at their ends or lost.
  void run()
  {
    this->traceOwn();
    while (this->part_.exchange().isTrueAnywhere(!this->leaving_.empty()))
    {
      this->job_.reach(TracingDone);
      this->handOver();
    }
  }

  /// \returns the targets of all ranks whose paths got lost, in one order.
  std::vector<TargetOnRank> gatherLost()
  {
    std::sort(this->lost_.begin(), this->lost_.end());
    Message message;
    for (const Id number : this->lost_)
    {
      put(message, this->onOwnFace(number));
    }
    std::vector<TargetOnRank> all;
    readEach(this->part_.exchange().tellAll(message),
      [&](int, MessageReader& reader) { all.push_back(reader.get<TargetOnRank>()); });
    return all;
  }

private:
  void traceOwn()
  {
    const std::size_t count = this->targets_.size();
    const Job tracing = this->job_.part(FrontDone, TracingDone);
    for (std::size_t first = 0; first < count; first += PathsAtATime)
    {
      tracing.reach(static_cast<double>(first) / static_cast<double>(count));
      std::vector<PathInTransit> paths(std::min(PathsAtATime, count - first));
      tracing.tasks(paths.size(),
        [&](std::size_t i) { paths[i] = this->traceFrom(static_cast<Id>(first + i)); });
      for (PathInTransit& transit : paths)
      {
        if (transit.path.isOnItsWay())
        {
          this->leaving_.push_back(std::move(transit));
        }
        else
        {
          this->noteIfLost(transit.target, transit.path.next);
        }
      }
    }
  }

  // Most paths end here: they need no message.
  PathInTransit traceFrom(Id target) const
  {
    PathInTransit transit;
    TracedPath& path = transit.path;
    transit.targetRank = this->part_.exchange().rank();
    transit.target = target;
    path = beginPath(this->field_, this->targets_[target]);
    this->follow(transit);
    if (path.next == Next::End && !path.points.empty())
    {
      const std::vector<SurfacePoint> points = std::move(path.points);
      this->take(target, this->part_.mesh(), points, path.whole,
        [this](Id face) { return this->part_.addressOf(face); });
    }
    return transit;
  }

  void noteIfLost(Id target, Next next)
  {
    if (next == Next::Lost)
    {
      this->lost_.push_back(target);
    }
  }

  void take(Id target, const TriangleMesh& mesh, const std::vector<SurfacePoint>& path,
    double length, const std::function<RankAddress(Id)>& addressOf) const
  {
    const std::vector<SurfacePoint> points = cleanedPath(mesh, path, length);
    this->take_(target, { mesh, points, addressOf, this->ends_.of(mesh, points, addressOf) });
  }

  // Sends the paths that leave to the ranks where they go on, and follows those that come.
  void handOver()
  {
    Exchange& exchange = this->part_.exchange();
    std::vector<Message> messages = exchange.noMessages();
    for (const PathInTransit& transit : this->leaving_)
    {
      this->putReport(transit, messages[rankIndex(transit.targetRank)]);
      if (transit.path.isOnItsWay())
      {
        Message& next = messages[rankIndex(transit.rank)];
        put(next, false);
        putInTransit(next, this->part_, transit);
      }
    }
    this->leaving_.clear();
    readEach(exchange.step(std::move(messages)),
      [this](int, MessageReader& reader)
      {
        const bool isReport = reader.get<bool>();
        if (isReport)
        {
          this->takeReport(reader);
        }
        else
        {
          this->leaving_.push_back(getInTransit(reader, this->part_));
        }
      });
    this->job_.tasks(
      this->leaving_.size(), [this](std::size_t i) { this->follow(this->leaving_[i]); });
  }

  void follow(PathInTransit& transit) const
  {
    do
    {
      const Id elsewhere = followPath(this->field_, transit.path);
      if (elsewhere != NoId)
      {
        const bool isAtExit = transit.path.next == Next::BehindExit;
        transit.rank = this->part_.ownerOf(elsewhere).rank;
        transit.face = isAtExit ? TriangleMesh::faceOf(transit.path.exit) : elsewhere;
        return;
      }
    } while (transit.path.isOnItsWay() && this->searchAround(transit));
  }

  // Asks the ranks around the last point, each of which has all faces there, one after another.
  // Then goes on where the path is shortest. Returns whether that is here.
  bool searchAround(PathInTransit& transit) const
  {
    const int self = this->part_.exchange().rank();
    if (transit.toAsk.empty() && transit.shortest == Infinity)
    {
      transit.toAsk = this->ranksToAsk(transit.path);
    }
    const auto own = std::find(transit.toAsk.begin(), transit.toAsk.end(), self);
    if (own != transit.toAsk.end())
    {
      transit.toAsk.erase(own);
      const double length = lengthThroughHere(this->field_, transit.path);
      if (std::tie(length, self) < std::tie(transit.shortest, transit.rankOfShortest))
      {
        transit.shortest = length;
        transit.rankOfShortest = self;
      }
    }
    if (transit.toAsk.empty() && transit.shortest == Infinity)
    {
      transit.path.next = Next::Lost; // the windows that it comes through were not kept
      return false;
    }
    transit.rank = transit.toAsk.empty() ? transit.rankOfShortest : transit.toAsk.front();
    if (transit.rank != self)
    {
      transit.face = someFace(this->part_.mesh(), transit.path.points.back());
      return false;
    }
    transit.shortest = Infinity;
    goOnThroughHere(this->field_, transit.path);
    return true;
  }

  // The ranks that own faces around the last point, each once.
  std::vector<int> ranksToAsk(const TracedPath& path) const
  {
    std::vector<int> ranks;
    forEachFace(this->part_.mesh(), path.points.back(),
      [&](Id face)
      {
        if (face != path.without)
        {
          ranks.push_back(this->part_.addressOf(face).rank);
        }
      });
    std::sort(ranks.begin(), ranks.end());
    ranks.erase(std::unique(ranks.begin(), ranks.end()), ranks.end());
    return ranks;
  }

  // What this rank has found of a path.
  void putReport(const PathInTransit& transit, Message& message) const
  {
    const TracedPath& path = transit.path;
    put(message, true);
    put(message, transit.target);
    put(message, path.next);
    std::vector<SentPathPoint> points;
    for (std::size_t i = transit.sent; i < path.points.size(); ++i)
    {
      const Id face = path.faces[i];
      points.push_back(
        { this->part_.sentFace(face), toFacePoint(this->part_.mesh(), face, path.points[i]) });
    }
    putAll(message, points);
    put(message, path.whole);
  }

  void takeReport(MessageReader& reader)
  {
    const Id target = reader.get<Id>();
    const auto next = reader.get<Next>();
    const auto points = reader.getAll<SentPathPoint>();
    const auto whole = reader.get<double>();
    std::vector<SentPathPoint>& found = this->found_[target];
    found.insert(found.end(), points.begin(), points.end());
    if (next == Next::End)
    {
      this->takeGathered(target, found, whole);
    }
    this->noteIfLost(target, next);
    if (next == Next::End || next == Next::Lost)
    {
      this->found_.erase(target);
    }
  }

  void takeGathered(Id target, const std::vector<SentPathPoint>& found, double length) const
  {
    std::vector<SentFace> sent;
    for (const SentPathPoint& p : found)
    {
      sent.push_back(p.face);
    }
    const GatheredFaces faces(std::move(sent));
    std::vector<SurfacePoint> path;
    for (const SentPathPoint& p : found)
    {
      path.push_back(fromFacePoint(faces.mesh(), faces.faceAt(p.face.owner), p.point));
    }
    this->take(
      target, faces.mesh(), path, length, [&faces](Id face) { return faces.ownerOf(face); });
  }

  TargetOnRank onOwnFace(Id number) const
  {
    const TriangleMesh& mesh = this->part_.mesh();
    const SurfacePoint& target = this->targets_[number];
    Id own = NoId;
    forEachFace(
      mesh, target, [&](Id face) { own = own == NoId && this->part_.isOwn(face) ? face : own; });
    const SurfacePoint inOwn = own != someFace(mesh, target)
      ? fromBarycentric(mesh, own, barycentric(mesh, target, own))
      : target;
    return { this->part_.addressOf(own), toFacePoint(mesh, own, inOwn),
      this->field_.distance(target), number };
  }

  const DistanceField& field_;
  const MeshPartition& part_;
  const PathEnds& ends_;
  const std::vector<SurfacePoint>& targets_;
  const Job& job_;
  const TakePath& take_;
  /// Those that go on from this rank, or whose ends it sends to their targets' ranks.
  std::vector<PathInTransit> leaving_;
  /// For targets of this rank, the points found so far of a path that has left this rank; and the
  /// targets whose paths got lost.
  std::map<Id, std::vector<SentPathPoint>> found_;
  std::vector<Id> lost_;
};

} // anonymous namespace

void pathsToSource(const MeshPartition& part, const ReplicatedPatch& patch,
  const std::vector<SourceCurve>& curves, const std::vector<SurfacePoint>& targets, const Job& job,
  const TakePath& take)
{
  RetentionAround retention(part.mesh(), targets);
  retention.keepForPaths(part);
  FrontOptions frontOptions;
  frontOptions.keepArrivals = true;
  frontOptions.job = job.part(0.0, FrontDone);
  FrontResult front = propagate(part,
    sourceWindowsOfPartition(part, patch, startingWindows(patch.mesh(), curves, frontOptions.job)),
    frontOptions, retention);
  const DistanceField field(part, std::move(front), retention.release());

  const PathEnds ends(patch, curves);
  PathFinder paths(field, ends, targets, job, take);
  paths.run();

  const KnownDistances known{ field.vertexDistances(),
    part.exchange().largestOf(retention.reach()) };
  const std::vector<TargetOnRank> lost = paths.gatherLost();
  for (std::size_t i = 0; i < lost.size(); ++i)
  {
    const double done = static_cast<double>(i) / static_cast<double>(lost.size());
    const double fraction = TracingDone + (1.0 - TracingDone) * done;
    job.reach(fraction);
    pathInStrip(part, patch, curves, ends, lost[i], known, job.part(fraction, fraction),
      [&](const PathToSource& path)
      {
        if (path.points.empty())
        {
          throw Error("The shortest path from target " + std::to_string(lost[i].number) +
            " could not be followed. Please report this with the surface, the source and the "
            "targets.");
        }
        take(lost[i].number, path);
      });
  }
}

}
