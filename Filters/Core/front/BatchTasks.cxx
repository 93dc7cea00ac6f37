// SPDX-License-Identifier: BSD-3-Clause
#include "front/BatchTasks.h"

#include "Tolerance.h"
#include "front/RareLists.h"
#include "source/SourceWindows.h"
#include "window/WindowMerge.h"

#include <algorithm>

namespace geodesic
{

namespace
{

// Few lists shorten the path to their apex, so only these are asked where their path comes from,
// and only if arrivals are kept, from where it starts and how it is directed.
DistanceUpdate arrivalThrough(
  const BatchTasks& tasks, Id halfedge, Vec2 apex, const ApexDistance& path)
{
  const Window& w = *path.nearest;
  const double x = w.crossing(apex);
  DistanceUpdate update = { tasks.mesh.opposite(halfedge), path.distance, w.error,
    { halfedge, w.origin, x } };
  if (tasks.options.keepArrivals)
  {
    update.from.direction = w.directionTo(apex, x);
    update.from.start = w.startOf({ x, 0.0 });
  }
  return update;
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

/// Whether the known distance shows that no path in the corridor passes the vertex.
bool isOutsideCorridor(const BatchTasks& tasks, Id vertex)
{
  const Corridor* corridor = tasks.options.corridor;
  return corridor != nullptr &&
    tasks.vertices.distance(vertex) + corridor->lowerBounds[vertex] > tasks.longestPath;
}

// No mail is read before step (2), so an update may go to any district.
void sendUpdate(BatchTasks& tasks, District& sender, const DistanceUpdate& update)
{
  tasks.mailboxes.to(sender.number, tasks.districts.of(update.vertex)).updates.push_back(update);
}

// Whether another own face has an outgoing halfedge of the vertex on the same edge, where the edge
// is relaxed already.
bool isOutgoingBeyond(const BatchTasks& tasks, Id halfedge, Id vertex)
{
  const Id beyond = tasks.mesh.nextSibling(halfedge);
  return beyond != halfedge && tasks.mesh.origin(beyond) == vertex &&
    tasks.surface.isOwn(TriangleMesh::faceOf(beyond));
}

// Distances along edges are upper bounds, which filter windows from the first one on.
void relaxEdges(BatchTasks& tasks, District& district, Id vertex)
{
  const double distance = tasks.vertices.distance(vertex);
  const double error = tasks.vertices.error(vertex);
  const RayOrigin origin = RayOrigin::vertex(tasks.surface.globalId(vertex));
  const auto isImproved = [&](Id other, double length)
  { return tasks.vertices.isImprovedBy(other, distance + length); };
  const auto relax = [&](Id other, double length, Id opposite, double x) {
    sendUpdate(tasks, district, { other, distance + length, error, { opposite, origin, x, {} } });
  };
  for (const Id corner : tasks.mesh.cornersAt(vertex))
  {
    const Id face = TriangleMesh::faceOf(corner);
    if (!tasks.surface.isOwn(face))
    {
      continue;
    }
    const Triangle& corners = tasks.mesh.triangle(face);
    const std::array<double, 3>& lengths = tasks.mesh.shape(face).length;
    const Id next = TriangleMesh::nextIndex(corner);
    const Id previous = TriangleMesh::previousIndex(corner);
    const double length = lengths[TriangleMesh::indexInFace(corner)];
    const Id before = TriangleMesh::halfedgeOf(face, previous);
    if (isImproved(corners[next], length))
    {
      relax(corners[next], length, before, lengths[previous]);
    }
    if (isImproved(corners[previous], lengths[previous]) &&
      !isOutgoingBeyond(tasks, before, vertex))
    {
      relax(corners[previous], lengths[previous], corner, 0.0);
    }
  }
}

void emitThrough(BatchTasks& tasks, FrontWorker& worker, District& district, Id vertex,
  const EmittedInterval& interval)
{
  const Id halfedge = TriangleMesh::nextInFace(interval.corner);
  const double length = tasks.mesh.length(halfedge);
  if (!tasks.surface.isOwn(TriangleMesh::faceOf(halfedge)) || tasks.mesh.isBoundary(halfedge) ||
    !(interval.end - interval.begin > tolerance::LeastWidth * length))
  {
    return;
  }
  Window w = vertexWindow(tasks.mesh, interval.corner, tasks.vertices.distance(vertex)).window;
  w.begin = length - interval.end;
  w.end = length - interval.begin;
  w.error = tasks.vertices.error(vertex);
  w.origin = RayOrigin::vertex(tasks.surface.globalId(vertex));
  const double atBegin = tasks.vertices.distance(tasks.mesh.destination(halfedge));
  const double atEnd = tasks.vertices.distance(tasks.mesh.origin(halfedge));
  if (!isBeaten(w, w.end, atBegin + w.end) && !isBeaten(w, w.begin, atEnd + (length - w.begin)))
  {
    tasks.send(worker, district, halfedge, { &w, &w + 1 });
  }
}

// Emits windows into the shadow of a saddle vertex, otherwise everywhere (paper, section 3:
// pseudo-sources).
void emitWindows(BatchTasks& tasks, FrontWorker& worker, District& district, Id vertex)
{
  const VertexState& state = tasks.vertices[vertex];
  if (state.pseudoSource != TriangleMesh::PseudoSource::Saddle ||
    !findSaddleWedge(tasks.mesh, vertex, state.arrival(), worker.emitted))
  {
    worker.emitted.clear();
    for (const Id corner : tasks.mesh.cornersAt(vertex))
    {
      worker.emitted.push_back(
        { corner, 0.0, tasks.mesh.length(TriangleMesh::nextInFace(corner)) });
    }
  }
  for (const EmittedInterval& interval : worker.emitted)
  {
    emitThrough(tasks, worker, district, vertex, interval);
  }
}

// What a vertex does once at each of its distances.
void settle(BatchTasks& tasks, FrontWorker& worker, District& district, Id vertex)
{
  VertexState& state = tasks.vertices[vertex];
  if (state.isShorter() && !isOutsideCorridor(tasks, vertex))
  {
    relaxEdges(tasks, district, vertex);
    if (state.pseudoSource != TriangleMesh::PseudoSource::None)
    {
      emitWindows(tasks, worker, district, vertex);
    }
  }
  district.settled += state.processed == Infinity ? 1 : 0;
  state.processed = std::min(state.processed, state.distance);
}

// A list is merged when it is complete and about to enter its face, so each window is merged once
// per face (paper, section 5).
void mergeNeighboursOf(
  const BatchTasks& tasks, FrontWorker& worker, Id halfedge, WindowBlock& block)
{
  if (tasks.options.relativeError > 0.0 && block.size > 1)
  {
    const double largest = mergeNeighbours(
      block, tasks.mesh.length(halfedge), tasks.options.relativeError, tasks.options.maximumMerged);
    worker.relativeError = std::max(worker.relativeError, largest);
  }
}

// Merging lists may shorten the way to their apex. So within an error, a vertex settles in the
// batch after the one in which they pass, at the distance found meanwhile, also on other ranks.
// Settled at once, every second vertex would settle again.
bool settlesNow(const BatchTasks& tasks, const VertexState& state, double last)
{
  return state.distance <= last && (state.hasPassed || !(tasks.options.relativeError > 0.0));
}

// What a vertex that the front has reached does when its lists have passed.
void finishReached(BatchTasks& tasks, District& district, Id vertex)
{
  VertexState& state = tasks.vertices[vertex];
  if (state.hasPassed)
  {
    state.hasPassed = false;
    return;
  }
  state.countProcessing();
  if (state.isShorter()) // within an error
  {
    state.hasPassed = true;
    district.schedule.addPassed(vertex);
  }
}

// Returns whether the vertex is done. If the worker has to pause, the remaining lists stay with the
// vertex.
bool processVertex(BatchTasks& tasks, FrontWorker& worker, District& district, Id vertex, Id batch)
{
  const double last = district.schedule.last();
  VertexState& state = tasks.vertices[vertex];
  const double distance = state.distance;
  const bool isReached = distance <= last;
  if (settlesNow(tasks, state, last))
  {
    settle(tasks, worker, district, vertex);
  }
  double next = isReached ? Infinity : distance;
  // Where the number of the next list stands: at the vertex, or at a list that goes on waiting.
  // Stays valid: propagate() only removes lists, which moves none. Lists are added in the second
  // step of the batch alone (receiveLists).
  Id* cursor = &state.facing;
  while (*cursor != NoId && !worker.hasToPause())
  {
    WaitingLists::List& list = district.lists[*cursor];
    if ((list.due < Infinity ? list.due : distance) <= last)
    {
      const Id number = *cursor;
      *cursor = list.next;
      tasks.propagate(worker, district, number, batch);
    }
    else
    {
      next = std::min(next, list.due);
      cursor = &list.next;
    }
  }
  const bool isDone = *cursor == NoId;
  if (isDone && isReached)
  {
    finishReached(tasks, district, vertex);
  }
  if (isDone && next < Infinity)
  {
    district.schedule.add(vertex, next);
  }
  return isDone;
}

void mergeInto(const BatchTasks& tasks, FrontWorker& worker, District& district, Id list,
  const WindowBlock& block)
{
  const WindowRange waiting = district.lists[list].windows.range();
  worker.handled += waiting.size();
  worker.merged.reset(tasks.mesh.length(district.lists[list].halfedge));
  worker.merged.appendLists(waiting, block.range());
  worker.pool.free(block);
  district.lists.assign(list, worker.merged.range(), worker.pool);
}

// A list waits for the vertex opposite, so that it is complete when it goes through its face. In a
// thin face the vertex may be far from where the windows are, or long behind them. There the list
// goes when the front is as far as its nearest window, as in MMP. Otherwise windows that wait for a
// far vertex are overtaken by longer paths, which they beat later.
void receiveList(BatchTasks& tasks, FrontWorker& worker, District& district, SentList sent)
{
  const Id apex = tasks.mesh.opposite(sent.halfedge);
  VertexState& state = tasks.vertices[apex];
  if (state.isBusy())
  {
    cutByPassed(tasks, worker, district, sent);
    if (sent.windows.size == 0)
    {
      worker.pool.free(sent.windows);
      return;
    }
  }
  const Vec2 apexAt = apexOf(tasks.mesh, sent.halfedge);
  const ApexDistance found = quickApexQuery(sent.windows.range(), apexAt);
  if (found.nearest != nullptr && tasks.vertices.isImprovedBy(apex, found.distance))
  {
    const DistanceUpdate arrival = arrivalThrough(tasks, sent.halfedge, apexAt, found);
    tasks.shorten(district, arrival);
    district.toRanks.addArrival(arrival);
  }
  worker.propagated += sent.windows.size;
  worker.handled += sent.windows.size;
  const bool isThin = state.hasThinFaces && isInThinFace(tasks, sent.halfedge);
  double due = isThin ? leastDistance(sent.windows.range()) : state.distance;
  // Often no list waits for the vertex, and a look into the table is spared.
  Id list = state.facing == NoId ? NoId : district.lists.find(sent.halfedge);
  if (list != NoId)
  {
    mergeInto(tasks, worker, district, list, sent.windows);
  }
  else
  {
    list = district.lists.add(sent.halfedge, sent.windows, state.facing);
    state.facing = list;
  }
  if (isThin)
  {
    due = std::min(due, district.lists[list].due);
    district.lists[list].due = due;
  }
  district.schedule.add(apex, due);
}

// Returns the first list that is not done.
std::size_t receiveFrom(BatchTasks& tasks, FrontWorker& worker, District& district,
  const std::vector<SentList>& lists, std::size_t first)
{
  return workAhead(
    first, lists.size(),
    [&](std::size_t i) { tasks.mesh.prefetch(TriangleMesh::faceOf(lists[i].halfedge)); },
    [&](std::size_t i)
    {
      if (worker.hasToPause())
      {
        return false;
      }
      receiveList(tasks, worker, district, lists[i]);
      return true;
    });
}

} // anonymous namespace

void BatchTasks::processBatch(FrontWorker& worker, District& district, Id batch)
{
  const std::vector<Id>& batched = district.batch;
  const auto prefetchFacing = [&](std::size_t i)
  {
    const Id list = this->vertices[batched[i]].facing;
    if (list != NoId)
    {
      this->mesh.prefetch(TriangleMesh::faceOf(district.lists[list].halfedge));
    }
  };
  district.done = workAhead(district.done, batched.size(), prefetchFacing,
    [&](std::size_t i) { return processVertex(*this, worker, district, batched[i], batch); });
  district.isDone = district.done == batched.size();
}

void BatchTasks::propagate(FrontWorker& worker, District& district, Id number, Id batch)
{
  const Id halfedge = district.lists[number].halfedge;
  WindowBlock block = district.lists.remove(number);
  mergeNeighboursOf(*this, worker, halfedge, block);
  const WindowRange list = block.range();
  if (list.size() == 0)
  {
    worker.pool.free(block);
    return;
  }
  worker.handled += list.size();
  if (this->vertices[this->mesh.opposite(halfedge)].isBusy())
  {
    remember(*this, worker, district, halfedge, list);
  }
  UnfoldedFace face = unfold(this->mesh, halfedge);
  if (this->options.keepAngles)
  {
    face.findTurns();
  }
  const ApexQuery apex = fullApexQuery(list, face.apex, worker.apexSides);
  const Window& first = *list.begin();
  const Window& last = *(list.end() - 1);
  const Id origin = this->mesh.origin(halfedge);
  const Id destination = this->mesh.destination(halfedge);
  const Id opposite = this->mesh.opposite(halfedge);
  const double toApex = apex.shortest.distance;
  const CornerDistances found = { first.distance(first.begin) + first.begin,
    last.distance(last.end) + (face.length - last.end), toApex };
  // Bounds along the halfedge; no shortest path reaches a corner that way.
  if (this->vertices.isImprovedBy(origin, found.origin, false))
  {
    sendUpdate(*this, district, { origin, found.origin, first.error, {} });
  }
  if (this->vertices.isImprovedBy(destination, found.destination, false))
  {
    sendUpdate(*this, district, { destination, found.destination, last.error, {} });
  }
  if (apex.shortest.nearest != nullptr && this->vertices.isImprovedBy(opposite, toApex))
  {
    sendUpdate(*this, district, arrivalThrough(*this, halfedge, face.apex, apex.shortest));
  }
  const CornerDistances corners = { std::min(this->vertices.distance(origin), found.origin),
    std::min(this->vertices.distance(destination), found.destination),
    std::min(this->vertices.distance(opposite), toApex) };

  const Id left = TriangleMesh::previousInFace(halfedge);
  const Id right = TriangleMesh::nextInFace(halfedge);
  propagateThroughFace(apex, face, corners, this->mostFaces, worker.leaving);
  this->retire(
    worker, district, { halfedge, block, { corners.origin, corners.destination } }, batch);
  if (!worker.leaving.left.windows().empty())
  {
    this->send(worker, district, left, worker.leaving.left.range());
  }
  if (!worker.leaving.right.windows().empty())
  {
    this->send(worker, district, right, worker.leaving.right.range());
  }
}

void BatchTasks::receiveUpdates(District& district)
{
  this->mailboxes.forEach(district.number,
    [&](const MailBatch& mail)
    {
      for (const DistanceUpdate& update : mail.updates)
      {
        this->shorten(district, update);
      }
    });
}

void BatchTasks::receiveLists(FrontWorker& worker, District& district)
{
  std::size_t end = 0;
  this->mailboxes.forEach(district.number,
    [&](const MailBatch& mail)
    {
      const std::size_t begin = end;
      end += mail.lists.size();
      if (district.done >= begin && district.done < end)
      {
        district.done =
          begin + receiveFrom(*this, worker, district, mail.lists, district.done - begin);
      }
    });
  district.isDone = district.done == end;
  if (district.isDone)
  {
    this->mailboxes.clear(district.number);
  }
}

void BatchTasks::shorten(District& district, const DistanceUpdate& update)
{
  const VertexState& state = this->vertices[update.vertex];
  if (!this->vertices.shorten(update) || !state.isShorter())
  {
    return;
  }
  if (state.processed < Infinity)
  {
    district.shortened.push_back(update.vertex);
  }
  if (!isOutsideCorridor(*this, update.vertex))
  {
    district.schedule.add(update.vertex, this->vertices.distance(update.vertex));
  }
}

void BatchTasks::send(FrontWorker& worker, District& sender, Id halfedge, WindowRange windows)
{
  if (this->options.corridor != nullptr && isOutsideCorridor(*this, halfedge, windows))
  {
    return;
  }
  const Id destination = this->mesh.destination(halfedge);
  for (Id s = this->mesh.nextSibling(halfedge); s != halfedge; s = this->mesh.nextSibling(s))
  {
    worker.handled += windows.size();
    const WindowBlock block = worker.pool.copyOf(windows);
    if (this->mesh.origin(s) != destination)
    {
      reverse(block, this->mesh.length(halfedge));
    }
    std::vector<SentList>& lists = this->surface.isOwn(TriangleMesh::faceOf(s))
      ? this->mailboxes.to(sender.number, this->districts.of(this->mesh.opposite(s))).lists
      : sender.toRanks.lists;
    lists.push_back({ s, block });
  }
}

void BatchTasks::retire(
  FrontWorker& worker, District& district, const PassedList& list, Id batch) const
{
  if (this->complete.isLimited() && !this->complete.isNeededAround(list.halfedge))
  {
    const WindowRange windows = list.windows.range();
    const bool within = std::any_of(windows.begin(), windows.end(),
      [this](const Window& w) { return this->complete.isWithin(w); });
    if (within)
    {
      district.withinLimit.push_back(list.halfedge);
    }
  }
  this->retention.pass(district.number, list, batch, worker.pool);
}

}
