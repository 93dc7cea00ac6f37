// SPDX-License-Identifier: BSD-3-Clause
// The first windows of sources: parallel rays at right angles to segments, circular windows from
// points into their wedges; around vertices with many faces; in faces without area.
#include "EngineSupport.h"
#include "source/BranchingFan.h"
#include "truth/AnalyticDistances.h"

#include "Errors.h"
#include "source/SourceWindows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

using namespace geodesictest;
using geodesic::Id;
using geodesic::LeavingWindow;
using geodesic::makeSourceWindows;
using geodesic::SourceCurve;
using geodesic::SourceWindows;
using geodesic::SurfacePoint;
using geodesic::TriangleMesh;
using geodesic::Window;

namespace
{

constexpr double RightAngle = 1.57079632679489661923;

double times(const Vec3& a, const Vec3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The point in space at x of a window's frame, which runs against the halfedge.
Vec3 pointAt(const TriangleMesh& mesh, Id halfedge, double x)
{
  const Vec3& from = mesh.point(mesh.destination(halfedge));
  const Vec3& to = mesh.point(mesh.origin(halfedge));
  const double t = x / mesh.length(halfedge);
  return { from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1]),
    from[2] + t * (to[2] - from[2]) };
}

/// As seen from the origin.
double angleBetween(const Vec3& a, const Vec3& b)
{
  const Vec3 d = { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
    a[0] * b[1] - a[1] * b[0] };
  return std::atan2(std::sqrt(times(d, d)), times(a, b));
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

TEST(SourceWindows, OnABranchingFanTheWedgeBeginsAtTheRightAngleOnEverySheet)
{
  for (const Index stages : { 5u, 26u, 120u, 1500u })
  {
    const BranchingFan fan(stages, 3.0);
    const TriangleMesh mesh = engineMesh(fan.mesh);
    const SourceWindows sources = makeSourceWindows(mesh, { firstEdge() });
    const double angle = fan.faceAngle();
    EXPECT_EQ(fan.mesh.points[0], (Vec3{ 0, 0, 0 }));
    std::vector<double> from(fan.mesh.triangles.size(), geodesic::Infinity);
    for (const LeavingWindow& leaving : sources.windows)
    {
      const Window& w = leaving.window;
      const Id face = TriangleMesh::faceOf(leaving.halfedge);
      if (w.kind != Window::Kind::Circular || mesh.opposite(leaving.halfedge) != 0)
      {
        continue; // the parallel rays, and those of the segment's other end
      }
      ASSERT_EQ(from[face], geodesic::Infinity) << "one window a face";
      EXPECT_EQ(w.begin, 0.0);
      // The face's first corner is vertex 0, its second the one nearer to the segment; the frame
      // runs against the halfedge.
      from[face] = angleBetween(
        mesh.point(mesh.origin(leaving.halfedge)), pointAt(mesh, leaving.halfedge, w.end));
    }
    for (Index face = 0; face < fan.mesh.triangles.size(); face += 2)
    {
      const Index place = face / 2 % (2 * stages); // in its sheet
      const double begin = RightAngle - place * angle;
      if (begin >= angle - 1e-9)
      {
        EXPECT_EQ(from[face], geodesic::Infinity) << "face " << face << " of " << stages;
      }
      else
      {
        EXPECT_NEAR(from[face], std::max(begin, 0.0), 1e-14 * stages)
          << "face " << face << " of " << stages;
      }
    }
  }
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

TEST(SourceWindows, ASourceOnTheLongEdgeOfAFaceWithoutAreaShinesThroughIt)
{
  // Vertex 2 lies on the edge between 0 and 1 of a face that has no area.
  const PlainMesh plain = { { { 0, 0, 0 }, { 2, 0, 0 }, { 1, 0, 0 }, { 1.2, -1, 0 }, { 1, 1, 0 } },
    { { 0, 1, 2 }, { 1, 0, 3 }, { 0, 2, 4 }, { 2, 1, 4 } } };
  const TriangleMesh mesh = geodesictest::cleanedEngineMesh(plain);
  SourceCurve point;
  point.points = { SurfacePoint::atVertex(2) };
  point.isCut = { 0 };
  const std::vector<double> distances = geodesic::solve(mesh, { point }).vertexDistances();
  EXPECT_NEAR(distances[3], std::hypot(0.2, 1.0), 1e-14);
  EXPECT_NEAR(distances[4], 1.0, 1e-15);
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
  constexpr std::size_t few = 5;
  std::vector<double> told;
  const auto watch = [&](bool goesOn)
  {
    return [&told, goesOn](double done)
    {
      told.push_back(done);
      if (told.size() < few) // longer than the time between calls
      {
        std::this_thread::sleep_for(std::chrono::milliseconds(25));
      }
      return goesOn || told.size() < few;
    };
  };
  const SourceWindows all = makeSourceWindows(mesh, { firstEdge() }, geodesic::Job(watch(true)));
  EXPECT_FALSE(all.windows.empty());
  ASSERT_GE(told.size(), few);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_GE(told.front(), 0.0);
  EXPECT_LE(told.back(), 1.0);
  told.clear();
  EXPECT_THROW(
    makeSourceWindows(mesh, { firstEdge() }, geodesic::Job(watch(false))), geodesic::Aborted);
  EXPECT_EQ(told.size(), few);
}
