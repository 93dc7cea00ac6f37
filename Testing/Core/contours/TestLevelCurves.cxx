// SPDX-License-Identifier: BSD-3-Clause
// Regions below a value, and where curves enter and leave them.
#include "Seeds.h"
#include "truth/TestMeshes.h"

#include "contours/LevelCurves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using geodesic::DistanceCandidate;
using geodesic::LevelCurve;
using geodesic::LevelRegion;
using geodesic::Vec2;
using geodesictest::Random;
using geodesictest::Seeds;
using geodesictest::seedsOfTest;

namespace
{

using Kind = DistanceCandidate::Kind;

Vec2 randomVector(Random& random)
{
  return { random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0) };
}

Vec2 randomDirection(double least, double most, Random& random)
{
  const double angle = random.uniform(least, most);
  return { std::cos(angle), std::sin(angle) };
}

/// From under a window on the x axis, or anywhere.
DistanceCandidate randomCandidate(Kind kind, Random& random)
{
  const double begin = random.uniform(-1.0, 0.5);
  DistanceCandidate c{ kind, random.uniform(0.0, 0.3), randomVector(random), { begin, 0.0 },
    { random.uniform(begin, 1.0), 0.0 }, 0.0, 0.0 };
  if (kind == Kind::Segment)
  {
    c.begin = randomVector(random);
    c.end = randomVector(random);
  }
  else if (kind == Kind::Circular)
  {
    c.source.y = -std::abs(c.source.y);
  }
  else if (kind == Kind::Linear)
  {
    c.source = randomDirection(0.5, 2.6, random);
  }
  return c;
}

LevelCurve randomCurve(Random& random)
{
  const bool isArc = random.chance(0.5);
  return { 1, isArc, randomVector(random), randomDirection(0.0, 7.0, random),
    random.uniform(0.1, 1.5), isArc ? random.uniform(0.2, 1.0) : random.uniform(0.5, 3.0) };
}

}

TEST(LevelCurves, EnterAndLeaveRegionsOnlyAtTheirMeetings)
{
  constexpr int steps = 400;
  const Seeds seeds = seedsOfTest(400);
  for (const Kind kind : { Kind::Circular, Kind::Linear, Kind::Cone, Kind::Segment })
  {
    int changes = 0;
    // Few seeds may have none: then more follow.
    const auto isWanted = [&](std::uint64_t seed)
    { return seed < seeds.end() || (changes == 0 && seed < seeds.end() + 400); };
    for (std::uint64_t seed = seeds.first; isWanted(seed); ++seed)
    {
      Random random(seed);
      const DistanceCandidate candidate = randomCandidate(kind, random);
      const LevelRegion region(candidate, 0, random.uniform(0.4, 1.2), 1e-12);
      const LevelCurve curve = randomCurve(random);
      std::vector<double> places;
      region.addMeetings(geodesic::CurvePart(curve, 0.0, curve.extent, 0.0), places);
      const auto isInside = [&](int i)
      { return region.contains(curve.at(i * curve.extent / steps)); };
      for (int i = 0; i < steps; ++i)
      {
        if (isInside(i) != isInside(i + 1))
        {
          ++changes;
          EXPECT_TRUE(std::any_of(places.begin(), places.end(),
            [&](double t)
            {
              const double step = t * steps / curve.extent;
              return step > i - 1e-6 && step < i + 1 + 1e-6;
            }))
            << "kind " << static_cast<int>(kind) << ", seed " << seed << ", step " << i;
        }
      }
    }
    EXPECT_GT(changes, 0);
  }
}
