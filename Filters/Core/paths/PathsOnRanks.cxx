// SPDX-License-Identifier: BSD-3-Clause
#include "paths/PathsOnRanks.h"

#include "paths/PathInWindows.h"
#include "paths/ShortestWay.h"

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

namespace geodesic
{

namespace
{

using Next = PathState::Next;

/// A target with a face that this rank owns.
TargetOnRank onOwnFace(
  const DistanceField& field, const std::vector<SurfacePoint>& targets, Id number)
{
  const MeshPartition& part = field.surface();
  const TriangleMesh& mesh = part.mesh();
  const SurfacePoint& target = targets[number];
  Id own = NoId;
  forEachFace(mesh, target, [&](Id face) { own = own == NoId && part.isOwn(face) ? face : own; });
  const SurfacePoint inOwn = own != someFace(mesh, target)
    ? fromBarycentric(mesh, own, barycentric(mesh, target, own))
    : target;
  return { part.addressOf(own), toFacePoint(mesh, own, inOwn), field.distance(target), number };
}

} // anonymous namespace

void PathsOnRanks::add(Id target, TracedPath path)
{
  InTransit& transit = this->leaving_.emplace_back();
  transit.targetRank = this->part_.exchange().rank();
  transit.target = target;
  transit.path = std::move(path);
  this->follow(transit);
}

std::vector<PathToSource> PathsOnRanks::handOver()
{
  Exchange& exchange = this->part_.exchange();
  std::vector<Message> messages = exchange.noMessages();
  for (const InTransit& transit : this->leaving_)
  {
    this->putReport(transit, messages[rankIndex(transit.targetRank)]);
    if (transit.path.isOnItsWay())
    {
      Message& next = messages[rankIndex(transit.rank)];
      put(next, false);
      this->putInTransit(transit, next);
    }
  }
  this->leaving_.clear();
  std::vector<PathToSource> arrived;
  readEach(exchange.step(std::move(messages)),
    [&](int, MessageReader& reader)
    {
      const bool isReport = reader.get<bool>();
      if (isReport)
      {
        this->takeReport(reader, arrived);
      }
      else
      {
        this->leaving_.push_back(this->getInTransit(reader));
      }
    });
  this->job_.tasks(
    this->leaving_.size(), [this](std::size_t i) { this->follow(this->leaving_[i]); });
  return arrived;
}

void PathsOnRanks::follow(InTransit& transit) const
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
bool PathsOnRanks::searchAround(InTransit& transit) const
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
    const double length =
      shortestWayTo(this->field_, transit.path.points.back(), transit.path.without).distance;
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
  continueOnThisRank(this->field_, transit.path);
  return true;
}

// The ranks that own faces around the last point, each once.
std::vector<int> PathsOnRanks::ranksToAsk(const TracedPath& path) const
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

void PathsOnRanks::putInTransit(const InTransit& transit, Message& message) const
{
  const TracedPath& path = transit.path;
  put(message, transit.targetRank);
  put(message, transit.target);
  put(message, this->part_.addressOf(transit.face));
  put(message, toFacePoint(this->part_.mesh(), transit.face, path.points.back()));
  put(message, static_cast<const PathState&>(path));
  put(
    message, path.without == NoId ? RankAddress{ -1, NoId } : this->part_.addressOf(path.without));
  putAll(message, transit.toAsk);
  put(message, transit.shortest);
  put(message, transit.rankOfShortest);
}

// The path has one point, the last one.
PathsOnRanks::InTransit PathsOnRanks::getInTransit(MessageReader& reader) const
{
  InTransit transit;
  TracedPath& path = transit.path;
  transit.targetRank = reader.get<int>();
  transit.target = reader.get<Id>();
  const Id face = this->part_.faceAt(reader.get<RankAddress>());
  path.faces = { face };
  path.points = { fromFacePoint(this->part_.mesh(), face, reader.get<FacePoint>()) };
  transit.sent = 1;
  static_cast<PathState&>(path) = reader.get<PathState>();
  path.exit = TriangleMesh::inCopy(path.exit, face);
  const auto without = reader.get<RankAddress>();
  path.without = without.rank < 0 ? NoId : this->part_.faceAt(without);
  transit.toAsk = reader.getAll<int>();
  transit.shortest = reader.get<double>();
  transit.rankOfShortest = reader.get<int>();
  return transit;
}

// What this rank has found of a path.
void PathsOnRanks::putReport(const InTransit& transit, Message& message)
{
  const TracedPath& path = transit.path;
  put(message, true);
  put(message, transit.target);
  put(message, path.next);
  std::vector<SentPoint> points;
  for (std::size_t i = transit.sent; i < path.points.size(); ++i)
  {
    const Id face = path.faces[i];
    points.push_back(
      { this->part_.sentFace(face), toFacePoint(this->part_.mesh(), face, path.points[i]) });
  }
  putAll(message, points);
  put(message, path.whole);
  const Foot foot =
    path.next == Next::End ? this->feet_.footOf(this->feet_.originOf(path.piece)) : Foot();
  put(message, endAt(foot, this->feet_, this->curves_, path.whole));
}

void PathsOnRanks::takeReport(MessageReader& reader, std::vector<PathToSource>& arrived)
{
  const Id target = reader.get<Id>();
  const auto next = reader.get<Next>();
  const auto points = reader.getAll<SentPoint>();
  const auto whole = reader.get<double>();
  const auto end = reader.get<PathEnd>();
  std::vector<SentPoint>& found = this->found_[target];
  found.insert(found.end(), points.begin(), points.end());
  if (next != Next::End && next != Next::Lost)
  {
    return;
  }
  PathToSource path;
  path.target = target;
  if (next == Next::End)
  {
    std::vector<SentFace> faces;
    std::transform(found.begin(), found.end(), std::back_inserter(faces),
      [](const SentPoint& point) { return point.face; });
    const GatheredFaces gathered(std::move(faces));
    for (const SentPoint& p : found)
    {
      path.points.push_back(fromFacePoint(gathered.mesh(), gathered.faceAt(p.face.owner), p.point));
    }
    path.points = cleanedPath(gathered.mesh(), path.points, whole);
    path.end = end;
    path.gathered = gathered;
  }
  arrived.push_back(std::move(path));
  this->found_.erase(target);
}

std::vector<TargetOnRank> gatherTargets(const DistanceField& field,
  const std::vector<SurfacePoint>& targets, const std::vector<Id>& numbers)
{
  std::vector<TargetOnRank> own;
  for (const Id number : numbers)
  {
    own.push_back(onOwnFace(field, targets, number));
  }
  return valuesOfRanks(field.surface().exchange(), own);
}

}
