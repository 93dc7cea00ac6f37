// SPDX-License-Identifier: BSD-3-Clause
#include "paths/PathsOnRanks.h"

#include "paths/PathInWindows.h"
#include "paths/ShortestWay.h"

#include <algorithm>
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
  this->addFollowed(path, 0, this->paths_.emplace_back(OwnPath{ target }));
}

void PathsOnRanks::follow(const TakePath& take)
{
  followOnRanks<SentPath>(
    this->part_.exchange(), this->job_,
    [this](Questions& questions) { return this->ask(questions); },
    [this](const SentPath& sent) { return this->step(sent); },
    [this](const SentPath& sent, TracedPath& followed, Message& answer)
    { this->tell(sent, followed, answer); },
    [&](std::size_t i, MessageReader& answer) { this->hear(this->paths_[i], answer, take); });
  this->paths_.clear();
}

bool PathsOnRanks::ask(Questions& questions)
{
  this->job_.look();
  bool isAnyOpen = false;
  for (std::size_t i = 0; i < this->paths_.size(); ++i)
  {
    for (const int rank : this->paths_[i].ranks)
    {
      questions.ask(rank, i, this->paths_[i].sent);
      isAnyOpen = true;
    }
  }
  return isAnyOpen;
}

// The path has one point, the last one.
TracedPath PathsOnRanks::step(const SentPath& sent) const
{
  TracedPath path;
  static_cast<PathState&>(path) = sent.state;
  const Id face = this->part_.faceAt(sent.face);
  path.faces = { face };
  path.points = { fromFacePoint(this->part_.mesh(), face, sent.last) };
  path.exit = TriangleMesh::inCopy(path.exit, face);
  path.without = sent.without.rank < 0 ? NoId : this->part_.faceAt(sent.without);
  if (sent.request == Request::FollowShortest)
  {
    continueOnThisRank(this->field_, path);
  }
  if (sent.request != Request::Measure)
  {
    followPath(this->field_, path);
  }
  return path;
}

void PathsOnRanks::tell(const SentPath& sent, TracedPath& followed, Message& answer)
{
  if (sent.request == Request::Measure)
  {
    put(answer, this->part_.exchange().rank());
    put(answer, shortestWayTo(this->field_, followed.points.back(), followed.without).distance);
    return;
  }
  OwnPath path;
  this->addFollowed(followed, 1, path); // the first point came with the question
  put(answer, path.sent);
  put(answer, path.end);
  putAll(answer, path.ranks);
  putAll(answer, path.points);
}

void PathsOnRanks::hear(OwnPath& path, MessageReader& answer, const TakePath& take)
{
  if (path.sent.request == Request::Measure)
  {
    const int rank = answer.get<int>();
    path.measured.push_back({ answer.get<double>(), rank });
    if (path.measured.size() < path.ranks.size())
    {
      return;
    }
    const auto [length, shortest] = *std::min_element(path.measured.begin(), path.measured.end());
    path.measured.clear();
    path.sent.request = Request::FollowShortest;
    path.ranks = { shortest };
    if (length == Infinity)
    {
      path.sent.state.next = Next::Lost; // the windows that it comes through were not kept
    }
  }
  else
  {
    path.sent = answer.get<SentPath>();
    path.end = answer.get<PathEnd>();
    path.ranks = answer.getAll<int>();
    const auto points = answer.getAll<SentPoint>();
    path.points.insert(path.points.end(), points.begin(), points.end());
  }
  if (!path.sent.state.isOnItsWay())
  {
    take(this->found(path));
    path = OwnPath();
  }
}

// Adds what followPath() has found, and who is asked next.
void PathsOnRanks::addFollowed(TracedPath& traced, std::size_t firstPoint, OwnPath& path)
{
  const TriangleMesh& mesh = this->part_.mesh();
  const Id elsewhere = followPath(this->field_, traced);
  for (std::size_t i = firstPoint; i < traced.points.size(); ++i)
  {
    const Id face = traced.faces[i];
    path.points.push_back(
      { this->part_.sentFace(face), toFacePoint(mesh, face, traced.points[i]) });
  }
  path.sent.state = traced;
  if (traced.next == Next::End)
  {
    path.end = endAt(this->feet_.footOf(this->feet_.originOf(traced.piece)), this->feet_,
      this->curves_, traced.whole);
  }
  if (!traced.isOnItsWay())
  {
    return;
  }
  const bool leaves = elsewhere != NoId;
  path.sent.request = leaves ? Request::Follow : Request::Measure;
  path.ranks =
    leaves ? std::vector<int>{ this->part_.ownerOf(elsewhere).rank } : this->ranksAround(traced);
  const Id face = !leaves             ? someFace(mesh, traced.points.back())
    : traced.next == Next::BehindExit ? TriangleMesh::faceOf(traced.exit)
                                      : elsewhere;
  path.sent.face = this->part_.addressOf(face);
  path.sent.last = toFacePoint(mesh, face, traced.points.back());
  path.sent.without =
    traced.without == NoId ? RankAddress{ -1, NoId } : this->part_.addressOf(traced.without);
}

// The ranks that own faces around the last point, each of which has all faces there.
std::vector<int> PathsOnRanks::ranksAround(const TracedPath& path) const
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

PathToSource PathsOnRanks::found(const OwnPath& path) const
{
  PathToSource result;
  result.target = path.target;
  if (path.sent.state.next == Next::End)
  {
    std::vector<SentFace> faces;
    for (const SentPoint& point : path.points)
    {
      faces.push_back(point.face);
    }
    const GatheredFaces gathered(std::move(faces));
    for (const SentPoint& p : path.points)
    {
      result.points.push_back(
        fromFacePoint(gathered.mesh(), gathered.faceAt(p.face.owner), p.point));
    }
    result.points = cleanedPath(gathered.mesh(), result.points, path.sent.state.whole);
    result.end = path.end;
    result.gathered = gathered;
  }
  return result;
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
