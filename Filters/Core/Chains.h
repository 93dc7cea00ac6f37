// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Chains_h
#define geodesic_Chains_h

#include "Types.h"

#include <vector>

namespace geodesic
{

/// Segments that follow each other. The ends of segment s are 2 * s and 2 * s + 1.
struct Chain
{
  /// The end at which the chain enters each segment. An odd end means that the chain runs against
  /// the segment's direction.
  std::vector<Id> ends;
  /// Whether the last segment leads to the first one.
  bool isLoop = false;

  /// Turns the chain round. A loop still begins with the same segment.
  void reverse();
};

/// Joins segments at the places where exactly two ends meet. A chain runs in the direction of its
/// lowest segment, and a loop begins with that segment. The time is linear in the number of
/// segments and in the largest place.
///
/// \param places the number of the place of each end; NoId where a chain ends in any case.
/// \returns the chains in the order of their lowest segments. Every segment is in exactly one.
std::vector<Chain> followChains(const std::vector<Id>& places);

/// Sorts chains by the ends at which they begin, loops last, and turns open chains round that would
/// begin at the higher one of their two ends.
void beginAtLowestEnds(std::vector<Chain>& chains);

}

#endif
