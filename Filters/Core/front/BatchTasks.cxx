// SPDX-License-Identifier: BSD-3-Clause
#include "front/BatchTasks.h"

#include "Tolerance.h"
#include "window/WindowMerge.h"

#include <algorithm>

namespace geodesic
{

namespace
{

Arrival arrivalThrough(Id halfedge, const ApexDistance& apex)
{
  return { halfedge, apex.origin, apex.crossing, apex.direction, apex.place };
}

} // anonymous namespace

void BatchTasks::prefetchFacing(Id vertex) const
{
  const Id halfedge = this->vertices_[vertex].facing;
  if (halfedge != NoId)
  {
    this->prefetchReceiver(halfedge);
  }
}

void BatchTasks::prefetchReceiver(Id halfedge) const
{
  this->mesh_.prefetch(TriangleMesh::faceOf(halfedge));
  this->waiting_.prefetch(halfedge);
}

void BatchTasks::process(FrontWorker& worker, Id vertex, Id batch)
{
  if (this->vertices_[vertex].isShorter() && !this->isOutsideCorridor(vertex))
  {
    this->relaxEdges(worker, vertex);
    if (this->vertices_[vertex].emission != Emission::Nothing)
    {
      this->emit(worker, vertex);
    }
  }
  for (Id halfedge = this->vertices_[vertex].facing; halfedge != NoId;)
  {
    const Id next = this->waiting_.next(halfedge);
    this->propagate(worker, halfedge, batch);
    halfedge = next;
  }
}

// Distances along edges are upper bounds, which the filter can use from the first window on.
void BatchTasks::relaxEdges(FrontWorker& worker, Id vertex) const
{
  const double distance = this->vertices_.distance(vertex);
  const double error = this->vertices_.error(vertex);
  const Id number = this->numberInWhole(vertex);
  const auto relax = [&](Id halfedge, Id other, Id opposite, double x)
  {
    const double along = distance + this->mesh_.length(halfedge);
    if (this->vertices_.isNews(other, along))
    {
      worker.updates.push_back({ other, along, error, { opposite, number, x, {} } });
    }
  };
  for (const Id corner : this->mesh_.cornersAt(vertex))
  {
    if (!this->isOwn(TriangleMesh::faceOf(corner)))
    {
      continue;
    }
    const Id before = TriangleMesh::previousInFace(corner);
    relax(corner, this->mesh_.destination(corner), before, this->mesh_.length(before));
    relax(before, this->mesh_.origin(before), corner, 0.0);
  }
}

void BatchTasks::emit(FrontWorker& worker, Id vertex) const
{
  const VertexState& state = this->vertices_[vertex];
  findEmittedIntervals(this->mesh_, vertex, state.emission, state.arrival(), worker.emitted);
  for (const EmittedInterval& interval : worker.emitted)
  {
    this->emit(worker, vertex, interval);
  }
}

void BatchTasks::emit(FrontWorker& worker, Id vertex, const EmittedInterval& interval) const
{
  const Id halfedge = TriangleMesh::nextInFace(interval.corner);
  const double length = this->mesh_.length(halfedge);
  if (!this->isOwn(TriangleMesh::faceOf(halfedge)) || this->mesh_.isBoundary(halfedge) ||
    !(interval.end - interval.begin > tolerance::LeastWidth * length))
  {
    return;
  }
  Window w = emittedWindow(this->mesh_, interval, this->vertices_.distance(vertex));
  w.error = this->vertices_.error(vertex);
  w.origin = this->numberInWhole(vertex);
  const double atBegin = this->vertices_.distance(this->mesh_.destination(halfedge));
  const double atEnd = this->vertices_.distance(this->mesh_.origin(halfedge));
  if (!isBeaten(w, w.end, atBegin + w.end) && !isBeaten(w, w.begin, atEnd + (length - w.begin)))
  {
    this->send(worker, halfedge, { &w, &w + 1 });
  }
}

// Sends the list of a halfedge through its face.
void BatchTasks::propagate(FrontWorker& worker, Id halfedge, Id batch) const
{
  this->mergeNeighboursOf(worker, halfedge);
  const WindowRange list = this->waiting_.at(halfedge);
  if (list.size() == 0)
  {
    this->waiting_.clear(halfedge, worker.pool);
    return;
  }
  const UnfoldedFace face = unfold(this->mesh_, halfedge);
  const ApexQuery apex = fullApexQuery(list, face.apex, worker.apexSides);
  const Window& first = *list.begin();
  const Window& last = *(list.end() - 1);
  // Along the halfedge: bounds only, no shortest path comes so to a corner.
  const DistanceUpdate found[] = { { this->mesh_.origin(halfedge),
                                     first.distance(first.begin) + first.begin, first.error, {} },
    { this->mesh_.destination(halfedge), last.distance(last.end) + (face.length - last.end),
      last.error, {} },
    { this->mesh_.opposite(halfedge), apex.shortest.distance, apex.shortest.error,
      arrivalThrough(halfedge, apex.shortest) } };
  for (const DistanceUpdate& update : found)
  {
    if (this->vertices_.isNews(update.vertex, update.distance, update.from.halfedge != NoId))
    {
      worker.updates.push_back(update);
    }
  }
  const auto known = [&](std::size_t i)
  { return std::min(this->vertices_.distance(found[i].vertex), found[i].distance); };

  const Id left = TriangleMesh::previousInFace(halfedge);
  const Id right = TriangleMesh::nextInFace(halfedge);
  propagateThroughFace(apex, face, { known(0), known(1), known(2) },
    { !this->mesh_.isBoundary(left), !this->mesh_.isBoundary(right) }, this->mostFaces_,
    worker.leaving);
  this->retire(worker, halfedge, { known(0), known(1) }, batch);
  this->send(worker, left, worker.leaving.left.range());
  this->send(worker, right, worker.leaving.right.range());
}

// A list is merged when it is complete and about to go on, so that each window is once a face
// (paper, section 5).
void BatchTasks::mergeNeighboursOf(FrontWorker& worker, Id halfedge) const
{
  const WindowRange list = this->waiting_.at(halfedge);
  if (!(this->options_.relativeError > 0.0) || list.size() < 2)
  {
    return;
  }
  const MergedNeighbours merged = mergeNeighbours(this->waiting_.blockAt(halfedge),
    this->mesh_.length(halfedge), this->options_.relativeError, this->options_.maximumMerged);
  worker.relativeError = std::max(worker.relativeError, merged.largest);
  this->waiting_.shorten(halfedge, merged.size);
}

void BatchTasks::send(FrontWorker& worker, Id halfedge, const WindowRange& windows) const
{
  if (windows.size() == 0 || this->isOutsideCorridor(halfedge, windows))
  {
    return;
  }
  for (Id s = this->mesh_.nextSibling(halfedge); s != halfedge; s = this->mesh_.nextSibling(s))
  {
    const WindowBlock block = worker.pool.copyOf(windows);
    if (this->mesh_.origin(s) != this->mesh_.destination(halfedge))
    {
      const double length = this->mesh_.length(halfedge);
      std::reverse(block.data, block.data + block.size);
      std::transform(block.data, block.data + block.size, block.data,
        [length](const Window& w) { return reversed(w, length); });
    }
    worker.sent.push_back({ s, block });
  }
}

// A point of the edge is nearer to one of its ends than its length, and no nearer to the target
// than that end by more than the way.
bool BatchTasks::isOutsideCorridor(Id halfedge, const WindowRange& windows) const
{
  const Corridor* corridor = this->options_.corridor;
  if (corridor == nullptr)
  {
    return false;
  }
  const double atOrigin = corridor->lowerBounds[this->mesh_.origin(halfedge)];
  const double atDestination = corridor->lowerBounds[this->mesh_.destination(halfedge)];
  const double left = 0.5 * (atOrigin + atDestination - this->mesh_.length(halfedge));
  return std::none_of(windows.begin(), windows.end(),
    [&](const Window& w) { return w.minimum() + left <= corridor->length; });
}

void BatchTasks::receive(FrontWorker& worker, const Outbox& outbox, std::size_t group)
{
  const Id halfedge = outbox.halfedge(group);
  const Id apex = this->mesh_.opposite(halfedge);
  const Vec2 position = apexOf(this->mesh_, halfedge);
  (this->waiting_.has(halfedge) ? worker.changedLists : worker.newLists).push_back(halfedge);
  outbox.forEach(group,
    [&](const WindowBlock& block)
    {
      const ApexDistance found = quickApexQuery(block.range(), position);
      if (this->vertices_.isNews(apex, found.distance))
      {
        worker.arrivals.push_back(
          { apex, found.distance, found.error, arrivalThrough(halfedge, found) });
      }
      worker.propagated += block.size;
      this->mergeInto(worker, halfedge, block);
    });
}

void BatchTasks::mergeInto(FrontWorker& worker, Id halfedge, const WindowBlock& block) const
{
  if (!this->waiting_.has(halfedge))
  {
    this->waiting_.adopt(halfedge, block);
    return;
  }
  const WindowRange waiting = this->waiting_.at(halfedge);
  worker.merged.reset(this->mesh_.length(halfedge));
  worker.merged.appendLists(waiting, block.range());
  worker.pool.free(block);
  this->waiting_.assign(halfedge, worker.merged.range(), worker.pool);
}

void BatchTasks::retire(
  FrontWorker& worker, Id halfedge, const std::array<double, 2>& ends, Id batch) const
{
  if (this->complete_.isLimited())
  {
    const WindowRange list = this->waiting_.at(halfedge);
    const bool within = std::any_of(
      list.begin(), list.end(), [this](const Window& w) { return this->complete_.isWithin(w); });
    if (within)
    {
      worker.withinLimit.push_back(halfedge);
    }
  }
  this->retention_.pass(
    worker.number, { halfedge, this->waiting_.release(halfedge), ends }, batch, worker.pool);
}

}
