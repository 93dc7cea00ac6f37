// SPDX-License-Identifier: BSD-3-Clause
// The approximate field compared with the exact one on well-known meshes from the folder that
// GEODESIC_TEST_MESHES names: the measured error is within the certified bound, and the bound
// within the requested one.
#include "EngineSupport.h"
#include "truth/MeshFiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <string>

using namespace geodesictest;
using geodesic::DistanceField;
using geodesic::TriangleMesh;

namespace
{

struct MeshFile
{
  const char* name;
  /// The source is the surface's boundary or, without one, a random curve.
  bool fromBoundary = false;
};

std::ostream& operator<<(std::ostream& os, const MeshFile& file)
{
  return os << file.name;
}

using Curves = std::vector<geodesic::SourceCurve>;

class RealApproximation : public ::testing::TestWithParam<MeshFile>
{
protected:
  void SetUp() override
  {
    if (meshFolder().empty())
    {
      GTEST_SKIP() << noMeshFolder(GetParam().name);
    }
  }

  static Curves curves(const PlainMesh& mesh, const TriangleMesh& engine, Random& random)
  {
    if (GetParam().fromBoundary)
    {
      return boundaryCurves(engine);
    }
    CurveMaker maker(mesh, random);
    return engineCurves(engine, { maker.walk(30), maker.straight(30) });
  }

  /// At all vertices and the queries, for every epsilon.
  static void compare(
    const TriangleMesh& engine, const Curves& source, const std::vector<MeshPoint>& queries)
  {
    EngineResult exact;
    std::uint64_t windows = 0;
    {
      // a large mesh has many windows: they are freed before the next solve
      const DistanceField field = solveKeepingAll(engine, source);
      EXPECT_EQ(field.relativeErrorBound(), 0.0);
      exact = valuesOf(field, queries);
      windows = field.windowsPropagated();
    }
    std::cout << "  exact: " << windows << " windows\n";
    for (const double epsilon : { 1e-4, 1e-3, 1e-2, 1e-1 })
    {
      SCOPED_TRACE("epsilon " + std::to_string(epsilon));
      const DistanceField field = solveKeepingAll(engine, source, epsilon);
      EXPECT_LE(field.relativeErrorBound(), epsilon);
      // with 1e-2 most halfedges have one window; with more hardly anything is left to merge
      const bool saturated = epsilon > 1e-2;
      EXPECT_LT(field.windowsPropagated(), saturated ? windows + windows / 100 : windows);
      windows = field.windowsPropagated();
      const double measured = expectCertified(field, queries, exact);
      std::cout << "  requested " << epsilon << ", reported " << field.relativeErrorBound()
                << ", measured " << measured << ": " << windows << " windows\n";
    }
  }
};

}

TEST_P(RealApproximation, MeasuredIsWithinReportedAndThatWithinRequested)
{
  const std::string name = GetParam().name;
  const PlainMesh mesh = readMesh(name);
  ASSERT_FALSE(mesh.triangles.empty()) << "cannot read " << meshFolder() << "/" << name;
  const TriangleMesh engine = engineMesh(mesh);
  ASSERT_EQ(engine.numberOfFaces(), mesh.triangles.size());
  constexpr std::uint64_t seed = 5000;
  constexpr std::size_t numberOfQueries = 20000;
  Random random(seed);
  const std::vector<MeshPoint> queries = randomPoints(mesh, numberOfQueries, random);
  std::cout << name << ", " << engine.numberOfFaces() << " faces, from a "
            << (GetParam().fromBoundary ? "boundary" : "curve") << "\n";
  compare(engine, curves(mesh, engine, random), queries);
  std::cout << name << ", " << engine.numberOfFaces() << " faces, from a vertex\n";
  compare(
    engine, engineCurves(engine, Sources{ { randomVertexPoint(mesh, random) }, {} }), queries);
}

INSTANTIATE_TEST_SUITE_P(Files, RealApproximation,
  ::testing::Values(MeshFile{ "beetle-alt.obj", true }, MeshFile{ "cow.obj" },
    MeshFile{ "fandisk.obj" }, MeshFile{ "homer.obj" }, MeshFile{ "igea.ply" },
    MeshFile{ "nefertiti.obj" }, MeshFile{ "ogre.obj" }, MeshFile{ "rocker-arm.obj" },
    MeshFile{ "spot.obj" }, MeshFile{ "stanford-bunny.obj" }),
  [](const auto& instance) { return testName(instance.param.name); });
