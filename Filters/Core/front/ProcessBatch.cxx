// SPDX-License-Identifier: BSD-3-Clause
#include "front/ProcessBatch.h"

#include "Tolerance.h"
#include "front/ReceiveMail.h"
#include "source/SourceWindows.h"
#include "window/WindowMerge.h"

#include <algorithm>
#include <functional>

namespace geodesic
{

namespace
{

// The mail is read in the second step of the batch, so an update may go to any district.
void sendUpdate(FrontContext& front, District& sender, const DistanceUpdate& update)
{
  front.mailboxes.to(sender.number, front.districtNumbers.of(update.vertex))
    .updates.push_back(update);
}

// Whether another own face has an outgoing halfedge of the vertex on the same edge, where the edge
// is relaxed already.
bool isOutgoingBeyond(FrontContext& front, Id halfedge, Id vertex)
{
  const Id beyond = front.mesh.nextSibling(halfedge);
  return beyond != halfedge && front.mesh.origin(beyond) == vertex &&
    front.surface.isOwn(TriangleMesh::faceOf(beyond));
}

// Distances along edges are upper bounds, which filter windows from the first one on.
void relaxEdges(FrontContext& front, District& district, Id vertex)
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

void emitThrough(FrontContext& front, FrontWorker& worker, District& district, Id vertex,
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
void emitWindows(FrontContext& front, FrontWorker& worker, District& district, Id vertex)
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
void settle(FrontContext& front, FrontWorker& worker, District& district, Id vertex)
{
  VertexState& state = front.vertices[vertex];
  if (front.vertices.isShorter(state) && !front.isOutsideCorridor(vertex))
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
void mergeNeighboursOf(FrontContext& front, FrontWorker& worker, Id halfedge, WindowBlock& block)
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
CornerDistances tellCorners(FrontContext& front, District& district, Id halfedge,
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
void retire(FrontContext& front, FrontWorker& worker, District& district, const PassedList& list)
{
  if (front.complete.isLimited() && !front.complete.isNeededAround(list.halfedge) &&
    leastDistance(list.windows.range()) <= front.complete.limit())
  {
    district.withinLimit.push_back(list.halfedge);
  }
  front.retention.pass(district.number, list, front.batch.number, worker.pool);
}

// Remembers a list that passes, if others may come to the halfedge and can still gain there. Where
// windows come to a vertex again and again, they are beaten by others that came before. A list in a
// thin face passes at its nearest window's distance, and others may come later.
void remember(FrontContext& front, FrontWorker& worker, District& district, Id halfedge,
  const WindowRange& passed)
{
  const VertexState& apex = front.vertices[front.mesh.opposite(halfedge)];
  if ((apex.isProcessedOften() || front.isInThinFace(halfedge)) && front.canGainOn(halfedge))
  {
    const auto isNeeded = [&front](Id other) { return front.canGainOn(other); };
    district.passed.add(halfedge, front.mesh.length(halfedge), passed, worker.merged, worker.pool,
      std::cref(isNeeded));
  }
}

// A window that comes to a face again ends, as no shortest path crosses a face twice. Within
// rounding, each turn around a tube would also bring corners and edges a shorter way.
void dropReturning(WindowBlock& block, Id face)
{
  Window* const end = block.data + block.size;
  Window* const left =
    std::remove_if(block.data, end, [face](const Window& w) { return w.crossed == face; });
  block.size = static_cast<std::uint32_t>(left - block.data);
}

// Sends a list that has waited through its face, and what leaves the face to the next ones.
void passThroughFace(
  FrontContext& front, FrontWorker& worker, District& district, const HalfedgeList& waited)
{
  const Id halfedge = waited.halfedge;
  WindowBlock block = waited.windows;
  const Id number = front.surface.globalFace(TriangleMesh::faceOf(halfedge));
  dropReturning(block, number);
  mergeNeighboursOf(front, worker, halfedge, block);
  const WindowRange list = block.range();
  if (list.size() == 0)
  {
    worker.pool.free(block);
    return;
  }
  worker.look(front.options.job, list.size());
  if (front.vertices[front.mesh.opposite(halfedge)].isBusy())
  {
    remember(front, worker, district, halfedge, list);
  }
  UnfoldedFace face = unfold(front.mesh, halfedge);
  face.number = number;
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
bool settlesNow(FrontContext& front, const VertexState& state)
{
  return state.distance <= front.batch.last &&
    (state.hasPassed || !(front.options.relativeError > 0.0));
}

// What a vertex that the front has reached does when its lists have passed.
void finishReached(FrontContext& front, District& district, Id vertex)
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

// A vertex that the front has reached settles, and the lists that face it pass through their faces.
// Lists in thin faces pass when they are due, whether or not the front has reached the vertex.
void processVertex(FrontContext& front, FrontWorker& worker, District& district, Id vertex)
{
  const double last = front.batch.last;
  VertexState& state = front.vertices[vertex];
  if (settlesNow(front, state))
  {
    settle(front, worker, district, vertex);
  }
  const bool isReached = state.distance <= last;
  double next = isReached ? Infinity : state.distance;
  const auto passesNow = [&](const WaitingLists::List& list)
  {
    const bool passes = list.due < Infinity ? list.due <= last : isReached;
    next = passes ? next : std::min(next, list.due);
    return passes;
  };
  district.lists.take(state.facing, passesNow, worker.due);
  for (const HalfedgeList& list : worker.due)
  {
    passThroughFace(front, worker, district, list);
  }
  if (isReached)
  {
    finishReached(front, district, vertex);
  }
  if (next < Infinity)
  {
    district.schedule.add(vertex, next);
  }
}

// Fetches the face of the first list that passes for a vertex, if there is one.
void prefetchFacing(const FrontContext& front, const District& district, Id vertex)
{
  const Id group = front.vertices[vertex].facing;
  if (group != NoId)
  {
    front.mesh.prefetch(TriangleMesh::faceOf(district.lists[group].back().halfedge));
  }
}

// Whether no path in the corridor, which there is, passes the windows of a halfedge. A point of an
// edge is at least as far from the target as each end is, less its distance to that end. The mean
// of these two bounds is the same for all points of the edge.
bool isOutsideCorridor(const FrontContext& front, Id halfedge, const WindowRange& windows)
{
  const std::vector<double>& bounds = front.options.corridor->lowerBounds;
  const double atOrigin = bounds[front.mesh.origin(halfedge)];
  const double atDestination = bounds[front.mesh.destination(halfedge)];
  const double left = 0.5 * (atOrigin + atDestination - front.mesh.length(halfedge));
  return leastDistance(windows) + left > front.options.corridor->length;
}

} // anonymous namespace

void processBatch(FrontContext& front, FrontWorker& worker, District& district)
{
  const std::vector<Id>& vertices = district.batch;
  forEachInAdvance(
    vertices.size(), [&](std::size_t i) { prefetchFacing(front, district, vertices[i]); },
    [&](std::size_t i) { processVertex(front, worker, district, vertices[i]); });
}

void sendWindows(
  FrontContext& front, FrontWorker& worker, District& sender, Id halfedge, WindowRange windows)
{
  if (front.options.corridor != nullptr && isOutsideCorridor(front, halfedge, windows))
  {
    return;
  }
  const Id destination = front.mesh.destination(halfedge);
  for (Id s = front.mesh.nextSibling(halfedge); s != halfedge; s = front.mesh.nextSibling(s))
  {
    if (!front.isCovered.empty() && front.isCovered[TriangleMesh::faceOf(s)])
    {
      continue;
    }
    worker.look(front.options.job, windows.size());
    const WindowBlock block = worker.pool.copyOf(windows);
    if (front.mesh.origin(s) != destination)
    {
      reverseAll(block.data, block.data + block.size, front.mesh.length(halfedge));
    }
    std::vector<HalfedgeList>& lists = front.surface.isOwn(TriangleMesh::faceOf(s))
      ? front.mailboxes.to(sender.number, front.districtNumbers.of(front.mesh.opposite(s))).lists
      : sender.toRanks.lists;
    lists.push_back({ s, block });
  }
}

}
