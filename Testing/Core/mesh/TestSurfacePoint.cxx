// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/SurfacePoint.h"
#include "mesh/TriangleMesh.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace geodesic;

namespace
{

constexpr double Epsilon = std::numeric_limits<double>::epsilon();

/// Three pages on one spine (vertices 0 and 1), and a triangle that touches only vertex 2. The
/// second page runs along the spine in the direction of the first, which makes the orientation
/// inconsistent.
TriangleMesh bookWithBowTie()
{
  return TriangleMesh({ { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0.5 }, { -1, 1, 0.25 }, { -1, -1, 0.75 },
                        { 2, 0, 0 }, { 2, 0, 1 } },
    { { 4, 1, 0 }, { 0, 1, 2 }, { 0, 1, 3 }, { 2, 5, 6 } });
}

/// A few points of every kind on every face, vertex and halfedge of the mesh.
std::vector<SurfacePoint> somePoints(const TriangleMesh& mesh)
{
  std::vector<SurfacePoint> result;
  for (Id vertex = 0; vertex < mesh.numberOfVertices(); ++vertex)
  {
    result.push_back(SurfacePoint::atVertex(vertex));
  }
  for (Id halfedge = 0; halfedge < mesh.numberOfHalfedges(); ++halfedge)
  {
    result.push_back(SurfacePoint::onEdge(halfedge, 0.125));
    result.push_back(SurfacePoint::onEdge(halfedge, 0.7));
  }
  for (Id face = 0; face < mesh.numberOfFaces(); ++face)
  {
    result.push_back(SurfacePoint::inFace(face, 0.25, 0.5));
    result.push_back(SurfacePoint::inFace(face, 0.1, 0.2));
  }
  return result;
}

Vec3 combined(const TriangleMesh& mesh, Id face, const std::array<double, 3>& weights)
{
  const Triangle& t = mesh.triangle(face);
  return weights[0] * mesh.point(t[0]) + weights[1] * mesh.point(t[1]) +
    weights[2] * mesh.point(t[2]);
}

std::vector<Id> facesOf(const TriangleMesh& mesh, const SurfacePoint& point)
{
  std::vector<Id> faces;
  forEachFace(mesh, point, [&](Id face) { faces.push_back(face); });
  return faces;
}

/// The halfedges of an edge, found without siblings in the faces that have both its vertices.
std::vector<Id> halfedgesBetween(const TriangleMesh& mesh, Id a, Id b)
{
  std::vector<Id> result;
  for (Id halfedge = 0; halfedge < mesh.numberOfHalfedges(); ++halfedge)
  {
    const Id from = mesh.origin(halfedge);
    const Id to = mesh.destination(halfedge);
    if ((from == a && to == b) || (from == b && to == a))
    {
      result.push_back(halfedge);
    }
  }
  return result;
}

TEST(SurfacePoint, EveryFaceThatHoldsAPointIsVisitedOnce)
{
  const TriangleMesh mesh = bookWithBowTie();
  for (const SurfacePoint& point : somePoints(mesh))
  {
    std::vector<Id> visited = facesOf(mesh, point);
    std::sort(visited.begin(), visited.end());
    std::vector<Id> holding;
    for (Id face = 0; face < mesh.numberOfFaces(); ++face)
    {
      if (contains(mesh, face, point))
      {
        holding.push_back(face);
      }
    }
    EXPECT_EQ(visited, holding);
    EXPECT_TRUE(contains(mesh, someFace(mesh, point), point));
  }
  EXPECT_EQ(facesOf(mesh, SurfacePoint::atVertex(0)).size(), 3u);
  EXPECT_EQ(facesOf(mesh, SurfacePoint::atVertex(2)).size(), 2u);
  EXPECT_EQ(
    facesOf(mesh, SurfacePoint::onEdge(halfedgesBetween(mesh, 0, 1).front(), 0.5)).size(), 3u);
}

TEST(SurfacePoint, BarycentricCoordinatesGiveThePositionAndThePointBackInEveryFaceAround)
{
  const TriangleMesh mesh = bookWithBowTie();
  for (const SurfacePoint& point : somePoints(mesh))
  {
    for (const Id face : facesOf(mesh, point))
    {
      const Barycentric weights = barycentric(mesh, point, face);
      EXPECT_LE(norm(combined(mesh, face, weights) - position(mesh, point)), 4.0 * Epsilon);
      const SurfacePoint back = fromBarycentric(mesh, face, weights);
      ASSERT_EQ(back.kind, point.kind);
      EXPECT_TRUE(contains(mesh, face, back));
      EXPECT_LE(norm(position(mesh, back) - position(mesh, point)), 4.0 * Epsilon);
    }
  }
}

TEST(SurfacePoint, AnEdgePointIsOnePlaceFromEveryHalfedgeOfItsEdge)
{
  const TriangleMesh mesh = bookWithBowTie();
  const double u = 0.3;
  for (Id halfedge = 0; halfedge < mesh.numberOfHalfedges(); ++halfedge)
  {
    for (const Id other : halfedgesBetween(mesh, mesh.origin(halfedge), mesh.destination(halfedge)))
    {
      const bool alike = mesh.origin(halfedge) == mesh.origin(other);
      const SurfacePoint a = SurfacePoint::onEdge(halfedge, u);
      EXPECT_TRUE(samePlace(mesh, a, SurfacePoint::onEdge(other, alike ? u : 1.0 - u)));
      EXPECT_FALSE(samePlace(mesh, a, SurfacePoint::onEdge(other, alike ? 1.0 - u : u)));
    }
    const Id next = TriangleMesh::nextInFace(halfedge);
    EXPECT_FALSE(samePlace(mesh, SurfacePoint::onEdge(halfedge, u), SurfacePoint::onEdge(next, u)));
  }
}

TEST(SurfacePoint, PlacesOfDifferentKindOrElementDiffer)
{
  const TriangleMesh mesh = bookWithBowTie();
  const SurfacePoint vertex = SurfacePoint::atVertex(1);
  const SurfacePoint inFace = SurfacePoint::inFace(1, 0.25, 0.5);
  EXPECT_TRUE(samePlace(mesh, vertex, vertex));
  EXPECT_FALSE(samePlace(mesh, vertex, SurfacePoint::atVertex(2)));
  EXPECT_FALSE(samePlace(mesh, vertex, SurfacePoint::onEdge(1, 0.5)));
  EXPECT_TRUE(samePlace(mesh, inFace, inFace));
  EXPECT_FALSE(samePlace(mesh, inFace, SurfacePoint::inFace(2, 0.25, 0.5)));
  EXPECT_FALSE(samePlace(mesh, inFace, SurfacePoint::inFace(1, 0.5, 0.25)));
}

TEST(SurfacePoint, TheCommonFaceIsTheLowestThatHoldsBoth)
{
  const TriangleMesh mesh = bookWithBowTie();
  const std::vector<SurfacePoint> points = somePoints(mesh);
  for (const SurfacePoint& a : points)
  {
    for (const SurfacePoint& b : points)
    {
      Id lowest = NoId;
      for (Id face = mesh.numberOfFaces(); face-- > 0;)
      {
        lowest = contains(mesh, face, a) && contains(mesh, face, b) ? face : lowest;
      }
      EXPECT_EQ(commonFace(mesh, a, b), lowest);
    }
  }
}

TEST(SurfacePoint, ZeroCoordinatesGiveVerticesAndEdges)
{
  const TriangleMesh mesh = bookWithBowTie();
  for (Id face = 0; face < mesh.numberOfFaces(); ++face)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      std::array<double, 3> weights = { 0.0, 0.0, 0.0 };
      weights[k] = 3.0; // need not sum to one
      const SurfacePoint vertex = fromBarycentric(mesh, face, weights);
      EXPECT_TRUE(samePlace(mesh, vertex, SurfacePoint::atVertex(mesh.triangle(face)[k])));

      weights[(k + 1) % 3] = 1.0;
      const SurfacePoint edge = fromBarycentric(mesh, face, weights);
      const Id halfedge = 3 * face + static_cast<Id>(k);
      EXPECT_TRUE(samePlace(mesh, edge, SurfacePoint::onEdge(halfedge, 0.25)));
    }
  }
}

TEST(SurfacePoint, CoordinatesThatVanishBesideOneGiveItsVertex)
{
  const TriangleMesh mesh = bookWithBowTie();
  for (std::size_t k = 0; k < 3; ++k)
  {
    for (const double small : { 0.0, 1e-200, 1e-18 })
    {
      std::array<double, 3> weights = { small, 1e-18, 1e-18 };
      weights[k] = 1.0;
      EXPECT_TRUE(samePlace(
        mesh, fromBarycentric(mesh, 1, weights), SurfacePoint::atVertex(mesh.triangle(1)[k])));
      const SurfacePoint inFace = SurfacePoint::inFace(1, weights[1], weights[2]);
      EXPECT_TRUE(
        samePlace(mesh, normalized(mesh, inFace), SurfacePoint::atVertex(mesh.triangle(1)[k])));
    }
  }
}

TEST(SurfacePoint, CoordinatesLostInRoundingStillGiveAValidPoint)
{
  const TriangleMesh mesh = bookWithBowTie();
  const std::array<double, 6> sizes = { 0.0, 1e-320, 1e-200, 1e-20, Epsilon / 4.0, 1.0 };
  for (const double a : sizes)
  {
    for (const double b : sizes)
    {
      for (const double c : sizes)
      {
        if (a + b + c < 1.0)
        {
          continue;
        }
        const SurfacePoint point = fromBarycentric(mesh, 1, { a, b, c });
        if (point.kind == SurfacePoint::Kind::Edge)
        {
          EXPECT_GT(point.u, 0.0);
          EXPECT_LT(point.u, 1.0);
        }
        if (point.kind == SurfacePoint::Kind::Face)
        {
          EXPECT_GT(point.u, 0.0);
          EXPECT_GT(point.v, 0.0);
          EXPECT_GT(1.0 - point.u - point.v, 0.0);
        }
        EXPECT_EQ(normalized(mesh, point).kind, point.kind);
        const double sum = a + b + c;
        const Vec3 expected = combined(mesh, 1, { a / sum, b / sum, c / sum });
        EXPECT_LE(norm(position(mesh, point) - expected), 4.0 * Epsilon);
      }
    }
  }
}

TEST(SurfacePoint, AnIsolatedVertexHasNoFace)
{
  const TriangleMesh mesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 5, 5, 5 } }, { { 0, 1, 2 } });
  const SurfacePoint isolated = SurfacePoint::atVertex(3);
  EXPECT_EQ(someFace(mesh, isolated), NoId);
  EXPECT_TRUE(facesOf(mesh, isolated).empty());
  EXPECT_EQ(commonFace(mesh, isolated, SurfacePoint::atVertex(0)), NoId);
}

}
