// SPDX-License-Identifier: BSD-3-Clause
// Distances from several sources to several targets, compared with brute force, with each other and
// with the field of each source alone.
#include "EngineSupport.h"
#include "OnThreads.h"

#include "Errors.h"
#include "field/DistanceMatrix.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>

using namespace geodesictest;
using geodesic::Id;
using geodesic::Job;
using geodesic::SurfacePoint;
using geodesic::TriangleMesh;

namespace
{

constexpr std::size_t Points = 12;

class DistanceMatrices : public ::testing::TestWithParam<MeshKind>
{
};

/// A random mesh with points on it, as sources and as targets.
struct MatrixCase
{
  MatrixCase(const MeshKind& kind, std::uint64_t seed)
    : random(seed)
    , plain(kind.make(random.between(20, 300), random))
    , mesh(engineMesh(plain))
    , points(randomPoints(plain, Points, random))
  {
    for (const MeshPoint& point : points)
    {
      targets.push_back(enginePoint(mesh, point));
      curves.push_back(geodesic::pointCurve(targets.back()));
      curves.back().source = static_cast<Id>(curves.size() - 1);
    }
  }

  std::vector<std::vector<double>> matrix(
    double maximumDistance = geodesic::Infinity, const Job& job = {}) const
  {
    return geodesic::distanceMatrix(
      mesh, setsOf(curves, Points), setsOf(targets), maximumDistance, job);
  }

  Random random;
  PlainMesh plain;
  TriangleMesh mesh;
  std::vector<MeshPoint> points;
  std::vector<SurfacePoint> targets;
  std::vector<geodesic::SourceCurve> curves;
};

/// How many solves there are, each of which is a long task.
struct SolveCount
{
  std::size_t solves = 0;

  Job job()
  {
    return Job({},
      [this](std::size_t count, const std::function<void(std::size_t)>& task,
        const std::function<void()>&)
      {
        this->solves = count;
        onThreads(count, task);
      });
  }
};

double largestFinite(const std::vector<std::vector<double>>& matrix)
{
  double largest = 0.0;
  for (const std::vector<double>& row : matrix)
  {
    largest = std::max(largest, geodesictest::largestFinite(row));
  }
  return largest;
}

/// The largest entry within a bound.
double largestUpTo(const std::vector<std::vector<double>>& matrix, double bound)
{
  double largest = 0.0;
  for (const std::vector<double>& row : matrix)
  {
    for (const double distance : row)
    {
      largest = distance <= bound ? std::max(largest, distance) : largest;
    }
  }
  return largest;
}

}

TEST_P(DistanceMatrices, BetweenPointsAreSymmetricAndTrue)
{
  double worst = 0.0;
  for (std::uint64_t seed = 0; seed < meshesOfAKind(10); ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const MatrixCase c(GetParam(), seed + 91000);
    const std::vector<std::vector<double>> matrix = c.matrix();
    const double largest = largestFinite(matrix);
    for (std::size_t i = 0; i < Points; ++i)
    {
      Sources source;
      source.points = { c.points[i] };
      const BruteForceResult truth = bruteForceDistances(c.plain, source, c.points);
      EXPECT_LE(
        worstError(matrix[i], truth.queries, std::max(largest, 1e-300)), accuracyOn(GetParam()));
      for (std::size_t j = 0; j < Points; ++j)
      {
        if (matrix[i][j] == matrix[j][i])
        {
          continue; // both may be infinite
        }
        const double difference = std::abs(matrix[i][j] - matrix[j][i]) / largest;
        worst = std::max(worst, difference);
        EXPECT_LE(difference, accuracyOn(GetParam())) << i << ", " << j;
      }
    }
  }
  std::cout << "worst asymmetry on " << GetParam().name << ": " << worst << "\n";
}

TEST_P(DistanceMatrices, HaveTheBitsOfTheFieldOfEachSourceForAnyTargetsAndInParallel)
{
  for (std::uint64_t seed = 0; seed < meshesOfAKind(5); ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const MatrixCase c(GetParam(), seed + 92000);
    const std::vector<std::vector<double>> matrix = c.matrix();
    EXPECT_EQ(c.matrix(geodesic::Infinity, Job({}, onThreads)), matrix);
    for (std::size_t i = 0; i < Points; ++i)
    {
      const geodesic::DistanceField field = solveKeepingAll(c.mesh, { c.curves[i] });
      for (std::size_t j = 0; j < Points; ++j)
      {
        EXPECT_EQ(matrix[i][j], field.distance(c.targets[j]));
        const auto alone =
          geodesic::distanceMatrix(c.mesh, geodesic::setsOf({ c.curves[i] }, Points),
            geodesic::setsOf(std::vector<SurfacePoint>{ c.targets[j] }));
        EXPECT_EQ(matrix[i][j], alone[i].front()) << "without other sources and targets";
      }
    }
  }
}

// A target exactly at the maximum is within it.
TEST_P(DistanceMatrices, AreInfiniteBeyondTheMaximumAndTheSameWithin)
{
  std::size_t within = 0;
  std::size_t beyond = 0;
  for (std::uint64_t seed = 0; seed < meshesOfAKind(5); ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const MatrixCase c(GetParam(), seed + 93000);
    const std::vector<std::vector<double>> matrix = c.matrix();
    const double limit = largestUpTo(matrix, 0.3 * largestFinite(matrix));
    const std::vector<std::vector<double>> limited = c.matrix(limit);
    for (std::size_t i = 0; i < Points; ++i)
    {
      for (std::size_t j = 0; j < Points; ++j)
      {
        const bool isWithin = matrix[i][j] <= limit;
        EXPECT_EQ(limited[i][j], isWithin ? matrix[i][j] : geodesic::Infinity);
        ++(isWithin ? within : beyond);
      }
    }
  }
  EXPECT_GT(within, 0U);
  EXPECT_GT(beyond, 0U);
}

TEST_P(DistanceMatrices, AreSolvedFromFewTargetsWithTheBitsOfTheirFields)
{
  std::size_t reversed = 0;
  for (std::uint64_t seed = 0; seed < meshesOfAKind(10); ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const MatrixCase c(GetParam(), seed + 94000);
    const std::vector<SurfacePoint> few(c.targets.begin(), c.targets.begin() + 2);
    SolveCount count;
    const std::vector<std::vector<double>> matrix = geodesic::distanceMatrix(
      c.mesh, setsOf(c.curves, Points), setsOf(few), geodesic::Infinity, count.job());
    const std::vector<std::vector<double>> square = c.matrix();
    const double largest = largestFinite(square);
    for (std::size_t i = 0; i < Points; ++i)
    {
      for (std::size_t j = 0; j < few.size(); ++j)
      {
        EXPECT_TRUE(matrix[i][j] == square[i][j] ||
          std::abs(matrix[i][j] - square[i][j]) <= accuracyOn(GetParam()) * largest)
          << i << ", " << j;
        EXPECT_EQ(matrix[i][j], count.solves == few.size() ? square[j][i] : square[i][j]);
      }
    }
    reversed += count.solves == few.size() ? 1 : 0;
  }
  EXPECT_GT(reversed, 0U);
}

INSTANTIATE_TEST_SUITE_P(Kinds, DistanceMatrices, ::testing::ValuesIn(meshKinds()),
  [](const auto& instance) { return std::string(instance.param.name); });

TEST(DistanceMatrix, TakesCurvesWithOneNumberForOneSourceAndNumbersWithoutCurvesForNone)
{
  PlainMesh mesh;
  mesh.points = { { 0, 0, 0 }, { 3, 0, 0 }, { 0, 4, 0 } };
  mesh.triangles = { { 0, 1, 2 } };
  const TriangleMesh engine = engineMesh(mesh);
  std::vector<geodesic::SourceCurve> curves = { geodesic::pointCurve(SurfacePoint::atVertex(1)),
    geodesic::pointCurve(SurfacePoint::atVertex(2)),
    geodesic::pointCurve(SurfacePoint::atVertex(0)) };
  curves[0].source = 2;
  curves[1].source = 2;
  curves[2].source = 0;
  const auto matrix = geodesic::distanceMatrix(engine, setsOf(curves, 3),
    geodesic::setsOf({ SurfacePoint::atVertex(0), SurfacePoint::onEdge(1, 0.2) }));
  EXPECT_EQ(matrix[0].front(), 0.0);
  EXPECT_EQ(matrix[1], std::vector<double>(2, geodesic::Infinity));
  EXPECT_EQ(matrix[2].front(), 3.0);
  EXPECT_NEAR(matrix[2].back(), 1.0, 1e-15);
}

namespace
{

/// A strip of squares along x, as a path on which all distances between points of y = 0 are known.
struct Strip
{
  explicit Strip(std::size_t length)
  {
    for (std::size_t x = 0; x <= length; ++x)
    {
      plain.points.push_back({ static_cast<double>(x), 0, 0 });
      plain.points.push_back({ static_cast<double>(x), 1, 0 });
    }
    for (Index x = 0; x < 2 * length; x += 2)
    {
      plain.triangles.push_back({ x, x + 2, x + 3 });
      plain.triangles.push_back({ x, x + 3, x + 1 });
    }
    mesh = engineMesh(plain);
  }

  static SurfacePoint at(std::size_t x) { return SurfacePoint::atVertex(static_cast<Id>(2 * x)); }

  static geodesic::SourceCurve sourceAt(std::size_t x, std::size_t source)
  {
    geodesic::SourceCurve curve = geodesic::pointCurve(at(x));
    curve.source = static_cast<Id>(source);
    return curve;
  }

  /// Checks the distances from the places of sources, the nearest of each, to the targets.
  ///
  /// \returns how many solves there were.
  std::size_t solve(const std::vector<std::vector<std::size_t>>& sources,
    const std::vector<std::size_t>& targets, double maximum = geodesic::Infinity) const
  {
    std::vector<geodesic::SourceCurve> curves;
    for (std::size_t i = 0; i < sources.size(); ++i)
    {
      for (const std::size_t x : sources[i])
      {
        curves.push_back(sourceAt(x, i));
      }
    }
    std::vector<SurfacePoint> places;
    for (const std::size_t x : targets)
    {
      places.push_back(at(x));
    }
    SolveCount count;
    const auto matrix = geodesic::distanceMatrix(
      mesh, setsOf(curves, sources.size()), setsOf(places), maximum, count.job());
    for (std::size_t i = 0; i < sources.size(); ++i)
    {
      for (std::size_t j = 0; j < targets.size(); ++j)
      {
        double expected = geodesic::Infinity;
        for (const std::size_t x : sources[i])
        {
          expected =
            std::min(expected, std::abs(static_cast<double>(x) - static_cast<double>(targets[j])));
        }
        expected = expected <= maximum ? expected : geodesic::Infinity;
        EXPECT_TRUE(matrix[i][j] == expected ||
          std::abs(matrix[i][j] - expected) <= OrdinaryAccuracy * expected)
          << i << ", " << j << ": " << matrix[i][j] << " for " << expected;
      }
    }
    return count.solves;
  }

  PlainMesh plain;
  TriangleMesh mesh;
};

}

TEST(DistanceMatrix, IsSolvedFromTheSideOfFewer)
{
  const Strip strip(40);
  EXPECT_EQ(strip.solve({ { 0 }, { 10 }, { 20 }, { 30 }, { 40 } }, { 3, 25 }), 2U);
  EXPECT_EQ(strip.solve({ { 3 }, { 25 } }, { 0, 10, 20, 30, 40 }), 2U);
  EXPECT_EQ(strip.solve({ { 3 }, { 25 } }, { 0, 40 }), 2U);
  // Sources of several points, and one of none.
  EXPECT_EQ(strip.solve({ { 0, 1 }, { 10, 12 }, {}, { 39 }, { 30, 31 } }, { 3, 25 }), 2U);
  EXPECT_EQ(strip.solve({ { 0, 40 }, {}, {}, {}, { 30, 1 } }, { 3, 25, 12 }), 5U)
    << "sources without points are no solves";
  EXPECT_EQ(strip.solve({ { 0 }, { 10 }, { 20 }, { 30 }, { 40 } }, { 3, 25 }, 7.0), 2U);
}

TEST(DistanceMatrix, IsSolvedFromSourcesIfTargetsWouldHaveToGoFarther)
{
  const Strip strip(400);
  // Three targets would each go out to the far source, which alone goes as far.
  EXPECT_EQ(strip.solve({ { 0 }, { 1 }, { 2 }, { 3 }, { 400 } }, { 0, 2, 4 }), 5U);
  EXPECT_EQ(strip.solve({ { 0 }, { 1 }, { 2 }, { 3 }, { 400 } }, { 0, 2, 4 }, 4.0), 3U);
}

TEST(DistanceMatrix, OfCurvesIsSolvedFromTheSideOfFewer)
{
  const Strip strip(10);
  std::vector<geodesic::SourceCurve> curves;
  for (std::size_t i = 0; i < 4; ++i)
  {
    curves.push_back(Strip::sourceAt(2 * i, i));
  }
  const auto solves = [&]()
  {
    SolveCount count;
    const auto matrix = geodesic::distanceMatrix(strip.mesh, setsOf(curves, 4),
      geodesic::setsOf({ Strip::at(10), Strip::at(9) }), geodesic::Infinity, count.job());
    EXPECT_NEAR(matrix[3].front(), 4.0, 1e-12);
    return count.solves;
  };
  EXPECT_EQ(solves(), 2U);
  curves[3].points.insert(curves[3].points.begin(), Strip::at(5));
  curves[3].faces = { geodesic::commonFace(strip.mesh, Strip::at(5), Strip::at(6)) };
  curves[3].isCut = { 0, 0 };
  EXPECT_EQ(solves(), 2U);
}
