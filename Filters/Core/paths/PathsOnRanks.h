// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PathsOnRanks_h
#define geodesic_PathsOnRanks_h

#include "mesh/ReplicatedPatch.h"
#include "paths/PathInStrip.h"
#include "paths/PathTracer.h"

#include <map>
#include <vector>

namespace geodesic
{

/// Follows paths that leave their target's rank. In one process none does.
///
/// At a seam a path is handed over to the rank that owns the next face. The rank of its target gets
/// the points that each rank has found. A point on an edge of three and more faces may lie on a
/// seam; then the ranks that own these faces are asked one after another, and the path goes on
/// where it is shortest.
class PathsOnRanks
{
public:
  /// \param field of this rank's part; must outlive this, as must the others.
  /// \param curves those of the feet.
  PathsOnRanks(const DistanceField& field, FootFinder& feet, const std::vector<SourceCurve>& curves,
    const Job& job)
    : field_(field)
    , part_(field.surface())
    , feet_(feet)
    , curves_(curves)
    , job_(job)
  {
  }

  /// Takes over a path that followPath() has followed as far as it goes through this rank's faces.
  void add(Id target, TracedPath path);

  /// Whether a path is on its way on any rank. All ranks call this together.
  bool isAnyOnItsWay() const
  {
    return this->part_.exchange().isTrueAnywhere(!this->leaving_.empty());
  }
  /// Hands each path over to the next rank, which follows it. All ranks call this together.
  ///
  /// \returns the paths of this rank's targets that have come to their ends or, without points, got
  ///          lost.
  std::vector<PathToSource> handOver();

private:
  /// A point of a path, and a face that holds it and the point before.
  struct SentPoint
  {
    SentFace face;
    FacePoint point;
  };
  /// A path on its way over ranks.
  struct InTransit
  {
    /// The rank that asks for it, and which of that rank's targets it begins at.
    int targetRank = 0;
    Id target = 0;
    TracedPath path;
    /// How many of the points at hand have been sent to the target's rank.
    std::size_t sent = 0;
    /// While the path searches around an edge: the ranks that were not yet asked, and of those that
    /// were the one through whose faces the path is shortest, the lowest of several.
    std::vector<int> toAsk;
    double shortest = Infinity;
    int rankOfShortest = 0;
    /// On its way: the rank that it goes to, and a face of both ranks that holds its last point
    /// and, if it goes on behind an exit, the exit.
    int rank = 0;
    Id face = NoId;
  };

  void follow(InTransit& transit) const;
  bool searchAround(InTransit& transit) const;
  std::vector<int> ranksToAsk(const TracedPath& path) const;
  void putInTransit(const InTransit& transit, Message& message) const;
  InTransit getInTransit(MessageReader& reader) const;
  void putReport(const InTransit& transit, Message& message);
  void takeReport(MessageReader& reader, std::vector<PathToSource>& arrived);

  const DistanceField& field_;
  const MeshPartition& part_;
  FootFinder& feet_;
  const std::vector<SourceCurve>& curves_;
  const Job& job_;
  /// Those that go on from this rank, or whose ends it sends to their targets' ranks.
  std::vector<InTransit> leaving_;
  /// For targets of this rank, the points found so far.
  std::map<Id, std::vector<SentPoint>> found_;
};

/// The targets of all ranks with some numbers, in one order on all ranks. All ranks call this
/// together.
///
/// \param targets those of this rank.
std::vector<TargetOnRank> gatherTargets(const DistanceField& field,
  const std::vector<SurfacePoint>& targets, const std::vector<Id>& numbers);

}

#endif
