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
    return geodesic::distanceMatrix(mesh, curves, Points, targets, maximumDistance, job);
  }

  Random random;
  PlainMesh plain;
  TriangleMesh mesh;
  std::vector<MeshPoint> points;
  std::vector<SurfacePoint> targets;
  std::vector<geodesic::SourceCurve> curves;
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
          geodesic::distanceMatrix(c.mesh, { c.curves[i] }, Points, { c.targets[j] });
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
  const auto matrix = geodesic::distanceMatrix(
    engine, curves, 3, { SurfacePoint::atVertex(0), SurfacePoint::onEdge(1, 0.2) });
  EXPECT_EQ(matrix[0].front(), 0.0);
  EXPECT_EQ(matrix[1], std::vector<double>(2, geodesic::Infinity));
  EXPECT_EQ(matrix[2].front(), 3.0);
  EXPECT_NEAR(matrix[2].back(), 1.0, 1e-15);
}
