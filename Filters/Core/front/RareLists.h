// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RareLists_h
#define geodesic_RareLists_h

#include "front/BatchTasks.h"

namespace geodesic
{

// What happens to few lists: in searches for one path, on thin and rough surfaces, and between
// faces of different orientation. These functions are compiled apart from BatchTasks so that they
// do not take the registers of what happens to all lists.

/// Changes the windows into those of the reversed halfedge, whose length is given.
void reverse(const WindowBlock& windows, double length);

/// Whether no path in the corridor, which there is, passes the windows of a halfedge.
bool isOutsideCorridor(const FrontContext& front, Id halfedge, const WindowRange& windows);

bool isInThinFace(const FrontContext& front, Id halfedge);

/// The least distance of any window.
double leastDistance(const WindowRange& windows);

/// Remembers a list that passes, if others may come to the halfedge. Where windows come to a vertex
/// again and again, they are beaten by others that came before. A list in a thin face passes at its
/// nearest window's distance, and others may come later.
void remember(const FrontContext& front, FrontWorker& worker, District& district, Id halfedge,
  const WindowRange& passed);

/// Cuts a list that comes once more by what has passed its halfedge before.
void cutByPassed(
  const FrontContext& front, FrontWorker& worker, const District& district, SentList& sent);

}

#endif
