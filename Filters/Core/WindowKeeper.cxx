// SPDX-License-Identifier: BSD-3-Clause
#include "WindowKeeper.h"

#include "InterpolationError.h"
#include "Tolerance.h"

#include <algorithm>
#include <cmath>

namespace geodesic
{

WindowKeeper::WindowKeeper(
  const TriangleMesh& mesh, double tolerance, const std::vector<std::uint8_t>& wanted)
  : mesh_(mesh)
  , tolerance_(tolerance)
  , state_(mesh.numberOfFaces(), State::Open)
  , above_(mesh.numberOfFaces(), 0.0F)
  , wanting_(mesh.numberOfFaces(), 0)
  , firstRun_(mesh.numberOfFaces(), NoId)
{
  for (Id face = 0; face < mesh.numberOfFaces(); ++face)
  {
    this->forEachNeighbour(face, [this, face](Id) { ++this->wanting_[face]; });
    if (wanted[face])
    {
      this->want(face);
    }
  }
}

// Over the edges; once for each that they share.
template <typename Visit>
void WindowKeeper::forEachNeighbour(Id face, Visit&& visit) const
{
  for (Id side = 3 * face; side < 3 * face + 3; ++side)
  {
    for (Id s = this->mesh_.nextInRing(side); s != side; s = this->mesh_.nextInRing(s))
    {
      visit(TriangleMesh::faceOf(s));
    }
  }
}

void WindowKeeper::want(Id face)
{
  this->state_[face] = State::Curved;
}

std::array<double, 3> WindowKeeper::atCorners(Id face, const AtVertex& distances) const
{
  const Triangle& t = this->mesh_.triangle(face);
  return { distances(t[0]), distances(t[1]), distances(t[2]) };
}

double WindowKeeper::rounding(const std::array<double, 3>& d) const
{
  constexpr double ties = 8.0;
  return ties * tolerance::Tie * std::max({ d[0], d[1], d[2] });
}

void WindowKeeper::take(std::vector<PassedList>& lists, const AtVertex& distances, WindowPool& pool)
{
  for (const PassedList& list : lists)
  {
    const Id face = TriangleMesh::faceOf(list.side);
    const State state = this->state_[face];
    if (state == State::Flat || state == State::Dropped)
    {
      const std::array<double, 3> d = this->atCorners(face, distances);
      const WindowRange windows = list.windows.range();
      const double bound = static_cast<double>(this->above_[face]) + this->rounding(d) +
        belowThroughSide(this->mesh_, list.side, d, { &windows, &windows + 1 });
      if (bound <= this->tolerance_)
      {
        this->flatErrorBound_ = std::max(this->flatErrorBound_, bound);
      }
      else
      {
        this->setCurved(face);
      }
    }
    if (this->state_[face] == State::Dropped)
    {
      pool.free(list.windows);
    }
    else
    {
      this->add(list);
    }
  }
  lists.clear();
}

void WindowKeeper::add(const PassedList& list)
{
  Id index = static_cast<Id>(this->runs_.size());
  if (this->freeRuns_.empty())
  {
    this->runs_.emplace_back();
  }
  else
  {
    index = this->freeRuns_.back();
    this->freeRuns_.pop_back();
  }
  this->runs_[index] = { list, NoId };
  Id* last = &this->firstRun_[TriangleMesh::faceOf(list.side)];
  while (*last != NoId)
  {
    last = &this->runs_[*last].next;
  }
  *last = index;
}

void WindowKeeper::changeCorner(Id vertex)
{
  for (const Id corner : this->mesh_.cornersAt(vertex))
  {
    const Id face = TriangleMesh::faceOf(corner);
    if (this->state_[face] == State::Flat || this->state_[face] == State::Dropped)
    {
      this->setCurved(face);
    }
  }
}

void WindowKeeper::setCurved(Id face)
{
  if (this->state_[face] == State::Dropped)
  {
    this->missed_.push_back(face);
  }
  this->state_[face] = State::Curved;
}

// Late lists come seldom more than an edge behind the front; one that is missed costs a solve.
void WindowKeeper::advance(const std::vector<Id>& settled, double front, const AtVertex& distances,
  const AtVertex& processed, WindowPool& pool)
{
  for (const Id vertex : settled)
  {
    for (const Id corner : this->mesh_.cornersAt(vertex))
    {
      const Id face = TriangleMesh::faceOf(corner);
      if (this->state_[face] != State::Open)
      {
        continue;
      }
      const std::array<double, 3> p = this->atCorners(face, processed);
      const double largest = std::max({ p[0], p[1], p[2] });
      if (largest < Infinity)
      {
        constexpr double edges = 2.0;
        this->state_[face] = State::Awaited;
        this->awaited_.push({ largest + edges * this->mesh_.shape(face).longest(), face });
      }
    }
  }
  while (!this->awaited_.empty() && this->awaited_.top().first < front)
  {
    const Id face = this->awaited_.top().second;
    this->awaited_.pop();
    this->test(face, distances, pool);
  }
}

// From what was told of the lists as they went through.
FaceBounds WindowKeeper::quickBounds(Id face, const std::array<double, 3>& d) const
{
  const double rounding = this->rounding(d);
  std::array<bool, 3> above{};
  for (Id r = this->firstRun_[face]; r != NoId; r = this->runs_[r].next)
  {
    const PassedList& list = this->runs_[r].list;
    const std::size_t k = list.side % 3;
    if (!list.near.below || !(std::abs(list.ends[0] - d[k]) <= rounding) ||
      !(std::abs(list.ends[1] - d[(k + 1) % 3]) <= rounding))
    {
      return {};
    }
    above[k] = above[k] || list.near.above;
  }
  return boundsNearLines(this->mesh_, face, d, above, tolerance::NearLine * this->tolerance_);
}

FaceBounds WindowKeeper::bounds(Id face, const std::array<double, 3>& d, double limit) const
{
  std::array<std::vector<WindowRange>, 3> lists;
  for (Id r = this->firstRun_[face]; r != NoId; r = this->runs_[r].next)
  {
    const PassedList& list = this->runs_[r].list;
    lists[list.side % 3].push_back(list.windows.range());
  }
  std::array<WindowRuns, 3> windows;
  for (std::size_t k = 0; k < 3; ++k)
  {
    windows[k] = WindowRuns(lists[k].data(), lists[k].data() + lists[k].size());
  }
  return boundsOfFace(this->mesh_, face, d, windows, limit);
}

void WindowKeeper::test(Id face, const AtVertex& distances, WindowPool& pool)
{
  if (!this->isOpen(face))
  {
    return;
  }
  this->state_[face] = State::Curved;
  const std::array<double, 3> d = this->atCorners(face, distances);
  const double rounding = this->rounding(d);
  if (!(rounding < this->tolerance_))
  {
    return;
  }
  // Quick bounds are wide: they are enough where they are not what is reported in the end.
  if (this->passes(face, this->quickBounds(face, d), rounding, this->flatErrorBound_) ||
    this->passes(
      face, this->bounds(face, d, this->tolerance_ - rounding), rounding, this->tolerance_))
  {
    this->release(face, pool);
    return;
  }
  // Split once, a face asks of those around it only to be halved.
  const double once = tolerance::SplitOnce * this->tolerance_;
  const FaceBounds wide = this->bounds(face, d, once);
  if (std::max(wide.above, wide.below) + rounding <= once)
  {
    this->release(face, pool);
  }
}

bool WindowKeeper::passes(Id face, const FaceBounds& bounds, double rounding, double limit)
{
  const float above =
    std::nextafter(static_cast<float>(bounds.above), std::numeric_limits<float>::infinity());
  const double bound = static_cast<double>(above) + bounds.below + 2.0 * rounding;
  if (!(bound <= limit))
  {
    return false;
  }
  this->flatErrorBound_ = std::max(this->flatErrorBound_, bound);
  this->above_[face] = above;
  this->state_[face] = State::Flat;
  return true;
}

// The face does not want its neighbours' windows.
void WindowKeeper::release(Id face, WindowPool& pool)
{
  this->drop(face, pool);
  this->forEachNeighbour(face,
    [&](Id neighbour)
    {
      --this->wanting_[neighbour];
      this->drop(neighbour, pool);
    });
}

void WindowKeeper::drop(Id face, WindowPool& pool)
{
  if (this->state_[face] != State::Flat || this->wanting_[face] > 0)
  {
    return;
  }
  this->state_[face] = State::Dropped;
  for (Id r = this->firstRun_[face]; r != NoId; r = this->runs_[r].next)
  {
    pool.free(this->runs_[r].list.windows);
    this->freeRuns_.push_back(r);
  }
  this->firstRun_[face] = NoId;
}

void WindowKeeper::finish(WindowArchive& archive, std::vector<std::uint8_t>& faceKept,
  const AtVertex& distances, WindowPool& pool)
{
  faceKept.assign(this->mesh_.numberOfFaces(), 1);
  for (Id face = 0; face < this->mesh_.numberOfFaces(); ++face)
  {
    if (this->isOpen(face))
    {
      const std::array<double, 3> d = this->atCorners(face, distances);
      if (std::max({ d[0], d[1], d[2] }) < Infinity)
      {
        this->test(face, distances, pool);
      }
    }
  }
  for (Id face = 0; face < this->mesh_.numberOfFaces(); ++face)
  {
    faceKept[face] = this->state_[face] == State::Dropped ? 0 : 1;
    for (Id r = this->firstRun_[face]; r != NoId; r = this->runs_[r].next)
    {
      const PassedList& list = this->runs_[r].list;
      archive.adopt(list.side, list.windows.range());
    }
  }
}

}
