// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SourceWindowsOfPartition_h
#define geodesic_SourceWindowsOfPartition_h

#include "mesh/ReplicatedPatch.h"
#include "source/SourceWindows.h"

namespace geodesic
{

/// What sources on a patch that all ranks have give the front of this rank's part: the windows that
/// leave faces owned here, the sources in these faces and in the halo, and the vertices of the
/// part. In one process they are the same.
///
/// \param onPatch of curves whose points lie in faces that were asked for when the patch was made.
SourceWindows sourceWindowsOfPartition(
  const MeshPartition& part, const ReplicatedPatch& patch, SourceWindows onPatch);

}

#endif
