// SPDX-License-Identifier: BSD-3-Clause
// Inputs on which other solvers are known to crash, hang or answer wrongly.
#include "EngineSupport.h"
#include "truth/AnalyticDistances.h"

#include "Errors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>
#include <string>

using namespace geodesictest;

namespace
{

geodesic::SourceCurve vertexSource(Index vertex)
{
  return geodesic::pointCurve(geodesic::SurfacePoint::atVertex(vertex));
}

std::vector<double> vertexDistances(const PlainMesh& mesh, Index source)
{
  const CleanedMesh cleaned = withoutFlatFaces(mesh);
  const geodesic::TriangleMesh engine = engineMesh(cleaned.mesh);
  const std::vector<double> distances =
    geodesic::solve(engine, { vertexSource(cleaned.vertexOf[source]) }).vertexDistances();
  std::vector<double> ofPoints;
  for (const Index vertex : cleaned.vertexOf)
  {
    ofPoints.push_back(distances[vertex]);
  }
  ofPoints.resize(mesh.points.size());
  return ofPoints;
}

/// Straight lines in space, for meshes that lie flat and convex.
std::vector<double> straightDistances(const PlainMesh& mesh, Index source)
{
  std::vector<double> result;
  const Vec3& s = mesh.points[source];
  for (const Vec3& p : mesh.points)
  {
    result.push_back(std::hypot(p[0] - s[0], p[1] - s[1], p[2] - s[2]));
  }
  return result;
}

void expectNear(
  const std::vector<double>& computed, const std::vector<double>& truth, const std::string& what)
{
  EXPECT_LE(worstError(computed, truth, largestFinite(truth)), EngineAccuracy) << what;
}

/// The place of a regular grid of n x n cells at these coordinates.
MeshPoint gridPoint(Index n, double x, double y)
{
  const double i = std::min(std::floor(x), n - 1.0);
  const double j = std::min(std::floor(y), n - 1.0);
  const Index cell = 2 * (static_cast<Index>(j) * n + static_cast<Index>(i));
  const double u = x - i;
  const double v = y - j;
  // The lower face's corners are (0, 0), (1, 0), (1, 1), the upper one's (0, 0), (1, 1), (0, 1).
  return u >= v ? MeshPoint{ cell, { 1.0 - u, u - v, v } }
                : MeshPoint{ cell + 1, { 1.0 - v, u, v - u } };
}

/// The message that building the mesh throws.
std::string meshErrorOf(const PlainMesh& mesh)
{
  try
  {
    engineMesh(mesh);
  }
  catch (const geodesic::MeshError& error)
  {
    return error.what();
  }
  return "";
}

}

TEST(PeersWrongAnswers, APolylineAcrossANonManifoldEdgeIsExactOnEveryPage)
{
  // Straight from page 0 to page 1: for page 2 it bends at the spine.
  Random random(3);
  const PlainMesh mesh = book(3, 4, 3, 0.0, random);
  const geodesic::TriangleMesh engine = engineMesh(mesh);
  const MeshPoint p = { 2, { 0.2, 0.5, 0.3 } };
  const MeshPoint q = { 2 * 4 * 3 + 6, { 0.3, 0.3, 0.4 } };
  geodesic::LocatedPolyline line;
  line.points = { position(mesh, p), position(mesh, q) };
  line.faces = { { p.face }, { q.face } };
  line.name = geodesic::PartName("the line");
  const geodesic::SourceCurves put =
    geodesic::putOntoSurface(engine, { line }, DBL_EPSILON, geodesic::joinByShortestPaths(engine));
  ASSERT_EQ(put.curves.size(), 1u);
  // Both ends and the place on the spine where the straight line crosses it, page by page.
  const auto page = [&mesh](const MeshPoint& x, double halfedge) -> Vec2
  {
    const Vec3 y = position(mesh, x);
    return { halfedge * std::hypot(y[0], y[1]), y[2] };
  };
  const Vec2 a = page(p, 1.0);
  const Vec2 b = page(q, -1.0);
  const double t = a[0] / (a[0] - b[0]);
  const Vec2 spine = { 0.0, a[1] + t * (b[1] - a[1]) };
  std::vector<double> truth;
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
  {
    const Vec3& x = mesh.points[v];
    const double r = std::hypot(x[0], x[1]);
    const std::size_t onPage = v < 5 ? 0 : (v - 5) / 15; // the spine has 5 vertices, a page 15 more
    // The part on the same page is on the same side, the other one opposite.
    const Vec2 toA = { onPage == 0 ? r : -r, x[2] };
    const Vec2 toB = { onPage == 1 ? -r : r, x[2] };
    truth.push_back(std::min(distanceToSegment(toA, a, spine), distanceToSegment(toB, b, spine)));
  }
  expectNear(geodesic::solve(engine, put.curves).vertexDistances(), truth, "line across the spine");
}

TEST(PeersWrongAnswers, AnEdgeWithoutLengthConducts)
{
  // An inner vertex moved onto its neighbour: the surface is the same, two faces lose their area.
  PlainMesh mesh = regularGrid(8, 8);
  mesh.points[4 * 9 + 4] = mesh.points[4 * 9 + 5];
  mesh.points[2 * 9 + 2] = mesh.points[3 * 9 + 3];
  EXPECT_EQ(facesWithoutArea(mesh), 4u);
  for (Index source : { 0u, 40u, 41u, 80u, 20u })
  {
    expectNear(vertexDistances(mesh, source), straightDistances(mesh, source),
      "from vertex " + std::to_string(source));
  }
}

TEST(PeersWrongAnswers, OfASoupOfTrianglesOnlyTheSourcesFaceIsReached)
{
  const PlainMesh grid = regularGrid(3, 3);
  PlainMesh soup;
  for (const Triangle& t : grid.triangles)
  {
    const Index first = static_cast<Index>(soup.points.size());
    for (Index v : t)
    {
      soup.points.push_back(grid.points[v]);
    }
    soup.triangles.push_back({ first, first + 1, first + 2 });
  }
  const std::vector<double> distances = vertexDistances(soup, 4);
  for (std::size_t v = 0; v < soup.points.size(); ++v)
  {
    EXPECT_EQ(std::isfinite(distances[v]), v / 3 == 1) << "vertex " << v;
  }
}

TEST(PeersWrongAnswers, CoordinatesThatAreNotFiniteAreRefusedByName)
{
  for (double bad : { std::numeric_limits<double>::quiet_NaN(),
         std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() })
  {
    for (Index axis = 0; axis < 3; ++axis)
    {
      PlainMesh mesh = regularGrid(4, 4);
      mesh.points[13][axis] = bad;
      EXPECT_NE(meshErrorOf(mesh).find("13"), std::string::npos) << meshErrorOf(mesh);
    }
  }
}

TEST(PeersWrongAnswers, NoRayIsMissingBetweenThePencilsOfAPolylinesEnd)
{
  // Queries close to the border between the parallel rays of a segment and the circular rays of its
  // end, which leaves at a right angle. The end is at various distances from an edge.
  const Index n = 8;
  const PlainMesh grid = regularGrid(n, n);
  const Index face = 2 * (4 * n + 3);
  for (Index k = 0; k < 3; ++k)
  {
    for (double off :
      { 0.0, 1e-18, 1e-16, 1e-15, 1e-14, 1e-13, 1e-12, 1e-10, 1e-8, 1e-6, 1e-3, 0.1 })
    {
      Barycentric start{};
      start[k] = 0.6;
      start[(k + 1) % 3] = 0.4 - off;
      start[(k + 2) % 3] = off;
      const Barycentric end = { 0.3, 0.25, 0.45 };
      const Vec3 a = position(grid, { face, start });
      const Vec3 b = position(grid, { face, end });
      const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
      const Vec2 along = { (b[0] - a[0]) / length, (b[1] - a[1]) / length };
      std::vector<MeshPoint> queries;
      std::vector<double> truth;
      for (double halfedge : { -1.0, 1.0 })
      {
        for (double angle :
          { 0.0, 1e-14, 1e-11, 1e-8, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 0.5, 1.0 })
        {
          for (double radius : { 0.3, 1.1, 2.3 })
          {
            const double out = halfedge * radius * std::cos(angle);
            const double back = -radius * std::sin(angle);
            const double x = a[0] + back * along[0] - out * along[1];
            const double y = a[1] + back * along[1] + out * along[0];
            queries.push_back(gridPoint(n, x, y));
            truth.push_back(distanceToSegment({ x, y }, { a[0], a[1] }, { b[0], b[1] }));
          }
        }
      }
      const EngineResult result =
        engineDistances(grid, std::vector<Polyline>{ { { { face, start, end } }, {} } }, queries);
      EXPECT_LE(worstError(result.queries, truth, n), EngineAccuracy)
        << "halfedge " << k << ", off by " << off;
    }
  }
}

TEST(PeersWrongAnswers, APointGivenInAFaceWhoseCoordinatesAreThoseOfAnEdgeIsOnThatEdge)
{
  // u + v = 1, exactly and up to rounding: the coordinate of corner 0 is zero or just below.
  const PlainMesh grid = regularGrid(6, 6);
  const geodesic::TriangleMesh engine = engineMesh(grid);
  for (const auto& [u, v] :
    { std::pair(0.5, 0.5), std::pair(0.64239925514211993, 0.35760074485788007), std::pair(0.0, 0.3),
      std::pair(0.3, 0.0), std::pair(1.0, 0.0), std::pair(0.0, 0.0) })
  {
    for (Index f : { 28u, 29u, 40u })
    {
      const geodesic::SurfacePoint point = geodesic::SurfacePoint::inFace(f, u, v);
      const Vec3 x = position(grid, { f, { 1.0 - u - v, u, v } });
      const geodesic::DistanceField fromPoint =
        solveKeepingAll(engine, { geodesic::pointCurve(point) });
      for (Index vertex = 0; vertex < grid.points.size(); ++vertex)
      {
        const Vec3& p = grid.points[vertex];
        const double truth = std::hypot(p[0] - x[0], p[1] - x[1]);
        EXPECT_NEAR(fromPoint.vertexDistances()[vertex], truth, 1e-12)
          << "source in face " << f << " at " << u << ", " << v << ", vertex " << vertex;
        EXPECT_NEAR(solveKeepingAll(engine, { vertexSource(vertex) }).distance(point), truth, 1e-12)
          << "query in face " << f << " at " << u << ", " << v << ", from vertex " << vertex;
      }
    }
  }
}
