// SPDX-License-Identifier: BSD-3-Clause
// Where along a curve shortest paths end and at which angle they leave the source, in closed form.
#include "EngineSupport.h"
#include "truth/AnalyticDistances.h"

#include "Errors.h"
#include "field/NearestSource.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

using namespace geodesictest;
using geodesic::Foot;
using geodesic::Id;
using geodesic::NearestSource;
using geodesic::SurfacePoint;

namespace
{

constexpr double Pi = 3.14159265358979323846;
/// The requirement is 1e-9 of the length and 1e-8 radians.
constexpr double Accuracy = 1e-11;

double gapOfAngles(double a, double b)
{
  return std::abs(std::remainder(a - b, 2.0 * Pi));
}

/// A field and its feet.
struct Solved
{
  geodesic::TriangleMesh mesh;
  std::vector<geodesic::SourceCurve> curves;
  geodesic::DistanceField field;
  NearestSource nearest;

  static geodesic::DistanceField solve(
    const geodesic::TriangleMesh& mesh, const std::vector<geodesic::SourceCurve>& curves)
  {
    geodesic::FrontOptions options;
    options.keepArrivals = true;
    options.keepAngles = true;
    return geodesic::solve(mesh, curves, options, geodesic::KeepWindows::All);
  }

  Solved(const PlainMesh& plain, const std::vector<Polyline>& polylines)
    : mesh(engineMesh(plain))
    , curves(engineCurves(mesh, polylines))
    , field(solve(mesh, curves))
    , nearest(field, geodesic::ReplicatedPatch(mesh), curves)
  {
  }

  Foot footOf(const MeshPoint& point)
  {
    const SurfacePoint p = geodesic::normalized(mesh, enginePoint(mesh, point));
    return p.kind == SurfacePoint::Kind::Vertex ? nearest.atVertex(p.id)
                                                : nearest.of(geodesic::incomingSegmentTo(field, p));
  }
};

Polyline pointAt(const MeshPoint& point)
{
  return { { { point.face, point.weights, point.weights } }, {} };
}

/// A line along mesh edges.
Polyline along(const PlainMesh& mesh, const std::vector<Index>& vertices)
{
  const auto cornerOf = [](const Triangle& t, Index vertex)
  { return static_cast<std::size_t>(std::find(t.begin(), t.end(), vertex) - t.begin()); };
  Polyline line;
  for (std::size_t i = 0; i + 1 < vertices.size(); ++i)
  {
    for (Index face = 0; face < mesh.triangles.size(); ++face)
    {
      const std::size_t a = cornerOf(mesh.triangles[face], vertices[i]);
      const std::size_t b = cornerOf(mesh.triangles[face], vertices[i + 1]);
      if (a < 3 && b < 3)
      {
        MeshSegment segment = { face, {}, {} };
        segment.from[a] = 1.0;
        segment.to[b] = 1.0;
        line.segments.push_back(segment);
        break;
      }
    }
  }
  EXPECT_EQ(line.segments.size() + 1, vertices.size());
  return line;
}

/// The vertices of a mesh and some other points.
std::vector<MeshPoint> manyPoints(const PlainMesh& mesh, Random& random)
{
  std::vector<MeshPoint> points;
  for (Index vertex = 0; vertex < mesh.points.size(); ++vertex)
  {
    points.push_back(vertexPoint(mesh, vertex));
  }
  for (int i = 0; i < 200; ++i)
  {
    points.push_back(randomFacePoint(mesh, random));
    points.push_back(randomEdgePoint(mesh, random));
  }
  return points;
}

Vec3 minus(const Vec3& a, const Vec3& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

/// The angle of a vector in a frame.
double angleIn(const geodesic::SourceFrame& frame, const Vec3& v)
{
  return std::atan2(geodesic::dot(v, frame.y), geodesic::dot(v, frame.x));
}

/// Checks that a frame's x axis runs along an edge of the mesh.
void expectAlong(const geodesic::SourceFrame& frame, const PlainMesh& mesh, Index from, Index to)
{
  const Vec3 edge = minus(mesh.points[to], mesh.points[from]);
  EXPECT_NEAR(geodesic::dot(frame.x, edge), geodesic::norm(edge), 1e-13 * geodesic::norm(edge));
  EXPECT_NEAR(geodesic::dot(frame.x, frame.y), 0.0, 1e-13);
  EXPECT_NEAR(geodesic::norm(frame.normal), 1.0, 1e-13);
}

} // anonymous namespace

// A point in a face, on an edge, at an inner vertex and on the boundary.
TEST(SourceAnglesInClosedForm, OfAPointInThePlaneAreThoseOfTheStraightLine)
{
  Random random(1);
  double worst = 0.0;
  for (int i = 0; i < 20; ++i)
  {
    const PlainMesh plain = moved(randomPlanar(9, 7, random), random);
    std::vector<Index> onBoundary;
    for (const auto& [a, b] : boundaryEdges(plain))
    {
      onBoundary.insert(onBoundary.end(), { a, b });
    }
    for (int kind = 0; kind < 4; ++kind)
    {
      SCOPED_TRACE("mesh " + std::to_string(i) + ", kind " + std::to_string(kind));
      const auto isOnBoundary = [&](const MeshPoint& p)
      {
        const Triangle& t = plain.triangles[p.face];
        return std::all_of(t.begin(), t.end(),
          [&](const Index& v)
          {
            const auto k = static_cast<std::size_t>(&v - &t[0]);
            return p.weights[k] == 0.0 ||
              std::find(onBoundary.begin(), onBoundary.end(), v) != onBoundary.end();
          });
      };
      MeshPoint source = kind == 0 ? randomFacePoint(plain, random)
        : kind == 1                ? randomEdgePoint(plain, random)
                                   : randomVertexPoint(plain, random);
      while (kind >= 2 && isOnBoundary(source) != (kind == 3))
      {
        source = randomVertexPoint(plain, random);
      }
      Solved s(plain, { pointAt(source) });
      const geodesic::SourceFrame frame = s.nearest.frameOf(0);
      const Vec3 center = position(plain, source);
      for (const MeshPoint& query : manyPoints(plain, random))
      {
        const Vec3 straight = minus(position(plain, query), center);
        if (geodesic::norm(straight) > 1e-3)
        {
          const double angle = s.nearest.angleOf(s.footOf(query));
          const double error = gapOfAngles(angle, angleIn(frame, straight));
          EXPECT_LE(error, Accuracy);
          worst = std::max(worst, error);
          EXPECT_GE(angle, kind == 3 ? 0.0 : -Pi);
          EXPECT_LE(angle, Pi + 1e-12);
          EXPECT_EQ(s.nearest.arcLengthOf(s.footOf(query)), 0.0);
        }
      }
    }
  }
  std::cout << "worst angle: " << worst << "\n";
}

TEST(SourceAnglesInClosedForm, BeginAtTheEdgeThatIsFirstInTheInput)
{
  const PlainMesh plain = regularGrid(4, 4);
  const Triangle first = plain.triangles[7];
  expectAlong(Solved(plain, { pointAt({ 7, { 0.3, 0.3, 0.4 } }) }).nearest.frameOf(0), plain,
    first[0], first[1]);
  // Both faces at an edge, whichever face names the point.
  for (Index face = 0; face < plain.triangles.size(); ++face)
  {
    const MeshPoint middle = { face, { 0.0, 0.5, 0.5 } };
    Solved s(plain, { pointAt(middle) });
    Index lowest = 0;
    while (geodesic::contains(s.mesh, lowest, enginePoint(s.mesh, middle)) == false)
    {
      ++lowest;
    }
    const Triangle& t = plain.triangles[lowest];
    expectAlong(s.nearest.frameOf(0), plain, t[0], t[1]);
  }
  // The edge that leaves an inner vertex in its first face; on the boundary the edge with the
  // surface on its left.
  for (Index vertex = 0; vertex < plain.points.size(); ++vertex)
  {
    const MeshPoint at = vertexPoint(plain, vertex);
    Solved s(plain, { pointAt(at) });
    Index to = 0;
    bool isOnBoundary = false;
    for (Index face = 0; face < plain.triangles.size() && !isOnBoundary; ++face)
    {
      const Triangle& t = plain.triangles[face];
      for (std::size_t k = 0; k < 3; ++k)
      {
        if (t[k] == vertex && s.mesh.isBoundary(3 * face + static_cast<Id>(k)))
        {
          to = t[(k + 1) % 3];
          isOnBoundary = true;
        }
      }
    }
    for (Index face = static_cast<Index>(plain.triangles.size()); face-- > 0 && !isOnBoundary;)
    {
      const Triangle& t = plain.triangles[face];
      for (std::size_t k = 0; k < 3; ++k)
      {
        to = t[k] == vertex ? t[(k + 1) % 3] : to;
      }
    }
    expectAlong(s.nearest.frameOf(0), plain, vertex, to);
  }
}

// The corner turns left by a right angle: on its left the sector is pi / 2, on its right 3 pi / 2.
TEST(SourceAnglesInClosedForm, OfALineInThePlaneAreMeasuredFromTheLine)
{
  const Index n = 12;
  const PlainMesh plain = regularGrid(n, n);
  const auto at = [](Index x, Index y) { return y * (n + 1) + x; };
  std::vector<Index> vertices;
  for (Index x = 3; x <= 7; ++x)
  {
    vertices.push_back(at(x, 4));
  }
  for (Index y = 5; y <= 9; ++y)
  {
    vertices.push_back(at(7, y));
  }
  Random random(2);
  for (const bool isReversed : { false, true })
  {
    if (isReversed)
    {
      std::reverse(vertices.begin(), vertices.end());
    }
    Solved s(plain, { along(plain, vertices) });
    double worst = 0.0;
    for (const MeshPoint& query : manyPoints(plain, random))
    {
      const Vec3 p = position(plain, query);
      const double toFirst = std::hypot(p[0] - std::clamp(p[0], 3.0, 7.0), p[1] - 4.0);
      const double toSecond = std::hypot(p[0] - 7.0, p[1] - std::clamp(p[1], 4.0, 9.0));
      const bool isCorner = p[0] > 7.0 && p[1] < 4.0;
      const bool isOff = std::min(toFirst, toSecond) > 1e-3;
      if (!isOff || (!isCorner && std::abs(toFirst - toSecond) < 1e-9))
      {
        continue;
      }
      double arc = 4.0;
      double angle = 0.0;
      if (isCorner)
      {
        // Counterclockwise from the backward segment, which is to the left.
        angle = -Pi + (std::atan2(p[1] - 4.0, p[0] - 7.0) + Pi) / 1.5;
      }
      else if (toFirst < toSecond)
      {
        arc = std::clamp(p[0], 3.0, 7.0) - 3.0;
        angle = p[0] < 3.0 ? std::atan2(p[1] - 4.0, p[0] - 3.0) : p[1] > 4.0 ? 0.5 * Pi : -0.5 * Pi;
      }
      else
      {
        arc = 4.0 + std::clamp(p[1], 4.0, 9.0) - 4.0;
        angle = p[1] > 9.0 ? std::atan2(-(p[0] - 7.0), p[1] - 9.0)
          : p[0] < 7.0     ? 0.5 * Pi
                           : -0.5 * Pi;
      }
      if (isReversed)
      {
        arc = 9.0 - arc;
        angle += Pi;
      }
      const Foot foot = s.footOf(query);
      EXPECT_NEAR(s.nearest.arcLengthOf(foot), arc, Accuracy) << p[0] << ", " << p[1];
      const double error = gapOfAngles(s.nearest.angleOf(foot), angle);
      EXPECT_LE(error, Accuracy) << p[0] << ", " << p[1] << ": " << s.nearest.angleOf(foot)
                                 << ", expected " << angle;
      worst = std::max(worst, error);
    }
    const geodesic::SourceFrame frame = s.nearest.frameOf(0);
    const Vec3 x = isReversed ? Vec3{ 0.0, -1.0, 0.0 } : Vec3{ 1.0, 0.0, 0.0 };
    EXPECT_NEAR(geodesic::dot(frame.x, x), 1.0, 1e-14);
    EXPECT_NEAR(frame.normal[2], 1.0, 1e-14);
    std::cout << "worst angle: " << worst << "\n";
  }
}

// Along the boundary angles are not scaled: at a corner of the rectangle the sector is a right
// angle.
TEST(SourceAnglesInClosedForm, OfABoundaryAreNotScaled)
{
  const Index n = 8;
  const PlainMesh plain = regularGrid(n, n);
  const geodesic::TriangleMesh mesh = engineMesh(plain);
  const std::vector<geodesic::SourceCurve> loops = geodesic::boundaryCurves(mesh);
  ASSERT_EQ(loops.size(), 1U);
  const geodesic::DistanceField field = Solved::solve(mesh, loops);
  NearestSource nearest(field, geodesic::ReplicatedPatch(mesh), loops);
  for (Id vertex = 0; vertex < mesh.numberOfVertices(); ++vertex)
  {
    const double x = mesh.point(vertex)[0];
    const double y = mesh.point(vertex)[1];
    const double angle = std::abs(nearest.angleOf(nearest.atVertex(vertex)));
    const bool isOnSource = std::min({ x, y, n - x, n - y }) == 0.0;
    EXPECT_NEAR(angle, isOnSource ? 0.0 : 0.5 * Pi, 1e-14);
  }
  // The length of the whole loop, and the places of its points.
  const std::vector<double> lengths = nearest.arcLengthsOf(0);
  ASSERT_EQ(lengths.size(), 4U * n + 1);
  for (std::size_t i = 0; i < lengths.size(); ++i)
  {
    EXPECT_EQ(lengths[i], static_cast<double>(i));
  }
}

TEST(SourceAnglesInClosedForm, OnACylinderAreThoseOfTheUnrolledOne)
{
  constexpr Index sides = 12;
  constexpr Index rows = 9;
  const PlainMesh plain = openCylinder(sides, rows, 10.0);
  const auto unrolled = [&](Index vertex) {
    return std::array<double, 2>{ double(vertex % sides), plain.points[vertex][2] };
  };
  for (const Index source : { 3 + 4 * sides, 7 + 5 * sides, 2 + 0 * sides })
  {
    Solved s(plain, { pointAt(vertexPoint(plain, source)) });
    const geodesic::SourceFrame frame = s.nearest.frameOf(0);
    // The frame's face is flat: turned about the axis, its vectors are those of the unrolled one.
    const double toMiddle = 2.0 * Pi *
      (source % sides +
        (frame.normal[0] * -plain.points[source][1] + frame.normal[1] * plain.points[source][0] >
              0.0
            ? 0.5
            : -0.5)) /
      sides;
    const Vec3 around = { -std::sin(toMiddle), std::cos(toMiddle), 0.0 };
    const double sense =
      geodesic::dot(geodesic::cross(around, Vec3{ 0.0, 0.0, 1.0 }), frame.normal);
    ASSERT_NEAR(std::abs(sense), 1.0, 1e-12);
    const double zero = std::atan2(frame.x[2], geodesic::dot(frame.x, around));
    int compared = 0;
    for (Index vertex = 0; vertex < plain.points.size(); ++vertex)
    {
      const auto a = unrolled(source);
      const auto b = unrolled(vertex);
      const double turn = std::remainder(b[0] - a[0], double(sides));
      if (vertex != source && std::abs(turn) < 0.5 * sides - 0.5)
      {
        const double angle = sense * (std::atan2(b[1] - a[1], turn) - zero);
        EXPECT_LE(gapOfAngles(s.nearest.angleOf(s.nearest.atVertex(vertex)), angle), Accuracy)
          << "from " << source << " to " << vertex;
        ++compared;
      }
    }
    EXPECT_GT(compared, 80);
  }
}

// Around the apex of a cone, or a saddle, the total angle is 2 pi.
TEST(SourceAnglesInClosedForm, AroundAnApexAreScaled)
{
  constexpr Index sectors = 8;
  constexpr Index n = 5;
  Random random(4);
  for (const double angle : { 0.3, 0.7, 0.9, 1.3 })
  {
    const PlainMesh plain = fan(sectors, angle, n);
    Solved s(plain, { pointAt(vertexPoint(plain, 0)) });
    double worst = 0.0;
    for (const MeshPoint& query : manyPoints(plain, random))
    {
      const Polar p = fanCoordinates(sectors, angle, n, plain, query);
      if (p.radius > 1e-3)
      {
        const double expected = p.angle * 2.0 * Pi / (sectors * angle);
        const double error = gapOfAngles(s.nearest.angleOf(s.footOf(query)), expected);
        EXPECT_LE(error, Accuracy) << "at " << p.radius << ", " << p.angle;
        worst = std::max(worst, error);
      }
    }
    std::cout << "total angle " << sectors * angle << ", worst angle: " << worst << "\n";
  }
}

// Great circles; a sphere of many facets differs from the sphere by a fraction of its facets.
TEST(SourceAnglesInClosedForm, OnASphereOfManyFacetsAreNearlyTheAzimuths)
{
  for (const Index n : { 8U, 32U })
  {
    const PlainMesh plain = octasphere(n);
    Index pole = 0;
    for (Index vertex = 0; vertex < plain.points.size(); ++vertex)
    {
      pole = plain.points[vertex][2] > plain.points[pole][2] ? vertex : pole;
    }
    Solved s(plain, { pointAt(vertexPoint(plain, pole)) });
    const geodesic::SourceFrame frame = s.nearest.frameOf(0);
    double worst = 0.0;
    for (Index vertex = 0; vertex < plain.points.size(); ++vertex)
    {
      const Vec3& p = plain.points[vertex];
      if (std::abs(p[2]) < 0.9)
      {
        const double zero = std::atan2(frame.x[1], frame.x[0]);
        const double azimuth =
          (frame.normal[2] > 0.0 ? 1.0 : -1.0) * (std::atan2(p[1], p[0]) - zero);
        const double error = gapOfAngles(s.nearest.angleOf(s.nearest.atVertex(vertex)), azimuth);
        worst = std::max(worst, error);
      }
    }
    EXPECT_LE(worst, 1.0 / n);
    std::cout << n << " facets along an octant, worst angle: " << worst << "\n";
  }
}

// Three cells of one line, the middle one opposite to the others: each has its own length, from its
// own first point, with the bits of feet there.
TEST(SourceAnglesInClosedForm, LengthsOfCurvesThatAreJoinedAreTheirOwn)
{
  const Index n = 12;
  const PlainMesh plain = regularGrid(n, 4);
  const auto row = [](Index from, Index to)
  {
    std::vector<Index> vertices;
    for (Index x = from; x != to; x = from < to ? x + 1 : x - 1)
    {
      vertices.push_back(2 * (n + 1) + x);
    }
    vertices.push_back(2 * (n + 1) + to);
    return vertices;
  };
  const std::vector<std::vector<Index>> rows = { row(1, 4), row(8, 4), row(8, 11) };
  std::vector<Polyline> lines;
  for (const std::vector<Index>& vertices : rows)
  {
    lines.push_back(along(plain, vertices));
  }
  Solved s(plain, lines);
  for (Id curve = 0; curve < 3; ++curve)
  {
    const std::vector<double> lengths = s.nearest.arcLengthsOf(curve);
    ASSERT_EQ(lengths.size(), rows[curve].size());
    for (std::size_t i = 0; i < lengths.size(); ++i)
    {
      EXPECT_EQ(lengths[i], static_cast<double>(i));
      const Foot foot = s.nearest.atVertex(rows[curve][i]);
      if (foot.curve == curve)
      {
        EXPECT_EQ(s.nearest.arcLengthOf(foot), lengths[i]);
      }
      // Straight above the line, on the left of those that run to the right.
      const Foot above = s.nearest.atVertex(rows[curve][i] + n + 1);
      if (above.curve == curve)
      {
        EXPECT_NEAR(s.nearest.arcLengthOf(above), lengths[i], 1e-14);
        EXPECT_NEAR(s.nearest.angleOf(above), curve == 1 ? -0.5 * Pi : 0.5 * Pi, 1e-14);
      }
    }
    EXPECT_NEAR(s.nearest.frameOf(curve).x[0], curve == 1 ? -1.0 : 1.0, 1e-14);
  }
}

TEST(SourceAnglesInClosedForm, AreRefusedWhereTheSolveDidNotKeepThem)
{
  const geodesic::TriangleMesh mesh = engineMesh(regularGrid(2, 2));
  const std::vector<geodesic::SourceCurve> curves = { geodesic::pointCurve(
    SurfacePoint::atVertex(4)) };
  geodesic::FrontOptions options;
  options.keepArrivals = true;
  const geodesic::DistanceField field = geodesic::solve(mesh, curves, options);
  NearestSource nearest(field, geodesic::ReplicatedPatch(mesh), curves);
  EXPECT_EQ(nearest.arcLengthOf(nearest.atVertex(0)), 0.0);
  EXPECT_THROW(nearest.angleOf(nearest.atVertex(0)), geodesic::Error);
}
