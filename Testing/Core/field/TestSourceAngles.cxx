// SPDX-License-Identifier: BSD-3-Clause
// The arc lengths at which shortest paths end on a curve, and the angles at which they leave it, on
// random meshes: compared with traced paths, at other points, with threads and on ranks. PathEnds
// compares both with closed forms.
#include "CaseWithoutTruth.h"
#include "EngineSupport.h"
#include "OnThreads.h"
#include "RanksSupport.h"
#include "truth/PlaneEnds.h"

#include "refinement/AdaptiveRefinement.h"
#include "refinement/SolveForRefinement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <mutex>

using namespace geodesictest;
using geodesic::Foot;
using geodesic::Id;
using geodesic::Job;
using geodesic::NearestSource;
using geodesic::SurfacePoint;

namespace
{

constexpr std::size_t NumberOfQueries = 30;
/// Relative to the largest distance, and in radians for paths longer than this fraction of it.
constexpr double AngleAccuracy = 1e-8;
constexpr double ShortPath = 1e-3;

/// Two paths whose directions differ by less than this angle, in radians, may be equally long
/// within the accuracy of distances: a bend lengthens a path by the square of its angle.
double bendOn(const MeshKind& kind)
{
  return std::sqrt(8.0 * accuracyOn(kind));
}

class SourceAngles : public ::testing::TestWithParam<MeshKind>
{
};

/// The results of comparisons.
struct Tally
{
  std::size_t compared = 0;
  /// Equally long paths to other places or in other directions.
  std::size_t others = 0;
  /// Paths that differ by no more than bendOn().
  std::size_t bent = 0;
  /// Paths that end at one place which curves pass several times, each named by another passage.
  std::size_t passages = 0;

  void expectFewOthers() const
  {
    EXPECT_GT(this->compared, 0U);
    EXPECT_LE(this->others, this->compared / 50);
    EXPECT_LE(this->bent, this->compared / 20);
    EXPECT_LE(this->passages, this->compared / 20);
    std::cout << "of " << this->compared << " points " << this->others << " have other paths, "
              << this->bent << " bent ones, " << this->passages << " other passages\n";
  }
};

/// The nearest source of a point, as numbers that can be compared.
struct Answer
{
  Id curve = geodesic::NoId;
  double arcLength = 0.0;
  double angle = 0.0;
};

Answer answerFor(NearestSource& nearest, const Foot& foot)
{
  return foot.isKnown() ? Answer{ foot.curve, nearest.arcLengthOf(foot), nearest.angleOf(foot) }
                        : Answer();
}

/// Compares two answers for a point. Either of two equally long paths may be the answer.
void compare(const Answer& a, const Answer& b, double scale, double bend, Tally& tally)
{
  ++tally.compared;
  const double gap = a.curve != b.curve
    ? geodesic::FullAngle
    : std::max(std::abs(a.arcLength - b.arcLength) / scale, gapOfAngles(a.angle, b.angle));
  tally.bent += gap > AngleAccuracy && gap <= bend ? 1 : 0;
  tally.others += gap > bend ? 1 : 0;
}

} // anonymous namespace

TEST_P(SourceAngles, AreThoseOfTracedPaths)
{
  constexpr std::uint64_t meshes = 12; // of fewer, one with many ties would be over the limits
  Tally tally;
  for (std::uint64_t seed = 0; seed < meshes; ++seed)
  {
    const RandomCase c = caseWithoutTruth(GetParam(), seed, NumberOfQueries);
    FieldWithFeet s(c.mesh, c.curves);
    const double largest = largestFinite(s.field.vertexDistances());
    const std::vector<SurfacePoint> targets = verticesAnd(s.mesh, c.queries);
    const std::vector<FoundPath> paths = findPaths(s.mesh, s.curves, targets);
    for (std::size_t i = 0; i < targets.size(); ++i)
    {
      const Foot foot = s.footOf(targets[i]);
      if (!foot.isKnown() || s.field.distance(targets[i]) <= ShortPath * largest)
      {
        continue;
      }
      const Answer traced = { paths[i].source, paths[i].arcLength, paths[i].angle };
      const Answer found = answerFor(s.nearest, foot);
      const Vec3 end = geodesic::position(s.mesh, s.nearest.pointOf(foot));
      const bool isSamePlace =
        spaceDistance(end, paths[i].places.back()) <= AngleAccuracy * largest;
      const bool isSamePassage = traced.curve == found.curve &&
        std::abs(traced.arcLength - found.arcLength) <= bendOn(GetParam()) * largest;
      if (isSamePlace && !isSamePassage)
      {
        ++tally.passages;
      }
      else
      {
        compare(traced, found, largest, bendOn(GetParam()), tally);
      }
    }
  }
  tally.expectFewOthers();
}

TEST_P(SourceAngles, ChangeNoDistance)
{
  for (std::uint64_t seed = 0; seed < meshesOfAKind(4); ++seed)
  {
    const RandomCase c = caseWithoutTruth(GetParam(), seed, NumberOfQueries);
    for (const double relativeError : { 0.0, 1e-3 })
    {
      geodesic::FrontOptions with = FieldWithFeet::withAngles(true);
      geodesic::FrontOptions without = FieldWithFeet::withAngles(false);
      with.relativeError = relativeError;
      without.relativeError = relativeError;
      const FieldWithFeet a(c.mesh, c.curves, with);
      const FieldWithFeet b(c.mesh, c.curves, without);
      EXPECT_EQ(a.field.vertexDistances(), b.field.vertexDistances());
      EXPECT_EQ(a.field.windowsPropagated(), b.field.windowsPropagated());
      EXPECT_EQ(a.field.relativeErrorBound(), b.field.relativeErrorBound());
      EXPECT_EQ(valuesOf(a.field, c.queries).queries, valuesOf(b.field, c.queries).queries);
    }
  }
}

TEST_P(SourceAngles, HaveTheSameBitsOnAnyNumberOfThreads)
{
  const RandomCase c = caseWithoutTruth(GetParam(), 1, NumberOfQueries);
  std::vector<std::array<double, 3>> expected;
  for (const geodesic::ParallelFor& way : waysToRun())
  {
    geodesic::FrontOptions options = FieldWithFeet::withAngles();
    options.job = Job({}, way);
    FieldWithFeet s(c.mesh, c.curves, options);
    std::vector<std::array<double, 3>> answers;
    for (const SurfacePoint& point : verticesAnd(s.mesh, c.queries))
    {
      const Answer t = answerFor(s.nearest, s.footOf(point));
      answers.push_back({ static_cast<double>(t.curve), t.arcLength, t.angle });
    }
    EXPECT_TRUE(expected.empty() || answers == expected);
    expected = answers;
  }
}

// With the windows that refinement keeps.
TEST_P(SourceAngles, AreKnownAtPointsThatRefinementAdds)
{
  Tally tally;
  for (std::uint64_t seed = 0; seed < meshesOfAKind(3); ++seed)
  {
    const RandomCase c = caseWithoutTruth(GetParam(), seed, 0);
    FieldWithFeet s(c.mesh, c.curves);
    constexpr double tolerance = 0.02;
    const geodesic::DistanceField field =
      solveForRefinement(s.mesh, s.curves, tolerance, FieldWithFeet::withAngles());
    NearestSource nearest(field, geodesic::ReplicatedPatch(s.mesh), s.curves);
    geodesic::RefinementOptions options;
    options.tolerance = tolerance;
    options.maximumFaces = std::uint64_t(4) * s.mesh.numberOfFaces();
    const geodesic::RefinedMesh refined = geodesic::refine(field, options);
    for (std::size_t i = 0; i < refined.points.size(); i += 7)
    {
      const SurfacePoint& place = refined.points[i].place;
      const Foot foot = nearest.of(geodesic::incomingSegmentTo(field, place));
      compare(answerFor(nearest, foot), answerFor(s.nearest, s.footOf(place)),
        largestFinite(s.field.vertexDistances()), bendOn(GetParam()), tally);
    }
  }
  tally.expectFewOthers();
}

// Each rank owns consecutive faces of the input.
TEST_P(SourceAngles, AreTheSameOnRanks)
{
  Tally tally;
  for (std::uint64_t seed = 0; seed < meshesOfAKind(3); ++seed)
  {
    const RandomCase c = caseWithoutTruth(GetParam(), seed, 0);
    FieldWithFeet s(c.mesh, c.curves);
    for (const int ranks : { 1, 2, 4 })
    {
      CutMesh cut = { c.mesh, ranks, {} };
      for (Index face = 0; face < c.mesh.triangles.size(); ++face)
      {
        cut.rankOfFace.push_back(
          static_cast<int>(face * static_cast<std::size_t>(ranks) / c.mesh.triangles.size()));
      }
      std::mutex mutex;
      onRanks(cut, c.curves, 0,
        [&](const RankOfRun& rank)
        {
          const geodesic::DistanceField field = geodesic::solve(
            rank.part, rank.sources, FieldWithFeet::withAngles(), geodesic::KeepWindows::None);
          NearestSource nearest(field, rank.patch, rank.curvesOnPatch);
          const std::lock_guard<std::mutex> lock(mutex);
          for (Id vertex = 0; vertex < rank.wholeVertices.size(); ++vertex)
          {
            compare(answerFor(nearest, nearest.atVertex(vertex)),
              answerFor(s.nearest, s.nearest.atVertex(rank.wholeVertices[vertex])),
              largestFinite(s.field.vertexDistances()), bendOn(GetParam()), tally);
          }
        });
    }
  }
  tally.expectFewOthers();
}

INSTANTIATE_TEST_SUITE_P(Kinds, SourceAngles, ::testing::ValuesIn(meshKinds()),
  [](const auto& instance) { return std::string(instance.param.name); });
