// SPDX-License-Identifier: BSD-3-Clause
// The first windows of sources where rounding could send rays through another edge; around vertices
// with many faces; at edges without length. Elsewhere, the distances of whole meshes show them.
#include "EngineSupport.h"
#include "Watched.h"
#include "source/BranchingFan.h"

#include "Errors.h"
#include "source/SourceWindows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace geodesictest;
using geodesic::Id;
using geodesic::LeavingWindow;
using geodesic::makeSourceWindows;
using geodesic::SourceCurve;
using geodesic::SurfacePoint;
using geodesic::TriangleMesh;

namespace
{

PlainMesh tetrahedron(Random& random)
{
  PlainMesh mesh;
  for (const Vec3& p : { Vec3{ 0, 0, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, { 0, 0, 2 } })
  {
    mesh.points.push_back({ p[0] + random.uniform(-0.5, 0.5), p[1] + random.uniform(-0.5, 0.5),
      p[2] + random.uniform(-0.5, 0.5) });
  }
  mesh.triangles = { { 0, 1, 2 }, { 0, 3, 1 }, { 1, 3, 2 }, { 2, 3, 0 } };
  return mesh;
}

Barycentric insideWeights(Random& random)
{
  const double a = random.uniform(0.1, 1.0);
  const double b = random.uniform(0.1, 1.0);
  const double c = random.uniform(0.1, 1.0);
  return { a / (a + b + c), b / (a + b + c), c / (a + b + c) };
}

/// The windows of a segment, or of the same segment from its end to its beginning.
std::vector<LeavingWindow> windowsOf(
  const TriangleMesh& mesh, geodesic::SourceInFace segment, bool isReversed)
{
  if (isReversed)
  {
    std::swap(segment.a, segment.b);
  }
  std::vector<LeavingWindow> windows;
  geodesic::addSegmentWindows(mesh, segment, windows);
  return windows;
}

/// From vertex 0 to vertex 1 of a mesh whose first face has both.
SourceCurve firstEdge()
{
  SourceCurve curve;
  curve.points = { SurfacePoint::atVertex(0), SurfacePoint::atVertex(1) };
  curve.faces = { 0 };
  curve.isCut = { 0, 0 };
  return curve;
}

}

// From nearly along the edge to nearly at a right angle to it. Beyond the point where the segment
// touches the edge, the distance to its line would be negative.
TEST(SourceWindows, RaysOfASegmentThatTouchesAnEdgeLeaveThroughItUpToThereOnly)
{
  Random random(2);
  int seen = 0;
  for (int i = 0; i < 1000; ++i)
  {
    const TriangleMesh mesh = engineMesh(tetrahedron(random));
    const Id halfedge = random.below(3);
    const double length = mesh.length(halfedge);
    const geodesic::Vec2 touching = { random.uniform(0.4, 0.6) * length, 0.0 };
    const double slope = std::pow(10.0, random.uniform(-10.0, 10.0));
    const double size = 0.05 * length / std::hypot(1.0, slope);
    const double side = random.chance(0.5) ? 1.0 : -1.0;
    const geodesic::Vec2 off = { side * size, slope * size };
    geodesic::SourceInFace segment;
    segment.face = 0;
    segment.a = geodesic::fromHalfedgeFrame(mesh, halfedge, touching);
    segment.b = geodesic::fromHalfedgeFrame(mesh, halfedge, touching + off);
    if (random.chance(0.5))
    {
      std::swap(segment.a, segment.b);
    }
    std::vector<LeavingWindow> windows;
    geodesic::addSegmentWindows(mesh, segment, windows);
    for (const LeavingWindow& leaving : windows)
    {
      if (leaving.halfedge == halfedge)
      {
        EXPECT_GE(leaving.window.minimum(), -1e-14) << "slope " << slope;
        const double x = length - touching.x; // in a frame that runs the other way
        const double beside = side < 0.0 ? leaving.window.begin - x : x - leaving.window.end;
        EXPECT_LE(beside, slope < 1.0 ? 1e-14 : 1e-14 * slope) << "slope " << slope;
        ++seen;
      }
    }
  }
  EXPECT_GT(seen, 500);
}

// One edge at the corner lies on the segment's left and the other on its right, at any angle.
TEST(SourceWindows, RaysOfASegmentFromACornerLeaveThroughTheEdgeOnTheirSide)
{
  Random random(3);
  for (int i = 0; i < 2000; ++i)
  {
    const TriangleMesh mesh = engineMesh(tetrahedron(random));
    const Id corner = random.below(3);
    geodesic::SourceInFace segment;
    segment.face = 0;
    segment.a[corner] = 1.0;
    segment.b = insideWeights(random);
    const bool isReversed = random.chance(0.5);
    for (const LeavingWindow& leaving : windowsOf(mesh, segment, isReversed))
    {
      const Id k = (leaving.halfedge + 3 - corner) % 3;
      // The halfedge that begins at the corner is on the right of what leaves it.
      const bool isRight = leaving.window.origin.isRight();
      if (k != 1)
      {
        EXPECT_EQ(isRight, (k == 0) != isReversed) << leaving.window.width();
      }
    }
  }
}

// Rounding alone decides where the ray at the corner meets such an edge, which is to the right or
// to the left of the segment.
TEST(SourceWindows, RaysOfASegmentNearlyAtARightAngleToAnEdgeStayOnTheirSideOfTheCorner)
{
  std::size_t leavingOnTheirSide = 0;
  for (Random& random : EachSeed(2000))
  {
    const double sign = random.chance(0.5) ? 1.0 : -1.0;
    const double length = random.uniform(0.5, 2.0);
    const geodesic::Vec3 atRightAngle = { sign * length, 0, 0 };
    const geodesic::Vec3 other = { -sign * random.uniform(0.2, 1.0), random.uniform(0.5, 1.0), 0 };
    const TriangleMesh mesh({ { 0, 0, 0 }, sign > 0.0 ? atRightAngle : other,
                              sign > 0.0 ? other : atRightAngle, { 1, -2, 0 }, { -1, -2, 0 } },
      { { 0, 1, 2 }, { 1, 0, 3 }, { 2, 0, 4 } });
    const double height = random.uniform(0.1, 0.4);
    const double lean = random.uniform(-1.0, 1.0) * std::pow(10.0, random.uniform(-15.0, -3.0));
    const double ofOther = height / other[1];
    const double ofFirst = (lean - sign * ofOther * other[0]) / length;
    geodesic::SourceInFace segment;
    segment.face = 0;
    segment.a = { 1.0, 0.0, 0.0 };
    segment.b = { 1.0 - ofFirst - ofOther, ofFirst, ofOther };
    if (sign < 0.0)
    {
      std::swap(segment.b[1], segment.b[2]);
    }
    const bool isReversed = random.chance(0.5);
    for (const LeavingWindow& leaving : windowsOf(mesh, segment, isReversed))
    {
      const bool isRight = leaving.window.origin.isRight() != isReversed;
      EXPECT_NE(leaving.halfedge, isRight ? 2U : 0U) << leaving.window.width();
      leavingOnTheirSide += leaving.halfedge == (isRight ? 0U : 2U) ? 1 : 0;
    }
  }
  EXPECT_GT(leavingOnTheirSide, 0U);
}

TEST(SourceWindows, ABranchingFanHasTheDistancesOfEitherSheet)
{
  // A path that changes sheets keeps its length if it is folded into one sheet.
  constexpr Index stages = 40;
  const BranchingFan both(stages, 3.0);
  const BranchingFan one(stages, 3.0, 1);
  const MeshSegment segment = { 0, { 1, 0, 0 }, { 0, 1, 0 } };
  const BruteForceResult truth = bruteForceDistances(one.mesh, { {}, { segment } });
  const TriangleMesh mesh = engineMesh(both.mesh);
  const std::vector<double> distances = geodesic::solve(mesh, { firstEdge() }).vertexDistances();
  const std::size_t common = stages + 2;
  const std::size_t sheet = one.mesh.points.size() - common;
  ASSERT_EQ(distances.size(), common + 2 * sheet);
  for (std::size_t v = 0; v < distances.size(); ++v)
  {
    const std::size_t folded = v < common + sheet ? v : v - sheet;
    EXPECT_NEAR(distances[v], truth.vertices[folded], 1e-13) << "vertex " << v;
  }
}

// Points whose distances are less than the root of the smallest number: the length of each edge
// between them is 0.
TEST(SourceWindows, ASegmentInAFaceAtOnePointIsASourceThere)
{
  PlainMesh plain;
  plain.points = { { 0, 0, 0 }, { 1e-200, 0, 0 }, { 0, 1e-200, 0 }, { 3, 0, 0 }, { 0, 4, 0 },
    { -5, 0, 0 } };
  plain.triangles = { { 0, 1, 2 }, { 1, 3, 2 }, { 3, 4, 2 }, { 0, 2, 5 } };
  const TriangleMesh mesh = engineMesh(plain);
  ASSERT_EQ(mesh.shape(0).longest(), 0.0);
  const std::vector<double> distances = geodesic::solve(mesh, { firstEdge() }).vertexDistances();
  EXPECT_EQ(distances[0], 0.0);
  EXPECT_EQ(distances[2], 0.0);
  EXPECT_NEAR(distances[3], 3.0, 1e-15);
  EXPECT_NEAR(distances[4], 4.0, 1e-15);
  EXPECT_NEAR(distances[5], 5.0, 1e-15);
}

// A walk around such a point once went around the vertex for ever.
TEST(SourceWindows, ASegmentThatEndsSomeRoundingsBesideAVertexIsASourceFromThere)
{
  const TriangleMesh mesh = engineMesh(regularGrid(2, 2));
  for (Id halfedge = 0; halfedge < mesh.numberOfHalfedges(); ++halfedge)
  {
    for (const double t : { 3e-15, 1.0 - 3e-15 })
    {
      SourceCurve curve;
      curve.points = { SurfacePoint::onEdge(halfedge, t),
        SurfacePoint::inFace(TriangleMesh::faceOf(halfedge), 0.3, 0.3) };
      curve.isCut = { 0, 0 };
      curve.faces = { TriangleMesh::faceOf(halfedge) };
      const std::vector<double> beside = solve(mesh, { curve }).vertexDistances();
      curve.points[0] =
        SurfacePoint::atVertex(t < 0.5 ? mesh.origin(halfedge) : mesh.destination(halfedge));
      EXPECT_LE(worstError(beside, solve(mesh, { curve }).vertexDistances(), 1.0), 1e-12);
    }
  }
}

TEST(SourceWindows, AWatcherCanStopTheWorkAroundOneVertex)
{
  const TriangleMesh mesh = engineMesh(BranchingFan(3000, 3.0).mesh);
  expectWatched(2,
    [&](const geodesic::Job& job)
    { EXPECT_FALSE(makeSourceWindows(mesh, { firstEdge() }, job).windows.empty()); });
}
