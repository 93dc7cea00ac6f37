// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PathInTransit_h
#define geodesic_PathInTransit_h

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
  enum class Status : std::uint8_t
  {
    OnItsWay,
    Whole,
    Lost
  };

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
  /// What has become of it on this rank. On its way: the rank that it goes to, and a face of both
  /// ranks that holds its last point and, if it is behind the exit of a leg, the leg.
  Status status = Status::OnItsWay;
  int rank = 0;
  Id face = NoId;
};

void putInTransit(Message& message, const MeshPartition& part, const PathInTransit& transit);
/// The path has one point, the last one.
PathInTransit getInTransit(MessageReader& reader, const MeshPartition& part);

}

#endif
