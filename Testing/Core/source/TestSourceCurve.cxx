// SPDX-License-Identifier: BSD-3-Clause
#include "EngineSupport.h"
#include "Watched.h"
#include "truth/AnalyticDistances.h"

#include "Errors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace
{

using namespace geodesic;
using geodesictest::boundaryCurves;
using geodesictest::engineMesh;
using geodesictest::MeshPoint;
using geodesictest::PlainMesh;
using geodesictest::Random;
using geodesictest::randomPoints;

constexpr double Epsilon = std::numeric_limits<double>::epsilon();
constexpr double FloatEpsilon = std::numeric_limits<float>::epsilon();

Vec3 roundedToFloat(const Vec3& p)
{
  return { static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2]) };
}

PlainMesh changed(PlainMesh mesh, const std::function<Vec3(const Vec3&)>& change)
{
  std::transform(mesh.points.begin(), mesh.points.end(), mesh.points.begin(), change);
  return mesh;
}

LocatedPolyline polyline(
  const std::vector<Vec3>& points, const std::vector<Id>& faces, bool closed = false)
{
  LocatedPolyline result;
  result.points = points;
  for (const Id face : faces)
  {
    result.faces.push_back({ face });
  }
  result.closed = closed;
  result.name = geodesic::PartName("the source").part("line", 7);
  return result;
}

LocatedPolyline polylineOn(
  const PlainMesh& mesh, const std::vector<MeshPoint>& points, bool closed = false)
{
  LocatedPolyline result = polyline({}, {}, closed);
  for (const MeshPoint& point : points)
  {
    result.points.push_back(position(mesh, point));
    result.faces.push_back({ point.face });
  }
  return result;
}

SourceCurves put(const TriangleMesh& mesh, const LocatedPolyline& line, double precision = Epsilon)
{
  return putOntoSurface(mesh, { line }, precision, joinByShortestPaths(mesh));
}

/// The place of a single point on the surface.
SurfacePoint placed(
  const TriangleMesh& mesh, const Vec3& point, Id face, double precision = Epsilon)
{
  const SourceCurves result = put(mesh, polyline({ point }, { face }), precision);
  EXPECT_EQ(result.curves.size(), 1u);
  EXPECT_EQ(result.curves[0].points.size(), 1u);
  EXPECT_TRUE(result.curves[0].faces.empty());
  EXPECT_FALSE(result.curves[0].isClosed());
  return result.curves[0].points[0];
}

double length(const TriangleMesh& mesh, const SourceCurve& curve)
{
  double sum = 0.0;
  for (std::size_t i = 1; i < curve.points.size(); ++i)
  {
    sum += norm(position(mesh, curve.points[i]) - position(mesh, curve.points[i - 1]));
  }
  return sum;
}

/// Checks properties of every curve.
void expectWhole(const TriangleMesh& mesh, const SourceCurve& curve)
{
  ASSERT_FALSE(curve.points.empty());
  ASSERT_EQ(curve.faces.size() + 1, curve.points.size());
  ASSERT_EQ(curve.isCut.size(), curve.points.size());
  EXPECT_FALSE(curve.isCut.front());
  EXPECT_FALSE(curve.isCut.back());
  for (std::size_t i = 0; i < curve.faces.size(); ++i)
  {
    ASSERT_LT(curve.faces[i], mesh.numberOfFaces());
    EXPECT_TRUE(contains(mesh, curve.faces[i], curve.points[i]));
    EXPECT_TRUE(contains(mesh, curve.faces[i], curve.points[i + 1]));
    EXPECT_FALSE(samePlace(mesh, curve.points[i], curve.points[i + 1]));
    const bool isCutInside = curve.isCut[i] && curve.points[i].kind != SurfacePoint::Kind::Edge;
    EXPECT_FALSE(isCutInside);
  }
}

//----------------------------------------------------------------------------
// Places of single points.

TEST(SourceCurve, TheSnapDistanceIsTheLargest)
{
  const TriangleMesh mesh = engineMesh(geodesictest::regularGrid(4, 1));
  const std::vector<Vec3> points = { { 0.6, 0.2, 0.25 }, { 0.7, 0.2, -2.0 }, { 0.8, 0.2, 1.0 } };
  EXPECT_DOUBLE_EQ(put(mesh, polyline(points, { 0, 0, 0 })).snapDistance, 2.0);
}

TEST(SourceCurve, ACurveOf64BitsIsNotMovedByMoreThanRounding)
{
  const PlainMesh plain = geodesictest::regularGrid(3, 3);
  const TriangleMesh mesh = engineMesh(plain);
  Random random(4);
  for (int i = 0; i < 1000; ++i)
  {
    const MeshPoint at = geodesictest::randomPoint(plain, random);
    const Vec3 p = position(plain, at);
    const Vec3 q = position(mesh, placed(mesh, p, at.face));
    EXPECT_LE(norm(q - p), 16.0 * Epsilon * 3.0);
  }
  const SurfacePoint beside = placed(mesh, { 1.5, 1e-9, 0.0 }, 2);
  EXPECT_EQ(beside.kind, SurfacePoint::Kind::Face);
}

TEST(SourceCurve, RoundingPutsAPointOntoTheVertexOrEdgeItWasMadeFrom)
{
  const PlainMesh plain = geodesictest::octasphere(5);
  const TriangleMesh mesh = engineMesh(plain);
  Random random(5);
  for (Id halfedge = 0; halfedge < mesh.numberOfHalfedges(); ++halfedge)
  {
    const SurfacePoint given = SurfacePoint::onEdge(halfedge, random.uniform(0.1, 0.9));
    const Vec3 p = position(mesh, given);
    const Id face = TriangleMesh::faceOf(halfedge);
    const SurfacePoint double64 = placed(mesh, p, face);
    const SurfacePoint float32 = placed(mesh, roundedToFloat(p), face, FloatEpsilon);
    for (const SurfacePoint& place : { double64, float32 })
    {
      EXPECT_EQ(place.kind, SurfacePoint::Kind::Edge);
      EXPECT_EQ(mesh.edgeOf(place.id), mesh.edgeOf(halfedge));
    }
    const SurfacePoint vertex =
      placed(mesh, roundedToFloat(mesh.point(mesh.origin(halfedge))), face, FloatEpsilon);
    EXPECT_TRUE(samePlace(mesh, vertex, SurfacePoint::atVertex(mesh.origin(halfedge))));
  }
}

TEST(SourceCurve, FarFromTheOriginNoFaceCollapses)
{
  const Vec3 away = { 3e6, -5e6, 1e6 };
  const PlainMesh plain =
    changed(geodesictest::regularGrid(2, 2), [&](const Vec3& p) { return p + away; });
  const TriangleMesh mesh = engineMesh(plain);
  // Roundings of 32 bits are half an edge long there.
  const LocatedPolyline line = polylineOn(plain,
    { { 0, { 0.5, 0.25, 0.25 } }, { 0, { 0.25, 0.5, 0.25 } }, { 0, { 0.25, 0.25, 0.5 } } }, true);
  const SourceCurves result = put(mesh, line, FloatEpsilon);
  EXPECT_EQ(result.repeatedPoints, 0u);
  ASSERT_EQ(result.curves[0].points.size(), 4u);
  for (const SurfacePoint& point : result.curves[0].points)
  {
    EXPECT_EQ(point.kind, SurfacePoint::Kind::Face);
  }
}

TEST(SourceCurve, ScaleDoesNotMatter)
{
  Random random(6);
  const PlainMesh plain = geodesictest::bumpySheet(6, 6, 0, 0.4, random);
  const std::vector<MeshPoint> points = randomPoints(plain, 40, random);
  const auto put32 = [&](const PlainMesh& mesh)
  {
    std::vector<LocatedPolyline> lines;
    for (const MeshPoint& point : points)
    {
      lines.push_back(polylineOn(mesh, { point }));
    }
    const TriangleMesh engine = engineMesh(mesh);
    return putOntoSurface(engine, lines, FloatEpsilon, joinByShortestPaths(engine));
  };
  const SourceCurves expected = put32(plain);
  for (const double scale : { 0x1p-30, 0x1p30 })
  {
    const SourceCurves result = put32(geodesictest::scaled(plain, scale));
    EXPECT_EQ(result.snapDistance, scale * expected.snapDistance);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const SurfacePoint& a = result.curves[i].points[0];
      const SurfacePoint& b = expected.curves[i].points[0];
      EXPECT_TRUE(a.kind == b.kind && a.id == b.id && a.u == b.u && a.v == b.v);
    }
  }
}

//----------------------------------------------------------------------------
// Polylines.

/// The section of a height field over the plane with x = at, ordered by y, as a filter for surfaces
/// with 32-bit points computes it: each point with one of the faces of its edge.
LocatedPolyline sectionOf(const TriangleMesh& mesh, double at)
{
  std::map<double, std::pair<Vec3, Id>> byY;
  for (Id halfedge = 0; halfedge < mesh.numberOfHalfedges(); ++halfedge)
  {
    const Vec3& a = mesh.point(mesh.origin(halfedge));
    const Vec3& b = mesh.point(mesh.destination(halfedge));
    if (halfedge == mesh.edgeOf(halfedge) && (a[0] < at) != (b[0] < at))
    {
      const Vec3 p = roundedToFloat(a + ((at - a[0]) / (b[0] - a[0])) * (b - a));
      byY[p[1]] = { p, TriangleMesh::faceOf(halfedge % 2 ? halfedge : mesh.nextSibling(halfedge)) };
    }
  }
  LocatedPolyline result = polyline({}, {});
  for (const auto& entry : byY)
  {
    result.points.push_back(entry.second.first);
    result.faces.push_back({ entry.second.second });
  }
  return result;
}

TEST(SourceCurve, ASectionOf32BitsCrossesEachEdgeAtOnePoint)
{
  Random random(7);
  for (const double offset : { 0.0, 1.0, 300.0, 5000.0 })
  {
    const PlainMesh plain = changed(geodesictest::bumpySheet(20, 20, 0, 0.4, random),
      [&](const Vec3& p) {
        return roundedToFloat(p + Vec3{ offset, offset, offset });
      });
    const TriangleMesh mesh = engineMesh(plain);
    const LocatedPolyline line = sectionOf(mesh, offset + 7.37);
    ASSERT_GT(line.points.size(), 20u);
    const SourceCurves result = put(mesh, line, FloatEpsilon);
    const SourceCurve& curve = result.curves[0];
    expectWhole(mesh, curve);
    EXPECT_EQ(curve.points.size(), line.points.size());
    EXPECT_LE(result.snapDistance, 4.0 * FloatEpsilon * (offset + 20.0));
    std::set<Id> edges;
    for (const SurfacePoint& point : curve.points)
    {
      ASSERT_EQ(point.kind, SurfacePoint::Kind::Edge);
      EXPECT_TRUE(edges.insert(mesh.edgeOf(point.id)).second);
    }
  }
}

TEST(SourceCurve, ASectionThroughVerticesPassesEachOnce)
{
  // The grid's line x = 2, cut at less than a 32-bit rounding beside it.
  const TriangleMesh mesh = engineMesh(geodesictest::regularGrid(4, 4));
  const LocatedPolyline line = sectionOf(mesh, 2.0 + 1e-8);
  const SourceCurves result = put(mesh, line, FloatEpsilon);
  expectWhole(mesh, result.curves[0]);
  ASSERT_EQ(result.curves[0].points.size(), 5u);
  for (std::size_t i = 0; i < 5; ++i)
  {
    const SurfacePoint expected = SurfacePoint::atVertex(static_cast<Id>(5 * i + 2));
    EXPECT_TRUE(samePlace(mesh, result.curves[0].points[i], expected));
  }
}

TEST(SourceCurve, RepeatedPointsAreLeftOutAndCounted)
{
  const TriangleMesh mesh = engineMesh(geodesictest::regularGrid(2, 2));
  const Vec3 a = { 0.5, 0.25, 0.0 };
  const Vec3 b = { 0.75, 0.25, 0.0 };
  const SourceCurves result = put(mesh, polyline({ a, a, b, b, b, a }, { 0, 0, 0, 0, 0, 0 }));
  EXPECT_EQ(result.repeatedPoints, 3u);
  ASSERT_EQ(result.curves[0].points.size(), 3u);
  expectWhole(mesh, result.curves[0]);
  EXPECT_TRUE(result.curves[0].isClosed());
}

TEST(SourceCurve, PointsCloserThanTheirPrecisionAreOne)
{
  const TriangleMesh mesh = engineMesh(geodesictest::regularGrid(2, 2));
  const Vec3 a = { 0.5, 0.25, 0.0 };
  const Vec3 b = { 0.5 + 0.5 * FloatEpsilon, 0.25, 0.0 };
  const LocatedPolyline line = polyline({ a, b }, { 0, 0 });
  const SourceCurves asOne = put(mesh, line, FloatEpsilon);
  EXPECT_EQ(asOne.repeatedPoints, 1u);
  EXPECT_NEAR(asOne.snapDistance, 0.5 * FloatEpsilon, Epsilon) << "the point that was left out";
  EXPECT_EQ(put(mesh, line, Epsilon).repeatedPoints, 0u);
}

TEST(SourceCurve, APolylineOfOnePlaceIsAPoint)
{
  const TriangleMesh mesh = engineMesh(geodesictest::regularGrid(2, 2));
  const Vec3 a = { 0.5, 0.25, 0.0 };
  for (const bool closed : { false, true })
  {
    const SourceCurves result = put(mesh, polyline({ a, a, a }, { 0, 0, 0 }, closed));
    EXPECT_EQ(result.repeatedPoints, 2u);
    ASSERT_EQ(result.curves.size(), 1u);
    EXPECT_EQ(result.curves[0].points.size(), 1u);
    expectWhole(mesh, result.curves[0]);
    EXPECT_FALSE(result.curves[0].isClosed());
  }
}

TEST(SourceCurve, AClosedPolylineEndsWithItsFirstPoint)
{
  const TriangleMesh mesh = engineMesh(geodesictest::regularGrid(2, 2));
  const Vec3 a = { 0.5, 0.25, 0.0 };
  const Vec3 b = { 0.75, 0.25, 0.0 };
  const Vec3 c = { 0.75, 0.5, 0.0 };
  const Vec3 d = { 0.6, 0.5, 0.0 };
  const SourceCurves implied = put(mesh, polyline({ a, b, c, d }, { 0, 0, 0, 0 }, true));
  const SourceCurves repeated = put(mesh, polyline({ a, b, c, d, a }, { 0, 0, 0, 0, 0 }, true));
  const SourceCurves written = put(mesh, polyline({ a, b, c, d, a }, { 0, 0, 0, 0, 0 }, false));
  EXPECT_EQ(implied.repeatedPoints, 0u);
  EXPECT_EQ(repeated.repeatedPoints, 1u);
  EXPECT_EQ(written.repeatedPoints, 0u);
  for (const SourceCurves& result : { implied, repeated, written })
  {
    expectWhole(mesh, result.curves[0]);
    EXPECT_EQ(result.curves[0].points.size(), 5u);
    EXPECT_TRUE(result.curves[0].isClosed());
  }
  EXPECT_FALSE(put(mesh, polyline({ a, b, c, d }, { 0, 0, 0, 0 })).curves[0].isClosed());
}

TEST(SourceCurve, ASegmentAlongAnEdgeHasAFaceOfTheEdge)
{
  const TriangleMesh mesh = engineMesh(geodesictest::regularGrid(2, 2));
  // Along y = 1 from inside one edge, by way of the middle vertex, to inside the next; located in
  // faces on both sides of it.
  const std::vector<Vec3> points = { { 0.25, 1.0, 0.0 }, { 1.0, 1.0, 0.0 }, { 1.75, 1.0, 0.0 } };
  const SourceCurves result = put(mesh, polyline(points, { 1, 0, 6 }));
  expectWhole(mesh, result.curves[0]);
  ASSERT_EQ(result.curves[0].points.size(), 3u);
  EXPECT_EQ(result.curves[0].points[0].kind, SurfacePoint::Kind::Edge);
  EXPECT_EQ(result.curves[0].points[1].kind, SurfacePoint::Kind::Vertex);
  EXPECT_EQ(result.curves[0].points[2].kind, SurfacePoint::Kind::Edge);
}

//----------------------------------------------------------------------------
// Joining points that share no face.

/// Checks that crossed edges are marked as cuts, and vertices are not.
void expectCutsAtEdges(const SourceCurve& curve)
{
  for (std::size_t i = 1; i + 1 < curve.points.size(); ++i)
  {
    EXPECT_EQ(curve.isCut[i] != 0, curve.points[i].kind == SurfacePoint::Kind::Edge);
  }
}

TEST(SourceCurve, ASegmentThroughVerticesOfAPlanePassesThem)
{
  Random random(15);
  for (int i = 0; i < 20; ++i)
  {
    // From corner to corner of 6 x 3 squares: through a vertex at every second column, and across
    // edges between. After the rotation the vertices are beside the segment by rounding.
    const PlainMesh plain = geodesictest::moved(geodesictest::regularGrid(6, 3), random);
    const TriangleMesh mesh = engineMesh(plain);
    const MeshPoint from = geodesictest::vertexPoint(plain, 0);
    const MeshPoint to = geodesictest::vertexPoint(plain, 27);
    const SourceCurve curve = put(mesh, polylineOn(plain, { from, to })).curves[0];
    expectWhole(mesh, curve);
    std::vector<Id> vertices;
    for (const SurfacePoint& point : curve.points)
    {
      if (point.kind == SurfacePoint::Kind::Vertex)
      {
        vertices.push_back(point.id);
      }
    }
    EXPECT_EQ(vertices, (std::vector<Id>{ 0, 9, 18, 27 }));
    EXPECT_EQ(curve.points.size(), 7u);
  }
}

/// Surfaces of every kind.
std::vector<PlainMesh> allKinds(Random& random)
{
  std::vector<PlainMesh> meshes;
  meshes.push_back(geodesictest::bumpySheet(7, 7, 2, 0.7, random));
  meshes.push_back(geodesictest::lShape(6, 6));
  meshes.push_back(geodesictest::octasphere(4));
  meshes.push_back(geodesictest::book(4, 3, 3, 0.4, random));
  meshes.push_back(geodesictest::moebius(9, 2));
  meshes.push_back(geodesictest::needleSheet(5, 5, 200.0, 0.3, random));
  meshes.push_back(geodesictest::fan(8, 1.0, 3));
  const PlainMesh sheet = geodesictest::bumpySheet(4, 4, 0, 0.5, random);
  meshes.push_back(
    geodesictest::joinedAtVertex(sheet, 12, geodesictest::bumpySheet(4, 4, 0, 0.5, random), 7));
  const std::size_t count = meshes.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    meshes.push_back(geodesictest::withFlippedFaces(meshes[i], random));
  }
  return meshes;
}

TEST(SourceCurve, AnyTwoPointsAreJoinedByAShortestPath)
{
  Random random(9);
  for (const PlainMesh& plain : allKinds(random))
  {
    const TriangleMesh mesh = engineMesh(plain);
    for (int i = 0; i < 4; ++i)
    {
      const MeshPoint from = geodesictest::randomPoint(plain, random);
      const MeshPoint to = geodesictest::randomPoint(plain, random);
      const SourceCurve curve = put(mesh, polylineOn(plain, { from, to })).curves[0];
      expectWhole(mesh, curve);
      expectCutsAtEdges(curve);
      const geodesictest::Sources sources{ { from }, {} };
      const double truth = geodesictest::bruteForceDistances(plain, sources, { to }).queries[0];
      EXPECT_NEAR(length(mesh, curve), truth, 1e-9 * truth);
    }
  }
}

// Straight from page 0 to page 1: for page 2 the line bends at the spine.
TEST(SourceCurve, APolylineAcrossAnEdgeOfThreeFacesIsExactOnEveryPage)
{
  using geodesictest::distanceToSegment;
  using Plane = geodesictest::Vec2;
  Random random(3);
  const PlainMesh plain = geodesictest::book(3, 4, 3, 0.0, random);
  const TriangleMesh mesh = engineMesh(plain);
  const MeshPoint p = { 2, { 0.2, 0.5, 0.3 } };
  const MeshPoint q = { 2 * 4 * 3 + 6, { 0.3, 0.3, 0.4 } };
  const SourceCurves line = put(mesh, polylineOn(plain, { p, q }));
  ASSERT_EQ(line.curves.size(), 1u);
  // Both ends and the place on the spine where the straight line crosses it, page by page.
  const auto page = [&plain](const MeshPoint& x, double side) -> Plane
  {
    const Vec3 y = position(plain, x);
    return { side * std::hypot(y[0], y[1]), y[2] };
  };
  const Plane a = page(p, 1.0);
  const Plane b = page(q, -1.0);
  const Plane spine = { 0.0, a[1] + a[0] / (a[0] - b[0]) * (b[1] - a[1]) };
  std::vector<double> truth;
  for (std::size_t v = 0; v < plain.points.size(); ++v)
  {
    const Vec3& x = plain.points[v];
    const double r = std::hypot(x[0], x[1]);
    const std::size_t onPage = v < 5 ? 0 : (v - 5) / 15; // the spine has 5 vertices, a page 15 more
    // The part on the same page is on the same side, the other one opposite.
    truth.push_back(std::min(distanceToSegment({ onPage == 0 ? r : -r, x[2] }, a, spine),
      distanceToSegment({ onPage == 1 ? -r : r, x[2] }, b, spine)));
  }
  const std::vector<double> found = solve(mesh, line.curves).vertexDistances();
  EXPECT_LE(geodesictest::worstError(found, truth, geodesictest::largestFinite(truth)),
    geodesictest::EngineAccuracy);
}

//----------------------------------------------------------------------------
// A surface that touches or overlaps itself.

/// Two grids of 3 x 1 squares, one above the other; faces 0 to 5 and 6 to 11.
PlainMesh twoSheets(double height)
{
  const PlainMesh sheet = geodesictest::regularGrid(3, 1);
  return geodesictest::merged(sheet,
    changed(sheet,
      [=](const Vec3& p) {
        return p + Vec3{ 0.0, 0.0, height };
      }));
}

TEST(SourceCurve, PointsOfSheetsNearerThanTheirPrecisionAreNotOnePlace)
{
  // Joined at one end, and 1e-9 apart at the other.
  const PlainMesh plain = { { { 0, 0, 0 }, { 4, -1, 0 }, { 4, 1, 0 }, { 4, -1, 1e-9 },
                              { 4, 1, 1e-9 } },
    { { 0, 1, 2 }, { 0, 3, 4 } } };
  const TriangleMesh mesh = engineMesh(plain);
  const Vec3 below = { 3.0, 0.25, 0.0 };
  const Vec3 above = { 3.0, 0.25, 0.75e-9 };
  const SourceCurves result =
    put(mesh, polyline({ below, above, below }, { 0, 1, 0 }), FloatEpsilon);
  EXPECT_EQ(result.repeatedPoints, 0u);
  expectWhole(mesh, result.curves[0]);
  // By way of the vertex that they share.
  EXPECT_EQ(result.curves[0].points.size(), 5u);
  EXPECT_NEAR(length(mesh, result.curves[0]), 4.0 * norm(below), 1e-6);
}

TEST(SourceCurve, TwoVerticesNearerThanTheirPrecisionStayTwo)
{
  // Each point is in a large face without a short edge.
  const TriangleMesh mesh(
    { { 0, 0, 0 }, { 1e-9, 0, 0 }, { 1, 1, 0 }, { -1, 0, 0 }, { 0, -1, 0 }, { 1, -1, 0 } },
    { { 0, 1, 2 }, { 0, 3, 4 }, { 1, 4, 5 } });
  const SourceCurves result =
    put(mesh, polyline({ mesh.point(0), mesh.point(1) }, { 1, 2 }), FloatEpsilon);
  EXPECT_EQ(result.repeatedPoints, 0u);
  ASSERT_EQ(result.curves[0].points.size(), 2u);
  EXPECT_TRUE(samePlace(mesh, result.curves[0].points[0], SurfacePoint::atVertex(0)));
  EXPECT_TRUE(samePlace(mesh, result.curves[0].points[1], SurfacePoint::atVertex(1)));
}

/// The faces that hold all of a curve's segments.
std::set<Id> facesOf(const SourceCurve& curve)
{
  return { curve.faces.begin(), curve.faces.end() };
}

TEST(SourceCurve, OfTwoSheetsAPolylineKeepsToTheOneWhereItsPointsShareFaces)
{
  const TriangleMesh mesh = engineMesh(twoSheets(0.0));
  // Points inside faces, except one at the diagonal of the middle squares.
  LocatedPolyline line =
    polyline({ { 1.75, 0.25, 0.0 }, { 1.5, 0.5, 0.0 }, { 1.25, 0.75, 0.0 } }, { 0, 0, 0 });
  for (const bool closed : { false, true })
  {
    line.closed = closed;
    line.faces = { { 2, 8 }, { 2, 3, 8, 9 }, { 9 } };
    const SourceCurve upper = put(mesh, line).curves[0];
    EXPECT_EQ(facesOf(upper), (std::set<Id>{ 8, 9 }));
    line.faces = { { 8, 2 }, { 8, 9, 2, 3 }, { 3 } };
    const SourceCurve lower = put(mesh, line).curves[0];
    EXPECT_EQ(facesOf(lower), (std::set<Id>{ 2, 3 }));
    for (const SourceCurve& curve : { upper, lower })
    {
      expectWhole(mesh, curve);
      EXPECT_EQ(curve.isClosed(), closed);
      EXPECT_NEAR(length(mesh, curve), (closed ? 2.0 : 1.0) * std::sqrt(0.5), 1e-15);
    }
  }
}

TEST(SourceCurve, FarPointsAreJoinedOnTheSheetWhereTheWayIsShortest)
{
  // A strip of length 6, folded over in the middle: faces 0 to 5 lie under faces 6 to 11.
  const PlainMesh plain = changed(geodesictest::regularGrid(6, 1),
    [](const Vec3& p) {
      return Vec3{ p[0] <= 3.0 ? p[0] : 6.0 - p[0], p[1], p[2] };
    });
  const TriangleMesh mesh = engineMesh(plain);
  const Vec3 p = { 0.25, 0.5, 0.0 };
  const Vec3 q = { 2.25, 0.5, 0.0 };
  LocatedPolyline line = polyline({ p, q }, { 0, 0 });
  for (const bool firstBelow : { false, true })
  {
    std::vector<LocatedPolyline> lines = { line };
    geodesictest::locate(mesh, lines, Epsilon);
    ASSERT_EQ(lines[0].faces[0].size(), 2u);
    if (firstBelow)
    {
      std::swap(lines[0].faces[0][0], lines[0].faces[0][1]);
    }
    const SourceCurve curve = put(mesh, lines[0]).curves[0];
    expectWhole(mesh, curve);
    EXPECT_NEAR(length(mesh, curve), 2.0, 1e-14);
  }
}

TEST(SourceCurve, APolylineIsCutWhereItChangesToASheetThatIsNotConnected)
{
  // Two squares side by side that share no points, closed around and open.
  const PlainMesh square = geodesictest::regularGrid(1, 1);
  const PlainMesh plain = geodesictest::merged(square,
    changed(square,
      [](const Vec3& p) {
        return p + Vec3{ 1.0, 0.0, 0.0 };
      }));
  const TriangleMesh mesh = engineMesh(plain);
  const std::vector<Vec3> around = { { 0.75, 0.25, 0.0 }, { 1.0, 0.25, 0.0 }, { 1.125, 0.5, 0.0 },
    { 1.0, 0.75, 0.0 }, { 0.875, 0.75, 0.0 }, { 0.75, 0.75, 0.0 } };
  for (const bool closed : { false, true })
  {
    std::vector<LocatedPolyline> lines = { polyline(around, {}, closed) };
    geodesictest::locate(mesh, lines, Epsilon);
    const SourceCurves result = put(mesh, lines[0]);
    double whole = 0.0;
    for (const SourceCurve& curve : result.curves)
    {
      expectWhole(mesh, curve);
      EXPECT_FALSE(curve.isClosed());
      whole += length(mesh, curve);
    }
    double expected = 0.0;
    for (std::size_t i = closed ? 0 : 1; i < around.size(); ++i)
    {
      expected += norm(around[i] - around[(i + around.size() - 1) % around.size()]);
    }
    EXPECT_NEAR(whole, expected, 1e-14);
    EXPECT_EQ(result.curves.size(), closed ? 2u : 3u);
    EXPECT_EQ(result.repeatedPoints, 0u);
  }
}

TEST(SourceCurve, ASinglePointTakesItsFirstFace)
{
  const TriangleMesh mesh = engineMesh(twoSheets(0.0));
  LocatedPolyline line = polyline({ { 1.5, 0.5, 0.0 } }, { 0 });
  line.faces = { { 8, 3 } };
  EXPECT_TRUE(contains(mesh, 8, put(mesh, line).curves[0].points[0]));
  line.faces = { { 3, 8 } };
  EXPECT_TRUE(contains(mesh, 3, put(mesh, line).curves[0].points[0]));
}

/// A flat sheet with one triangle of opposite orientation, and its section, which walks from face
/// to face.
TEST(SourceCurve, ASectionOfASheetWithATurnedTriangleStaysTheSameCurve)
{
  Random random(31);
  for (int i = 0; i < 20; ++i)
  {
    PlainMesh plain = geodesictest::regularGrid(6, 6);
    plain.points[24] = { 4.0 + random.uniform(0.1, 0.3), 3.0 + random.uniform(0.3, 0.6), 0.0 };
    const TriangleMesh mesh = engineMesh(plain);
    const double height = plain.points[24][1] + random.uniform(-0.1, 0.1);
    std::vector<LocatedPolyline> lines;
    geodesictest::Sources truth;
    for (Id face = 0; face < mesh.numberOfFaces(); ++face)
    {
      std::vector<Vec3> ends;
      std::vector<geodesictest::Barycentric> weights;
      for (Id k = 0; k < 3; ++k)
      {
        const Vec3& a = plain.points[plain.triangles[face][k]];
        const Vec3& b = plain.points[plain.triangles[face][(k + 1) % 3]];
        if ((a[1] < height) != (b[1] < height))
        {
          const double t = (height - a[1]) / (b[1] - a[1]);
          ends.push_back(a + t * (b - a));
          geodesictest::Barycentric& w = weights.emplace_back();
          w = { 0.0, 0.0, 0.0 };
          w[k] = 1.0 - t;
          w[(k + 1) % 3] = t;
        }
      }
      if (ends.size() == 2)
      {
        lines.push_back(polyline(ends, {}));
        truth.segments.push_back({ face, weights[0], weights[1] });
      }
    }
    geodesictest::locate(mesh, lines, Epsilon);
    const SourceCurves result = putOntoSurface(mesh, lines, Epsilon, joinByShortestPaths(mesh));
    const std::vector<double> expected =
      geodesictest::bruteForceDistances(plain, truth, {}).vertices;
    const std::vector<double> actual =
      geodesictest::engineDistances(plain, result.curves, mesh, {}).vertices;
    EXPECT_LE(geodesictest::worstError(actual, expected, 6.0), 1e-12);
  }
}

//----------------------------------------------------------------------------
// Errors and abort.

TEST(SourceCurve, WhatCannotBePutIsNamed)
{
  const PlainMesh sheet = geodesictest::regularGrid(1, 1);
  const PlainMesh plain = geodesictest::merged(sheet, sheet);
  const TriangleMesh mesh = engineMesh(plain);
  std::vector<std::pair<LocatedPolyline, const char*>> cases = {
    { polyline({}, {}), "line 7 of the source" },
    { polyline({ { 0, 0, 0 } }, { 4 }),
      "Point 0 of line 7 of the source" }, // there is no such face
    { polylineOn(plain, { { 0, { 0.5, 0.3, 0.2 } }, { 0, { 0.3, 0.5, 0.2 } }, { 2, { 1, 0, 0 } } }),
      "Points 1 and 2 of line 7 of the source" }, // in different components
  };
  for (const double bad : { std::nan(""), Infinity, -Infinity })
  {
    cases.emplace_back(
      polyline({ { 0, 0, 0 }, { 0.5, bad, 0 } }, { 0, 0 }), "Point 1 of line 7 of the source");
  }
  for (const auto& [line, words] : cases)
  {
    try
    {
      put(mesh, line);
      ADD_FAILURE() << "no error about " << words;
    }
    catch (const SourceError& error)
    {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  }
}

TEST(SourceCurve, ItsWatcherSeesZeroToOneAndCanAbort)
{
  Random random(11);
  const PlainMesh plain = geodesictest::octasphere(6);
  const TriangleMesh mesh = engineMesh(plain);
  const std::vector<MeshPoint> points = randomPoints(plain, 12, random);
  const std::vector<LocatedPolyline> lines = { polylineOn(plain, points, true),
    polylineOn(plain, points) };
  const std::vector<double> told = geodesictest::expectWatched(4,
    [&](const Job& job) { putOntoSurface(mesh, lines, Epsilon, joinByShortestPaths(mesh), job); });
  EXPECT_GT(told.back(), 0.5);
}

//----------------------------------------------------------------------------
// The boundary.

/// Every boundary edge is in the curves exactly once, and nothing else is.
void expectCoversBoundary(const PlainMesh& plain, const std::vector<SourceCurve>& curves)
{
  const TriangleMesh mesh = engineMesh(plain);
  std::multiset<std::pair<Id, Id>> expected;
  for (const auto& [a, b] : geodesictest::boundaryEdges(plain))
  {
    expected.insert(std::minmax({ a, b }));
  }
  std::multiset<std::pair<Id, Id>> found;
  for (const SourceCurve& curve : curves)
  {
    expectWhole(mesh, curve);
    for (std::size_t i = 1; i < curve.points.size(); ++i)
    {
      ASSERT_EQ(curve.points[i].kind, SurfacePoint::Kind::Vertex);
      EXPECT_FALSE(curve.isCut[i]);
      found.insert(std::minmax({ curve.points[i - 1].id, curve.points[i].id }));
    }
  }
  EXPECT_EQ(found, expected);
}

TEST(SourceCurve, TheBoundaryIsCoveredOnce)
{
  Random random(12);
  for (const PlainMesh& plain : allKinds(random))
  {
    expectCoversBoundary(plain, boundaryCurves(engineMesh(plain)));
  }
}

TEST(SourceCurve, EachBoundaryLoopIsOneClosedCurve)
{
  const auto countClosed = [](const PlainMesh& plain)
  {
    const std::vector<SourceCurve> curves = boundaryCurves(engineMesh(plain));
    for (const SourceCurve& curve : curves)
    {
      EXPECT_TRUE(curve.isClosed());
    }
    return curves.size();
  };
  Random random(13);
  PlainMesh ring = geodesictest::regularGrid(3, 3);
  ring.triangles.erase(ring.triangles.begin() + 8, ring.triangles.begin() + 10);
  EXPECT_EQ(countClosed(geodesictest::tetrahedron(2)), 0u);
  EXPECT_EQ(countClosed(geodesictest::regularGrid(3, 2)), 1u);
  EXPECT_EQ(countClosed(ring), 2u);
  EXPECT_EQ(countClosed(geodesictest::withFlippedFaces(ring, random)), 2u);
  EXPECT_EQ(countClosed(geodesictest::openCylinder(5, 3, 1.0)), 2u);
  EXPECT_EQ(countClosed(geodesictest::moebius(7, 2)), 1u);
}

TEST(SourceCurve, ABoundaryCurveEndsWhereTheBoundaryBranches)
{
  const PlainMesh sheet = geodesictest::regularGrid(2, 2);
  const PlainMesh plain = geodesictest::joinedAtVertex(sheet, 8, sheet, 0);
  const std::vector<SourceCurve> curves = boundaryCurves(engineMesh(plain));
  expectCoversBoundary(plain, curves);
  ASSERT_EQ(curves.size(), 2u);
  for (const SourceCurve& curve : curves)
  {
    EXPECT_EQ(curve.points.front().id, 8u);
    EXPECT_EQ(curve.points.back().id, 8u);
  }

  Random random(14);
  // Three pages: at either end of the spine three boundary edges meet.
  const PlainMesh pages = geodesictest::book(3, 2, 2, 0.2, random);
  const std::vector<SourceCurve> outlines = boundaryCurves(engineMesh(pages));
  expectCoversBoundary(pages, outlines);
  ASSERT_EQ(outlines.size(), 3u);
  for (const SourceCurve& curve : outlines)
  {
    EXPECT_FALSE(curve.isClosed());
  }
}

TEST(SourceCurve, TheBoundaryOfAFinThatEndsInsideASheetIsOneOpenCurve)
{
  PlainMesh plain = geodesictest::regularGrid(3, 3);
  plain.points.push_back({ 1.5, 1.0, 1.0 });
  plain.triangles.push_back({ 16, 5, 6 });
  const std::vector<SourceCurve> curves = boundaryCurves(engineMesh(plain));
  expectCoversBoundary(plain, curves);
  ASSERT_EQ(curves.size(), 2u);
  const SourceCurve& fin = curves[curves[0].isClosed() ? 1 : 0];
  EXPECT_FALSE(fin.isClosed());
  EXPECT_EQ(fin.points.size(), 3u);
  EXPECT_EQ(fin.points[1].id, 16u);
}

} // anonymous namespace
