// SPDX-License-Identifier: BSD-3-Clause
#include "front/RareLists.h"

#include <algorithm>

namespace geodesic
{

namespace
{

// What comes from now on is no shorter than the key. Where paths by way of the apex are as short
// everywhere on the halfedge, nothing can gain there. The apex is the district's own; another
// district may be shortening the distances of the halfedge's ends.
bool isNeededOn(const FrontContext& front, const District& district, Id halfedge)
{
  const double toFartherEnd = std::max(front.mesh.length(TriangleMesh::nextInFace(halfedge)),
    front.mesh.length(TriangleMesh::previousInFace(halfedge)));
  return district.schedule.key() <=
    front.vertices.distance(front.mesh.opposite(halfedge)) + toFartherEnd;
}

} // anonymous namespace

void reverse(const WindowBlock& windows, double length)
{
  std::reverse(windows.data, windows.data + windows.size);
  std::transform(windows.data, windows.data + windows.size, windows.data,
    [length](const Window& w) { return reversed(w, length); });
}

// A point of an edge is at least as far from the target as each end is, less its distance to that
// end. The mean of these two bounds is the same for all points of the edge.
bool isOutsideCorridor(const FrontContext& front, Id halfedge, const WindowRange& windows)
{
  const Corridor* corridor = front.options.corridor;
  const double atOrigin = corridor->lowerBounds[front.mesh.origin(halfedge)];
  const double atDestination = corridor->lowerBounds[front.mesh.destination(halfedge)];
  const double left = 0.5 * (atOrigin + atDestination - front.mesh.length(halfedge));
  return std::none_of(windows.begin(), windows.end(),
    [&](const Window& w) { return w.minimum() + left <= front.longestPath; });
}

bool isInThinFace(const FrontContext& front, Id halfedge)
{
  return front.mesh.shape(TriangleMesh::faceOf(halfedge)).isThin();
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

void remember(const FrontContext& front, FrontWorker& worker, District& district, Id halfedge,
  const WindowRange& passed)
{
  const VertexState& apex = front.vertices[front.mesh.opposite(halfedge)];
  const bool isAgain =
    apex.timesProcessed >= VertexState::UsualTimes || isInThinFace(front, halfedge);
  if (isAgain && isNeededOn(front, district, halfedge))
  {
    const auto isNeeded = [&](Id other) { return isNeededOn(front, district, other); };
    worker.handled += passed.size();
    district.passed.add(
      halfedge, front.mesh.length(halfedge), passed, worker.merged, worker.pool, isNeeded);
  }
}

void cutByPassed(
  const FrontContext& front, FrontWorker& worker, const District& district, SentList& sent)
{
  const WindowRange passed = district.passed.at(sent.halfedge);
  if (passed.size() == 0 || !isNeededOn(front, district, sent.halfedge))
  {
    return;
  }
  worker.merged.reset(front.mesh.length(sent.halfedge));
  for (const Window& window : sent.windows.range())
  {
    worker.merged.appendWhereLower(window, passed);
  }
  worker.handled += passed.size() + sent.windows.size;
  worker.pool.free(sent.windows);
  sent.windows = worker.pool.copyOf(worker.merged.range());
}

}
