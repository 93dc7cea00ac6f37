// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_WindowMerge_h
#define geodesic_WindowMerge_h

#include "window/WindowPool.h"

namespace geodesic
{

/// Merges neighbours in a sorted list of one halfedge as long as the result stays within the error
/// (paper, section 5; the bound is ours, see Merging.md).
///
/// A merged window equals the originals at its two ends and is nowhere above them, so distances are
/// only ever underestimated. Its `error` bounds how far it is below a real path. After the call
/// every merged window has error <= relativeError * its own minimum.
///
/// \param list sorted, without overlap; replaced.
/// \param edgeLength length of the halfedge.
/// \param relativeError epsilon, > 0.
/// \param maximumAdded bounds how far a merged window may be below the windows that it replaces,
///        however many they are; >= 0.
/// \returns the largest error / minimum of the newly merged windows; 0 if none was merged.
double mergeNeighbours(
  WindowBlock& list, double edgeLength, double relativeError, double maximumAdded = Infinity);

}

#endif
