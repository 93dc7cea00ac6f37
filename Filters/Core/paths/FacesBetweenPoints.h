// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FacesBetweenPoints_h
#define geodesic_FacesBetweenPoints_h

#include "Job.h"
#include "mesh/ReplicatedPatch.h"
#include "source/PolylineOnSurface.h"

#include <vector>

namespace geodesic
{

/// Finds the faces that shortest paths between consecutive points of polylines can touch, for
/// points that share no face. A patch that contains these faces has the same shortest paths as the
/// whole surface, so that polylines can be put onto the patch.
///
/// All ranks call this together.
///
/// \param patch that contains the faces of the points and those around them.
/// \param polylines located on the patch.
/// \param coordinatePrecision as in putOntoSurface().
/// \returns faces that this rank owns, ascending; none if consecutive points share faces or no path
///          joins them.
/// \throws Aborted
std::vector<Id> facesBetweenPoints(const MeshPartition& part, const ReplicatedPatch& patch,
  const std::vector<LocatedPolyline>& polylines, double coordinatePrecision, const Job& job = {});

}

#endif
