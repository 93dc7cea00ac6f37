// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_WindowMerge_h
#define geodesic_WindowMerge_h

#include "window/WindowPool.h"

#include <vector>

namespace geodesic
{

/// The size of a list after merging, and the largest error / minimum of its newly merged windows; 0
/// if none was merged.
struct MergedNeighbours
{
  std::size_t size;
  double largest;
};

/// Merges neighbours in a sorted list of one halfedge as long as the result stays within the error
/// (paper, section 5; the bound is ours, see Merging.md).
///
/// A merged window equals the originals at its two ends and is nowhere above them, so distances are
/// only ever underestimated. Its `error` bounds how far it is below a real path. After the call
/// every merged window has error <= relativeError * its own minimum.
///
/// \param list sorted, without overlap; its beginning holds the merged list afterwards.
/// \param edgeLength length of the halfedge.
/// \param relativeError epsilon, > 0.
/// \param maximumAdded bounds how far a merged window may be below the windows that it replaces,
///        however many they are; >= 0.
MergedNeighbours mergeNeighbours(
  const WindowBlock& list, double edgeLength, double relativeError, double maximumAdded = Infinity);

/// Merges the windows of a vector.
///
/// \returns the largest error / minimum of the newly merged windows; 0 if none was merged.
double mergeNeighbours(std::vector<Window>& windows, double edgeLength, double relativeError,
  double maximumAdded = Infinity);

}

#endif
