// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SegmentWindows_h
#define geodesic_SegmentWindows_h

#include "source/LeavingWindow.h"
#include "source/SourceInFace.h"

namespace geodesic
{

/// Adds the linear windows of a segment in a face: its rays leave at right angles to both sides,
/// through the face's halfedges (paper, section 4.2 and figure 6).
void addSegmentWindows(
  const TriangleMesh& mesh, const SourceInFace& segment, std::vector<LeavingWindow>& windows);

}

#endif
