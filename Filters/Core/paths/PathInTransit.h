// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PathInTransit_h
#define geodesic_PathInTransit_h

#include "mesh/ReplicatedPatch.h"
#include "paths/PathTracer.h"

#include <vector>

namespace geodesic
{

/// How long a path is that goes on through a rank's faces.
struct SearchAnswer
{
  double distance = Infinity;
  int rank = 0;

  bool isFound() const { return this->distance < Infinity; }
  bool operator<(const SearchAnswer& other) const
  {
    return this->distance != other.distance ? this->distance < other.distance
                                            : this->rank < other.rank;
  }
};

/// A path on its way over ranks.
struct PathInTransit
{
  /// The rank that asks for it, and which of that rank's targets it begins at.
  int targetRank = 0;
  Id target = 0;
  TracedPath path;
  /// How many of the points at hand have been sent to the target's rank.
  std::size_t sent = 0;
  /// While the path searches around an edge: the ranks that were not yet asked, and the nearest of
  /// those that were.
  std::vector<int> toAsk;
  SearchAnswer nearest;
};

/// \param face that holds the last point, on this rank and on the one that the message goes to.
void putInTransit(
  Message& message, const MeshPartition& part, const PathInTransit& transit, Id face);
/// The path has one point, the last one.
PathInTransit getInTransit(MessageReader& reader, const MeshPartition& part);

/// A point of a path, and a face that holds it and the point before.
struct SentPathPoint
{
  SentFace face;
  FacePoint point;
};

/// A path through faces of several ranks, on a mesh of these faces.
class PathStrip
{
public:
  explicit PathStrip(const std::vector<SentPathPoint>& path);

  const TriangleMesh& mesh() const { return this->faces_.mesh(); }
  RankAddress ownerOf(Id face) const { return this->faces_.ownerOf(face); }
  const std::vector<SurfacePoint>& points() const { return this->points_; }

private:
  GatheredFaces faces_;
  std::vector<SurfacePoint> points_;
};

}

#endif
