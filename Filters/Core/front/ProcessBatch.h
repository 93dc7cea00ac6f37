// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_ProcessBatch_h
#define geodesic_ProcessBatch_h

#include "front/FrontContext.h"

namespace geodesic
{

/// The first step of a batch in a district (paper, section 3.1; as lists after Qin et al. 2016):
/// its vertices settle, and the lists that face them pass through their faces. What leaves the
/// faces, and the distances found, become mail.
void processBatch(FrontContext& front, FrontWorker& worker, District& district);

/// Sends windows, at least one, that leave a face through a halfedge to its siblings.
void sendWindows(
  FrontContext& front, FrontWorker& worker, District& sender, Id halfedge, WindowRange windows);

}

#endif
