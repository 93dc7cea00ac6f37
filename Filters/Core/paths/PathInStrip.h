// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PathInStrip_h
#define geodesic_PathInStrip_h

#include "paths/PathsToSource.h"

#include <functional>
#include <vector>

namespace geodesic
{

/// What a front from the source has found.
struct KnownDistances
{
  /// At each vertex of this rank's part, not below the distance; and the distance where it is
  /// within the reach.
  const std::vector<double>& atVertices;
  /// The largest reach of all ranks.
  double reach = Infinity;
};

/// A target on any rank.
struct TargetOnRank
{
  /// A face that holds it, on the rank that owns it.
  RankAddress face;
  FacePoint point;
  /// Finite and within the reach of what is known.
  double distance;
  /// Which of its rank's targets it is.
  Id number = 0;
};

/// Finds a shortest path by the windows of the faces that it goes through: slower than tracing it
/// by arrivals (followPath()), but rounding cannot lead it astray. All ranks together call it for
/// one target.
///
/// A front from the target goes over all ranks, but only where a path can still be as short as it
/// is, by the distances that are known. That leaves a strip of few faces. The target's rank gathers
/// these, and a second front goes from the source through the strip and keeps its windows.
///
/// \param ends of paths on the same curves.
/// \param take is called on the target's rank with the path, whose points are none where it was not
///        found.
void pathInStrip(const MeshPartition& part, const ReplicatedPatch& patch,
  const std::vector<SourceCurve>& curves, const PathEnds& ends, const TargetOnRank& target,
  const KnownDistances& known, const Job& job,
  const std::function<void(const PathToSource&)>& take);

}

#endif
