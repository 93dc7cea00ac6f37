// SPDX-License-Identifier: BSD-3-Clause
// The result is the same to the last bit however many tasks run, in whatever order.
#include "EngineSupport.h"
#include "OnThreads.h"
#include "truth/RandomCurves.h"
#include "truth/RandomMeshKinds.h"

#include "front/Front.h"
#include "refinement/AdaptiveRefinement.h"
#include "refinement/SolveForRefinement.h"

#include <gtest/gtest.h>

using namespace geodesictest;
using geodesic::DistanceField;
using geodesic::FrontOptions;
using geodesic::KeepWindows;
using geodesic::RefinedMesh;
using geodesic::TriangleMesh;

namespace
{

using geodesic::ParallelFor;

void lastToFirst(std::size_t count, const std::function<void(std::size_t)>& task)
{
  while (count > 0)
  {
    task(--count);
  }
}

struct Mode
{
  double relativeError;
  bool forRefinement;
};

class Parallel : public ::testing::TestWithParam<MeshKind>
{
};

}

TEST_P(Parallel, ResultsDoNotDependOnTasksAndTheirOrder)
{
  Random random(4711);
  const PlainMesh mesh = GetParam().make(1500, random);
  const TriangleMesh engine = engineMesh(mesh);
  CurveMaker maker(mesh, random);
  const auto curves = engineCurves(engine, maker.anySource());
  const double tolerance = 0.01 * largestFinite(solve(engine, curves, {}).vertexDistances());
  for (const Mode mode : { Mode{ 0.0, false }, Mode{ 0.0, true }, Mode{ 0.01, false } })
  {
    FrontOptions options;
    options.relativeError = mode.relativeError;
    const auto solveAs = [&]
    {
      return mode.forRefinement ? solveForRefinement(engine, curves, tolerance, options)
                                : solve(engine, curves, options, KeepWindows::All);
    };
    geodesic::RefinementOptions refinement;
    refinement.tolerance = tolerance;
    const DistanceField field = solveAs();
    const RefinedMesh refined = refine(field, refinement);
    for (const ParallelFor& parallelFor : { ParallelFor(lastToFirst), ParallelFor(onThreads) })
    {
      options.parallelFor = parallelFor;
      const DistanceField other = solveAs();
      EXPECT_EQ(field.vertexDistances(), other.vertexDistances());
      EXPECT_EQ(field.windowsPropagated(), other.windowsPropagated());
      EXPECT_EQ(field.relativeErrorBound(), other.relativeErrorBound());
      const RefinedMesh otherRefined = refine(other, refinement);
      EXPECT_EQ(refined.triangles, otherRefined.triangles);
      EXPECT_EQ(refined.errorBound, otherRefined.errorBound);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, Parallel, ::testing::ValuesIn(meshKinds()),
  [](const auto& instance) { return std::string(instance.param.name); });
