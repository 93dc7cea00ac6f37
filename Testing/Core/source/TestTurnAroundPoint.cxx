// SPDX-License-Identifier: BSD-3-Clause
// Turns around points across a face without area: the faces and angles are those of the plane.
#include "EngineSupport.h"
#include "truth/CappedMeshes.h"

#include "source/TurnAroundPoint.h"

#include <gtest/gtest.h>

using namespace geodesictest;
using geodesic::Id;
using geodesic::SurfacePoint;
using geodesic::TriangleMesh;
using geodesic::TurnAroundPoint;

namespace
{

constexpr double FullAngle = 6.28318530717958647692;

/// Vertex 3 lies on the edge from 0 to 1 of face 0, at a quarter of it; face 1, without area,
/// closes the gap to faces 2 and 3.
TriangleMesh meshWithCap()
{
  PlainMesh mesh;
  mesh.points = { { 0, 0, 0 }, { 2, 0, 0 }, { 1, -1, 0 }, { 0.5, 0, 0 }, { 1, 1, 0 } };
  mesh.triangles = { { 1, 0, 2 }, { 0, 1, 3 }, { 3, 1, 4 }, { 0, 3, 4 } };
  return engineMesh(mesh);
}

struct Turned
{
  std::vector<Id> faces;
  double angle = 0.0;
  bool isClosed = false;
};

Turned turnAround(const TriangleMesh& mesh, const SurfacePoint& point, Id face)
{
  Turned result;
  TurnAroundPoint turn(mesh, point, face);
  do
  {
    result.faces.push_back(TriangleMesh::faceOf(turn.halfedge()));
    result.angle += turn.angle();
  } while (turn.next());
  result.isClosed = turn.isClosed();
  return result;
}

}

TEST(TurnAroundPoint, AroundAVertexOnAnEdgeEntersTheFaceBehindTheOneWithoutArea)
{
  const Turned found = turnAround(meshWithCap(), SurfacePoint::atVertex(3), 2);
  EXPECT_EQ(found.faces, (std::vector<Id>{ 2, 3, 1, 0, 1 }));
  EXPECT_NEAR(found.angle, FullAngle, 1e-14);
  EXPECT_TRUE(found.isClosed);
}

TEST(TurnAroundPoint, AroundAPointOfTheEdgeEntersTheFaceThatHasItThere)
{
  const TriangleMesh mesh = meshWithCap();
  for (const auto& [place, face] : { std::pair(0.1, 3U), std::pair(0.7, 2U) })
  {
    const SurfacePoint point = SurfacePoint::onEdge(mesh.halfedgeBetween(0, 1), 1.0 - place);
    const Turned found = turnAround(mesh, point, 0);
    EXPECT_EQ(found.faces, (std::vector<Id>{ 0, 1, face, 1 }));
    EXPECT_NEAR(found.angle, FullAngle, 1e-14);
    EXPECT_TRUE(found.isClosed);
  }
}

TEST(TurnAroundPoint, FindsTheVertexAtThePlaceOfAPointOnTheEdge)
{
  const TriangleMesh mesh = meshWithCap();
  const Id halfedge = mesh.halfedgeBetween(0, 1);
  ASSERT_EQ(mesh.origin(halfedge), 1U);
  EXPECT_EQ(verticesAtPlaceOf(mesh, SurfacePoint::onEdge(halfedge, 0.75)), std::vector<Id>{ 3 });
  EXPECT_TRUE(verticesAtPlaceOf(mesh, SurfacePoint::onEdge(halfedge, 0.7)).empty());
  EXPECT_TRUE(verticesAtPlaceOf(mesh, SurfacePoint::atVertex(3)).empty());
}

// Also at the boundary, in both directions.
TEST(TurnAroundPoint, AroundAnEndOfTheEdgeTakesTheAnglesOfAllFaces)
{
  const TriangleMesh mesh = meshWithCap();
  TurnAroundPoint turn(mesh, SurfacePoint::atVertex(0), 1);
  double angle = turn.angle();
  while (turn.next())
  {
    angle += turn.angle();
  }
  EXPECT_FALSE(turn.isClosed());
  for (bool isThere = turn.turnBack(); isThere; isThere = turn.next())
  {
    angle += turn.angle();
  }
  EXPECT_NEAR(angle, 0.25 * FullAngle, 1e-14);
}

namespace
{

/// Turns both ways around each vertex, from each of its faces. Faces without area are in any order,
/// so that turns may lead back to themselves.
void expectEndsInPockets(std::uint64_t seed)
{
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  const PlainMesh plain = bumpySheet(2, 2, 0, 0.0, random);
  const TriangleMesh mesh = engineMesh(withPockets(plain, random.between(1, 6), random));
  for (Id vertex = 0; vertex < mesh.numberOfVertices(); ++vertex)
  {
    for (const Id corner : mesh.cornersAt(vertex))
    {
      TurnAroundPoint turn(mesh, SurfacePoint::atVertex(vertex), TriangleMesh::faceOf(corner));
      Id steps = 0;
      for (bool isThere = true; isThere && steps <= mesh.numberOfHalfedges(); ++steps)
      {
        isThere = turn.next();
      }
      for (bool isThere = turn.turnBack(); isThere && steps <= 2 * mesh.numberOfHalfedges();
           ++steps)
      {
        isThere = turn.next();
      }
      EXPECT_LE(steps, 2 * mesh.numberOfHalfedges());
    }
  }
}

}

TEST(TurnAroundPoint, EndsInPockets)
{
  for (std::uint64_t seed = 0; seed < 300; ++seed)
  {
    expectEndsInPockets(seed);
  }
}

// One turn in a million would cross faces without area in a circle that does not hold its first
// face.
TEST(TurnAroundPoint, EndsWhereItComesToAFaceWithoutAreaAgain)
{
  for (const std::uint64_t seed : { 4392U, 7086U, 11251U, 29428U })
  {
    expectEndsInPockets(seed);
  }
}
