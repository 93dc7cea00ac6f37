// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Solve_h
#define geodesic_Solve_h

#include "field/DistanceField.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace geodesic
{

/// Which windows a solve keeps.
enum class KeepWindows
{
  /// Distances at vertices only, in the least memory.
  None,
  /// The distance can be evaluated at any surface point, and paths traced.
  All
};

/// Computes the field of the geodesic distance to the curves (paper, sections 3 to 5). For a field
/// that is to be refined solveForRefinement() needs less memory.
///
/// \param surface whose mesh must outlive the field.
/// \param sources the first windows and vertices, see propagate().
/// \throws SourceError if there is no curve; Error if the relative error is not a number >= 0;
///         Aborted.
DistanceField solve(const MeshPartition& surface, SourceWindows sources,
  const FrontOptions& options = {}, KeepWindows keep = KeepWindows::None);

/// The same in one process, from the curves themselves.
DistanceField solve(const TriangleMesh& mesh, const std::vector<SourceCurve>& sources,
  const FrontOptions& options = {}, KeepWindows keep = KeepWindows::None);

/// Solves with windows dropped. If any rank has dropped windows that turn out to be needed, all
/// ranks solve again and keep these. The last solve keeps all windows of their faces.
///
/// \param maximumSolves the largest number of solves that drop windows.
/// \param makeRetention (pinned, options) -> a retention with droppedTooEarly() and release(). For
///        each face, `pinned` is not 0 if the face's windows must not be dropped.
/// \param pinned faces whose windows must not be dropped in the first solve; empty: none.
template <typename MakeRetention>
DistanceField solveDropping(const MeshPartition& surface, const SourceWindows& sources,
  FrontOptions options, int maximumSolves, const MakeRetention& makeRetention,
  std::vector<std::uint8_t> pinned = {})
{
  const ProgressCallback progress = std::move(options.progress);
  options.progress = ascending(progress);
  pinned.resize(surface.mesh().numberOfFaces(), 0);
  for (int solves = 0; solves < maximumSolves; ++solves)
  {
    auto retention = makeRetention(pinned, options);
    FrontResult front = propagate(surface, sources, options, retention);
    if (!surface.exchange().isTrueAnywhere(!retention.droppedTooEarly().empty()))
    {
      return { surface, std::move(front), retention.release() };
    }
    for (const Id face : retention.droppedTooEarly())
    {
      pinned[face] = 1;
    }
  }
  KeepFaces all(surface.mesh(), surface.ownFaces());
  FrontResult front = propagate(surface, sources, options, all);
  return { surface, std::move(front), all.release() };
}

}

#endif
