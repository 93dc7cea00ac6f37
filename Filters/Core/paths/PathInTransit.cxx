// SPDX-License-Identifier: BSD-3-Clause
#include "paths/PathInTransit.h"

namespace geodesic
{

void putInTransit(Message& message, const MeshPartition& part, const PathInTransit& transit)
{
  const TracedPath& path = transit.path;
  put(message, transit.targetRank);
  put(message, transit.target);
  put(message, part.addressOf(transit.face));
  put(message, toFacePoint(part.mesh(), transit.face, path.points.back()));
  put(message, static_cast<const PathState&>(path));
  put(message, path.without == NoId ? RankAddress{ -1, NoId } : part.addressOf(path.without));
  putAll(message, transit.toAsk);
  put(message, transit.nearest);
}

PathInTransit getInTransit(MessageReader& reader, const MeshPartition& part)
{
  PathInTransit transit;
  TracedPath& path = transit.path;
  transit.targetRank = reader.get<int>();
  transit.target = reader.get<Id>();
  const Id face = part.faceAt(reader.get<RankAddress>());
  path.faces = { face };
  path.points = { fromFacePoint(part.mesh(), face, reader.get<FacePoint>()) };
  transit.sent = 1;
  static_cast<PathState&>(path) = reader.get<PathState>();
  path.leg.exit = 3 * face + path.leg.exit % 3;
  const auto without = reader.get<RankAddress>();
  path.without = without.rank < 0 ? NoId : part.faceAt(without);
  transit.toAsk = reader.getAll<int>();
  transit.nearest = reader.get<SearchAnswer>();
  return transit;
}

}
