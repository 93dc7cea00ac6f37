// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PinnedFaces_h
#define geodesic_PinnedFaces_h

#include "mesh/MeshPartition.h"

#include <cstdint>
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
  bool areAllPinned() const { return this->solvesLeft_ == 0; }

private:
  const MeshPartition& surface_;
  std::vector<std::uint8_t> faces_;
  int solvesLeft_;
};

}

#endif
