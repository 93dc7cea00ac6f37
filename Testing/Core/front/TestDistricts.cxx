// SPDX-License-Identifier: BSD-3-Clause
// The districts that the front works in.
#include "front/Districts.h"

#include "EngineSupport.h"
#include "OnThreads.h"
#include "truth/TestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

using namespace geodesictest;
using geodesic::Districts;
using geodesic::Id;
using geodesic::Job;
using geodesic::TriangleMesh;

TEST(Districts, OfATinyMeshThereIsOneAndOfALargeOneNotMoreThanMost)
{
  const Job job({}, onThreads);
  EXPECT_EQ(Districts(TriangleMesh(), job).size(), 1U);
  EXPECT_EQ(Districts(engineMesh(regularGrid(8, 8)), job).size(), 1U);
  const TriangleMesh large(std::vector<geodesic::Vec3>(4400000), { { 0, 1, 2 } });
  EXPECT_EQ(Districts(large, job).size(), Districts::Most);
}

TEST(Districts, OfOneThreadThereIsOneWithTheBlocksOfMany)
{
  const TriangleMesh mesh = engineMesh(regularGrid(60, 50));
  const Districts one(mesh);
  const Districts many(mesh, Job({}, onThreads));
  ASSERT_EQ(one.size(), 1U);
  ASSERT_GT(many.size(), 1U);
  std::vector<Id> vertices;
  for (Id vertex = mesh.numberOfVertices(); vertex-- > 0;)
  {
    EXPECT_EQ(one.of(vertex), 0U);
    EXPECT_EQ(one.blockOf(vertex), many.of(vertex));
    vertices.push_back(vertex);
  }
  one.sort(vertices);
  for (std::size_t i = 1; i < vertices.size(); ++i)
  {
    const auto place = [&](Id vertex) { return std::make_pair(many.of(vertex), vertex); };
    ASSERT_LT(place(vertices[i - 1]), place(vertices[i]));
  }
}

TEST(Districts, AreOfNearlyEqualSizeAndMostNeighboursAreOfOne)
{
  const TriangleMesh mesh = engineMesh(regularGrid(300, 250));
  const Districts districts(mesh, Job({}, onThreads));
  ASSERT_GE(districts.size(), 8U);
  std::vector<Id> sizes(districts.size(), 0);
  for (Id vertex = 0; vertex < mesh.numberOfVertices(); ++vertex)
  {
    ++sizes[districts.of(vertex)];
  }
  const auto [least, most] = std::minmax_element(sizes.begin(), sizes.end());
  EXPECT_LE(*most, 1.2 * *least);
  Id crossed = 0;
  for (Id halfedge = 0; halfedge < mesh.numberOfHalfedges(); ++halfedge)
  {
    crossed +=
      districts.of(mesh.origin(halfedge)) != districts.of(mesh.destination(halfedge)) ? 1 : 0;
  }
  EXPECT_LE(crossed, 0.15 * mesh.numberOfHalfedges());
}

TEST(Districts, VerticesOfOnePlaceAreOneDistrict)
{
  const std::vector<geodesic::Vec3> points(10000, geodesic::Vec3{ 1.0, 2.0, 3.0 });
  const TriangleMesh mesh(points, { { 0, 1, 2 } });
  const Districts districts(mesh, Job({}, onThreads));
  for (Id vertex = 1; vertex < mesh.numberOfVertices(); ++vertex)
  {
    ASSERT_EQ(districts.of(vertex), districts.of(0));
  }
}
