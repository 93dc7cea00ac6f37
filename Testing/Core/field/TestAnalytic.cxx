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

class Analytic : public ::testing::TestWithParam<AnalyticConfiguration>
{
};

}

TEST_P(Analytic, DistancesAreThoseInClosedForm)
{
  double worst = 0.0;
  for (Random& random : EachSeed(60))
  {
    const AnalyticCase c = GetParam().make(random);
    const EngineResult result = engineDistances(c.mesh, c.sources, c.queries);
    const double largest = largestFinite(c.vertexTruth);
    const double atVertices = worstError(result.vertices, c.vertexTruth, largest);
    const double atQueries = worstError(result.queries, c.queryTruth, largest);
    EXPECT_LE(atVertices, OrdinaryAccuracy) << "vertices";
    EXPECT_LE(atQueries, OrdinaryAccuracy) << "surface points";
    worst = std::max({ worst, atVertices, atQueries });
  }
  ::testing::Test::RecordProperty("worst_relative_error", std::to_string(worst));
}

INSTANTIATE_TEST_SUITE_P(Table, Analytic, ::testing::ValuesIn(analyticConfigurations()),
  [](const auto& instance) { return std::string(instance.param.name); });
