// SPDX-License-Identifier: BSD-3-Clause
// The result is the same to the last bit for any number of tasks, in any order.
#include "EngineSupport.h"
#include "OnThreads.h"
#include "truth/RandomCurves.h"
#include "truth/RandomMeshKinds.h"

#include "front/Front.h"
#include "refinement/AdaptiveRefinement.h"
#include "refinement/SolveForRefinement.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

using namespace geodesictest;
using geodesic::DistanceField;
using geodesic::FrontOptions;
using geodesic::Id;
using geodesic::Job;
using geodesic::KeepWindows;
using geodesic::ParallelFor;
using geodesic::RefinedMesh;
using geodesic::SourceCurve;
using geodesic::TriangleMesh;

namespace
{

struct Mode
{
  double relativeError;
  bool forRefinement;
};

class Parallel : public ::testing::TestWithParam<MeshKind>
{
protected:
  Random random_{ 4711 };
  PlainMesh plain_ = GetParam().make(600, random_);
  TriangleMesh mesh_ = engineMesh(plain_);
  std::vector<SourceCurve> curves_ = engineCurves(mesh_, CurveMaker(plain_, random_).anySource());
  double largest_ = largestFinite(solve(mesh_, curves_, {}).vertexDistances());
};

void expectSameField(const DistanceField& field, const DistanceField& other)
{
  EXPECT_EQ(field.vertexDistances(), other.vertexDistances());
  EXPECT_EQ(field.windowsPropagated(), other.windowsPropagated());
  EXPECT_EQ(field.relativeErrorBound(), other.relativeErrorBound());
  EXPECT_EQ(field.droppedErrorBound(), other.droppedErrorBound());
}

void expectSameMesh(const RefinedMesh& refined, const RefinedMesh& other)
{
  EXPECT_EQ(refined.triangles, other.triangles);
  EXPECT_EQ(refined.faces, other.faces);
  EXPECT_EQ(refined.errorBound, other.errorBound);
  EXPECT_EQ(refined.stoppedAtMaximum, other.stoppedAtMaximum);
  ASSERT_EQ(refined.points.size(), other.points.size());
  for (std::size_t i = 0; i < refined.points.size(); ++i)
  {
    EXPECT_EQ(refined.points[i].parents, other.points[i].parents);
    EXPECT_EQ(refined.points[i].weight, other.points[i].weight);
    EXPECT_EQ(refined.points[i].position, other.points[i].position);
    EXPECT_EQ(refined.points[i].distance, other.points[i].distance);
  }
}

/// Each corner of each face as its own point, except in the first half of the faces.
void giveCornersOfTheirOwn(const TriangleMesh& mesh, geodesic::RefinementOptions& options)
{
  options.numberOfPoints = mesh.numberOfVertices();
  for (Id face = 0; face < mesh.numberOfFaces(); ++face)
  {
    options.cornerPoints.push_back(mesh.triangle(face));
    for (std::size_t k = 0; k < 3 && face > mesh.numberOfFaces() / 2; ++k)
    {
      options.cornerPoints.back()[k] = options.numberOfPoints++;
    }
  }
}

}

TEST_P(Parallel, ResultsDoNotDependOnTasksAndTheirOrder)
{
  const double tolerance = 0.01 * this->largest_;
  for (const Mode mode : { Mode{ 0.0, false }, Mode{ 0.0, true }, Mode{ 0.01, false } })
  {
    FrontOptions options;
    options.relativeError = mode.relativeError;
    const auto solveAs = [&]
    {
      return mode.forRefinement ? solveForRefinement(this->mesh_, this->curves_, tolerance, options)
                                : solve(this->mesh_, this->curves_, options, KeepWindows::All);
    };
    geodesic::RefinementOptions refinement;
    refinement.tolerance = tolerance;
    const DistanceField field = solveAs();
    const RefinedMesh refined = refine(field, refinement);
    for (const ParallelFor& parallelFor : waysToRun())
    {
      options.job = Job({}, parallelFor);
      refinement.job = Job({}, parallelFor);
      const DistanceField other = solveAs();
      expectSameField(field, other);
      expectSameMesh(refined, refine(other, refinement));
    }
  }
}

TEST_P(Parallel, RefinementThatStopsOrHasCornersOfItsOwnDoesNotDependOnThreads)
{
  const double tolerance = 0.002 * this->largest_;
  const DistanceField field = solveForRefinement(this->mesh_, this->curves_, tolerance);
  geodesic::RefinementOptions stopping;
  stopping.tolerance = tolerance;
  stopping.maximumFaces = this->mesh_.numberOfFaces() + this->mesh_.numberOfFaces() / 20;
  geodesic::RefinementOptions withCorners;
  withCorners.tolerance = tolerance;
  giveCornersOfTheirOwn(this->mesh_, withCorners);
  for (geodesic::RefinementOptions options : { stopping, withCorners })
  {
    const RefinedMesh refined = refine(field, options);
    EXPECT_GT(refined.points.size(), 0U);
    for (const ParallelFor& parallelFor : waysToRun())
    {
      options.job = Job({}, parallelFor);
      expectSameMesh(refined, refine(field, options));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, Parallel, ::testing::ValuesIn(meshKinds()),
  [](const auto& instance) { return std::string(instance.param.name); });
