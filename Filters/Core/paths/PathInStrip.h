// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PathInStrip_h
#define geodesic_PathInStrip_h

#include "paths/PathsToSource.h"

#include <optional>
#include <vector>

namespace geodesic
{

/// What a front from the source has found.
struct KnownDistances
{
  /// At each vertex of this rank's part, not below the distance; and the distance where it is at
  /// most `upTo`.
  const std::vector<double>& atVertices;
  /// How far the front has come on all ranks.
  double upTo = Infinity;
};

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

/// A path on faces that were gathered around it.
struct GatheredPath
{
  /// Which of its rank's targets it begins at.
  Id target;
  bool isLost;
  GatheredFaces faces;
  /// On the mesh of the faces; as far as the path was followed if it got lost.
  std::vector<SurfacePoint> points;
  double length;
  PathEnd end;
};

/// Finds a shortest path by the windows of the faces that it goes through: slower than tracing it
/// by arrivals (followPath()), but rounding cannot lead it astray. All ranks together call it for
/// one target.
///
/// A front from the target goes over all ranks, but only where a path can still be as short as it
/// is, by the distances that are known. That leaves a strip of few faces. The target's rank gathers
/// these, and a second front goes from the source through the strip and keeps its windows.
///
/// \returns the path on the target's rank, lost if it was not found; nothing on the others.
std::optional<GatheredPath> pathInStrip(const MeshPartition& part, const ReplicatedPatch& patch,
  const std::vector<SourceCurve>& curves, const TargetOnRank& target, const KnownDistances& known,
  const Job& job);

/// A gathered path without what its search adds by rounding.
///
/// \param path must outlive the result.
PathToSource toSource(const GatheredPath& path);

}

#endif
