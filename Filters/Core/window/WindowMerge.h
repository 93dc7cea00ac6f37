// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_WindowMerge_h
#define geodesic_WindowMerge_h

#include "window/WindowPool.h"

#include <vector>

namespace geodesic
{

/// What is left of a list whose neighbours were merged, and the largest error / minimum of the
/// windows merged; 0 where none was.
struct MergedNeighbours
{
  std::size_t size;
  double largest;
};

/// Merges neighbours of a sorted list of one halfedge as long as the result stays within the error
/// (paper, section 5; the bound is ours, see Merging.md).
///
/// A merged window equals the originals at its two ends and is nowhere above them, so that
/// distances are only ever underestimated. Its `error` is how far it can be below a real path.
/// After the call every merged window has error <= relativeError * its own minimum.
///
/// \param list sorted, without overlap; the merged list stands at its beginning afterwards.
/// \param edgeLength length of the halfedge.
/// \param relativeError epsilon, > 0.
/// \param maximumAdded a merged window is nowhere below the windows that it replaces by more than
///        this, however many they are; >= 0.
MergedNeighbours mergeNeighbours(
  const WindowBlock& list, double edgeLength, double relativeError, double maximumAdded = Infinity);

/// The same of windows in a vector, which is left with the merged list.
///
/// \returns the largest error / minimum of the windows merged; 0 where none was.
double mergeNeighbours(std::vector<Window>& windows, double edgeLength, double relativeError,
  double maximumAdded = Infinity);

}

#endif
