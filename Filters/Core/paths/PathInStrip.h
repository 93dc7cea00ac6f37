// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PathInStrip_h
#define geodesic_PathInStrip_h

#include "paths/PathsToSource.h"

#include <optional>
#include <vector>

namespace geodesic
{

/// A target on any rank.
struct TargetOnRank
{
  /// A face that holds it, on the rank that owns it.
  RankAddress face;
  FacePoint point;
  /// Finite and known.
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
/// \param toSource lower bounds of the distance at each vertex of this rank's part
///        (Corridor::lowerBounds): lowerBoundsOf().
/// \returns the path on the target's rank, without points if it was not found; nothing on the
///          others.
std::optional<PathToSource> pathInStrip(const MeshPartition& part, const ReplicatedPatch& patch,
  const std::vector<SourceCurve>& curves, const TargetOnRank& target,
  const std::vector<double>& toSource, const Job& job);

}

#endif
