// SPDX-License-Identifier: BSD-3-Clause
#include "contours/IsolinesOnRanks.h"

#include <algorithm>
#include <utility>

namespace geodesic
{

void exchangeEdgePoints(const MeshPartition& part, std::vector<EdgePoint>& points)
{
  if (!part.isDistributed())
  {
    return;
  }
  std::vector<Message> messages = part.exchange().noMessages();
  for (const EdgePoint& p : points)
  {
    for (const int rank : part.otherRanksAt(p.halfedge))
    {
      put(messages[rankIndex(rank)], p);
    }
  }
  readEach(part.exchange().step(std::move(messages)),
    [&](int rank, MessageReader& reader)
    {
      auto p = reader.get<EdgePoint>();
      const Id face = part.faceAt({ rank, TriangleMesh::faceOf(p.halfedge) });
      p.halfedge = TriangleMesh::inCopy(p.halfedge, face);
      points.push_back(p);
    });
  std::stable_sort(points.begin(), points.end(),
    [](const EdgePoint& a, const EdgePoint& b)
    { return a.halfedge != b.halfedge ? a.halfedge < b.halfedge : a.value < b.value; });
}

std::vector<Id> pointsAtSeams(const MeshPartition& part, const std::vector<EdgePoint>& points)
{
  std::vector<Id> atSeams;
  for (Id id = 0; part.isDistributed() && id < points.size(); ++id)
  {
    if (!part.otherRanksAt(points[id].halfedge).empty())
    {
      atSeams.push_back(id);
    }
  }
  return atSeams;
}

void countTurnsAtSeams(const TriangleMesh& mesh, Isolines& isolines)
{
  const auto turns = [&](const SurfacePoint& end)
  {
    return end.kind == SurfacePoint::Kind::Edge && mesh.isInner(end.id) &&
      mesh.acrossOriented(end.id) == NoId;
  };
  for (const Isoline& line : isolines.lines)
  {
    const bool isTurned = !line.isClosed() &&
      (turns(isolines.points[line.points.front()]) || turns(isolines.points[line.points.back()]));
    isolines.linesWithoutDirection += isTurned ? 1 : 0;
  }
}

}
