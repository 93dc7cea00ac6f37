// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SolveDropping_h
#define geodesic_SolveDropping_h

#include "field/DistanceField.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace geodesic
{

/// For each face, not 0 if a solve must not drop its windows.
using PinnedFaces = std::vector<std::uint8_t>;

/// Pins the faces of this rank whose windows are missing. All ranks call this together.
///
/// \returns whether any rank misses windows: then all solve again.
inline bool pinMissing(
  const MeshPartition& surface, const std::vector<Id>& missing, PinnedFaces& pinned)
{
  for (const Id face : missing)
  {
    pinned[face] = 1;
  }
  return surface.exchange().isTrueAnywhere(!missing.empty());
}

/// Drops the windows of a face when the distances known at that time say that nobody will need
/// them. Paths that are found later may prove that wrong.
class DroppingRetention : public Retention
{
public:
  bool needsInside() const override { return true; }

  /// The faces whose windows are needed, but were dropped.
  const std::vector<Id>& missing() const { return this->missing_; }
  KeptWindows release() { return std::move(this->kept_); }

protected:
  std::vector<Id> missing_;
  KeptWindows kept_;
};

/// How many solves may drop windows that are needed. The next solve keeps all windows, so that
/// there is an end.
constexpr int MostDroppingSolves = 4;

/// Solves with a DroppingRetention. If windows turn out to be missing, pins their faces and solves
/// again. One repetition is nearly always enough; each further one is for faces that the repetition
/// before it has made necessary.
///
/// Ranks that share the surface solve together. The field is known in the faces that each rank
/// owns.
///
/// \param surface whose mesh must outlive the field.
/// \param sources the first windows and vertices (propagate()).
/// \param pinned the faces to keep from the beginning; those that were pinned are added.
/// \param makeRetention makes the retention of one solve from the pinned faces.
/// \throws as solve().
template <typename MakeRetention>
DistanceField solveDropping(const MeshPartition& surface, const SourceWindows& sources,
  const FrontOptions& options, PinnedFaces& pinned, const MakeRetention& makeRetention)
{
  for (int solves = 0; solves < MostDroppingSolves; ++solves)
  {
    auto retention = makeRetention(std::as_const(pinned));
    FrontResult front = propagate(surface, sources, options, retention);
    if (!pinMissing(surface, retention.missing(), pinned))
    {
      return { surface, std::move(front), retention.release() };
    }
  }
  return solveKeeping(surface, sources, options, surface.ownFaces());
}

}

#endif
