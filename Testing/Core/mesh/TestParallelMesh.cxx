// SPDX-License-Identifier: BSD-3-Clause
// The mesh does not depend on the number of threads, and is right if loops have many tasks.
#include "EngineSupport.h"
#include "Errors.h"
#include "OnThreads.h"
#include "truth/RandomMeshKinds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

using namespace geodesictest;
using geodesic::Id;
using geodesic::Job;
using geodesic::ParallelFor;
using geodesic::TriangleMesh;

namespace
{

class ParallelMesh : public ::testing::TestWithParam<MeshKind>
{
};

}

// Large enough for loops of many tasks.
TEST_P(ParallelMesh, MeshesDoNotDependOnThreads)
{
  Random random(4713);
  PlainMesh mesh = GetParam().make(12000, random);
  const std::size_t faces = mesh.triangles.size();
  mesh.points.push_back(mesh.points.front()); // isolated
  for (std::size_t i = 0; i < faces; i += 997)
  {
    const auto [a, b, c] = mesh.triangles[i];
    mesh.triangles.push_back({ c, a, b }); // a duplicate
    mesh.triangles.insert(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(i), { a, b, a });
  }
  const TriangleMesh engine = engineMesh(mesh);
  for (const ParallelFor& parallelFor : waysToRun())
  {
    const TriangleMesh other(mesh.points, mesh.triangles, Job({}, parallelFor));
    ASSERT_EQ(engine.numberOfFaces(), other.numberOfFaces());
    EXPECT_EQ(numberOfEdges(engine), numberOfEdges(other));
    EXPECT_EQ(engine.numberOfNonManifoldEdges(), other.numberOfNonManifoldEdges());
    for (Id halfedge = 0; halfedge < engine.numberOfHalfedges(); ++halfedge)
    {
      ASSERT_EQ(engine.origin(halfedge), other.origin(halfedge));
      ASSERT_EQ(engine.nextSibling(halfedge), other.nextSibling(halfedge));
      ASSERT_EQ(engine.length(halfedge), other.length(halfedge));
      ASSERT_EQ(engine.cornerAngle(halfedge), other.cornerAngle(halfedge));
      ASSERT_EQ(engine.inputFace(halfedge / 3), other.inputFace(halfedge / 3));
    }
    for (Id vertex = 0; vertex < engine.numberOfVertices(); ++vertex)
    {
      const geodesic::IdRange corners = engine.cornersAt(vertex);
      const geodesic::IdRange others = other.cornersAt(vertex);
      ASSERT_TRUE(std::equal(corners.begin(), corners.end(), others.begin(), others.end()));
      ASSERT_EQ(engine.pseudoSource(vertex), other.pseudoSource(vertex));
    }
  }
}

// Compares with the definitions, in loops of many tasks.
TEST_P(ParallelMesh, SiblingsAndCornersOfLargeMeshesAreThoseOfTheirVertices)
{
  Random random(4714);
  const PlainMesh mesh = GetParam().make(12000, random);
  const TriangleMesh engine(mesh.points, mesh.triangles, Job({}, waysToRun().back()));
  std::map<std::pair<Id, Id>, std::vector<Id>> halfedges;
  std::vector<std::vector<Id>> corners(engine.numberOfVertices());
  for (Id halfedge = 0; halfedge < engine.numberOfHalfedges(); ++halfedge)
  {
    const auto ends = std::minmax({ engine.origin(halfedge), engine.destination(halfedge) });
    halfedges[ends].push_back(halfedge);
    corners[engine.origin(halfedge)].push_back(halfedge);
  }
  EXPECT_EQ(halfedges.size(), numberOfEdges(engine));
  for (const auto& [ends, around] : halfedges)
  {
    for (std::size_t i = 0; i < around.size(); ++i)
    {
      ASSERT_EQ(engine.nextSibling(around[i]), around[(i + 1) % around.size()]);
    }
  }
  for (Id vertex = 0; vertex < engine.numberOfVertices(); ++vertex)
  {
    const geodesic::IdRange found = engine.cornersAt(vertex);
    ASSERT_EQ(corners[vertex], std::vector<Id>(found.begin(), found.end()));
  }
}

TEST(ParallelMeshErrors, NameTheFirstWrongFaceOrPoint)
{
  Random random(4715);
  const PlainMesh mesh = meshKinds().front().make(12000, random);
  const auto messageOf = [](const PlainMesh& wrong, const ParallelFor& parallelFor) -> std::string
  {
    try
    {
      TriangleMesh(wrong.points, wrong.triangles, Job({}, parallelFor));
    }
    catch (const geodesic::MeshError& error)
    {
      return error.what();
    }
    return "no error";
  };
  PlainMesh wrongFaces = mesh;
  PlainMesh wrongPoints = mesh;
  for (const std::size_t i : { std::size_t(4000), std::size_t(9000), std::size_t(9001) })
  {
    wrongFaces.triangles.at(i)[1] = static_cast<Id>(mesh.points.size());
    wrongPoints.points.at(i / 2)[2] = std::nan("");
  }
  for (const ParallelFor& parallelFor : waysToRun())
  {
    EXPECT_NE(messageOf(wrongFaces, parallelFor).find("Face 4000 "), std::string::npos);
    EXPECT_NE(messageOf(wrongPoints, parallelFor).find("Point 2000 "), std::string::npos);
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, ParallelMesh, ::testing::ValuesIn(meshKinds()),
  [](const auto& instance) { return std::string(instance.param.name); });
