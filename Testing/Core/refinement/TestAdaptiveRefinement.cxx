// SPDX-License-Identifier: BSD-3-Clause
// Refined meshes compared with the brute-force solver: no error is over the reported one, no
// reported one is over the tolerance, and the surface is unchanged.
#include "EngineSupport.h"
#include "Watched.h"
#include "refinement/RefinementSupport.h"
#include "truth/MeshFiles.h"
#include "truth/RandomMeshKinds.h"

#include "Errors.h"
#include "field/FaceDistance.h"
#include "refinement/AdaptiveRefinement.h"
#include "refinement/SolveForRefinement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <map>
#include <set>
#include <string>

using namespace geodesictest;
using geodesic::DistanceField;
using geodesic::Id;
using geodesic::Job;
using geodesic::RefinedMesh;
using geodesic::RefinementOptions;
using geodesic::SurfacePoint;
using geodesic::TriangleMesh;

namespace
{

/// Compares an approximate field, solved to be refined, with itself.
void meetsToleranceOfItsField(const PlainMesh& mesh, const Sources& sources, double relativeError,
  double fraction, Random& random)
{
  const TriangleMesh engine = engineMesh(mesh);
  const std::vector<geodesic::SourceCurve> source = engineCurves(engine, sources);
  const DistanceField exact = geodesic::solve(engine, source);
  const double largest = largestFinite(exact.vertexDistances());
  const double tolerance = fraction * largest;
  const DistanceField field = solveKeepingAll(
    engine, source, relativeError, geodesic::Infinity, geodesic::maximumMergedFor(tolerance));
  const RefinedMesh refined = refineTo(field, tolerance);
  EXPECT_FALSE(refined.stoppedAtMaximum);
  EXPECT_LE(refined.errorBound, tolerance);
  const Samples samples = sample(field, refined, 3000, random);
  std::vector<double> computed;
  for (const MeshPoint& place : samples.places)
  {
    computed.push_back(field.distance(enginePoint(engine, place)));
  }
  EXPECT_LE(largestDifference(samples, computed), refined.errorBound + EngineAccuracy * largest);
}

//----------------------------------------------------------------------------
class Refinement : public ::testing::TestWithParam<MeshKind>
{
protected:
  /// Refines one mesh to one tolerance. \returns the measured error over the tolerance.
  static double compare(const PlainMesh& mesh, const std::vector<Polyline>& curves, double fraction,
    std::size_t count, Random& random)
  {
    const TriangleMesh engine = engineMesh(mesh);
    const DistanceField field = solveKeepingAll(engine, engineCurves(engine, curves));
    const double largest = largestFinite(field.vertexDistances());
    const double tolerance = fraction * largest;
    const RefinedMesh refined = refineTo(field, tolerance);
    EXPECT_FALSE(refined.stoppedAtMaximum);
    EXPECT_LE(refined.errorBound, tolerance);
    const Samples samples = sample(field, refined, count, random);
    const double rounding = EngineAccuracy * largest;
    expectRefinedPointsRight(engine, refined, mesh, toSources(curves), 1e-11 * largest);
    const BruteForceResult truth = bruteForceDistances(mesh, toSources(curves), samples.places);
    const double measured = largestDifference(samples, truth.queries);
    EXPECT_LE(measured, refined.errorBound + rounding)
      << refined.triangles.size() << " triangles of " << mesh.triangles.size()
      << " faces, tolerance " << tolerance << "\n"
      << describe(curves);
    expectSameSurface(field, refined);
    return measured / tolerance;
  }
};

}

TEST_P(Refinement, IsNowhereOverTheToleranceOnRandomMeshes)
{
  constexpr std::uint64_t meshes = meshesOfAKind(12);
  constexpr std::size_t samples = 10000;
  double worst = 0.0;
  for (Random& random : EachSeed(meshes, 7000))
  {
    const PlainMesh mesh = GetParam().make(random.between(50, 250), random);
    CurveMaker maker(mesh, random);
    const double fraction = std::pow(10.0, random.uniform(-3.0, -1.0));
    worst = std::max(worst, compare(mesh, maker.anySource(), fraction, samples, random));
  }
  std::cout << "worst error over tolerance on " << GetParam().name << ": " << worst << "\n";
}

TEST_P(Refinement, SeesASourceThatIsStrictlyInsideOneFace)
{
  constexpr std::uint64_t meshes = meshesOfAKind(6);
  constexpr std::size_t samples = 3000;
  for (std::uint64_t seed = 0; seed < meshes; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed + 8000);
    const PlainMesh mesh = GetParam().make(random.between(50, 120), random);
    const Index face = random.below(mesh.triangles.size());
    const double size = seed == 0 ? 0.0 : random.uniform(0.001, 0.1);
    const Barycentric from = { 0.5, 0.3, 0.2 };
    const Barycentric to = { 0.5 - size, 0.3 + 0.4 * size, 0.2 + 0.6 * size };
    const std::vector<Polyline> source = { { { { face, from, to } }, {} } };
    compare(mesh, source, random.uniform(0.003, 0.03), samples, random);
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, Refinement, ::testing::ValuesIn(meshKinds()),
  [](const auto& instance) { return std::string(instance.param.name); });

TEST_P(Refinement, OfAnApproximateFieldMeetsTheToleranceAtEveryEpsilon)
{
  constexpr std::uint64_t meshes = meshesOfAKind(3);
  for (Random& random : EachSeed(meshes, 9000))
  {
    const PlainMesh mesh = GetParam().make(random.between(50, 250), random);
    CurveMaker maker(mesh, random);
    const std::vector<Polyline> curves = maker.anySource();
    SCOPED_TRACE(describe(curves));
    const Sources source = toSources(curves);
    for (const double relativeError : { 1e-3, 1e-2, 1e-1 })
    {
      SCOPED_TRACE(relativeError);
      meetsToleranceOfItsField(mesh, source, relativeError, random.uniform(0.002, 0.02), random);
    }
  }
}

// In an approximate field the faces at an edge have different distances there: the least counts.
TEST(RefinementOfApproximateFields, PointsOnEdgesHaveTheLeastDistanceOfAllFacesThere)
{
  std::size_t different = 0;
  for (Random& random : EachSeed(20))
  {
    const geodesic::TriangleMesh mesh = engineMesh(bumpySheet(6, 6, 0, 0.5, random));
    const geodesic::Id source = static_cast<geodesic::Id>(random.below(mesh.numberOfVertices()));
    const geodesic::DistanceField field = solveKeepingAll(
      mesh, { geodesic::pointCurve(geodesic::SurfacePoint::atVertex(source)) }, 0.05);
    for (const geodesic::RefinedPoint& point : refineTo(field, 0.02).points)
    {
      double least = geodesic::Infinity;
      double largest = 0.0;
      forEachFace(mesh, point.place,
        [&](geodesic::Id number)
        {
          const geodesic::FaceDistance face(field, number);
          const double distance =
            face.distance(face.inPlane(barycentric(mesh, point.place, number)));
          least = std::min(least, distance);
          largest = std::max(largest, distance);
        });
      ASSERT_NEAR(point.distance, least, 1e-12);
      different += largest > least + 1e-9 ? 1 : 0;
    }
  }
  EXPECT_GT(different, 100U);
}

// The source crosses two edges in the middle. When they are split there, it becomes an edge itself.
TEST(RefinementOfOneFace, FollowsTheSourceFromEdgeToEdgeWithThreeTriangles)
{
  const PlainMesh mesh = { { { 0, 0, 0 }, { 4, 0, 0 }, { 1, 3, 0 } }, { { 0, 1, 2 } } };
  const TriangleMesh engine = engineMesh(mesh);
  const Sources source{ {}, { { 0, { 0.5, 0.5, 0.0 }, { 0.5, 0.0, 0.5 } } } };
  const DistanceField field = solveKeepingAll(engine, engineCurves(engine, source));
  const double tolerance = 0.5;
  const RefinedMesh refined = refineTo(field, tolerance);
  EXPECT_LE(refined.errorBound, tolerance);
  EXPECT_EQ(refined.triangles.size(), 3u);
  ASSERT_EQ(refined.points.size(), 2u);
  EXPECT_NEAR(refined.points[0].distance, 0.0, EngineAccuracy);
  EXPECT_NEAR(refined.points[1].distance, 0.0, EngineAccuracy);
  const auto holdsBoth = [](const geodesic::Triangle& t)
  { return std::count(t.begin(), t.end(), 3u) + std::count(t.begin(), t.end(), 4u) == 2; };
  EXPECT_EQ(std::count_if(refined.triangles.begin(), refined.triangles.end(), holdsBoth), 2);
  expectSameSurface(field, refined);
}

// All three edges are on the source, with distance 0 all along; the inside is not.
TEST(RefinementOfOneFace, SeesALocalMaximumInside)
{
  const PlainMesh mesh = { { { 0, 0, 0 }, { 3, 0, 0 }, { 0, 4, 0 } }, { { 0, 1, 2 } } };
  const TriangleMesh engine = engineMesh(mesh);
  const DistanceField field = solveKeepingAll(engine, boundaryCurves(engine));
  Random random(1);
  for (const double tolerance : { 2.0, 0.5, 0.1, 0.01 })
  {
    const RefinedMesh refined = refineTo(field, tolerance);
    EXPECT_LE(refined.errorBound, tolerance);
    const double inradius = 1.0;
    EXPECT_EQ(refined.triangles.size() > 1, tolerance < inradius);
    const Samples samples = sample(field, refined, 20000, random);
    double measured = 0.0;
    for (std::size_t i = 0; i < samples.places.size(); ++i)
    {
      const Vec3 p = position(mesh, samples.places[i]);
      const double truth = std::min({ p[0], p[1], (12.0 - 4.0 * p[0] - 3.0 * p[1]) / 5.0 });
      measured = std::max(measured, std::abs(truth - samples.interpolant[i]));
    }
    EXPECT_LE(measured, refined.errorBound * (1.0 + EngineAccuracy));
    EXPECT_GE(measured, tolerance < inradius ? 0.5 * refined.errorBound : 0.0);
    expectSameSurface(field, refined);
  }
}

// The error of the linear interpolant of one face is known: the distance from its corner is at
// least 1/sqrt(2) on the opposite edge, where the interpolant is 1.
TEST(RefinementOfOneFace, ReportsTheErrorThatItHas)
{
  const PlainMesh mesh = { { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } } };
  const TriangleMesh engine = engineMesh(mesh);
  const Sources source{ { vertexPoint(mesh, 0) }, {} };
  const DistanceField field = solveKeepingAll(engine, engineCurves(engine, source));
  const double error = 1.0 - std::sqrt(0.5);
  for (const double tolerance : { 1.01 * error, 1.5 * error, 10.0 })
  {
    const RefinedMesh refined = refineTo(field, tolerance);
    EXPECT_EQ(refined.triangles.size(), 1u);
    EXPECT_GE(refined.errorBound, error);
    EXPECT_LE(refined.errorBound, tolerance < 10.0 ? error * (1.0 + 1e-9) : std::sqrt(2.0));
  }
}

// At a curve's end inside the face the distance is 0, and the interpolant is as large as nowhere
// else on the curve or on the edges.
TEST(RefinementOfOneFace, SeesTheEndOfACurveInsideWhicheverWayItRuns)
{
  const PlainMesh mesh = { { { 0, 0, 0 }, { 2, 0, 0 }, { 1, std::sqrt(3.0), 0 } },
    { { 0, 1, 2 } } };
  const TriangleMesh engine = engineMesh(mesh);
  const Barycentric corner = { 1.0, 0.0, 0.0 };
  const Barycentric middle = { 1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0 };
  for (const bool isInwards : { true, false })
  {
    const Sources source{ {}, { { 0, isInwards ? corner : middle, isInwards ? middle : corner } } };
    const DistanceField field = solveKeepingAll(engine, engineCurves(engine, source));
    const double atMiddle = 2.0 / 3.0 * (2.0 / std::sqrt(3.0));
    EXPECT_EQ(refineTo(field, 1.01 * atMiddle).triangles.size(), 1u);
    EXPECT_GT(refineTo(field, 0.95 * atMiddle).triangles.size(), 1u);
  }
}

namespace
{

/// The largest excess of a face's interpolant over the distance from its first corner: it is on the
/// opposite edge, where both are compared with more digits.
long double errorFromFirstCorner(const TriangleMesh& mesh)
{
  using Long = long double;
  const auto difference = [&mesh](Long t)
  {
    std::array<Long, 3> squared{}; // of both corners, and of the point between them
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const Long b = static_cast<Long>(mesh.point(1)[axis]) - mesh.point(0)[axis];
      const Long c = static_cast<Long>(mesh.point(2)[axis]) - mesh.point(0)[axis];
      const Long p = b + t * (c - b);
      squared[0] += b * b;
      squared[1] += c * c;
      squared[2] += p * p;
    }
    return (1.0L - t) * std::sqrt(squared[0]) + t * std::sqrt(squared[1]) - std::sqrt(squared[2]);
  };
  Long lo = 0.0L;
  Long hi = 1.0L;
  for (int i = 0; i < 200; ++i)
  {
    const Long a = lo + (hi - lo) / 3.0L;
    const Long b = hi - (hi - lo) / 3.0L;
    (difference(a) < difference(b) ? lo : hi) = difference(a) < difference(b) ? a : b;
  }
  return difference(lo);
}

}

TEST(RefinementOfOneFace, TheBoundHoldsToTheLastDigit)
{
  for (Random& random : EachSeed(300))
  {
    PlainMesh mesh = { {}, { { 0, 1, 2 } } };
    for (int i = 0; i < 3; ++i)
    {
      mesh.points.push_back({ random.uniform(), random.uniform(), random.uniform() });
    }
    const TriangleMesh engine = engineMesh(mesh);
    const Sources source{ { vertexPoint(mesh, 0) }, {} };
    const DistanceField field = solveKeepingAll(engine, engineCurves(engine, source));
    const long double error = errorFromFirstCorner(engine);
    const RefinedMesh refined = refineTo(field, static_cast<double>(1.01L * error));
    EXPECT_EQ(refined.triangles.size(), 1u);
    EXPECT_GE(static_cast<long double>(refined.errorBound), error);
  }
}

// Where windows were dropped, nothing is evaluated again: the reported error is at least the bound
// that the solve gave for them.
TEST(RefinementOfACoarsePlane, ReportsWhatIsLostWhereWindowsWereDropped)
{
  const PlainMesh plane = regularGrid(8, 8);
  const TriangleMesh engine = engineMesh(plane);
  const Sources source{ { vertexPoint(plane, 0) }, {} };
  const double tolerance = 1.0;
  const DistanceField field = solveForRefinement(engine, engineCurves(engine, source), tolerance);
  const RefinedMesh refined = refineTo(field, tolerance);
  EXPECT_EQ(refined.triangles.size(), plane.triangles.size());
  EXPECT_GT(field.droppedErrorBound(), 0.0);
  EXPECT_GE(refined.errorBound, field.droppedErrorBound());
  Random random(3);
  const Samples samples = sample(field, refined, 20000, random);
  double measured = 0.0;
  for (std::size_t i = 0; i < samples.places.size(); ++i)
  {
    const Vec3 p = position(plane, samples.places[i]);
    measured = std::max(measured, std::abs(samples.interpolant[i] - std::hypot(p[0], p[1])));
  }
  EXPECT_GT(measured, 0.05);
  EXPECT_LE(measured, refined.errorBound);
}

// The point is the nearest source only inside its face, whose corners are all as far from it as
// from the line.
TEST(RefinementOfThreeFaces, SeesAPointThatMakesNoCornerNearer)
{
  const PlainMesh mesh = { { { -10, 0, 0 }, { 10, 0, 0 }, { 0, 1, 0 }, { -10, -0.1, 0 },
                             { 10, -0.1, 0 } },
    { { 0, 1, 2 }, { 3, 4, 1 }, { 3, 1, 0 } } };
  const TriangleMesh engine = engineMesh(mesh);
  // (3, 0.6) in the first face
  const Sources source{ { { 0, { 0.05, 0.35, 0.6 } } },
    { { 1, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 } } } };
  const DistanceField field = solveKeepingAll(engine, engineCurves(engine, source));
  for (const double tolerance : { 0.1, 0.3 })
  {
    const RefinedMesh refined = refineTo(field, tolerance);
    EXPECT_LE(refined.errorBound, tolerance);
    Random random(1);
    const Samples samples = sample(field, refined, 20000, random);
    const BruteForceResult truth = bruteForceDistances(mesh, source, samples.places);
    EXPECT_LE(largestDifference(samples, truth.queries), refined.errorBound);
  }
  const RefinedMesh same = refineTo(field, 10.0);
  EXPECT_GE(same.errorBound, 0.7) << "the interpolant at the point";
}

//----------------------------------------------------------------------------
namespace
{

/// A field on a random sheet that needs some refinement.
class RefinementOfASheet : public ::testing::Test
{
protected:
  PlainMesh mesh_ = makeMesh();
  TriangleMesh engine_ = engineMesh(mesh_);
  Sources source_{ { { 17, { 0.2, 0.3, 0.5 } }, vertexPoint(mesh_, 100) }, {} };
  DistanceField field_ = solveKeepingAll(engine_, engineCurves(engine_, source_));
  double largest_ = largestFinite(field_.vertexDistances());

  static PlainMesh makeMesh()
  {
    Random random(5);
    return bumpySheet(12, 12, 2, 0.5, random);
  }
};

}

TEST_F(RefinementOfASheet, TheCapIsKeptAndWhatWasMetIsReported)
{
  const double tolerance = 1e-3 * largest_;
  const RefinedMesh whole = refineTo(field_, tolerance);
  EXPECT_FALSE(whole.stoppedAtMaximum);
  double before = std::numeric_limits<double>::infinity();
  for (const double share : { 0.05, 0.2, 0.5, 0.8 })
  {
    const auto added = static_cast<double>(whole.triangles.size() - mesh_.triangles.size());
    const std::uint64_t most = mesh_.triangles.size() + static_cast<std::uint64_t>(share * added);
    const RefinedMesh capped = refineTo(field_, tolerance, most);
    EXPECT_LE(capped.triangles.size(), most);
    EXPECT_GE(static_cast<double>(capped.triangles.size()), 0.9 * static_cast<double>(most));
    EXPECT_TRUE(capped.stoppedAtMaximum);
    EXPECT_GT(capped.errorBound, tolerance);
    EXPECT_LE(capped.errorBound, before) << "worst ones come first";
    before = 1.05 * capped.errorBound;
    Random random(most);
    const Samples samples = sample(field_, capped, 10000, random);
    const BruteForceResult truth = bruteForceDistances(mesh_, source_, samples.places);
    const double measured = largestDifference(samples, truth.queries);
    EXPECT_LE(measured, capped.errorBound + EngineAccuracy * largest_);
    EXPECT_GE(largestDifferenceInside(field_, capped, 30, random), 0.6 * capped.errorBound)
      << "the bound says what it is";
    expectSameSurface(field_, capped);
  }
}

// Over the cap before any split, or within the tolerance without one.
TEST_F(RefinementOfASheet, AnInputOverTheCapOrWithinTheToleranceStaysAsItIs)
{
  for (const double tolerance : { 1e-3 * largest_, 10.0 * largest_ })
  {
    const RefinedMesh same = refineTo(field_, tolerance, 10);
    EXPECT_EQ(same.triangles.size(), mesh_.triangles.size());
    EXPECT_TRUE(same.points.empty());
    EXPECT_EQ(same.stoppedAtMaximum, tolerance < largest_);
    Random random(2);
    const Samples samples = sample(field_, same, 10000, random);
    const BruteForceResult truth = bruteForceDistances(mesh_, source_, samples.places);
    const double rounding = same.stoppedAtMaximum ? EngineAccuracy * largest_ : 0.0;
    EXPECT_LE(largestDifference(samples, truth.queries), same.errorBound + rounding);
  }
}

TEST_F(RefinementOfASheet, WrongTolerancesFieldsAndLabelsAreRefused)
{
  for (const double tolerance : { 0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
         std::numeric_limits<double>::infinity() })
  {
    EXPECT_THROW(refineTo(field_, tolerance), geodesic::Error) << tolerance;
  }
  const DistanceField withoutWindows = geodesic::solve(engine_, engineCurves(engine_, source_));
  EXPECT_THROW(refineTo(withoutWindows, 0.1), geodesic::Error);
  RefinementOptions ofAnotherNumberOfFaces;
  ofAnotherNumberOfFaces.tolerance = 0.1;
  ofAnotherNumberOfFaces.cornerPoints.assign(3, { 0, 1, 2 });
  ofAnotherNumberOfFaces.numberOfPoints = 3;
  EXPECT_THROW(geodesic::refine(field_, ofAnotherNumberOfFaces), geodesic::Error);
}

TEST_F(RefinementOfASheet, ItsWatcherSeesZeroToOneAndStopsIt)
{
  RefinementOptions options;
  options.tolerance = 1e-4 * largest_;
  expectWatched(4,
    [&](const Job& job)
    {
      options.job = job;
      geodesic::refine(field_, options);
    });
}

TEST_F(RefinementOfASheet, IsTheSameAtAnyScale)
{
  const RefinedMesh refined = refineTo(field_, 2e-3 * largest_);
  for (const double factor : { 0x1p-30, 0x1p30 })
  {
    const PlainMesh other = scaled(mesh_, factor);
    const TriangleMesh engine = engineMesh(other);
    const DistanceField field = solveKeepingAll(engine, engineCurves(engine, source_));
    const RefinedMesh same = refineTo(field, 2e-3 * largest_ * factor);
    EXPECT_EQ(same.triangles, refined.triangles) << factor;
    EXPECT_EQ(same.errorBound, factor * refined.errorBound) << factor;
  }
}

// Where the caller's points are doubled along a seam, the points of split edges are, too; nothing
// else changes.
TEST_F(RefinementOfASheet, SplitEdgesOfASeamHaveAPointASide)
{
  const double tolerance = 2e-3 * largest_;
  const RefinedMesh plain = refineTo(field_, tolerance);
  const Id vertices = engine_.numberOfVertices();
  RefinementOptions options;
  options.tolerance = tolerance;
  options.numberOfPoints = 2 * vertices;
  std::vector<Id> part(engine_.numberOfFaces());
  for (Id face = 0; face < engine_.numberOfFaces(); ++face)
  {
    const geodesic::Triangle& c = engine_.triangle(face);
    part[face] = engine_.point(c[0])[0] + engine_.point(c[1])[0] > 12.0 ? vertices : 0;
    options.cornerPoints.push_back({ c[0] + part[face], c[1] + part[face], c[2] + part[face] });
  }
  const RefinedMesh seamed = geodesic::refine(field_, options);
  ASSERT_EQ(seamed.numberOfInputPoints, 2 * vertices);
  ASSERT_EQ(seamed.faces, plain.faces);
  EXPECT_EQ(seamed.errorBound, plain.errorBound);
  const Points points(field_, plain);
  std::map<std::pair<Id, Id>, Id> pointOf; // plain point and part of the surface
  for (std::size_t t = 0; t < seamed.triangles.size(); ++t)
  {
    const Id halfedge = part[seamed.faces[t]];
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Id corner = plain.triangles[t][k];
      const Id label = seamed.triangles[t][k];
      const auto [found, isNew] = pointOf.emplace(std::make_pair(corner, halfedge), label);
      EXPECT_EQ(found->second, label);
      if (corner < vertices)
      {
        EXPECT_EQ(label, corner + halfedge);
        continue;
      }
      const geodesic::RefinedPoint& p = seamed.points[label - seamed.numberOfInputPoints];
      EXPECT_EQ(p.position, points.position(corner));
      EXPECT_EQ(p.distance, points.distance(corner));
      EXPECT_LT(std::max(p.parents[0], p.parents[1]), label);
    }
  }
  std::set<Id> labels;
  std::size_t doubled = 0;
  for (const auto& [corner, label] : pointOf)
  {
    labels.insert(label);
    doubled +=
      corner.second == 0 && corner.first >= vertices && pointOf.count({ corner.first, vertices })
      ? 1
      : 0;
  }
  EXPECT_EQ(labels.size(), pointOf.size()) << "one point for two halfedges";
  EXPECT_EQ(seamed.points.size(), plain.points.size() + doubled);
  EXPECT_GT(doubled, 3u);
}

TEST_F(RefinementOfASheet, OfAnApproximateFieldIsHeldAgainstThatField)
{
  for (const double relativeError : { 1e-4, 1e-3, 1e-2, 1e-1 })
  {
    SCOPED_TRACE(relativeError);
    const DistanceField field =
      solveKeepingAll(engine_, engineCurves(engine_, source_), relativeError);
    const double tolerance = 2e-3 * largest_;
    const RefinedMesh refined = refineTo(field, tolerance, 100000);
    EXPECT_FALSE(refined.stoppedAtMaximum);
    // in a field not solved for refinement, faces may differ where they meet by the error of
    // merging
    EXPECT_LE(refined.errorBound, tolerance + field.relativeErrorBound() * largest_);
    Random random(6);
    const Samples samples = sample(field, refined, 10000, random);
    std::vector<double> computed;
    for (const MeshPoint& place : samples.places)
    {
      computed.push_back(field.distance(enginePoint(engine_, place)));
    }
    const double rounding = EngineAccuracy * largest_;
    EXPECT_LE(largestDifference(samples, computed), refined.errorBound + rounding);
    const BruteForceResult truth = bruteForceDistances(mesh_, source_, samples.places);
    EXPECT_LE(largestDifference(samples, truth.queries),
      refined.errorBound + field.relativeErrorBound() * largest_ + rounding);
    expectSameSurface(field, refined);
  }
}

//----------------------------------------------------------------------------
namespace
{

double diagonal(const PlainMesh& mesh)
{
  Vec3 least = mesh.points[0];
  Vec3 most = least;
  for (const Vec3& p : mesh.points)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      least[axis] = std::min(least[axis], p[axis]);
      most[axis] = std::max(most[axis], p[axis]);
    }
  }
  return spaceDistance(least, most);
}

/// The smallest angle of each triangle, in degrees, ascending.
std::vector<double> smallestAngles(const DistanceField& field, const RefinedMesh& refined)
{
  constexpr double degrees = 57.29577951308232;
  const Points points(field, refined);
  std::vector<double> angles;
  for (const geodesic::Triangle& t : refined.triangles)
  {
    double least = 180.0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const geodesic::Vec3 p = points.position(t[k]);
      const geodesic::Vec3 q = points.position(t[(k + 1) % 3]);
      const geodesic::Vec3 r = points.position(t[(k + 2) % 3]);
      using namespace geodesic;
      const double angle = std::atan2(norm(cross(q - p, r - p)), dot(q - p, r - p));
      least = std::min(least, degrees * angle);
    }
    angles.push_back(least);
  }
  std::sort(angles.begin(), angles.end());
  return angles;
}

PlainMesh bumpySphere()
{
  Random random(5);
  PlainMesh mesh = octasphere(16);
  for (Vec3& p : mesh.points)
  {
    const double factor = 1.0 + 0.05 * random.uniform();
    p = { factor * p[0], factor * p[1], factor * p[2] };
  }
  return mesh;
}

/// Refines to fractions of the diagonal, the largest first, as the filter solves.
void expectShapesToStay(
  const PlainMesh& mesh, const std::string& name, const std::vector<double>& fractions)
{
  const TriangleMesh engine = engineMesh(mesh);
  const auto curves = engineCurves(engine, Sources{ { vertexPoint(mesh, 0) }, {} });
  const DistanceField field = solveKeepingAll(engine, curves);
  double percentileAtFirst = 0.0;
  for (const double fraction : fractions)
  {
    const double tolerance = fraction * diagonal(mesh);
    const RefinedMesh refined = refineTo(solveForRefinement(engine, curves, tolerance), tolerance);
    EXPECT_LE(refined.errorBound, tolerance);
    const std::vector<double> angles = smallestAngles(field, refined);
    const double percentile = angles[angles.size() / 100];
    std::cout << name << " at " << fraction << " of the diagonal: " << refined.triangles.size()
              << " triangles of " << mesh.triangles.size() << " faces, angles: smallest "
              << angles.front() << ", 1st percentile " << percentile << ", median "
              << angles[angles.size() / 2] << "\n";
    percentileAtFirst = percentileAtFirst > 0.0 ? percentileAtFirst : percentile;
    EXPECT_GE(percentile, 0.8 * percentileAtFirst);
    Random random(1);
    const Samples samples = sample(field, refined, 100000, random);
    double measured = 0.0;
    for (std::size_t i = 0; i < samples.places.size(); ++i)
    {
      const double truth = field.distance(enginePoint(engine, samples.places[i]));
      measured = std::max(measured, std::abs(samples.interpolant[i] - truth));
    }
    EXPECT_LE(measured, refined.errorBound);
  }
}

class RefinementOfRealMeshes : public ::testing::TestWithParam<const char*>
{
};

}

TEST(RefinementOfABumpySphere, ShapesDoNotDecayWithDepth)
{
  expectShapesToStay(bumpySphere(), "a bumpy sphere", { 1e-3, 2.5e-4, 1e-4 });
}

TEST_P(RefinementOfRealMeshes, ShapesDoNotDecayWithDepth)
{
  if (meshFolder().empty())
  {
    GTEST_SKIP() << noMeshFolder(GetParam());
  }
  const PlainMesh mesh = readMesh(GetParam());
  ASSERT_FALSE(mesh.triangles.empty()) << "cannot read " << meshFolder() << "/" << GetParam();
  expectShapesToStay(mesh, GetParam(), { 1e-3, 2.5e-4 });
}

INSTANTIATE_TEST_SUITE_P(Files, RefinementOfRealMeshes,
  ::testing::Values("fandisk.obj", "beetle-alt.obj", "stanford-bunny.obj"),
  [](const auto& instance) { return testName(instance.param); });
