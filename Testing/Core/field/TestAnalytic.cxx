// SPDX-License-Identifier: BSD-3-Clause
// The engine against distances that are known without a mesh.
#include "EngineSupport.h"
#include "truth/AnalyticCases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

using namespace geodesictest;

namespace
{

constexpr std::uint64_t Rounds = 60;

void expectTruth(AnalyticCase (*makeCase)(Random&))
{
  double worst = 0.0;
  for (std::uint64_t seed = 0; seed < Rounds; ++seed)
  {
    Random random(seed);
    const AnalyticCase c = makeCase(random);
    const EngineResult result = engineDistances(c.mesh, c.sources, c.queries);
    const double largest = largestFinite(c.vertexTruth);
    const double atVertices = worstError(result.vertices, c.vertexTruth, largest);
    const double atQueries = worstError(result.queries, c.queryTruth, largest);
    EXPECT_LE(atVertices, OrdinaryAccuracy) << "vertices, seed " << seed;
    EXPECT_LE(atQueries, OrdinaryAccuracy) << "surface points, seed " << seed;
    worst = std::max({ worst, atVertices, atQueries });
  }
  ::testing::Test::RecordProperty("worst_relative_error", std::to_string(worst));
}

}

TEST(Analytic, AnyTriangulationOfTheConvexPlaneIsEuclidean)
{
  expectTruth(planeCase);
}

TEST(Analytic, ARegularGridIsEuclidean)
{
  expectTruth(regularGridCase);
}

TEST(Analytic, NeedlesInThePlaneAreEuclidean)
{
  expectTruth(stretchedPlaneCase);
}

TEST(Analytic, ABoxUnfolds)
{
  expectTruth(boxCase);
}

TEST(Analytic, ACylinderUnrolls)
{
  expectTruth(cylinderCase);
}

TEST(Analytic, AConeUnrolls)
{
  expectTruth(coneCase);
}

TEST(Analytic, GeodesicsBendAtASaddleVertex)
{
  expectTruth(saddleFanCase);
}

TEST(Analytic, ATetrahedronUnfolds)
{
  expectTruth(tetrahedronCase);
}

TEST(Analytic, HolesAreGoneAroundLikeInAVisibilityGraph)
{
  expectTruth(holesCase);
}

TEST(Analytic, TheCornerOfAnLIsGoneAround)
{
  expectTruth(lShapeCase);
}

TEST(Analytic, ANonManifoldEdgeConductsIntoEveryFace)
{
  expectTruth(bookCase);
}

TEST(Analytic, ABowTieConducts)
{
  expectTruth(bowTieCase);
}
