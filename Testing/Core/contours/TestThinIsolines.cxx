// SPDX-License-Identifier: BSD-3-Clause
// Isolines on flat strips, whose length is known: no part is missing where faces have hardly any
// height or no area. GEODESIC_TEST_SEEDS=FIRST,COUNT takes other seeds.
#include "contours/IsolineSupport.h"
#include "truth/CappedMeshes.h"

#include "contours/SolveForIsolines.h"
#include "paths/JoinPoints.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <iostream>
#include <utility>
#include <vector>

using namespace geodesictest;
using geodesic::Id;
using geodesic::Isoline;
using geodesic::Isolines;
using geodesic::TriangleMesh;

namespace
{

constexpr std::uint64_t Strips = 400;

/// The largest decimal exponent of the aspect: much thinner faces are without area.
constexpr double Thinnest = 10.0;

/// A triangulated rectangle [0, width] x [0, height].
struct Strip
{
  PlainMesh plain;
  double width;
  double height;

  Strip(double exponent, Random& random)
  {
    const Index nx = random.between(1, 8);
    const Index ny = random.between(1, 6);
    const double flatter = std::pow(10.0, -random.uniform(0.0, exponent));
    this->plain = random.chance(0.5) ? regularGrid(nx, ny) : randomPlanar(nx, ny, random);
    for (Vec3& p : this->plain.points)
    {
      p[1] *= flatter;
    }
    this->width = nx;
    this->height = ny * flatter;
  }

  bool isOnBoundary(const geodesic::Vec3& p) const
  {
    const double slack = 1e-13;
    return p[0] <= slack * this->width || p[0] >= (1.0 - slack) * this->width ||
      p[1] <= slack * this->height || p[1] >= (1.0 - slack) * this->height;
  }
};

/// The true properties of the part of a circle in a rectangle.
struct Arcs
{
  double length = 0.0;
  /// The sum of its ways up and down.
  double rise = 0.0;
  LineCount count;
};

/// The right half of the circle, then the left one, from the lowest point up: so the angles of arcs
/// that hardly rise are accurate.
Arcs arcsIn(const Strip& strip, const Vec3& center, double radius)
{
  const double quarter = 2.0 * std::atan(1.0);
  const double below = center[1];
  const double above = strip.height - center[1];
  const double lowest = below >= radius ? -quarter : -std::asin(below / radius);
  const double highest = above >= radius ? quarter : std::asin(above / radius);
  const bool hasBothHalves = center[0] > 0.0 && center[0] < strip.width;
  Arcs arcs;
  std::size_t ends = 0;
  const auto add = [&](double first, double last)
  {
    if (last > first)
    {
      arcs.length += radius * (last - first);
      arcs.rise += radius * (std::sin(last) - std::sin(first));
      ends += hasBothHalves && first == -quarter ? 0 : 1; // else the other half goes on
      ends += hasBothHalves && last == quarter ? 0 : 1;
    }
  };
  for (const double room : { center[0], strip.width - center[0] })
  {
    const double outside = room < radius ? std::acos(room / radius) : 0.0;
    add(lowest, outside > 0.0 ? std::min(highest, -outside) : highest);
    if (outside > 0.0)
    {
      add(std::max(lowest, outside), highest);
    }
  }
  arcs.count = { ends / 2, ends == 0 && arcs.length > 0.0 ? std::size_t(1) : std::size_t(0) };
  return arcs;
}

/// A vertex, or a point of an edge or a face well away from vertices.
MeshPoint anyPlace(const PlainMesh& mesh, Random& random)
{
  switch (random.below(3))
  {
    case 0:
      return randomVertexPoint(mesh, random);
    case 1:
      return randomEdgePoint(mesh, random);
    default:
      return randomFacePoint(mesh, random);
  }
}

/// The length that lines cover along an axis, back and forth.
double wayAlong(const TriangleMesh& mesh, const Isolines& isolines, std::size_t axis)
{
  double way = 0.0;
  for (const Isoline& line : isolines.lines)
  {
    for (std::size_t i = 1; i < line.points.size(); ++i)
    {
      way += std::abs(geodesic::position(mesh, isolines.points[line.points[i]])[axis] -
        geodesic::position(mesh, isolines.points[line.points[i - 1]])[axis]);
    }
  }
  return way;
}

void expectEndsOnBoundary(const Strip& strip, const TriangleMesh& mesh, const Isolines& isolines)
{
  for (const Isoline& line : isolines.lines)
  {
    for (const Id end : { line.points.front(), line.points.back() })
    {
      EXPECT_TRUE(
        line.isClosed() || strip.isOnBoundary(geodesic::position(mesh, isolines.points[end])));
    }
  }
}

/// Checks isolines round a point against the arcs of its circle.
class ArcChecker
{
public:
  void check(const Strip& strip, const TriangleMesh& mesh, const geodesic::SourceCurve& source,
    double radius)
  {
    constexpr double chordFraction = 1e-6;
    Vec3 center = geodesic::position(mesh, source.points[0]);
    center[1] = std::min(center[1], strip.height); // but for rounding
    const Isolines isolines = isolinesOf(mesh, { source }, { radius }, chordFraction * radius);
    const Arcs truth = arcsIn(strip, center, radius);
    EXPECT_TRUE(countLines(isolines, 0) == truth.count);
    expectEndsOnBoundary(strip, mesh, isolines);
    expectChordsInFaces(mesh, isolines);
    double length = 0.0;
    for (std::size_t i = 0; i < isolines.lines.size(); ++i)
    {
      length += lengthOf(mesh, isolines, i);
    }
    // Where the strip is as thin as rounding, the line may go back and forth along it.
    EXPECT_NEAR(length, truth.length, chordFraction * truth.length + 1e-13 * strip.width);
    const double rise = wayAlong(mesh, isolines, 1);
    EXPECT_NEAR(rise, truth.rise, 1e-4 * truth.rise);
    this->worstRise_ =
      std::max(this->worstRise_, truth.rise > 0.0 ? std::abs(rise / truth.rise - 1.0) : 0.0);
    for (const geodesic::SurfacePoint& point : isolines.points)
    {
      const geodesic::Vec3 p = geodesic::position(mesh, point);
      const double distance = std::hypot(p[0] - center[0], p[1] - center[1]);
      this->worstPoint_ =
        std::max(this->worstPoint_, std::abs(distance - radius) / (radius + strip.width));
    }
    EXPECT_LE(this->worstPoint_, 1e-12);
  }

  void report() const
  {
    std::cout << "worst point " << this->worstPoint_ << " of radius and width, worst rise "
              << this->worstRise_ << "\n";
  }

private:
  double worstPoint_ = 0.0;
  double worstRise_ = 0.0;
};

geodesic::SourceCurve pointOnSurface(const TriangleMesh& mesh, const Vec3& place)
{
  std::vector<geodesic::LocatedPolyline> point(1);
  point[0].points = { place };
  geodesictest::locate(mesh, point);
  return geodesic::putOntoSurface(mesh, point, DBL_EPSILON, geodesic::joinByShortestPaths(mesh))
    .curves[0];
}

}

TEST(ThinIsolines, RoundAPointAreWholeArcsOfItsCircle)
{
  ArcChecker checker;
  for (Random& random : EachSeed(Strips, 83600))
  {
    Strip strip(Thinnest, random);
    strip.plain = withoutFlatFaces(strip.plain).mesh;
    const TriangleMesh mesh = engineMesh(strip.plain);
    const geodesic::SourceCurve source =
      geodesic::pointCurve(enginePoint(mesh, anyPlace(strip.plain, random)));
    const double least = std::max(1e-8 * strip.width, 0.1 * strip.height);
    const double radius = random.chance(0.7)
      ? strip.width * random.uniform(0.05, 0.98)
      : least * std::pow(strip.width / least, random.uniform());
    checker.check(strip, mesh, source, radius);
  }
  checker.report();
}

// Faces without area close vertices on edges of other faces. Sources and lines may go through them.
TEST(IsolinesAcrossFacesWithoutArea, RoundAPointAreWholeArcsOfItsCircle)
{
  ArcChecker checker;
  for (Random& random : EachSeed(Strips, 83700))
  {
    Strip strip(0.0, random);
    const Caps caps = random.chance(0.5) ? Caps::One : Caps::Several;
    const CappedMesh both = withCaps(strip.plain, caps, random.uniform(0.3, 1.0), random);
    strip.plain = withoutFlatFaces(both.mesh).mesh;
    const TriangleMesh mesh = engineMesh(strip.plain);
    const Vec3 place = position(both.conforming, anyPlace(both.conforming, random));
    const double radius = strip.width * random.uniform(0.01, 0.98);
    checker.check(strip, mesh, pointOnSurface(mesh, place), radius);
  }
  checker.report();
}

TEST(ThinIsolines, BesideASideAreStraightFromEndToEnd)
{
  double worstWay = 0.0;
  double worstPoint = 0.0;
  for (Random& random : EachSeed(Strips, 83600))
  {
    const std::size_t axis = random.below(2);
    Strip strip(Thinnest, random);
    strip.plain = withoutFlatFaces(strip.plain).mesh;
    const TriangleMesh mesh = engineMesh(strip.plain);
    const double most = axis == 0 ? strip.width : strip.height;
    std::vector<double> values;
    for (const Index i : { 0U, 1U, 2U })
    {
      values.push_back(most * random.uniform(0.3 * i + 0.01, 0.3 * i + 0.3));
    }
    const double atVertex = mesh.point(random.below(mesh.numberOfVertices()))[axis];
    if (atVertex > 0.0)
    {
      values.push_back(atVertex);
    }
    std::sort(values.begin(), values.end());
    const Isolines isolines = isolinesOf(mesh, { sideOf(mesh, axis) }, values, 1e-6 * most);
    expectEndsOnBoundary(strip, mesh, isolines);
    expectChordsInFaces(mesh, isolines);
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      EXPECT_TRUE(countLines(isolines, i) == (LineCount{ 1, 0 }));
    }
    const double length = axis == 0 ? strip.height : strip.width;
    const double way = wayAlong(mesh, isolines, 1 - axis);
    const double all = static_cast<double>(values.size()) * length;
    EXPECT_NEAR(way, all, 1e-4 * all);
    worstWay = std::max(worstWay, std::abs(way / all - 1.0));
    for (const Isoline& line : isolines.lines)
    {
      for (const Id point : line.points)
      {
        const double at = geodesic::position(mesh, isolines.points[point])[axis];
        worstPoint = std::max(worstPoint, std::abs(at - values[line.value]) / (strip.width + most));
      }
    }
    EXPECT_LE(worstPoint, 1e-12);
  }
  std::cout << "worst point " << worstPoint << " of width and distance, worst way " << worstWay
            << "\n";
}
