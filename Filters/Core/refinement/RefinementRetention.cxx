// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/RefinementRetention.h"

#include "refinement/InterpolationError.h"
#include "Tolerance.h"

#include <algorithm>
#include <cmath>

namespace geodesic
{

RefinementRetention::RefinementRetention(
  const TriangleMesh& mesh, double tolerance, const std::vector<std::uint8_t>& pinned)
  : mesh_(mesh)
  , tolerance_(tolerance)
  , state_(mesh.numberOfFaces(), State::Open)
  , above_(mesh.numberOfFaces(), 0.0F)
  , neededBy_(mesh.numberOfFaces(), 0)
  , firstRun_(mesh.numberOfFaces(), NoId)
{
  for (Id face = 0; face < mesh.numberOfFaces(); ++face)
  {
    this->forEachNeighbour(face, [this, face](Id) { ++this->neededBy_[face]; });
    if (pinned[face])
    {
      this->state_[face] = State::Kept;
    }
  }
}

// Over the edges; once for each that they share.
template <typename Visit>
void RefinementRetention::forEachNeighbour(Id face, Visit&& visit) const
{
  for (Id halfedge = 3 * face; halfedge < 3 * face + 3; ++halfedge)
  {
    for (Id s = this->mesh_.nextSibling(halfedge); s != halfedge; s = this->mesh_.nextSibling(s))
    {
      visit(TriangleMesh::faceOf(s));
    }
  }
}

void RefinementRetention::start(const std::vector<SourceInFace>& sources)
{
  for (const SourceInFace& source : sources)
  {
    this->state_[source.face] = State::Kept;
  }
}

void RefinementRetention::pass(std::size_t worker, const PassedList& list, Id, WindowPool&)
{
  const NearLine near = nearLine(list.windows.range(), this->mesh_.length(list.halfedge),
    list.ends[0], list.ends[1], tolerance::NearLine * this->tolerance_);
  this->passed_[worker].push_back({ list, near });
}

std::array<double, 3> RefinementRetention::atCorners(Id face, const VertexNumbers& distances) const
{
  const Triangle& t = this->mesh_.triangle(face);
  return { distances(t[0]), distances(t[1]), distances(t[2]) };
}

double RefinementRetention::rounding(const std::array<double, 3>& d) const
{
  constexpr double ties = 8.0;
  return ties * tolerance::Tie * std::max({ d[0], d[1], d[2] });
}

void RefinementRetention::take(std::vector<MeasuredList>& lists, const VertexNumbers& distances, WindowPool& pool)
{
  for (const MeasuredList& measured : lists)
  {
    const PassedList& list = measured.list;
    const Id face = TriangleMesh::faceOf(list.halfedge);
    const State state = this->state_[face];
    if (state == State::Linear || state == State::Dropped)
    {
      const std::array<double, 3> d = this->atCorners(face, distances);
      const WindowRange windows = list.windows.range();
      const double bound = static_cast<double>(this->above_[face]) + this->rounding(d) +
        belowThroughHalfedge(this->mesh_, list.halfedge, d, { &windows, &windows + 1 });
      if (bound <= this->tolerance_)
      {
        this->kept_.droppedErrorBound = std::max(this->kept_.droppedErrorBound, bound);
      }
      else
      {
        this->keep(face);
      }
    }
    if (this->state_[face] == State::Dropped)
    {
      pool.free(list.windows);
    }
    else
    {
      this->add(measured);
    }
  }
  lists.clear();
}

void RefinementRetention::add(const MeasuredList& measured)
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
  this->runs_[index] = { measured, NoId };
  Id* last = &this->firstRun_[TriangleMesh::faceOf(measured.list.halfedge)];
  while (*last != NoId)
  {
    last = &this->runs_[*last].next;
  }
  *last = index;
}

void RefinementRetention::shortenDistance(Id vertex)
{
  for (const Id corner : this->mesh_.cornersAt(vertex))
  {
    const Id face = TriangleMesh::faceOf(corner);
    if (this->state_[face] == State::Linear || this->state_[face] == State::Dropped)
    {
      this->keep(face);
    }
  }
}

void RefinementRetention::keep(Id face)
{
  if (this->state_[face] == State::Dropped)
  {
    this->droppedTooEarly_.push_back(face);
  }
  this->state_[face] = State::Kept;
}

void RefinementRetention::advance(const FrontState& front)
{
  for (std::size_t worker = 0; worker < this->passed_.size(); ++worker)
  {
    this->take(this->passed_[worker], front.distances, *front.pools[worker]);
  }
  for (const Id vertex : front.settled)
  {
    this->awaitFacesAround(vertex, front.processed);
  }
  WindowPool& pool = this->anyPool(front);
  while (!this->awaited_.empty() && this->awaited_.top().first < front.key)
  {
    const Id face = this->awaited_.top().second;
    this->awaited_.pop();
    this->test(face, front.distances, pool);
  }
}

// Late lists come seldom more than an edge behind the front; a face dropped too early costs a solve.
void RefinementRetention::awaitFacesAround(Id vertex, const VertexNumbers& processed)
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

// From what was told of the lists as they went through.
FaceBounds RefinementRetention::quickBounds(Id face, const std::array<double, 3>& d) const
{
  const double rounding = this->rounding(d);
  std::array<bool, 3> above{};
  for (Id r = this->firstRun_[face]; r != NoId; r = this->runs_[r].next)
  {
    const PassedList& list = this->runs_[r].measured.list;
    const NearLine& near = this->runs_[r].measured.near;
    const std::size_t k = list.halfedge % 3;
    if (!near.below || !(std::abs(list.ends[0] - d[k]) <= rounding) ||
      !(std::abs(list.ends[1] - d[(k + 1) % 3]) <= rounding))
    {
      return {};
    }
    above[k] = above[k] || near.above;
  }
  return boundsNearLines(this->mesh_, face, d, above, tolerance::NearLine * this->tolerance_);
}

FaceBounds RefinementRetention::bounds(Id face, const std::array<double, 3>& d, double limit) const
{
  std::array<std::vector<WindowRange>, 3> lists;
  for (Id r = this->firstRun_[face]; r != NoId; r = this->runs_[r].next)
  {
    const PassedList& list = this->runs_[r].measured.list;
    lists[list.halfedge % 3].push_back(list.windows.range());
  }
  std::array<WindowRuns, 3> windows;
  for (std::size_t k = 0; k < 3; ++k)
  {
    windows[k] = WindowRuns(lists[k].data(), lists[k].data() + lists[k].size());
  }
  return boundsOfFace(this->mesh_, face, d, windows, limit);
}

void RefinementRetention::test(Id face, const VertexNumbers& distances, WindowPool& pool)
{
  if (!this->isOpen(face))
  {
    return;
  }
  this->state_[face] = State::Kept;
  const std::array<double, 3> d = this->atCorners(face, distances);
  const double rounding = this->rounding(d);
  if (!(rounding < this->tolerance_))
  {
    return;
  }
  // Quick bounds are wide: they are enough where they are not what is reported in the end.
  if (this->passes(face, this->quickBounds(face, d), rounding, this->kept_.droppedErrorBound) ||
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

bool RefinementRetention::passes(Id face, const FaceBounds& bounds, double rounding, double limit)
{
  const float above =
    std::nextafter(static_cast<float>(bounds.above), std::numeric_limits<float>::infinity());
  const double bound = static_cast<double>(above) + bounds.below + 2.0 * rounding;
  if (!(bound <= limit))
  {
    return false;
  }
  this->kept_.droppedErrorBound = std::max(this->kept_.droppedErrorBound, bound);
  this->above_[face] = above;
  this->state_[face] = State::Linear;
  return true;
}

// The face does not want its neighbours' windows.
void RefinementRetention::release(Id face, WindowPool& pool)
{
  this->drop(face, pool);
  this->forEachNeighbour(face,
    [&](Id neighbour)
    {
      --this->neededBy_[neighbour];
      this->drop(neighbour, pool);
    });
}

void RefinementRetention::drop(Id face, WindowPool& pool)
{
  if (this->state_[face] != State::Linear || this->neededBy_[face] > 0)
  {
    return;
  }
  this->state_[face] = State::Dropped;
  for (Id r = this->firstRun_[face]; r != NoId; r = this->runs_[r].next)
  {
    pool.free(this->runs_[r].measured.list.windows);
    this->freeRuns_.push_back(r);
  }
  this->firstRun_[face] = NoId;
}

void RefinementRetention::finish(const FrontState& front)
{
  for (std::size_t worker = 0; worker < this->passed_.size(); ++worker)
  {
    this->take(this->passed_[worker], front.distances, *front.pools[worker]);
  }
  WindowPool& pool = this->anyPool(front);
  for (Id face = 0; face < this->mesh_.numberOfFaces(); ++face)
  {
    if (this->isOpen(face))
    {
      const std::array<double, 3> d = this->atCorners(face, front.distances);
      if (std::max({ d[0], d[1], d[2] }) < Infinity)
      {
        this->test(face, front.distances, pool);
      }
    }
  }
  this->kept_.faces.assign(this->mesh_.numberOfFaces(), 1);
  for (Id face = 0; face < this->mesh_.numberOfFaces(); ++face)
  {
    this->kept_.faces[face] = this->state_[face] == State::Dropped ? 0 : 1;
    for (Id r = this->firstRun_[face]; r != NoId; r = this->runs_[r].next)
    {
      const PassedList& list = this->runs_[r].measured.list;
      this->kept_.windows.adopt(list.halfedge, list.windows.range());
    }
  }
  for (WindowPool* used : front.pools)
  {
    this->kept_.windows.own(used->release());
  }
  this->kept_.windows.index(this->mesh_.numberOfHalfedges());
  this->kept_.droppedTolerance = this->tolerance_;
}

}
