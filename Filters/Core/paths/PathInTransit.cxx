// SPDX-License-Identifier: BSD-3-Clause
#include "paths/PathInTransit.h"

namespace geodesic
{

namespace
{

/// \param face of the part, or NoId.
void putFace(Message& message, const MeshPartition& part, Id face)
{
  put(message, face == NoId ? RankAddress{ -1, NoId } : part.addressOf(face));
}

Id getFace(MessageReader& reader, const MeshPartition& part)
{
  const auto address = reader.get<RankAddress>();
  return address.rank < 0 ? NoId : part.faceAt(address);
}

std::vector<SentFace> facesOf(const std::vector<SentPathPoint>& path)
{
  std::vector<SentFace> faces;
  for (const SentPathPoint& p : path)
  {
    faces.push_back(p.face);
  }
  return faces;
}

} // anonymous namespace

void putInTransit(
  Message& message, const MeshPartition& part, const PathInTransit& transit, Id face)
{
  const TracedPath& path = transit.path;
  put(message, transit.targetRank);
  put(message, transit.target);
  putFace(message, part, face);
  put(message, toFacePoint(part.mesh(), face, path.points.back()));
  put(message, static_cast<const PathState&>(path));
  const bool isOnLeg = path.next == TracedPath::Next::BehindExit;
  putFace(message, part, isOnLeg ? TriangleMesh::faceOf(path.leg.exit) : NoId);
  put(message, path.leg.exit % 3);
  put(message, path.leg.ray);
  put(message, path.leg.origin);
  putFace(message, part, path.next == TracedPath::Next::Search ? path.without : NoId);
  putAll(message, transit.toAsk);
  put(message, transit.nearest);
}

PathInTransit getInTransit(MessageReader& reader, const MeshPartition& part)
{
  PathInTransit transit;
  TracedPath& path = transit.path;
  transit.targetRank = reader.get<int>();
  transit.target = reader.get<Id>();
  path.faces = { getFace(reader, part) };
  path.points = { fromFacePoint(part.mesh(), path.faces.front(), reader.get<FacePoint>()) };
  transit.sent = 1;
  static_cast<PathState&>(path) = reader.get<PathState>();
  const Id exitFace = getFace(reader, part);
  const Id k = reader.get<Id>();
  path.leg.exit = exitFace == NoId ? NoId : 3 * exitFace + k;
  path.leg.ray = reader.get<Window>();
  path.leg.origin = reader.get<Id>();
  path.without = getFace(reader, part);
  transit.toAsk = reader.getAll<int>();
  transit.nearest = reader.get<SearchAnswer>();
  return transit;
}

PathStrip::PathStrip(const std::vector<SentPathPoint>& path)
  : faces_(facesOf(path))
{
  for (const SentPathPoint& p : path)
  {
    this->points_.push_back(
      fromFacePoint(this->mesh(), this->faces_.faceAt(p.face.owner), p.point));
  }
}

}
