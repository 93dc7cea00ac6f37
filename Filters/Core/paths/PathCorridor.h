// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PathCorridor_h
#define geodesic_PathCorridor_h

#include "front/Front.h"
#include "mesh/ReplicatedPatch.h"

#include <vector>

namespace geodesic
{

/// Lower bounds of the distances at vertices that a front has found.
///
/// \param distances the front's: not below the distance, and right where they are at most
///        `searchedTo`.
/// \param searchedTo how far the front has come.
std::vector<double> lowerBoundsOf(std::vector<double> distances, double searchedTo);

/// Finds the corridor of the shortest paths from a start to a goal. An approximate front from the
/// goal, which costs a fraction of an exact one, stops at the start. The search itself is an exact
/// front from the start that does not leave the corridor. All ranks call this together.
///
/// \param patch that contains the faces of both points.
/// \param within null, or a corridor from the goal to the start that the approximate front may not
///        leave.
/// \returns a corridor whose length is infinite if no path joins the points.
/// \throws Aborted
Corridor corridorTo(const MeshPartition& part, const ReplicatedPatch& patch,
  const SurfacePoint& goal, const SurfacePoint& start, const Corridor* within, const Job& job);

/// Finds the faces that the paths of a corridor can touch, except those of the start, by an exact
/// front from the start. All ranks call this together.
///
/// \param patch that contains the faces of the start.
/// \returns faces that this rank owns, ascending.
/// \throws Aborted
std::vector<Id> facesInCorridor(const MeshPartition& part, const ReplicatedPatch& patch,
  const SurfacePoint& start, const Corridor& corridor, const Job& job);

}

#endif
