// SPDX-License-Identifier: BSD-3-Clause
// The locator finds the face that a look at every face finds.
#include "Errors.h"
#include "FaceLocator.h"
#include "SurfaceSnap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace
{

using geodesic::Id;
using geodesic::Vec3;

double distanceOf(const geodesic::TriangleMesh& mesh, Id face, const Vec3& point)
{
  return geodesic::snapToFace(mesh, face, point, 0.0).distance;
}

Id closestOfAll(const geodesic::TriangleMesh& mesh, const Vec3& point)
{
  Id best = 0;
  for (Id face = 1; face < mesh.numberOfFaces(); ++face)
  {
    best = distanceOf(mesh, face, point) < distanceOf(mesh, best, point) ? face : best;
  }
  return best;
}

/// Points in and around the box, the same ones again, and the mesh's own.
void expectClosest(const geodesic::TriangleMesh& mesh, double size)
{
  geodesic::FaceLocator locator(mesh);
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> coordinate(-1.5 * size, 1.5 * size);
  for (int i = 0; i < 200; ++i)
  {
    Vec3 point{ coordinate(random), coordinate(random), coordinate(random) };
    if (i % 4 == 0)
    {
      point = mesh.point(static_cast<Id>(random() % mesh.numberOfVertices()));
    }
    const Id found = locator.closest(point);
    const Id best = closestOfAll(mesh, point);
    ASSERT_LT(found, mesh.numberOfFaces());
    // A box's distance is rounded, too: faces of one distance up to that are as good.
    EXPECT_LE(distanceOf(mesh, found, point), distanceOf(mesh, best, point) + 1e-15 * size);
    EXPECT_EQ(locator.closest(point), found);
  }
}

/// A strip of triangles whose size falls by a factor from one to the next.
geodesic::TriangleMesh shrinkingStrip(int count, double factor)
{
  std::vector<Vec3> points;
  double x = 1.0;
  for (int i = 0; i < count + 2; ++i, x *= factor)
  {
    points.push_back({ x, i % 2 == 0 ? 0.0 : x, 0.5 * x });
  }
  std::vector<geodesic::Triangle> triangles;
  for (Id i = 0; i < static_cast<Id>(count); ++i)
  {
    triangles.push_back({ i, i + 1, i + 2 });
  }
  return { points, triangles };
}

TEST(FaceLocator, FindsTheClosestFaceOfACrowdedStrip)
{
  expectClosest(shrinkingStrip(300, 0.9), 1.0);
  expectClosest(shrinkingStrip(300, 0.5), 1.0);
}

TEST(FaceLocator, FindsFacesWithoutArea)
{
  const geodesic::TriangleMesh mesh(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 0, 5, 0 }, { 1, 5, 0 }, { 0, 6, 0 } },
    { { 0, 1, 2 }, { 3, 4, 5 } });
  geodesic::FaceLocator locator(mesh);
  EXPECT_EQ(locator.closest({ 1.7, 0.3, 0.1 }), 0u);
  EXPECT_EQ(locator.closest({ 1.7, 5.3, 0.1 }), 1u);
}

TEST(FaceLocator, OfFacesAtOneDistanceTheLowestCounts)
{
  std::vector<Vec3> points;
  std::vector<geodesic::Triangle> triangles;
  constexpr Id fan = 40;
  points.push_back({ 0, 0, 0 });
  for (Id i = 0; i < fan; ++i)
  {
    const double angle = 0.1 * i;
    points.push_back({ std::cos(angle), std::sin(angle), 0.25 * i });
    points.push_back({ std::cos(angle + 0.05), std::sin(angle + 0.05), 0.25 * i });
    triangles.push_back({ 0, 2 * i + 1, 2 * i + 2 });
  }
  const geodesic::TriangleMesh mesh(points, triangles);
  EXPECT_EQ(geodesic::FaceLocator(mesh).closest({ 0, 0, 0 }), 0u);
}

TEST(FaceLocator, ProgressNeverFallsAndStopsTheSearch)
{
  const geodesic::TriangleMesh mesh = shrinkingStrip(2000, 0.99);
  std::vector<double> seen;
  geodesic::FaceLocator(mesh).closest({ 0.3, 0.2, 0.1 },
    [&](double fraction)
    {
      seen.push_back(fraction);
      return true;
    });
  ASSERT_GT(seen.size(), 3u);
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
  EXPECT_GE(seen.front(), 0.0);
  EXPECT_LE(seen.back(), 1.0);
  geodesic::FaceLocator locator(mesh);
  EXPECT_THROW(locator.closest({ 0.3, 0.2, 0.1 }, [](double) { return false; }), geodesic::Aborted);
  EXPECT_EQ(locator.closest({ 0.3, 0.2, 0.1 }), closestOfAll(mesh, { 0.3, 0.2, 0.1 }));
}

}
