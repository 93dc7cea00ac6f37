// SPDX-License-Identifier: BSD-3-Clause
// The locator gives points of polylines their closest faces.
#include "EngineSupport.h"
#include "Watched.h"

#include "Errors.h"
#include "source/PolylineLocator.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{

using namespace geodesic;
using geodesictest::engineMesh;
using geodesictest::PlainMesh;

constexpr double Epsilon = std::numeric_limits<double>::epsilon();

using Faces = std::vector<std::vector<Id>>;

Faces locate(const TriangleMesh& mesh, const std::vector<Vec3>& points, bool closed = false)
{
  std::vector<LocatedPolyline> lines(1);
  lines[0].points = points;
  lines[0].closed = closed;
  geodesictest::locate(mesh, lines);
  return lines[0].faces;
}

/// The faces at a vertex, by number.
std::vector<Id> around(const TriangleMesh& mesh, Id vertex)
{
  std::vector<Id> faces;
  for (const Id corner : mesh.cornersAt(vertex))
  {
    faces.push_back(TriangleMesh::faceOf(corner));
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

TEST(PolylineLocator, AlongEdgesEachPointHasAFaceOfItsVertex)
{
  const TriangleMesh mesh = engineMesh(geodesictest::regularGrid(4, 4));
  const std::vector<Vec3> points = { mesh.point(6), mesh.point(7), mesh.point(12), mesh.point(6) };
  for (const bool closed : { false, true })
  {
    const Faces faces = locate(mesh, points, closed);
    ASSERT_EQ(faces.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i)
    {
      ASSERT_EQ(faces[i].size(), 1u);
    }
    EXPECT_TRUE(contains(mesh, faces[1][0], SurfacePoint::atVertex(7)));
    EXPECT_TRUE(contains(mesh, faces[2][0], SurfacePoint::atVertex(12)));
  }
  EXPECT_EQ(locate(mesh, { mesh.point(7) })[0].size(), 1u);
}

TEST(PolylineLocator, WhereAPolylineLeavesTheEdgesAllItsPointsHaveAllFaces)
{
  const TriangleMesh mesh = engineMesh(geodesictest::regularGrid(4, 4));
  const std::vector<Vec3> points = { mesh.point(6), mesh.point(7), mesh.point(8) };
  // Three polylines that leave the edges: on the way back from the last point, at a point inside a
  // face, and across a square.
  const Faces closed = locate(mesh, points, true);
  const Faces inside = locate(mesh, { points[0], points[1], points[1] + Vec3{ 0.3, 0.2, 0.0 } });
  const Faces across = locate(mesh, { points[0], points[1], mesh.point(18) });
  for (const Faces& faces : { closed, inside, across })
  {
    EXPECT_EQ(faces[0], around(mesh, 6));
    EXPECT_EQ(faces[1], around(mesh, 7));
  }
  EXPECT_EQ(inside[2].size(), 1u);
}

TEST(PolylineLocator, VerticesOfSeveralSheetsAreAllFound)
{
  const PlainMesh sheet = geodesictest::regularGrid(2, 2);
  const TriangleMesh mesh = engineMesh(geodesictest::merged(sheet, sheet));
  for (const std::vector<Id>& faces : locate(mesh, { mesh.point(3), mesh.point(4) }))
  {
    ASSERT_EQ(faces.size(), 2u);
    EXPECT_LT(faces[0], 8u);
    EXPECT_EQ(faces[1], faces[0] + 8);
  }
}

// Whether a polyline stays on the edges is a question of its vertices, not of their places.
TEST(PolylineLocator, AGivenVertexIsNotTheOneAtItsPlace)
{
  const PlainMesh sheet = geodesictest::regularGrid(2, 2);
  const TriangleMesh mesh = engineMesh(geodesictest::merged(sheet, sheet));
  const auto beyond = static_cast<Id>(sheet.points.size()); // the first vertex of the other sheet
  const auto locateOn = [&mesh](Id second)
  {
    std::vector<LocatedPolyline> lines(1);
    lines[0].points = { mesh.point(3), mesh.point(4), mesh.point(5) };
    lines[0].vertices = { 3, second, NoId };
    geodesictest::locate(mesh, lines);
    return lines[0].faces;
  };
  for (const Id second : { Id{ 4 }, beyond + 4 })
  {
    const Faces faces = locateOn(second);
    ASSERT_EQ(faces.size(), 3U);
    ASSERT_EQ(faces[0].size(), 1U);
    ASSERT_EQ(faces[1].size(), 1U);
    EXPECT_TRUE(contains(mesh, faces[0][0], SurfacePoint::atVertex(3)));
    EXPECT_TRUE(contains(mesh, faces[1][0], SurfacePoint::atVertex(second)));
  }
  EXPECT_EQ(locateOn(4)[2].size(), 2U) << "along the edges: a face of each vertex there";
  EXPECT_EQ(locateOn(beyond + 4)[2].size(), 2 * around(mesh, 5).size());
}

TEST(PolylineLocator, PointsAtOnePlaceHaveTheSameFaces)
{
  const TriangleMesh mesh = engineMesh(geodesictest::regularGrid(3, 3));
  std::vector<LocatedPolyline> lines(2);
  lines[0].points = { { 0.7, 0.1, 0.0 }, { 2.0, 1.5, 0.0 } };
  lines[1].points = { { 2.0, 1.5, 0.0 }, { 0.7, 0.1, 0.0 }, { -0.0, 0.0, 0.0 } };
  geodesictest::locate(mesh, lines);
  EXPECT_EQ(lines[0].faces[0], lines[1].faces[1]);
  EXPECT_EQ(lines[0].faces[1], lines[1].faces[0]);
  EXPECT_EQ(lines[0].faces[1].size(), 2u);
  EXPECT_EQ(lines[1].faces[2], around(mesh, 0));
}

TEST(PolylineLocator, ItsWatcherSeesNoFallAndAborts)
{
  const TriangleMesh mesh = engineMesh(geodesictest::octasphere(20));
  std::vector<LocatedPolyline> lines(1);
  for (int i = 0; i < 1000; ++i)
  {
    lines[0].points.push_back({ std::cos(0.1 * i), std::sin(0.1 * i), 0.001 * i });
  }
  const std::vector<double> told = geodesictest::expectWatched(
    9, [&](const Job& job) { PolylineLocator(MeshPartition(mesh)).locate(lines, Epsilon, job); });
  EXPECT_EQ(told.front(), 0.0);
}

}
