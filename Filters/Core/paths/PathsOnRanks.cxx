// SPDX-License-Identifier: BSD-3-Clause
#include "paths/PathsOnRanks.h"

#include "paths/PathInWindows.h"

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

void PathsOnRanks::add(Id target, const TracedPath& path)
{
  this->paths_.push_back({ target, this->followed(path, 0) });
}

void PathsOnRanks::follow(const TakePath& take)
{
  followOnRanks<SentPath>(
    this->part_.exchange(), this->job_,
    [this](Questions& questions) { return this->ask(questions); },
    [this](const SentPath& sent) { return this->step(sent); },
    [this](Step& step, Message& answer) { this->tell(step, answer); },
    [&](std::size_t i, MessageReader& answer) { this->hear(this->paths_[i], answer, take); });
  this->paths_.clear();
}

bool PathsOnRanks::ask(Questions& questions)
{
  this->job_.look();
  bool isAnyOpen = false;
  for (std::size_t i = 0; i < this->paths_.size(); ++i)
  {
    for (const int rank : this->paths_[i].path.ranks)
    {
      questions.ask(rank, i, this->paths_[i].path.sent);
      isAnyOpen = true;
    }
  }
  return isAnyOpen;
}

// The path has one point, the last one.
PathsOnRanks::Step PathsOnRanks::step(const SentPath& sent) const
{
  Step step;
  TracedPath& path = step.path;
  static_cast<PathState&>(path) = sent.state;
  const Id face = this->part_.faceAt(sent.face);
  path.faces = { face };
  path.points = { fromFacePoint(this->part_.mesh(), face, sent.last) };
  path.exit = TriangleMesh::inCopy(path.exit, face);
  if (path.next == Next::Search)
  {
    step.through = continueOnThisRank(this->field_, path);
  }
  followPath(this->field_, path);
  return step;
}

void PathsOnRanks::tell(const Step& step, Message& answer) const
{
  Followed found = this->followed(step.path, 1); // the first point came with the question
  found.sent.through = step.through;
  put(answer, found.sent);
  put(answer, found.end);
  putAll(answer, found.ranks);
  putAll(answer, found.points);
}

void PathsOnRanks::hear(OwnPath& own, MessageReader& answer, const TakePath& take)
{
  Followed found;
  found.sent = answer.get<SentPath>();
  found.end = answer.get<PathEnd>();
  found.ranks = answer.getAll<int>();
  found.points = answer.getAll<SentPoint>();
  if (own.answers == 0 || found.sent.through < own.next.sent.through)
  {
    own.next = std::move(found);
  }
  if (++own.answers < own.path.ranks.size())
  {
    return;
  }
  own.answers = 0;
  std::vector<SentPoint>& points = own.path.points;
  points.insert(points.end(), own.next.points.begin(), own.next.points.end());
  own.next.points = std::move(points);
  own.path = std::move(own.next);
  if (!own.path.sent.state.isOnItsWay())
  {
    take(this->found(own));
    own = OwnPath();
  }
}

// What has been found of a path in this rank's faces, and who is asked next.
PathsOnRanks::Followed PathsOnRanks::followed(
  const TracedPath& traced, std::size_t firstPoint) const
{
  const TriangleMesh& mesh = this->part_.mesh();
  Followed path;
  for (std::size_t i = firstPoint; i < traced.points.size(); ++i)
  {
    const Id face = traced.faces[i];
    path.points.push_back(
      { this->part_.sentFace(face), toFacePoint(mesh, face, traced.points[i]) });
  }
  path.sent.state = traced;
  if (traced.next == Next::End)
  {
    path.end = endOf(traced, this->feet_, this->curves_);
  }
  if (!traced.isOnItsWay())
  {
    return path;
  }
  const bool leaves = traced.elsewhere != NoId;
  path.ranks = leaves ? std::vector<int>{ this->part_.addressOf(traced.elsewhere).rank }
                      : this->ranksAround(traced);
  const Id face = !leaves             ? someFace(mesh, traced.points.back())
    : traced.next == Next::BehindExit ? TriangleMesh::faceOf(traced.exit)
                                      : traced.elsewhere;
  path.sent.face = this->part_.addressOf(face);
  path.sent.last = toFacePoint(mesh, face, traced.points.back());
  return path;
}

// The ranks that own faces around the last point, each of which has all faces there.
std::vector<int> PathsOnRanks::ranksAround(const TracedPath& path) const
{
  std::vector<int> ranks;
  forEachFace(this->part_.mesh(), path.points.back(),
    [&](Id face) { ranks.push_back(this->part_.addressOf(face).rank); });
  std::sort(ranks.begin(), ranks.end());
  ranks.erase(std::unique(ranks.begin(), ranks.end()), ranks.end());
  return ranks;
}

PathToSource PathsOnRanks::found(const OwnPath& own) const
{
  const Followed& path = own.path;
  PathToSource result;
  result.target = own.target;
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
