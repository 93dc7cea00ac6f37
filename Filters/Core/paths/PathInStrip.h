// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PathInStrip_h
#define geodesic_PathInStrip_h

#include "paths/PathInWindows.h"
#include "paths/PathsOnRanks.h"

#include <vector>

namespace geodesic
{

/// A target on any rank.
struct TargetOnRank
{
  /// A face that holds it, on the rank that owns it.
  RankAddress face;
  Barycentric weights;
  /// Finite and within the reach of what is known.
  double distance;
};

/// A shortest path by windows where ranks have the surface together: see pathInWindows(). All ranks
/// together call it for one target.
///
/// The front from the target goes over all ranks. The strip of faces that it leaves is gathered,
/// and there the target's rank finds the path.
///
/// \param known of this rank's part; the reach of all ranks.
/// \returns the path on the target's rank; none elsewhere.
PathInSpace pathInStrip(const MeshPartition& part, const ReplicatedPatch& patch,
  const std::vector<SourceCurve>& curves, const TargetOnRank& target, const KnownDistances& known,
  const ParallelFor& parallelFor, const ProgressCallback& progress);

}

#endif
