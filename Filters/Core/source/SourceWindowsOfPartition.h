// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SourceWindowsOfPartition_h
#define geodesic_SourceWindowsOfPartition_h

#include "mesh/ReplicatedPatch.h"
#include "source/SourceWindows.h"

namespace geodesic
{

/// This rank's share of the sources on a replicated patch: the windows that leave its own faces,
/// the sources in these faces and in the halo, and the vertices in its partition. In one process
/// that is all.
///
/// \param onPatch from curves whose points lie in faces for which the patch was made.
SourceWindows sourceWindowsOfPartition(
  const MeshPartition& part, const ReplicatedPatch& patch, const SourceWindows& onPatch);

}

#endif
