// SPDX-License-Identifier: BSD-3-Clause
#include "front/ReceiveMail.h"

#include <algorithm>

namespace geodesic
{

namespace
{

// Merges a list into the one that waits on its halfedge.
void mergeInto(
  FrontContext& front, FrontWorker& worker, WaitingLists::List& waiting, const WindowBlock& block)
{
  worker.look(front.options.job, waiting.windows.size);
  worker.merged.reset(front.mesh.length(waiting.halfedge));
  worker.merged.appendLists(waiting.windows.range(), block.range());
  worker.pool.free(block);
  worker.pool.assign(waiting.windows, worker.merged.range());
}

// Cuts windows where others have passed through the halfedge with shorter paths. Through thin faces
// that meet in a sharp vertex rays may go around it thousands of times, and gain a gap between
// windows each time. They cross a face twice, which no shortest path does: where such a ray comes,
// a path along the edge is shorter. So where lists pass very often, these bounds count, too, from
// all directions.
void cutByPassed(FrontContext& front, FrontWorker& worker, HalfedgeList& list)
{
  const double length = front.mesh.length(list.halfedge);
  const auto passedOn = [&front](Id halfedge) -> const PassedWindows&
  { return front.districtOf(front.mesh.opposite(halfedge)).passed; };
  const auto cut = [&](const WindowRange& bounds)
  { PassedWindows::cut(list, length, bounds, worker.merged, worker.pool); };
  Id halfedge = list.halfedge;
  if (!passedOn(halfedge).findBounds(halfedge, length, worker.bounds))
  {
    cut(passedOn(halfedge).at(halfedge));
    return;
  }
  do
  {
    Window* const begin = worker.bounds.data();
    Window* const end = begin + worker.bounds.size();
    if (front.mesh.origin(halfedge) != front.mesh.origin(list.halfedge))
    {
      reverseAll(begin, end, length);
    }
    cut({ begin, end });
    halfedge = front.mesh.nextSibling(halfedge);
  } while (halfedge != list.halfedge && list.windows.size > 0 &&
    passedOn(halfedge).findBounds(halfedge, length, worker.bounds));
}

// A list waits for the vertex opposite, so that it is complete when it goes through its face. In a
// thin face the vertex may be far from where the windows are, or long behind them. There the list
// goes when the front is as far as its nearest window, as in MMP. Otherwise windows that wait for a
// far vertex are overtaken by longer paths, which they beat later.
void receiveList(FrontContext& front, FrontWorker& worker, District& district, HalfedgeList sent)
{
  const Id apex = front.mesh.opposite(sent.halfedge);
  VertexState& state = front.vertices[apex];
  if (state.isBusy() && front.canGainOn(sent.halfedge))
  {
    cutByPassed(front, worker, sent);
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
    if (front.surface.isDistributed())
    {
      district.toRanks.updates.push_back(arrival);
    }
  }
  worker.propagated += sent.windows.size;
  worker.look(front.options.job, sent.windows.size);
  const bool isThin = state.hasThinFaces && front.isInThinFace(sent.halfedge);
  double due = isThin ? leastDistance(sent.windows.range()) : state.distance;
  WaitingLists::List* waiting = district.lists.find(state.facing, sent.halfedge);
  if (waiting != nullptr)
  {
    mergeInto(front, worker, *waiting, sent.windows);
  }
  else
  {
    waiting = &district.lists.add(state.facing, sent);
  }
  if (isThin)
  {
    due = std::min(due, waiting->due);
    waiting->due = due;
  }
  district.schedule.add(apex, due);
}

// As a part of receiveMail() it is slower: 5 % of a solve within .1 % on a cylinder of strips.
[[gnu::noinline]] void receiveLists(FrontContext& front, FrontWorker& worker, District& district,
  const std::vector<HalfedgeList>& lists)
{
  forEachInAdvance(
    lists.size(),
    [&](std::size_t i) { front.mesh.prefetch(TriangleMesh::faceOf(lists[i].halfedge)); },
    [&](std::size_t i) { receiveList(front, worker, district, lists[i]); });
}

} // anonymous namespace

void receiveMail(FrontContext& front, FrontWorker& worker, District& district)
{
  std::vector<MailBatch*>& inbox = front.mailboxes.inbox(district.number);
  // Distances first: they may make lists needless.
  for (const MailBatch* mail : inbox)
  {
    for (const DistanceUpdate& update : mail->updates)
    {
      acceptUpdate(front, district, update);
    }
  }
  for (MailBatch* mail : inbox)
  {
    receiveLists(front, worker, district, mail->lists);
    mail->clear();
  }
  inbox.clear();
  district.next = district.schedule.outlook();
}

void acceptUpdate(FrontContext& front, District& district, const DistanceUpdate& update)
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
  if (!front.isOutsideCorridor(update.vertex))
  {
    district.schedule.add(update.vertex, state.distance);
  }
}

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

}
