// SPDX-License-Identifier: BSD-3-Clause
// Ways around a vertex: their number, and roundings. That their angles are the least of all ways,
// the distances around branching fans show (SourceWindows).
#include "EngineSupport.h"
#include "source/BranchingFan.h"

#include "source/CurveWedge.h"

#include <gtest/gtest.h>

using namespace geodesictest;
using geodesic::EdgeAngle;
using geodesic::Id;
using geodesic::leastAnglesAround;
using geodesic::TriangleMesh;

TEST(AnglesAroundVertex, TheWorkGrowsWithTheFacesWhereTheWaysAreExponential)
{
  for (const Index stages : { 20u, 200u, 2000u })
  {
    const TriangleMesh mesh = engineMesh(BranchingFan(stages, 3.0).mesh);
    const Id first = *mesh.cornersAt(0).begin();
    const std::size_t entered =
      leastAnglesAround(mesh, 0, { { TriangleMesh::previousInFace(first), 0.0 } }, 10.0).size();
    EXPECT_LE(entered, 2 * mesh.cornersAt(0).size());
    EXPECT_GE(entered, mesh.cornersAt(0).size() - 2) << "every face is entered";
  }
}

// A curve's next segment is laid out behind one without length, so that rounding may put it below
// the edge that it runs along. At a straight corner that must not turn it around.
TEST(AnglesAroundVertex, ADirectionARoundingBelowTheEdgeOfAStraightCornerIsAlongTheEdge)
{
  const TriangleMesh mesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 1, 1, 0 } },
    { { 1, 2, 0 }, { 0, 1, 3 }, { 1, 2, 3 } });
  ASSERT_EQ(mesh.numberOfFaces(), 3U);
  const geodesic::SurfacePoint vertex = geodesic::SurfacePoint::atVertex(1);
  const auto boundsIn = [&](Id face, double y)
  {
    geodesic::SegmentEnd end;
    end.from = vertex;
    end.to = vertex;
    end.face = 0;
    end.onward = { 0, { -1.0, y } };
    std::vector<std::array<double, 3>> bounds;
    const geodesic::CurveWedge wedge = wedgeAround(mesh, vertex, { end });
    for (auto bound = wedge.lower_bound(face); bound != wedge.upper_bound(face); ++bound)
    {
      const geodesic::FaceDirection& direction = bound->second;
      bounds.push_back(
        { static_cast<double>(direction.halfedge), direction.vector.x, direction.vector.y });
    }
    return bounds;
  };
  // The segment runs along the edge to vertex 0, at a right angle to the way up and at a straight
  // one to the edge to vertex 2.
  ASSERT_EQ(boundsIn(1, 0.0).size(), 1U);
  EXPECT_EQ(boundsIn(1, -1e-17), boundsIn(1, 0.0));
  EXPECT_EQ(boundsIn(2, -1e-17), boundsIn(2, 0.0));
}

// All faces lie in the plane. One of the segment's, without area, has no length along one of its
// edges at the vertex.
TEST(AnglesAroundVertex, BoundsInAFaceWithAnEdgeOfNoLengthHaveTheDirectionOfTheSegment)
{
  const TriangleMesh mesh({ { 0, 0, 0 }, { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, 1, 0 }, { 0.5, -1, 0 } },
    { { 2, 0, 1 }, { 0, 2, 3 }, { 1, 4, 2 } });
  ASSERT_EQ(mesh.numberOfFaces(), 3U);
  ASSERT_EQ(mesh.length(mesh.cornerAt(0, 0)), 0.0);
  geodesic::SegmentEnd end;
  end.from = geodesic::SurfacePoint::atVertex(0);
  end.to = geodesic::SurfacePoint::atVertex(2);
  end.face = 0;
  std::array<int, 3> bounds{};
  for (const auto& [face, bound] : wedgeAround(mesh, end.from, { end }))
  {
    ++bounds[face];
    const Vec3& a = mesh.point(mesh.origin(bound.halfedge));
    const Vec3& b = mesh.point(mesh.destination(bound.halfedge));
    const double length = mesh.length(bound.halfedge);
    ASSERT_GT(length, 0.0);
    const geodesic::Vec2 x = { (b[0] - a[0]) / length, (b[1] - a[1]) / length };
    const geodesic::Vec2 v = bound.vector;
    EXPECT_NEAR(x.x * v.x - x.y * v.y, 1.0, 1e-14) << "face " << face;
    EXPECT_NEAR(x.y * v.x + x.x * v.y, 0.0, 1e-14) << "face " << face;
  }
  EXPECT_EQ(bounds[0], 1);
}
