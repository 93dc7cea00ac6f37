// SPDX-License-Identifier: BSD-3-Clause
#include "front/BatchTasks.h"

#include "Tolerance.h"
#include "source/SourceWindows.h"
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

double leastDistance(const WindowRange& windows)
{
  double least = Infinity;
  for (const Window& w : windows)
  {
    least = std::min(least, w.minimum());
  }
  return least;
}

/// Works on items one after another, while the memory of the next ones is prefetched.
///
/// \param work (std::size_t i) -> whether the item is done.
/// \returns the first item that is not done.
template <typename Prefetch, typename Work>
std::size_t workAhead(
  std::size_t first, std::size_t count, const Prefetch& prefetch, const Work& work)
{
  constexpr std::size_t ahead = 4;
  for (std::size_t i = first; i < std::min(first + ahead, count); ++i)
  {
    prefetch(i);
  }
  for (std::size_t i = first; i < count; ++i)
  {
    if (i + ahead < count)
    {
      prefetch(i + ahead);
    }
    if (!work(i))
    {
      return i;
    }
  }
  return count;
}

} // anonymous namespace

void BatchTasks::prefetchFacing(const District& district, Id vertex) const
{
  const Id list = this->vertices_[vertex].facing;
  if (list != NoId)
  {
    this->mesh_.prefetch(TriangleMesh::faceOf(district.lists[list].halfedge));
  }
}

void BatchTasks::processBatch(FrontWorker& worker, District& district, Id batch)
{
  const std::vector<Id>& vertices = district.batch;
  district.done = workAhead(
    district.done, vertices.size(),
    [&](std::size_t i) { this->prefetchFacing(district, vertices[i]); },
    [&](std::size_t i) { return this->processVertex(worker, district, vertices[i], batch); });
  district.isDone = district.done == vertices.size();
}

// Returns whether the vertex is done. If the worker has to pause, the remaining lists stay with the
// vertex.
bool BatchTasks::processVertex(FrontWorker& worker, District& district, Id vertex, Id batch)
{
  const double last = district.schedule.last();
  const double distance = this->vertices_.distance(vertex);
  const bool isReached = distance <= last;
  if (isReached)
  {
    this->settle(worker, district, vertex);
  }
  double next = isReached ? Infinity : distance;
  VertexState& state = this->vertices_[vertex];
  // Stays valid: propagate() only removes lists, which moves none. Lists are added in the second
  // step of the batch alone (receiveLists).
  Id* link = &state.facing;
  while (*link != NoId && !worker.hasToPause())
  {
    WaitingLists::List& list = district.lists[*link];
    if ((list.due < Infinity ? list.due : distance) <= last)
    {
      const Id number = *link;
      *link = list.next;
      this->propagate(worker, district, number, batch);
    }
    else
    {
      next = std::min(next, list.due);
      link = &list.next;
    }
  }
  const bool isDone = *link == NoId;
  if (isDone && isReached)
  {
    state.countTurn();
  }
  if (isDone && next < Infinity)
  {
    district.schedule.add(vertex, next);
  }
  return isDone;
}

// What a vertex does once at each of its distances.
void BatchTasks::settle(FrontWorker& worker, District& district, Id vertex)
{
  VertexState& state = this->vertices_[vertex];
  if (state.isShorter() && !this->isOutsideCorridor(vertex))
  {
    this->relaxEdges(district, vertex);
    if (state.pseudoSource != TriangleMesh::PseudoSource::None)
    {
      this->emitWindows(worker, district, vertex);
    }
  }
  district.settled += state.processed == Infinity ? 1 : 0;
  state.processed = std::min(state.processed, state.distance);
}

// No mail is read before step (2), so an update may go to any district.
void BatchTasks::sendUpdate(District& sender, const DistanceUpdate& update)
{
  this->mailboxes_.to(sender.number, this->districts_.of(update.vertex)).updates.push_back(update);
}

// Distances along edges are upper bounds, which filter windows from the first one on.
void BatchTasks::relaxEdges(District& district, Id vertex)
{
  const double distance = this->vertices_.distance(vertex);
  const double error = this->vertices_.error(vertex);
  const Id number = this->surface_.globalId(vertex);
  const auto relax = [&](Id halfedge, Id other, Id opposite, double x)
  {
    const double along = distance + this->mesh_.length(halfedge);
    if (this->vertices_.isImprovedBy(other, along))
    {
      this->sendUpdate(district, { other, along, error, { opposite, number, x, {} } });
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
    if (!this->isOutgoingBeyond(before, vertex))
    {
      relax(before, this->mesh_.origin(before), corner, 0.0);
    }
  }
}

// Whether another own face has an outgoing halfedge of the vertex on the same edge, where the edge
// is relaxed already.
bool BatchTasks::isOutgoingBeyond(Id halfedge, Id vertex) const
{
  const Id beyond = this->mesh_.nextSibling(halfedge);
  return beyond != halfedge && this->mesh_.origin(beyond) == vertex &&
    this->isOwn(TriangleMesh::faceOf(beyond));
}

// Emits windows into the shadow of a saddle vertex, otherwise everywhere (paper, section 3:
// pseudo-sources).
void BatchTasks::emitWindows(FrontWorker& worker, District& district, Id vertex)
{
  const VertexState& state = this->vertices_[vertex];
  if (state.pseudoSource != TriangleMesh::PseudoSource::Saddle ||
    !findSaddleWedge(this->mesh_, vertex, state.arrival(), worker.emitted))
  {
    worker.emitted.clear();
    for (const Id corner : this->mesh_.cornersAt(vertex))
    {
      worker.emitted.push_back(
        { corner, 0.0, this->mesh_.length(TriangleMesh::nextInFace(corner)) });
    }
  }
  for (const EmittedInterval& interval : worker.emitted)
  {
    this->emitThrough(worker, district, vertex, interval);
  }
}

void BatchTasks::emitThrough(
  FrontWorker& worker, District& district, Id vertex, const EmittedInterval& interval)
{
  const Id halfedge = TriangleMesh::nextInFace(interval.corner);
  const double length = this->mesh_.length(halfedge);
  if (!this->isOwn(TriangleMesh::faceOf(halfedge)) || this->mesh_.isBoundary(halfedge) ||
    !(interval.end - interval.begin > tolerance::LeastWidth * length))
  {
    return;
  }
  Window w = vertexWindow(this->mesh_, interval.corner, this->vertices_.distance(vertex)).window;
  w.begin = length - interval.end;
  w.end = length - interval.begin;
  w.error = this->vertices_.error(vertex);
  w.origin = this->surface_.globalId(vertex);
  const double atBegin = this->vertices_.distance(this->mesh_.destination(halfedge));
  const double atEnd = this->vertices_.distance(this->mesh_.origin(halfedge));
  if (!isBeaten(w, w.end, atBegin + w.end) && !isBeaten(w, w.begin, atEnd + (length - w.begin)))
  {
    this->send(worker, district, halfedge, { &w, &w + 1 });
  }
}

void BatchTasks::propagate(FrontWorker& worker, District& district, Id number, Id batch)
{
  const Id halfedge = district.lists[number].halfedge;
  WindowBlock block = district.lists.remove(number);
  this->mergeNeighboursOf(worker, halfedge, block);
  const WindowRange list = block.range();
  if (list.size() == 0)
  {
    worker.pool.free(block);
    return;
  }
  worker.handled += list.size();
  if (this->vertices_[this->mesh_.opposite(halfedge)].isBusy())
  {
    this->remember(worker, district, halfedge, list);
  }
  UnfoldedFace face = unfold(this->mesh_, halfedge);
  if (this->options_.keepAngles)
  {
    face.findTurns();
  }
  const ApexQuery apex = fullApexQuery(list, face.apex, worker.apexSides);
  const Window& first = *list.begin();
  const Window& last = *(list.end() - 1);
  // The first two are bounds along the halfedge; no shortest path reaches a corner that way.
  const DistanceUpdate found[] = { { this->mesh_.origin(halfedge),
                                     first.distance(first.begin) + first.begin, first.error, {} },
    { this->mesh_.destination(halfedge), last.distance(last.end) + (face.length - last.end),
      last.error, {} },
    { this->mesh_.opposite(halfedge), apex.shortest.distance, apex.shortest.error,
      arrivalThrough(halfedge, apex.shortest) } };
  for (const DistanceUpdate& update : found)
  {
    if (this->vertices_.isImprovedBy(update.vertex, update.distance, update.from.halfedge != NoId))
    {
      this->sendUpdate(district, update);
    }
  }
  const auto known = [&](std::size_t i)
  { return std::min(this->vertices_.distance(found[i].vertex), found[i].distance); };

  const Id left = TriangleMesh::previousInFace(halfedge);
  const Id right = TriangleMesh::nextInFace(halfedge);
  propagateThroughFace(apex, face, { known(0), known(1), known(2) },
    { !this->mesh_.isBoundary(left), !this->mesh_.isBoundary(right) }, this->mostFaces_,
    worker.leaving);
  this->retire(worker, district, { halfedge, block, { known(0), known(1) } }, batch);
  this->send(worker, district, left, worker.leaving.left.range());
  this->send(worker, district, right, worker.leaving.right.range());
}

// Where windows come to a vertex again and again, they are beaten by others that came before. A
// list in a thin face passes at its nearest window's distance, and others may come later.
void BatchTasks::remember(
  FrontWorker& worker, District& district, Id halfedge, const WindowRange& passed) const
{
  const VertexState& apex = this->vertices_[this->mesh_.opposite(halfedge)];
  const bool isAgain = apex.turns >= VertexState::UsualTurns || this->isThin(halfedge);
  if (isAgain && this->isNeededOn(district, halfedge))
  {
    const auto isNeeded = [&](Id other) { return this->isNeededOn(district, other); };
    worker.handled += passed.size();
    district.passed.add(
      halfedge, this->mesh_.length(halfedge), passed, worker.merged, worker.pool, isNeeded);
  }
}

// What comes from now on is no shorter than the key. Where paths by way of the apex are as short
// everywhere on the halfedge, nothing can gain there. The apex is the district's own; another
// district may be shortening the distances of the halfedge's ends.
bool BatchTasks::isNeededOn(const District& district, Id halfedge) const
{
  const double toFartherEnd = std::max(this->mesh_.length(TriangleMesh::nextInFace(halfedge)),
    this->mesh_.length(TriangleMesh::previousInFace(halfedge)));
  return district.schedule.key() <=
    this->vertices_.distance(this->mesh_.opposite(halfedge)) + toFartherEnd;
}

// A list is merged when it is complete and about to enter its face, so each window is merged once
// per face (paper, section 5).
void BatchTasks::mergeNeighboursOf(FrontWorker& worker, Id halfedge, WindowBlock& block) const
{
  if (this->options_.relativeError > 0.0 && block.size > 1)
  {
    const double largest = mergeNeighbours(block, this->mesh_.length(halfedge),
      this->options_.relativeError, this->options_.maximumMerged);
    worker.relativeError = std::max(worker.relativeError, largest);
  }
}

void BatchTasks::send(
  FrontWorker& worker, District& sender, Id halfedge, const WindowRange& windows)
{
  if (windows.size() == 0 || this->isOutsideCorridor(halfedge, windows))
  {
    return;
  }
  for (Id s = this->mesh_.nextSibling(halfedge); s != halfedge; s = this->mesh_.nextSibling(s))
  {
    const WindowBlock block = worker.pool.copyOf(windows);
    worker.handled += windows.size();
    if (this->mesh_.origin(s) != this->mesh_.destination(halfedge))
    {
      const double length = this->mesh_.length(halfedge);
      const Id vertices = this->surface_.numberOfGlobalVertices();
      std::reverse(block.data, block.data + block.size);
      std::transform(block.data, block.data + block.size, block.data,
        [length, vertices](const Window& w) { return reversed(w, length, vertices); });
    }
    std::vector<SentList>& lists = this->isOwn(TriangleMesh::faceOf(s))
      ? this->mailboxes_.to(sender.number, this->districts_.of(this->mesh_.opposite(s))).lists
      : sender.leaving;
    lists.push_back({ s, block });
  }
}

// A point of an edge is at least as far from the target as each end is, less its distance to that
// end. The mean of these two bounds is the same for all points of the edge.
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
    [&](const Window& w) { return w.minimum() + left <= this->longestPath_; });
}

void BatchTasks::shorten(District& district, const DistanceUpdate& update)
{
  const VertexState& state = this->vertices_[update.vertex];
  if (!this->vertices_.shorten(update) || !state.isShorter())
  {
    return;
  }
  if (state.processed < Infinity)
  {
    district.shortened.push_back(update.vertex);
  }
  if (!this->isOutsideCorridor(update.vertex))
  {
    district.schedule.add(update.vertex, this->vertices_.distance(update.vertex));
  }
}

// First the distances of lower ranks, then this rank's, then those of higher ranks. So all ranks
// take them in the same order and choose alike between equal paths.
void BatchTasks::receiveUpdates(District& district)
{
  const auto takeUpdates = [&](MailBatch& mail)
  {
    for (const DistanceUpdate& update : mail.updates)
    {
      this->shorten(district, update);
    }
  };
  takeUpdates(district.fromLower);
  this->mailboxes_.forEach(district.number, takeUpdates);
  takeUpdates(district.fromHigher);
}

void BatchTasks::receiveLists(FrontWorker& worker, District& district)
{
  std::size_t end = 0;
  const auto takeLists = [&](MailBatch& mail)
  {
    const std::size_t begin = end;
    end += mail.lists.size();
    if (district.done >= begin && district.done < end)
    {
      district.done =
        begin + this->receiveFrom(worker, district, mail.lists, district.done - begin);
    }
  };
  this->mailboxes_.forEach(district.number, takeLists);
  takeLists(district.fromHigher);
  district.isDone = district.done == end;
  if (district.isDone)
  {
    district.fromLower.clear();
    district.fromHigher.clear();
    this->mailboxes_.clear(district.number);
  }
}

// Returns the first list that is not done.
std::size_t BatchTasks::receiveFrom(
  FrontWorker& worker, District& district, const std::vector<SentList>& lists, std::size_t first)
{
  return workAhead(
    first, lists.size(),
    [&](std::size_t i) { this->mesh_.prefetch(TriangleMesh::faceOf(lists[i].halfedge)); },
    [&](std::size_t i)
    {
      if (worker.hasToPause())
      {
        return false;
      }
      this->receiveList(worker, district, lists[i]);
      return true;
    });
}

// A list that comes once more is cut by what has passed its halfedge before.
void BatchTasks::cutByPassed(FrontWorker& worker, const District& district, SentList& sent) const
{
  const WindowRange passed = district.passed.at(sent.halfedge);
  if (passed.size() == 0 || !this->isNeededOn(district, sent.halfedge))
  {
    return;
  }
  worker.merged.reset(this->mesh_.length(sent.halfedge));
  for (const Window& window : sent.windows.range())
  {
    worker.merged.appendWhereLower(window, passed);
  }
  worker.handled += passed.size() + sent.windows.size;
  worker.pool.free(sent.windows);
  sent.windows = worker.pool.copyOf(worker.merged.range());
}

// A list waits for the vertex opposite, so that it is complete when it goes through its face. In a
// thin face the vertex may be far from where the windows are, or long behind them. There the list
// goes when the front is as far as its nearest window, as in MMP. Otherwise windows that wait for a
// far vertex are overtaken by longer paths, which they beat later.
void BatchTasks::receiveList(FrontWorker& worker, District& district, SentList sent)
{
  const Id apex = this->mesh_.opposite(sent.halfedge);
  if (this->vertices_[apex].isBusy())
  {
    this->cutByPassed(worker, district, sent);
  }
  if (sent.windows.size == 0)
  {
    worker.pool.free(sent.windows);
    return;
  }
  const ApexDistance found =
    quickApexQuery(sent.windows.range(), apexOf(this->mesh_, sent.halfedge));
  if (this->vertices_.isImprovedBy(apex, found.distance))
  {
    const DistanceUpdate arrival = { apex, found.distance, found.error,
      arrivalThrough(sent.halfedge, found) };
    this->shorten(district, arrival);
    if (this->surface_.isDistributed())
    {
      district.arrivals.push_back(arrival);
    }
  }
  worker.propagated += sent.windows.size;
  worker.handled += sent.windows.size;
  const bool isThin = this->vertices_[apex].hasThinFaces && this->isThin(sent.halfedge);
  double due = isThin ? leastDistance(sent.windows.range()) : this->vertices_.distance(apex);
  Id list = district.lists.find(sent.halfedge);
  if (list != NoId)
  {
    this->mergeInto(worker, district, list, sent.windows);
  }
  else
  {
    Id& facing = this->vertices_[apex].facing;
    list = district.lists.add(sent.halfedge, sent.windows);
    district.lists[list].next = facing;
    facing = list;
  }
  if (isThin)
  {
    due = std::min(due, district.lists[list].due);
    district.lists[list].due = due;
  }
  district.schedule.add(apex, due);
}

void BatchTasks::mergeInto(
  FrontWorker& worker, District& district, Id list, const WindowBlock& block) const
{
  const WindowRange waiting = district.lists[list].windows.range();
  worker.handled += waiting.size();
  worker.merged.reset(this->mesh_.length(district.lists[list].halfedge));
  worker.merged.appendLists(waiting, block.range());
  worker.pool.free(block);
  district.lists.assign(list, worker.merged.range(), worker.pool);
}

void BatchTasks::retire(
  FrontWorker& worker, District& district, const PassedList& list, Id batch) const
{
  if (this->complete_.isLimited() && !this->complete_.isNeededAround(list.halfedge))
  {
    const WindowRange windows = list.windows.range();
    const bool within = std::any_of(windows.begin(), windows.end(),
      [this](const Window& w) { return this->complete_.isWithin(w); });
    if (within)
    {
      district.withinLimit.push_back(list.halfedge);
    }
  }
  this->retention_.pass(district.number, list, batch, worker.pool);
}

}
