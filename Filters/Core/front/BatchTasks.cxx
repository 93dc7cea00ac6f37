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

/// A task fetches the memory of so many vertices or lists in advance, so that it does not wait.
constexpr std::size_t ItemsAhead = 4;

// Few lists shorten the path to their apex, so only these are asked where their path comes from,
// and only if arrivals are kept, from where it starts and how it is directed.
DistanceUpdate arrivalThrough(
  const FrontContext& front, Id halfedge, Vec2 apex, const ApexDistance& path)
{
  const Window& w = *path.nearest;
  const double x = w.crossing(apex);
  DistanceUpdate update = { front.mesh.opposite(halfedge), path.distance, w.error,
    { halfedge, w.origin, x } };
  if (front.options.keepArrivals)
  {
    update.from.direction = w.directionTo(apex, x);
    update.from.start = w.startOf({ x, 0.0 });
  }
  return update;
}

/// Whether the known distance shows that no path in the corridor passes the vertex.
bool isOutsideCorridor(const FrontContext& front, Id vertex)
{
  const Corridor* corridor = front.options.corridor;
  return corridor != nullptr &&
    front.vertices.distance(vertex) + corridor->lowerBounds[vertex] > front.longestPath;
}

// No mail is read before step (2), so an update may go to any district.
void sendUpdate(const FrontContext& front, District& sender, const DistanceUpdate& update)
{
  front.mailboxes.to(sender.number, front.districts.of(update.vertex)).updates.push_back(update);
}

// Whether another own face has an outgoing halfedge of the vertex on the same edge, where the edge
// is relaxed already.
bool isOutgoingBeyond(const FrontContext& front, Id halfedge, Id vertex)
{
  const Id beyond = front.mesh.nextSibling(halfedge);
  return beyond != halfedge && front.mesh.origin(beyond) == vertex &&
    front.surface.isOwn(TriangleMesh::faceOf(beyond));
}

// Distances along edges are upper bounds, which filter windows from the first one on.
void relaxEdges(const FrontContext& front, District& district, Id vertex)
{
  const double distance = front.vertices.distance(vertex);
  const double error = front.vertices.error(vertex);
  const RayOrigin origin = RayOrigin::vertex(front.surface.globalId(vertex));
  const auto isImproved = [&](Id other, double length)
  { return front.vertices.isImprovedBy(other, distance + length); };
  const auto relax = [&](Id other, double length, Id opposite, double x) {
    sendUpdate(front, district, { other, distance + length, error, { opposite, origin, x, {} } });
  };
  for (const Id corner : front.mesh.cornersAt(vertex))
  {
    const Id face = TriangleMesh::faceOf(corner);
    if (!front.surface.isOwn(face))
    {
      continue;
    }
    const Triangle& corners = front.mesh.triangle(face);
    const std::array<double, 3>& lengths = front.mesh.shape(face).length;
    const Id next = TriangleMesh::nextIndex(corner);
    const Id previous = TriangleMesh::previousIndex(corner);
    const double length = lengths[TriangleMesh::indexInFace(corner)];
    const Id before = TriangleMesh::halfedgeOf(face, previous);
    if (isImproved(corners[next], length))
    {
      relax(corners[next], length, before, lengths[previous]);
    }
    if (isImproved(corners[previous], lengths[previous]) &&
      !isOutgoingBeyond(front, before, vertex))
    {
      relax(corners[previous], lengths[previous], corner, 0.0);
    }
  }
}

void emitThrough(const FrontContext& front, FrontWorker& worker, District& district, Id vertex,
  const EmittedInterval& interval)
{
  const Id halfedge = TriangleMesh::nextInFace(interval.corner);
  const double length = front.mesh.length(halfedge);
  if (!front.surface.isOwn(TriangleMesh::faceOf(halfedge)) || front.mesh.isBoundary(halfedge) ||
    !(interval.end - interval.begin > tolerance::LeastWidth * length))
  {
    return;
  }
  Window w = vertexWindow(front.mesh, interval.corner, front.vertices.distance(vertex)).window;
  w.begin = length - interval.end;
  w.end = length - interval.begin;
  w.error = front.vertices.error(vertex);
  w.origin = RayOrigin::vertex(front.surface.globalId(vertex));
  const double atBegin = front.vertices.distance(front.mesh.destination(halfedge));
  const double atEnd = front.vertices.distance(front.mesh.origin(halfedge));
  if (!isBeaten(w, w.end, atBegin + w.end) && !isBeaten(w, w.begin, atEnd + (length - w.begin)))
  {
    sendWindows(front, worker, district, halfedge, { &w, &w + 1 });
  }
}

// Emits windows into the shadow of a saddle vertex, otherwise everywhere (paper, section 3:
// pseudo-sources).
void emitWindows(const FrontContext& front, FrontWorker& worker, District& district, Id vertex)
{
  const VertexState& state = front.vertices[vertex];
  if (state.pseudoSource != TriangleMesh::PseudoSource::Saddle ||
    !findSaddleWedge(front.mesh, vertex, state.arrival(), worker.emitted))
  {
    worker.emitted.clear();
    for (const Id corner : front.mesh.cornersAt(vertex))
    {
      worker.emitted.push_back(
        { corner, 0.0, front.mesh.length(TriangleMesh::nextInFace(corner)) });
    }
  }
  for (const EmittedInterval& interval : worker.emitted)
  {
    emitThrough(front, worker, district, vertex, interval);
  }
}

// What a vertex does once at each of its distances.
void settle(const FrontContext& front, FrontWorker& worker, District& district, Id vertex)
{
  VertexState& state = front.vertices[vertex];
  if (front.vertices.isShorter(state) && !isOutsideCorridor(front, vertex))
  {
    relaxEdges(front, district, vertex);
    if (state.pseudoSource != TriangleMesh::PseudoSource::None)
    {
      emitWindows(front, worker, district, vertex);
    }
  }
  district.settled += state.processed == Infinity ? 1 : 0;
  state.processed = std::min(state.processed, state.distance);
}

// A list is merged when it is complete and about to enter its face, so each window is merged once
// per face (paper, section 5).
void mergeNeighboursOf(
  const FrontContext& front, FrontWorker& worker, Id halfedge, WindowBlock& block)
{
  if (front.options.relativeError > 0.0 && block.size > 1)
  {
    const double largest = mergeNeighbours(
      block, front.mesh.length(halfedge), front.options.relativeError, front.options.maximumMerged);
    worker.relativeError = std::max(worker.relativeError, largest);
  }
}

// Sends the distances that a list has for the corners of its face, where they are shorter. Returns
// the corners' distances with these.
CornerDistances tellCorners(const FrontContext& front, District& district, Id halfedge,
  const UnfoldedFace& face, const ApexQuery& apex)
{
  const Window& first = *apex.list.begin();
  const Window& last = *(apex.list.end() - 1);
  const Id origin = front.mesh.origin(halfedge);
  const Id destination = front.mesh.destination(halfedge);
  const Id opposite = front.mesh.opposite(halfedge);
  const CornerDistances found = { first.distance(first.begin) + first.begin,
    last.distance(last.end) + (face.length - last.end), apex.shortest.distance };
  // Bounds along the halfedge; no shortest path reaches a corner that way.
  if (front.vertices.isImprovedBy(origin, found.origin, false))
  {
    sendUpdate(front, district, { origin, found.origin, first.error, {} });
  }
  if (front.vertices.isImprovedBy(destination, found.destination, false))
  {
    sendUpdate(front, district, { destination, found.destination, last.error, {} });
  }
  if (apex.shortest.nearest != nullptr && front.vertices.isImprovedBy(opposite, found.apex))
  {
    sendUpdate(front, district, arrivalThrough(front, halfedge, face.apex, apex.shortest));
  }
  return { std::min(front.vertices.distance(origin), found.origin),
    std::min(front.vertices.distance(destination), found.destination),
    std::min(front.vertices.distance(opposite), found.apex) };
}

// Hands a list that has passed its face to the retention.
void retire(
  const FrontContext& front, FrontWorker& worker, District& district, const PassedList& list)
{
  if (front.complete.isLimited() && !front.complete.isNeededAround(list.halfedge))
  {
    const WindowRange windows = list.windows.range();
    const bool within = std::any_of(
      windows.begin(), windows.end(), [&](const Window& w) { return front.complete.isWithin(w); });
    if (within)
    {
      district.withinLimit.push_back(list.halfedge);
    }
  }
  front.retention.pass(district.number, list, front.batch, worker.pool);
}

// Sends a list that waits through its face, and what leaves the face to the next ones.
void passThroughFace(const FrontContext& front, FrontWorker& worker, District& district, Id number)
{
  const Id halfedge = district.lists[number].halfedge;
  WindowBlock block = district.lists.remove(number);
  mergeNeighboursOf(front, worker, halfedge, block);
  const WindowRange list = block.range();
  if (list.size() == 0)
  {
    worker.pool.free(block);
    return;
  }
  worker.handled += list.size();
  if (front.vertices[front.mesh.opposite(halfedge)].isBusy())
  {
    remember(front, worker, district, halfedge, list);
  }
  UnfoldedFace face = unfold(front.mesh, halfedge);
  if (front.options.keepAngles)
  {
    face.findTurns();
  }
  const ApexQuery apex = fullApexQuery(list, face.apex, worker.apexSides);
  const CornerDistances corners = tellCorners(front, district, halfedge, face, apex);
  propagateThroughFace(apex, face, corners, front.mostFaces, worker.leaving);
  retire(front, worker, district, { halfedge, block, { corners.origin, corners.destination } });
  if (!worker.leaving.left.windows().empty())
  {
    sendWindows(
      front, worker, district, TriangleMesh::previousInFace(halfedge), worker.leaving.left.range());
  }
  if (!worker.leaving.right.windows().empty())
  {
    sendWindows(
      front, worker, district, TriangleMesh::nextInFace(halfedge), worker.leaving.right.range());
  }
}

// Merging lists may shorten the way to their apex. So within an error, a vertex settles in the
// batch after the one in which they pass, at the distance found meanwhile, also on other ranks.
// Settled at once, every second vertex would settle again.
bool settlesNow(const FrontContext& front, const VertexState& state, double last)
{
  return state.distance <= last && (state.hasPassed || !(front.options.relativeError > 0.0));
}

// What a vertex that the front has reached does when its lists have passed.
void finishReached(const FrontContext& front, District& district, Id vertex)
{
  VertexState& state = front.vertices[vertex];
  if (state.hasPassed)
  {
    state.hasPassed = false;
    return;
  }
  state.countProcessing();
  if (front.vertices.isShorter(state)) // within an error
  {
    state.hasPassed = true;
    district.schedule.addPassed(vertex);
  }
}

// Returns whether the vertex is done. If the worker has to pause, the remaining lists stay with the
// vertex.
bool processVertex(const FrontContext& front, FrontWorker& worker, District& district, Id vertex)
{
  const double last = district.schedule.last();
  VertexState& state = front.vertices[vertex];
  const double distance = state.distance;
  const bool isReached = distance <= last;
  if (settlesNow(front, state, last))
  {
    settle(front, worker, district, vertex);
  }
  double next = isReached ? Infinity : distance;
  // Where the number of the next list stands: at the vertex, or at a list that goes on waiting.
  // Stays valid: passThroughFace() only removes lists, which moves none. Lists are added in the
  // second step of the batch alone (receiveLists).
  Id* cursor = &state.facing;
  while (*cursor != NoId && !worker.hasToPause())
  {
    WaitingLists::List& list = district.lists[*cursor];
    if ((list.due < Infinity ? list.due : distance) <= last)
    {
      const Id number = *cursor;
      *cursor = list.next;
      passThroughFace(front, worker, district, number);
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
    finishReached(front, district, vertex);
  }
  if (isDone && next < Infinity)
  {
    district.schedule.add(vertex, next);
  }
  return isDone;
}

// Fetches the face of the first list that waits for vertex i of the batch, if there is one.
void prefetchFacing(const FrontContext& front, const District& district, std::size_t i)
{
  const Id list = i < district.batch.size() ? front.vertices[district.batch[i]].facing : NoId;
  if (list != NoId)
  {
    front.mesh.prefetch(TriangleMesh::faceOf(district.lists[list].halfedge));
  }
}

void mergeInto(const FrontContext& front, FrontWorker& worker, District& district, Id list,
  const WindowBlock& block)
{
  const WindowRange waiting = district.lists[list].windows.range();
  worker.handled += waiting.size();
  worker.merged.reset(front.mesh.length(district.lists[list].halfedge));
  worker.merged.appendLists(waiting, block.range());
  worker.pool.free(block);
  district.lists.assign(list, worker.merged.range(), worker.pool);
}

// A list waits for the vertex opposite, so that it is complete when it goes through its face. In a
// thin face the vertex may be far from where the windows are, or long behind them. There the list
// goes when the front is as far as its nearest window, as in MMP. Otherwise windows that wait for a
// far vertex are overtaken by longer paths, which they beat later.
void receiveList(const FrontContext& front, FrontWorker& worker, District& district, SentList sent)
{
  const Id apex = front.mesh.opposite(sent.halfedge);
  VertexState& state = front.vertices[apex];
  if (state.isBusy())
  {
    cutByPassed(front, worker, district, sent);
    if (sent.windows.size == 0)
    {
      worker.pool.free(sent.windows);
      return;
    }
  }
  const Vec2 apexAt = apexOf(front.mesh, sent.halfedge);
  const ApexDistance found = quickApexQuery(sent.windows.range(), apexAt);
  if (found.nearest != nullptr && front.vertices.isImprovedBy(apex, found.distance))
  {
    const DistanceUpdate arrival = arrivalThrough(front, sent.halfedge, apexAt, found);
    acceptUpdate(front, district, arrival);
    district.toRanks.addArrival(arrival);
  }
  worker.propagated += sent.windows.size;
  worker.handled += sent.windows.size;
  const bool isThin = state.hasThinFaces && isInThinFace(front, sent.halfedge);
  double due = isThin ? leastDistance(sent.windows.range()) : state.distance;
  // Often no list waits for the vertex, and a look into the table is spared.
  Id list = state.facing == NoId ? NoId : district.lists.find(sent.halfedge);
  if (list != NoId)
  {
    mergeInto(front, worker, district, list, sent.windows);
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
std::size_t receiveFrom(const FrontContext& front, FrontWorker& worker, District& district,
  const std::vector<SentList>& lists, std::size_t first)
{
  const auto prefetch = [&](std::size_t i)
  {
    if (i < lists.size())
    {
      front.mesh.prefetch(TriangleMesh::faceOf(lists[i].halfedge));
    }
  };
  for (std::size_t i = 0; i < ItemsAhead; ++i)
  {
    prefetch(first + i);
  }
  for (std::size_t i = first; i < lists.size(); ++i)
  {
    prefetch(i + ItemsAhead);
    if (worker.hasToPause())
    {
      return i;
    }
    receiveList(front, worker, district, lists[i]);
  }
  return lists.size();
}

} // anonymous namespace

void processBatch(const FrontContext& front, FrontWorker& worker, District& district)
{
  const std::vector<Id>& vertices = district.batch;
  for (std::size_t i = 0; i < ItemsAhead; ++i)
  {
    prefetchFacing(front, district, district.done + i);
  }
  for (; district.done < vertices.size(); ++district.done)
  {
    prefetchFacing(front, district, district.done + ItemsAhead);
    if (!processVertex(front, worker, district, vertices[district.done]))
    {
      break;
    }
  }
  district.isDone = district.done == vertices.size();
}

void receiveUpdates(const FrontContext& front, District& district)
{
  front.mailboxes.forEach(district.number,
    [&](const MailBatch& mail)
    {
      for (const DistanceUpdate& update : mail.updates)
      {
        acceptUpdate(front, district, update);
      }
    });
}

void receiveLists(const FrontContext& front, FrontWorker& worker, District& district)
{
  std::size_t end = 0;
  front.mailboxes.forEach(district.number,
    [&](const MailBatch& mail)
    {
      const std::size_t begin = end;
      end += mail.lists.size();
      if (district.done >= begin && district.done < end)
      {
        district.done =
          begin + receiveFrom(front, worker, district, mail.lists, district.done - begin);
      }
    });
  district.isDone = district.done == end;
  if (district.isDone)
  {
    front.mailboxes.clear(district.number);
    front.outlooks[district.number] = district.schedule.outlook();
  }
}

void acceptUpdate(const FrontContext& front, District& district, const DistanceUpdate& update)
{
  const VertexState& state = front.vertices[update.vertex];
  if (!front.vertices.shorten(update) || !front.vertices.isShorter(state))
  {
    return;
  }
  if (state.processed < Infinity)
  {
    district.shortened.push_back(update.vertex);
  }
  if (!isOutsideCorridor(front, update.vertex))
  {
    district.schedule.add(update.vertex, front.vertices.distance(update.vertex));
  }
}

void sendWindows(const FrontContext& front, FrontWorker& worker, District& sender, Id halfedge,
  WindowRange windows)
{
  if (front.options.corridor != nullptr && isOutsideCorridor(front, halfedge, windows))
  {
    return;
  }
  const Id destination = front.mesh.destination(halfedge);
  for (Id s = front.mesh.nextSibling(halfedge); s != halfedge; s = front.mesh.nextSibling(s))
  {
    worker.handled += windows.size();
    const WindowBlock block = worker.pool.copyOf(windows);
    if (front.mesh.origin(s) != destination)
    {
      reverse(block, front.mesh.length(halfedge));
    }
    std::vector<SentList>& lists = front.surface.isOwn(TriangleMesh::faceOf(s))
      ? front.mailboxes.to(sender.number, front.districts.of(front.mesh.opposite(s))).lists
      : sender.toRanks.lists;
    lists.push_back({ s, block });
  }
}

}
