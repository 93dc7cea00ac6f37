// SPDX-License-Identifier: BSD-3-Clause
#include "front/FrontStart.h"

#include "front/ProcessBatch.h"
#include "front/ReceiveMail.h"

#include <algorithm>

namespace geodesic
{

namespace
{

void shorten(FrontContext& front, const DistanceUpdate& update)
{
  acceptUpdate(front, front.districtOf(update.vertex), update);
}

void startVertices(FrontContext& front, const SourceWindows& sources)
{
  for (const Id vertex : sources.vertices)
  {
    // The curve's own wedges already exist.
    front.vertices[vertex].pseudoSource = TriangleMesh::PseudoSource::None;
    shorten(front, { vertex, 0.0, 0.0, {} });
  }
}

// The vertex opposite a halfedge, from a window's source or along an edge from a near vertex.
void startAt(FrontContext& front, const LeavingWindow& to)
{
  const Window& w = to.window;
  const Vec2 apex = apexOf(front.mesh, to.halfedge);
  const bool isStraight = w.origin.isOnCurve();
  shorten(front,
    { front.mesh.opposite(to.halfedge), w.straightDistance(apex), 0.0,
      { to.halfedge, w.origin, isStraight ? w.crossing(apex) : w.sourceX,
        isStraight ? apex - Vec2{ w.sourceX, -w.sourceDepth } : Vec2{}, w.start } });
}

// After all sources: a near vertex with a fan emits into the shadow of the nearest of them.
void startAroundVertices(FrontContext& front, SourceWindows& sources)
{
  // Straight ways first: those by a near vertex may be as short but for rounding.
  const auto isStraight = [](const LeavingWindow& to) { return to.window.origin.isOnCurve(); };
  std::stable_partition(sources.toVertices.begin(), sources.toVertices.end(), isStraight);
  for (const LeavingWindow& to : sources.toVertices)
  {
    startAt(front, to);
  }
  for (const NearVertex& near : sources.nearVertices)
  {
    VertexState& state = front.vertices[near.vertex];
    const bool isNearest = near.hasFan() &&
      near.distance <= state.distance + tolerance::PlaceRounding * front.mesh.length(near.halfedge);
    if (!isNearest)
    {
      // Also vertices on a curve: a segment of a rounding's length may bound a wedge there.
      state.pseudoSource = TriangleMesh::PseudoSource::Irregular;
      continue;
    }
    shorten(front, { near.vertex, near.distance, 0.0, {} });
    state.arrivalHalfedge = near.halfedge;
    state.arrivalX = near.x;
  }
}

void closeCoveredFaces(FrontContext& front, const std::vector<SourceInFace>& sources)
{
  for (const SourceInFace& source : sources)
  {
    if (source.isWholeFace)
    {
      front.isCovered.resize(front.mesh.numberOfFaces(), 0);
      front.isCovered[source.face] = 1;
    }
  }
}

void startFaces(FrontContext& front, FrontOnRanks& ranks, const SourceWindows& sources)
{
  for (const SourceInFace& source : sources.inFaces)
  {
    const Triangle& corners = front.mesh.triangle(source.face);
    const RayOrigin origin = RayOrigin::curveSide(source.curve, false);
    for (std::size_t k = 0; k < 3; ++k)
    {
      const DistanceUpdate found = { corners[k],
        distanceToSource(front.mesh, source, cornerWeights(k)), 0.0, { NoId, origin } };
      shorten(front, found);
      ranks.addUpdate(found);
    }
    if (front.complete.isLimited())
    {
      front.complete.add(source.face);
    }
  }
}

// In the order in which districts send, for any number of them.
void sendFirstWindows(FrontContext& front, FrontWorker& worker, std::vector<LeavingWindow>& windows)
{
  const auto blockOf = [&front](const LeavingWindow& leaving)
  { return front.districtNumbers.blockOf(front.mesh.origin(leaving.halfedge)); };
  std::stable_sort(windows.begin(), windows.end(),
    [&](const LeavingWindow& a, const LeavingWindow& b) { return blockOf(a) < blockOf(b); });
  for (const LeavingWindow& leaving : windows)
  {
    District& sender = front.districtOf(front.mesh.origin(leaving.halfedge));
    sendWindows(front, worker, sender, leaving.halfedge, { &leaving.window, &leaving.window + 1 });
  }
}

} // anonymous namespace

void startFront(
  FrontContext& front, FrontWorker& worker, FrontOnRanks& ranks, SourceWindows& sources)
{
  closeCoveredFaces(front, sources.inFaces);
  closeCoveredFaces(front, sources.inHalo);
  startVertices(front, sources);
  startFaces(front, ranks, sources);
  startAroundVertices(front, sources);
  sendFirstWindows(front, worker, sources.windows);
}

}
