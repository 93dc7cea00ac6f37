// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PathsOnRanks_h
#define geodesic_PathsOnRanks_h

#include "FollowOnRanks.h"
#include "mesh/ReplicatedPatch.h"
#include "paths/PathInStrip.h"
#include "paths/PathTracer.h"

#include <cstdint>
#include <vector>

namespace geodesic
{

/// Follows paths that leave their target's rank. In one process none does.
///
/// At a seam the target's rank asks the rank that owns the next face to follow the path; the answer
/// contains the points that this rank has found. A point on an edge of three and more faces may lie
/// on a seam; then all ranks that own these faces follow the path through them, and the one that is
/// shortest goes on.
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
  void add(Id target, const TracedPath& path);

  /// Follows the paths of all ranks to their ends. All ranks call this together.
  ///
  /// \param take gets the paths of this rank's targets; those that got lost have no points.
  void follow(const TakePath& take);

private:
  /// A path as one rank sends it to another.
  struct SentPath
  {
    PathState state = {};
    /// In the answer to a search: the length of the path through the faces of the rank that
    /// answers.
    double through = 0.0;
    /// A face of both ranks that holds the last point and, if the path goes on behind an exit, the
    /// exit.
    RankAddress face = {};
    FacePoint last = {};
  };
  /// A point of a path, and a face that holds it and the point before.
  struct SentPoint
  {
    SentFace face;
    FacePoint point;
  };
  /// What is known of a path behind a point.
  struct Followed
  {
    SentPath sent = {};
    PathEnd end = {};
    /// The ranks that are asked next, ascending.
    std::vector<int> ranks = {};
    std::vector<SentPoint> points = {};
  };
  /// A path of one of this rank's targets.
  struct OwnPath
  {
    Id target = NoId;
    Followed path = {};
    /// The shortest one of the answers that have come.
    Followed next = {};
    std::size_t answers = 0;
  };

  bool ask(Questions& questions);
  struct Step
  {
    TracedPath path;
    double through = 0.0;
  };
  Step step(const SentPath& sent) const;
  void tell(const Step& step, Message& answer) const;
  void hear(OwnPath& path, MessageReader& answer, const TakePath& take);
  Followed followed(const TracedPath& traced, std::size_t firstPoint) const;
  std::vector<int> ranksAround(const TracedPath& path) const;
  PathToSource found(const OwnPath& path) const;

  const DistanceField& field_;
  const MeshPartition& part_;
  FootFinder& feet_;
  const std::vector<SourceCurve>& curves_;
  const Job& job_;
  std::vector<OwnPath> paths_;
};

/// The targets of all ranks with some numbers, in one order on all ranks. All ranks call this
/// together.
///
/// \param targets those of this rank.
std::vector<TargetOnRank> gatherTargets(const DistanceField& field,
  const std::vector<SurfacePoint>& targets, const std::vector<Id>& numbers);

}

#endif
