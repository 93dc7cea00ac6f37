// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Chords_h
#define geodesic_Chords_h

#include "contours/LevelArrangement.h"

#include <vector>

/// Chords that replace the arcs of isolines within a tolerance.
namespace geodesic
{

/// A point of a line: where parts of level curves meet, or one inside an arc.
struct LinePoint
{
  Vec2 at;
  /// NoId for a new one.
  Id id = NoId;
  /// The largest distance of the line from its chord, between this point and the next one.
  double sagitta = 0.0;
};
using Line = std::vector<LinePoint>;

/// Adds the points of a remainder to the end of a line, of an arc so many that no chord is farther
/// from the arc than the tolerance.
void follow(const LevelArrangement::Remainder& remainder, double chordTolerance, Line& line);

/// The end of the longest chord from a point that is near enough to all of the line below it.
std::size_t chordFrom(std::size_t first, const Line& line, double chordTolerance);

}

#endif
