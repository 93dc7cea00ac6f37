// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FrontStart_h
#define geodesic_FrontStart_h

#include "front/FrontContext.h"
#include "front/FrontOnRanks.h"

namespace geodesic
{

/// Starts a front at its sources: sets the distances of the vertices on them and beside them, and
/// sends their first windows. The mail waits for receiveMail() then.
void startFront(
  FrontContext& front, FrontWorker& worker, FrontOnRanks& ranks, SourceWindows& sources);

}

#endif
