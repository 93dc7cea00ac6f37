// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PathsOnRanks_h
#define geodesic_PathsOnRanks_h

#include "mesh/ReplicatedPatch.h"
#include "paths/PathsToSource.h"

#include <vector>

namespace geodesic
{

/// A path by places in space: it may go through faces that this rank does not have.
struct PathInSpace
{
  /// As PathToSource::points.
  std::vector<Vec3> points;
  /// SourceCurve::source of a curve that the end lies on.
  Id source = NoId;
};

/// The shortest paths from points of a surface that ranks have together, each told to the rank that
/// asks for it: see pathsToSource(). All ranks together call it.
///
/// One front goes from the source until the targets of all ranks are settled. A path is followed as
/// a ray by the rank that owns the faces it goes through, which hands it over at a seam, with what
/// is known of it, and tells the target's rank what it has found.
///
/// \param curves on the patch.
/// \param targets in faces that this rank owns; maybe none.
/// \throws SourceError where there is no source; Aborted.
std::vector<PathInSpace> pathsOnRanks(const MeshPartition& part, const ReplicatedPatch& patch,
  const std::vector<SourceCurve>& curves, const std::vector<SurfacePoint>& targets,
  const PathsOptions& options = {});

}

#endif
