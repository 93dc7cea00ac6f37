// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SourceWindowsOfPart_h
#define geodesic_SourceWindowsOfPart_h

#include "mesh/SurfacePatch.h"
#include "source/SourceWindows.h"

namespace geodesic
{

/// What sources on a patch that all ranks have give the front of this rank's part: the windows that
/// leave faces owned here, the sources in these faces and in the halo, and the vertices of the
/// part.
///
/// \param onPatch of curves whose points lie in faces that were asked for when the patch was made.
SourceWindows sourceWindowsOfPart(
  const SurfacePart& part, const SurfacePatch& patch, const SourceWindows& onPatch);

}

#endif
