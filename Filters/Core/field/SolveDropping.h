// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SolveDropping_h
#define geodesic_SolveDropping_h

#include "field/DistanceField.h"

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace geodesic
{

/// The faces whose windows a solve must not drop. If windows turn out to be needed that a solve has
/// dropped, their faces are pinned and the solve is repeated, until no window is missing.
class PinnedFaces
{
public:
  /// \param surface must outlive this.
  /// \param faces for each face, not 0 if it is pinned from the beginning; empty: none is.
  /// \param maximumDroppingSolves the number of solves that may drop windows too early; the next
  ///        one keeps all, so that there is an end.
  explicit PinnedFaces(const MeshPartition& surface, std::vector<std::uint8_t> faces = {},
    int maximumDroppingSolves = 4)
    : surface_(surface)
    , faces_(std::move(faces))
    , solvesLeft_(maximumDroppingSolves)
  {
    this->faces_.resize(surface.mesh().numberOfFaces(), 0);
  }

  /// For each face, not 0 if it is pinned.
  const std::vector<std::uint8_t>& faces() const { return this->faces_; }

  /// Pins faces of this rank. All ranks call this together.
  ///
  /// \returns whether any rank has pinned a face: then all solve again.
  bool pin(const std::vector<Id>& faces)
  {
    for (const Id face : faces)
    {
      this->faces_[face] = 1;
    }
    return this->surface_.exchange().isTrueAnywhere(!faces.empty());
  }
  /// The same for faces whose windows a solve has dropped too early. All faces are pinned when this
  /// has happened too often.
  bool pinTooEarly(const std::vector<Id>& faces)
  {
    const bool isAny = this->pin(faces);
    this->solvesLeft_ -= isAny ? 1 : 0;
    return isAny;
  }
  void pinAll() { this->solvesLeft_ = 0; }
  bool areAllPinned() const { return this->solvesLeft_ == 0; }

private:
  const MeshPartition& surface_;
  std::vector<std::uint8_t> faces_;
  int solvesLeft_;
};

/// Solves once, with windows dropped of faces that are not pinned. If any rank has dropped windows
/// that turn out to be needed, their faces are pinned, and nothing is returned: all ranks solve
/// again then.
///
/// \param makeRetention (faces) -> a retention with droppedTooEarly() and release(); see
///        PinnedFaces::faces().
template <typename MakeRetention>
std::optional<DistanceField> solveDropping(const MeshPartition& surface,
  const SourceWindows& sources, const FrontOptions& options, PinnedFaces& pinned,
  const MakeRetention& makeRetention)
{
  if (pinned.areAllPinned())
  {
    KeepFaces all(surface.mesh(), surface.ownFaces());
    FrontResult front = propagate(surface, sources, options, all);
    return DistanceField(surface, std::move(front), all.release());
  }
  auto retention = makeRetention(pinned.faces());
  FrontResult front = propagate(surface, sources, options, retention);
  if (pinned.pinTooEarly(retention.droppedTooEarly()))
  {
    return std::nullopt;
  }
  return DistanceField(surface, std::move(front), retention.release());
}

/// Solves again until no window is missing.
///
/// \param solveOnce () -> what solveDropping() returns.
template <typename SolveOnce>
DistanceField solveUntilComplete(const SolveOnce& solveOnce)
{
  for (;;)
  {
    std::optional<DistanceField> field = solveOnce();
    if (field)
    {
      return std::move(*field);
    }
  }
}

}

#endif
