// SPDX-License-Identifier: BSD-3-Clause
#include "contours/Chords.h"

#include "Tolerance.h"
#include "Trigonometry.h"

#include <algorithm>
#include <cmath>

namespace geodesic
{

namespace
{

// The largest angle of a chord, so that a circle looks like one, and the tangent of its half.
constexpr double LargestStep = Pi / 6.0;
constexpr double TangentOfHalfStep = 0.2679491924311227; // 2 - sqrt(3)

/// The distance of an arc from its chord.
///
/// \param halfTangent the tangent of half the arc's angle.
double sagittaOf(double radius, double halfTangent)
{
  const double squared = halfTangent * halfTangent;
  const double root = std::sqrt(1.0 + squared);
  return radius * squared / (root * (1.0 + root));
}

// The angle of a chord within the tolerance. Points are at the value only up to a tie, so that no
// chord need be nearer to its arc.
double angleOfChord(double radius, double chordTolerance)
{
  const double sagitta = std::clamp(chordTolerance / radius, tolerance::Tie, 1.0);
  return std::min(LargestStep, 4.0 * arcSine(std::sqrt(0.5 * sagitta)));
}

// Adds the points of an arc between its ends. Most arcs are one chord.
void followArc(const LevelArrangement::Remainder& arc, double chordTolerance, Line& line)
{
  const double radius = arc.curve->radius;
  const double halfTangent = (arc.end - arc.begin) / (1.0 + arc.end * arc.begin);
  line.back().sagitta = sagittaOf(radius, halfTangent);
  if (line.back().sagitta <= chordTolerance && halfTangent <= TangentOfHalfStep)
  {
    return;
  }
  const double first = 2.0 * polarAngle({ 1.0, arc.begin });
  const double angle = 2.0 * polarAngle({ 1.0, halfTangent });
  const double chords = std::max(1.0, std::ceil(angle / angleOfChord(radius, chordTolerance)));
  const double sagitta = sagittaOf(radius, tangent(0.5 * angle / chords));
  line.back().sagitta = sagitta;
  const auto count = static_cast<std::size_t>(chords);
  for (std::size_t i = 1; i < count; ++i)
  {
    const double parameter = tangent(0.5 * (first + static_cast<double>(i) / chords * angle));
    line.push_back({ arc.curve->at(parameter), NoId, sagitta });
  }
}

} // anonymous namespace

void follow(const LevelArrangement::Remainder& remainder, double chordTolerance, Line& line)
{
  if (remainder.curve->isArc)
  {
    followArc(remainder, chordTolerance, line);
  }
  line.push_back({ remainder.curve->at(remainder.end) });
}

std::size_t chordFrom(std::size_t first, const Line& line, double chordTolerance)
{
  const auto isNear = [&](std::size_t end)
  {
    const Vec2 chord = line[end].at - line[first].at;
    const double squared = dot(chord, chord);
    for (std::size_t i = first + 1; i < end; ++i)
    {
      const Vec2 p = line[i].at - line[first].at;
      const double t = squared > 0.0 ? std::clamp(dot(p, chord) / squared, 0.0, 1.0) : 0.0;
      const double sagitta = std::max(line[i - 1].sagitta, line[i].sagitta);
      if (!(norm(p - t * chord) + sagitta <= chordTolerance))
      {
        return false;
      }
    }
    return true;
  };
  std::size_t end = first + 1;
  while (end + 1 < line.size() && isNear(end + 1))
  {
    ++end;
  }
  return end;
}

}
