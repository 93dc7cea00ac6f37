// SPDX-License-Identifier: BSD-3-Clause
// One rank's part of a surface: coordinates of its vertices, faces of its triangles, and the
// boundary in a patch of several parts.
#include "RanksSupport.h"
#include "truth/TestMeshes.h"

#include "mesh/ReplicatedPatch.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using namespace geodesic;
using geodesictest::MemoryRanks;
using geodesictest::ownFacesOf;

TEST(MeshPartition, PointsOfSeamsLieWhereTheLowestRankHasThem)
{
  const Vec3 low = { 1.0, 1.0, 0.0 };
  const Vec3 high = { std::nextafter(1.0, 2.0), std::nextafter(1.0, 0.0), 0.0 };
  MemoryRanks(3).run(
    [&](Exchange& exchange)
    {
      // A triangle on each rank; the first point is common.
      const double side = 1.0 + exchange.rank();
      const auto key = static_cast<std::uint64_t>(exchange.rank());
      const std::vector<Vec3> points = { exchange.rank() == 0 ? low : high, { 2.0, side, 0.0 },
        { 2.0, side + 0.5, 0.0 } };
      const MeshPartition part(points, { { 0, 1, 2 } }, { 100, 2 * key, 2 * key + 1 }, exchange);
      EXPECT_EQ(part.mesh().point(0), low) << "rank " << exchange.rank();
    });
}

TEST(MeshPartition, ATriangleThatNamesAVertexTwiceIsNoFace)
{
  MemoryRanks(2).run(
    [](Exchange& exchange)
    {
      const double x = 2.0 * exchange.rank();
      const auto key = static_cast<std::uint64_t>(3 * exchange.rank());
      const MeshPartition part({ { x, 0.0, 0.0 }, { x + 1.0, 0.0, 0.0 }, { x, 1.0, 0.0 } },
        { { 0, 0, 1 }, { 0, 1, 1 }, { 1, 0, 1 }, { 0, 1, 2 } }, { key, key + 1, key + 2 },
        exchange);
      ASSERT_EQ(part.endOfOwnFaces() - part.firstOwnFace(), 1U);
      EXPECT_EQ(part.triangleOf(part.firstOwnFace()), 3U);
    });
}

TEST(ReplicatedPatch, OfAllFacesEndsWhereTheWholeSurfaceDoes)
{
  // Faces of a grid go to the ranks in turn, so each rank has copies of nearly all other faces.
  const geodesictest::PlainMesh whole = geodesictest::regularGrid(4, 4);
  constexpr int ranks = 3;
  MemoryRanks(ranks).run(
    [&](Exchange& exchange)
    {
      std::vector<Vec3> points;
      std::vector<std::uint64_t> keys;
      std::vector<Id> numbers(whole.points.size(), NoId);
      std::vector<Triangle> triangles;
      for (std::size_t face = rankIndex(exchange.rank()); face < whole.triangles.size();
           face += ranks)
      {
        Triangle& triangle = triangles.emplace_back();
        for (std::size_t k = 0; k < 3; ++k)
        {
          const auto vertex = static_cast<std::size_t>(whole.triangles[face][k]);
          if (numbers[vertex] == NoId)
          {
            numbers[vertex] = static_cast<Id>(points.size());
            const auto& p = whole.points[vertex];
            points.push_back({ p[0], p[1], p[2] });
            keys.push_back(vertex);
          }
          triangle[k] = numbers[vertex];
        }
      }
      const MeshPartition part(points, triangles, keys, exchange);
      const ReplicatedPatch patch(part, ownFacesOf(part));
      ASSERT_EQ(patch.mesh().numberOfFaces(), whole.triangles.size());
      Id boundaryEdges = 0;
      for (Id halfedge = 0; halfedge < patch.mesh().numberOfHalfedges(); ++halfedge)
      {
        boundaryEdges += patch.mesh().isBoundary(halfedge) ? 1 : 0;
      }
      EXPECT_EQ(boundaryEdges, 4U * 4U) << "on rank " << exchange.rank();
    });
}

}
