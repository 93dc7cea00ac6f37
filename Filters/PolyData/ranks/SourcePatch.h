// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SourcePatch_h
#define geodesic_SourcePatch_h

#include "PolyData/reading/PolyDataSurface.h"
#include "mesh/ReplicatedPatch.h"
#include "source/PolylineLocator.h"
#include "source/SourceCurve.h"

#include <cstdint>
#include <optional>
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
  /// Adds the faces on the boundary.
  void addBoundary();
  /// Adds faces that this rank owns.
  ///
  /// \returns whether any rank has added one.
  bool addFaces(const std::vector<Id>& faces);
  /// Adds the faces at vertices, by their global numbers.
  void addFacesAt(const std::vector<Id>& globalIds);

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

/// The boundary of a surface. The rims of barriers do not belong to it: the loops are those of the
/// surface with its barriers.
class SurfaceBoundary
{
public:
  /// Finds it and adds its faces to a patch. All ranks call this together.
  SurfaceBoundary(const PolyDataSurface& surface, SourcePatch& faces, const Job& job);

  /// The loops as curves on the patch that was made of these faces. Vertices that only barriers
  /// have follow those of the patch, for boundaryOutsideBarriers().
  std::vector<SourceCurve> curvesOn(const ReplicatedPatch& patch) const;

private:
  Id numberOfGlobalVertices_;
  /// With barriers: the loops, whose points have global numbers in place of vertices.
  std::optional<std::vector<SourceCurve>> ofAllFaces_;
};

}

#endif
