// SPDX-License-Identifier: BSD-3-Clause
// Bounds on whole triangles, compared with distances in the plane.
#include "EngineSupport.h"

#include "refinement/EdgeSplitter.h"
#include "refinement/FaceCheck.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace geodesictest;
using geodesic::Deviation;
using geodesic::DistanceField;
using geodesic::SurfacePoint;
using geodesic::TriangleMesh;

namespace
{

/// Face 0 has the corners 0, 1, 2. Around it are faces to three sources, the vertices 3, 4, 5, each
/// in the direction of a corner.
PlainMesh faceBetweenSources(Random& random)
{
  PlainMesh mesh;
  for (const double radius : { 1.0, random.uniform(1e3, 1e4) })
  {
    for (int k = 0; k < 3; ++k)
    {
      const double angle = 2.0943951023931953 * k + random.uniform(-0.1, 0.1);
      mesh.points.push_back({ radius * std::cos(angle), radius * std::sin(angle), 0.0 });
    }
  }
  mesh.triangles = { { 0, 1, 2 }, { 3, 4, 1 }, { 3, 1, 0 }, { 4, 5, 2 }, { 4, 2, 1 }, { 5, 3, 0 },
    { 5, 0, 2 } };
  return mesh;
}

double toNearestSource(const PlainMesh& mesh, const Vec3& p)
{
  return std::min({ spaceDistance(p, mesh.points[3]), spaceDistance(p, mesh.points[4]),
    spaceDistance(p, mesh.points[5]) });
}

/// The place as far from each of the three sources.
Vec3 meetingOf(const PlainMesh& mesh)
{
  const Vec3& a = mesh.points[3];
  const Vec3 b = { mesh.points[4][0] - a[0], mesh.points[4][1] - a[1], 0.0 };
  const Vec3 c = { mesh.points[5][0] - a[0], mesh.points[5][1] - a[1], 0.0 };
  const double b2 = b[0] * b[0] + b[1] * b[1];
  const double c2 = c[0] * c[0] + c[1] * c[1];
  const double area4 = 2.0 * (b[0] * c[1] - b[1] * c[0]);
  return { a[0] + (c[1] * b2 - b[1] * c2) / area4, a[1] + (b[0] * c2 - c[0] * b2) / area4, 0.0 };
}

/// The linear function with these values at the corners of face 0.
double linearAt(const PlainMesh& mesh, const std::array<double, 3>& d, const Vec3& p)
{
  const Vec3& o = mesh.points[0];
  const Vec3 x = { mesh.points[1][0] - o[0], mesh.points[1][1] - o[1], 0.0 };
  const Vec3 y = { mesh.points[2][0] - o[0], mesh.points[2][1] - o[1], 0.0 };
  const double area2 = x[0] * y[1] - x[1] * y[0];
  const double u = ((p[0] - o[0]) * y[1] - (p[1] - o[1]) * y[0]) / area2;
  const double v = (x[0] * (p[1] - o[1]) - x[1] * (p[0] - o[0])) / area2;
  return (1.0 - u - v) * d[0] + u * d[1] + v * d[2];
}

/// How far the distance is above the linear function with these values at the corners of face 0.
double excessAt(const PlainMesh& mesh, const std::array<double, 3>& d, const Vec3& p)
{
  return toNearestSource(mesh, p) - linearAt(mesh, d, p);
}

Deviation onEdgesOf(const PlainMesh& mesh, const std::array<double, 3>& d)
{
  constexpr int steps = 1000;
  Deviation largest{};
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vec3& a = mesh.points[k];
    const Vec3& b = mesh.points[(k + 1) % 3];
    for (int i = 0; i <= steps; ++i)
    {
      const double t = static_cast<double>(i) / steps;
      const double excess =
        excessAt(mesh, d, { a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), 0.0 });
      largest.above = std::max(largest.above, excess);
      largest.below = std::max(largest.below, -excess);
    }
  }
  return largest;
}

/// Whether face 0 as a whole is within a tolerance.
bool hasPassed(const DistanceField& field, double tolerance)
{
  geodesic::RefinedFaces faces(field);
  faces.open(0);
  geodesic::EdgeSplitter splitter(faces, tolerance);
  for (geodesic::Id edge = 0; edge < faces.edges.size(); ++edge)
  {
    faces.edges[edge].pieces = splitter.measure(edge);
  }
  geodesic::FaceCheck check(faces, tolerance);
  check.enter(faces.triangles(0));
  return check.of({ 0, 1, 2 }).bound < geodesic::Infinity;
}

}

// Three fronts meet inside, where none of them alone is near the distance in a large part. The
// search must combine them, or it ends before it has halved the triangle often enough.
TEST(FaceCheck, ProvesALimitCloseToTheDifferenceWhereFrontsMeet)
{
  for (Random& random : EachSeed(100))
  {
    const PlainMesh plain = faceBetweenSources(random);
    const TriangleMesh mesh = engineMesh(plain);
    const DistanceField field = solveKeepingAll(mesh,
      { geodesic::pointCurve(SurfacePoint::atVertex(3)),
        geodesic::pointCurve(SurfacePoint::atVertex(4)),
        geodesic::pointCurve(SurfacePoint::atVertex(5)) });
    const std::array<double, 3> d = { toNearestSource(plain, plain.points[0]),
      toNearestSource(plain, plain.points[1]), toNearestSource(plain, plain.points[2]) };
    const double largest = excessAt(plain, d, meetingOf(plain));
    ASSERT_LT(onEdgesOf(plain, d).above, largest);
    for (const double limit : { 0.9 * largest, 0.999 * largest, 1.005 * largest })
    {
      EXPECT_EQ(hasPassed(field, limit), limit > largest) << limit << " of " << largest;
    }
  }
}

// All corners are sources. In the middle two of them are much farther than the third.
TEST(FaceCheck, KnowsFrontsThatAreNearestOnlyAtCorners)
{
  PlainMesh plain;
  plain.points = { { -1, 0, 0 }, { 1, 0, 0 }, { 0, 0.2, 0 }, { -1, 0, 0 }, { 1, 0, 0 },
    { 0, 0.2, 0 } };
  plain.triangles = { { 0, 1, 2 } };
  const TriangleMesh mesh = engineMesh(plain);
  const DistanceField field = solveKeepingAll(mesh,
    { geodesic::pointCurve(SurfacePoint::atVertex(0)),
      geodesic::pointCurve(SurfacePoint::atVertex(1)),
      geodesic::pointCurve(SurfacePoint::atVertex(2)) });
  // As the angle at the third corner is obtuse, the farthest point is on an edge.
  EXPECT_TRUE(hasPassed(field, 1.01 * onEdgesOf(plain, {}).above));
}
