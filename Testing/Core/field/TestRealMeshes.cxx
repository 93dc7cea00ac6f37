// SPDX-License-Identifier: BSD-3-Clause
// Well-known meshes, from the folder that GEODESIC_TEST_MESHES names.
#include "EngineSupport.h"
#include "truth/MeshFiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

using namespace geodesictest;

namespace
{

class RealMeshes : public ::testing::Test
{
protected:
  void SetUp() override
  {
    if (meshFolder().empty())
    {
      GTEST_SKIP() << noMeshFolder("fandisk.obj, spot.obj, beetle-alt.obj, igea.ply");
    }
  }

  static PlainMesh read(const std::string& name)
  {
    PlainMesh mesh = readMesh(name);
    EXPECT_FALSE(mesh.triangles.empty()) << "cannot read " << meshFolder() << "/" << name;
    return mesh;
  }

  static void expectSymmetry(const PlainMesh& mesh)
  {
    const geodesic::TriangleMesh engine = engineMesh(mesh);
    Random random(1);
    std::vector<Index> vertices;
    std::vector<std::vector<double>> fields;
    for (int i = 0; i < 4; ++i)
    {
      vertices.push_back(random.below(mesh.points.size()));
      const geodesic::SourceCurve source =
        geodesic::pointCurve(geodesic::SurfacePoint::atVertex(vertices.back()));
      fields.push_back(geodesic::solve(engine, { source }).vertexDistances());
    }
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      for (std::size_t j = 0; j < i; ++j)
      {
        const double there = fields[i][vertices[j]];
        const double back = fields[j][vertices[i]];
        EXPECT_TRUE(
          there == back || std::abs(there - back) <= EngineAccuracy * largestFinite(fields[i]))
          << "vertices " << vertices[i] << " and " << vertices[j] << ": " << there << ", " << back;
      }
    }
  }

  /// Compares where the distance is below a fraction of the largest.
  static void expectBruteForce(const PlainMesh& mesh,
    const std::vector<geodesic::SourceCurve>& curves, const Sources& sources, double fraction,
    std::size_t atLeast)
  {
    const geodesic::TriangleMesh engine = engineMesh(mesh);
    const std::vector<double> computed = geodesic::solve(engine, curves).vertexDistances();
    const double largest = largestFinite(computed);
    BruteForceOptions options;
    options.maximumDistance = fraction * largest;
    const std::vector<double> truth = bruteForceDistances(mesh, sources, {}, options).vertices;
    std::size_t compared = 0;
    double worst = 0.0;
    for (std::size_t v = 0; v < truth.size(); ++v)
    {
      if (truth[v] <= options.maximumDistance)
      {
        ++compared;
        const double error = std::abs(computed[v] - truth[v]) / largest;
        EXPECT_LE(error, EngineAccuracy) << "vertex " << v;
        worst = std::max(worst, error);
      }
      else
      {
        EXPECT_GT(computed[v], options.maximumDistance * (1.0 - EngineAccuracy)) << "vertex " << v;
      }
    }
    EXPECT_GE(compared, atLeast);
    RecordProperty("vertices_compared", static_cast<int>(compared));
    RecordProperty("worst_relative_error", std::to_string(worst));
  }

  static void expectBruteForceFromRandomCurve(const PlainMesh& mesh, double fraction)
  {
    const geodesic::TriangleMesh engine = engineMesh(mesh);
    ASSERT_EQ(engine.numberOfFaces(), mesh.triangles.size());
    for (Random& random : EachSeed(3))
    {
      CurveMaker maker(mesh, random);
      const std::vector<Polyline> curves = { maker.walk(4), maker.straight(5), maker.point() };
      expectBruteForce(mesh, engineCurves(engine, curves), toSources(curves), fraction, 100);
    }
  }
};

}

// The file has triangle strips, in which the orientation alternates.
TEST_F(RealMeshes, IgeaIsReadAsAClosedSurfaceOfOneOrientation)
{
  const PlainMesh mesh = read("igea.ply");
  std::set<std::pair<Index, Index>> halfedges;
  for (const Triangle& t : mesh.triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      EXPECT_TRUE(halfedges.emplace(t[k], t[(k + 1) % 3]).second) << t[k] << ", " << t[(k + 1) % 3];
    }
  }
  for (const auto& [from, to] : halfedges)
  {
    EXPECT_EQ(halfedges.count({ to, from }), 1u) << from << ", " << to;
  }
}

TEST_F(RealMeshes, AreSymmetricBetweenVertices)
{
  for (const char* name : { "fandisk.obj", "spot.obj", "beetle-alt.obj" })
  {
    SCOPED_TRACE(name);
    expectSymmetry(read(name));
  }
}

TEST_F(RealMeshes, AgreeWithBruteForceNearTheSource)
{
  for (const char* name : { "fandisk.obj", "spot.obj" })
  {
    SCOPED_TRACE(name);
    expectBruteForceFromRandomCurve(read(name), 0.3);
  }
}

TEST_F(RealMeshes, BeetlesBoundaryAgreesWithBruteForce)
{
  const PlainMesh mesh = read("beetle-alt.obj");
  const geodesic::TriangleMesh engine = engineMesh(mesh);
  expectBruteForce(
    mesh, boundaryCurves(engine), boundarySources(engine), 1.0, mesh.points.size() / 3);
}
