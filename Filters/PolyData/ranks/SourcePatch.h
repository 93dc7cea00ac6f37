// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SourcePatch_h
#define geodesic_SourcePatch_h

#include "PolyData/reading/PolyDataSurface.h"
#include "mesh/ReplicatedPatch.h"
#include "source/PolylineLocator.h"
#include "source/SourceCurve.h"

#include <cstdint>
#include <vector>

namespace geodesic
{

/// Collects the faces around a source, for a patch that all ranks have, so that the source lies on
/// the patch in the same way on all of them. In one process the patch is the whole surface. All
/// ranks call these functions together.
class SourcePatch
{
public:
  explicit SourcePatch(const MeshPartition& surface)
    : surface_(surface)
    , isChosen_(surface.isDistributed() ? surface.mesh().numberOfFaces() : 0, 0)
  {
  }

  /// Adds the faces around the places of curves' points.
  void addFacesAround(const LocatedPlaces& located);
  /// Adds a face of any rank and those at its vertices.
  void addFacesAround(const RankAddress& address);
  /// Adds the faces at the points of boundaryOfAllFaces().
  void addBoundary(const std::vector<SourceCurve>& loops);
  /// Adds faces that this rank owns.
  ///
  /// \returns whether any rank has added one.
  bool addFaces(const std::vector<Id>& faces);

  /// Makes the patch of all that was added.
  ReplicatedPatch make() const;

private:
  void addFacesAround(Id face);
  void addFacesAtVertex(Id vertex);

  MeshPartition surface_;
  /// Whether each face of the partition is asked for; empty in one process, where the patch has all
  /// faces anyway.
  std::vector<std::uint8_t> isChosen_;
};

/// The boundary of all faces of a surface, barriers or not: the rims of barriers do not belong to
/// it. Its points have global numbers in place of vertices, those that only barriers have behind
/// all others; its faces say nothing. All ranks call this together.
std::vector<SourceCurve> boundaryOfAllFaces(const PolyDataSurface& surface);

}

#endif
