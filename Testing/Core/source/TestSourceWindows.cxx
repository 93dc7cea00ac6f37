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

Vec3 minus(const Vec3& a, const Vec3& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

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

/// The windows of a kind that contain the place x of a halfedge.
std::vector<Window> holding(
  const SourceWindows& sources, Id halfedge, double x, Window::Kind kind, double margin)
{
  std::vector<Window> result;
  for (const LeavingWindow& leaving : sources.windows)
  {
    const Window& w = leaving.window;
    if (leaving.halfedge == halfedge && w.kind == kind && x > w.begin - margin &&
      x < w.end + margin)
    {
      result.push_back(w);
    }
  }
  return result;
}

SourceCurve inFace(Id face, const std::vector<Barycentric>& points)
{
  SourceCurve curve;
  for (const Barycentric& b : points)
  {
    curve.points.push_back(SurfacePoint::inFace(face, b[1], b[2]));
    curve.isCut.push_back(0);
  }
  curve.faces.assign(points.size() - 1, face);
  return curve;
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

TEST(SourceWindows, RaysOfASegmentLeaveAtRightAnglesAndNoneIsMissing)
{
  Random random(1);
  std::array<int, 2> seen{};
  for (int i = 0; i < 200; ++i)
  {
    const PlainMesh plain = tetrahedron(random);
    const TriangleMesh mesh = engineMesh(plain);
    const Barycentric a = insideWeights(random);
    const Barycentric b = insideWeights(random);
    const SourceWindows sources = makeSourceWindows(mesh, { inFace(0, { a, b }) });
    const Vec3 p = position(plain, { 0, a });
    const Vec3 d = minus(position(plain, { 0, b }), p);
    for (Id halfedge = 0; halfedge < 3; ++halfedge)
    {
      for (int k = 0; k < 20; ++k)
      {
        const double x = mesh.length(halfedge) * (k + 0.5) / 20.0;
        const Vec3 to = minus(pointAt(mesh, halfedge, x), p);
        const double t = times(to, d) / times(d, d);
        const double distance = std::sqrt(std::max(0.0, times(to, to) - t * t * times(d, d)));
        if (std::abs(t) < 1e-9 || std::abs(t - 1.0) < 1e-9)
        {
          continue;
        }
        const auto windows = holding(sources, halfedge, x, Window::Kind::Linear, 0.0);
        const bool beside = t > 0.0 && t < 1.0;
        ++seen[beside ? 1 : 0];
        ASSERT_EQ(windows.size(), beside ? 1u : 0u) << "foot at " << t;
        if (beside)
        {
          ASSERT_NEAR(windows[0].distance(x), distance, 1e-14 * 10.0);
        }
      }
    }
  }
  EXPECT_GT(seen[0], 1000);
  EXPECT_GT(seen[1], 1000);
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

TEST(SourceWindows, APointEmitsIntoTheWedgeBetweenTheNormalsOfItsSegments)
{
  Random random(2);
  std::array<int, 2> seen{};
  for (int i = 0; i < 200; ++i)
  {
    const PlainMesh plain = tetrahedron(random);
    const TriangleMesh mesh = engineMesh(plain);
    const std::vector<Barycentric> corners = { insideWeights(random), insideWeights(random),
      insideWeights(random) };
    const SourceWindows sources = makeSourceWindows(mesh, { inFace(0, corners) });
    for (Id halfedge = 0; halfedge < 3; ++halfedge)
    {
      for (int k = 0; k < 20; ++k)
      {
        const double x = mesh.length(halfedge) * (k + 0.5) / 20.0;
        for (std::size_t c = 0; c < 3; ++c)
        {
          const Vec3 p = position(plain, { 0, corners[c] });
          const Vec3 ray = minus(pointAt(mesh, halfedge, x), p);
          double largest = -1.0;
          for (const std::size_t other : { c + 2, c + 4 }) // those before and behind
          {
            if (other % 3 != c && (c == 1 || other % 3 == 1))
            {
              const Vec3 d = minus(position(plain, { 0, corners[other % 3] }), p);
              largest = std::max(largest, times(ray, d) / std::sqrt(times(ray, ray) * times(d, d)));
            }
          }
          if (std::abs(largest) < 1e-9)
          {
            continue;
          }
          const double distance = std::sqrt(times(ray, ray));
          const auto windows = holding(sources, halfedge, x, Window::Kind::Circular, 0.0);
          const bool emitted = std::any_of(windows.begin(), windows.end(),
            [&](const Window& w) { return std::abs(w.distance(x) - distance) < 1e-13; });
          ++seen[emitted ? 1 : 0];
          ASSERT_EQ(emitted, largest < 0.0) << "cosine " << largest;
        }
      }
    }
  }
  EXPECT_GT(seen[0], 1000);
  EXPECT_GT(seen[1], 1000);
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

TEST(SourceWindows, SeveralCurvesThatMeetInAVertexBoundItsWedgeTogether)
{
  // Along the axes of a regular grid from its middle: no circular rays remain.
  const PlainMesh grid = regularGrid(4, 4);
  const TriangleMesh mesh = engineMesh(grid);
  std::vector<SourceCurve> curves;
  for (const Index to : { 13u, 11u, 7u, 17u })
  {
    SourceCurve curve;
    curve.points = { SurfacePoint::atVertex(12), SurfacePoint::atVertex(to) };
    curve.faces = { commonFace(mesh, curve.points[0], curve.points[1]) };
    curve.isCut = { 0, 0 };
    ASSERT_NE(curve.faces[0], geodesic::NoId);
    curves.push_back(curve);
    const SourceWindows sources = makeSourceWindows(mesh, curves);
    double emitted = 0.0; // the angle that vertex 12 emits into
    for (const LeavingWindow& leaving : sources.windows)
    {
      const Window& w = leaving.window;
      if (w.kind == Window::Kind::Circular && mesh.opposite(leaving.halfedge) == 12)
      {
        emitted += std::atan2(w.end - w.sourceX, w.sourceDepth) -
          std::atan2(w.begin - w.sourceX, w.sourceDepth);
      }
    }
    // a half disc behind one end, a quarter between two at a right angle behind both, then nothing
    const double expected = curves.size() == 1 ? 2.0 * RightAngle : 0.0;
    EXPECT_NEAR(emitted, expected, 1e-12) << curves.size() << " curves";
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

TEST(SourceWindows, TheWindowOfAVertexHasItsDistances)
{
  Random random(3);
  for (int i = 0; i < 50; ++i)
  {
    const TriangleMesh mesh = engineMesh(tetrahedron(random));
    for (Id corner = 0; corner < mesh.numberOfHalfedges(); ++corner)
    {
      const LeavingWindow leaving = geodesic::vertexWindow(mesh, corner, 0.25);
      EXPECT_EQ(leaving.halfedge, TriangleMesh::nextInFace(corner));
      for (const double t : { 0.0, 0.4, 1.0 })
      {
        const double x = t * mesh.length(leaving.halfedge);
        EXPECT_NEAR(leaving.window.distance(x),
          0.25 + spaceDistance(mesh.point(mesh.origin(corner)), pointAt(mesh, leaving.halfedge, x)),
          1e-14);
      }
    }
  }
}

TEST(SourceInFace, TheNearestPointIsOnTheSourceAndAtTheLeastDistance)
{
  Random random(4);
  for (int i = 0; i < 300; ++i)
  {
    const PlainMesh plain = tetrahedron(random);
    const TriangleMesh mesh = engineMesh(plain);
    const Barycentric a = randomWeights(random);
    const Barycentric b = random.chance(0.2) ? a : randomWeights(random);
    const Barycentric p = randomWeights(random);
    const geodesic::SourceInFace source = { 2, a, b };
    const Vec3 place = position(plain, { 2, p });
    const Vec3 from = position(plain, { 2, a });
    const Vec3 along = minus(position(plain, { 2, b }), from);
    const double squared = times(along, along);
    const double t =
      squared > 0.0 ? std::clamp(times(minus(place, from), along) / squared, 0.0, 1.0) : 0.0;
    const Vec3 nearest = { from[0] + t * along[0], from[1] + t * along[1], from[2] + t * along[2] };
    EXPECT_NEAR(distanceToSource(mesh, source, p), spaceDistance(place, nearest), 1e-13);
    EXPECT_NEAR(
      spaceDistance(position(plain, { 2, nearestOnSource(mesh, source, p) }), nearest), 0.0, 1e-7);
  }
}
