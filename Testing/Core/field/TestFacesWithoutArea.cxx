// SPDX-License-Identifier: BSD-3-Clause
// Surfaces with faces without area, as CAD programs close vertices on edges of other faces: against
// straight lines in flat convex domains, and against the brute force on the same surface without
// these faces. GEODESIC_TEST_SEEDS=N takes N meshes of each kind in place of the usual number.
#include "EngineSupport.h"
#include "field/PathChecker.h"
#include "truth/AnalyticDistances.h"
#include "truth/CappedMeshes.h"

#include "field/NearestSource.h"
#include "field/PathsToSource.h"
#include "field/ShortestPathFinder.h"
#include "source/PolylineLocator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

using namespace geodesictest;
using geodesic::Id;
using geodesic::SourceCurve;
using geodesic::SurfacePoint;
using geodesic::TriangleMesh;

namespace
{

std::uint64_t numberOfSeeds(std::uint64_t usual)
{
  const char* wanted = std::getenv("GEODESIC_TEST_SEEDS");
  return wanted != nullptr ? std::strtoull(wanted, nullptr, 10) : usual;
}

constexpr double FlatAccuracy = 1e-10;

Vec2 flat(const Vec3& p)
{
  return { p[0], p[1] };
}

/// A polyline in the plane that its surface lies in.
struct FlatLine
{
  std::vector<Vec3> points;
  bool closed = false;

  std::size_t numberOfSegments() const { return this->points.size() - (this->closed ? 0 : 1); }
  Vec2 at(std::size_t i) const { return flat(this->points[i % this->points.size()]); }

  double distance(const Vec2& p) const
  {
    double least = distanceToSegment(p, this->at(0), this->at(0));
    for (std::size_t i = 0; i < this->numberOfSegments(); ++i)
    {
      least = std::min(least, distanceToSegment(p, this->at(i), this->at(i + 1)));
    }
    return least;
  }

  /// Positive on the left of all segments that are nearest to a point, negative on their right; 0
  /// where that is not the same for all, or not clear.
  double side(const Vec2& p) const
  {
    const double nearest = this->distance(p);
    double side = 0.0;
    for (std::size_t i = 0; i < this->numberOfSegments(); ++i)
    {
      const Vec2 a = this->at(i);
      const Vec2 b = this->at(i + 1);
      if (distanceToSegment(p, a, b) <= nearest + 1e-6)
      {
        const double height = ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])) /
          std::hypot(b[0] - a[0], b[1] - a[1]);
        if (std::abs(height) < 1e-6 || height * side < 0.0)
        {
          return 0.0;
        }
        side = height;
      }
    }
    return side;
  }
};

/// Vertices, points on edges and points in faces with area, joined by straight lines.
FlatLine randomLine(const PlainMesh& mesh, const PlainMesh& conforming, Random& random)
{
  FlatLine line;
  const Index count = random.between(1, 4);
  while (line.points.size() < count)
  {
    const Vec3 p = random.chance(0.5) ? mesh.points[random.below(mesh.points.size())]
                                      : position(conforming, randomPoint(conforming, random));
    const auto isFar = [&p](const Vec3& q) { return spaceDistance(p, q) > 1e-3; };
    if (std::all_of(line.points.begin(), line.points.end(), isFar))
    {
      line.points.push_back(p);
    }
  }
  line.closed = count > 2 && random.chance(0.3);
  return line;
}

std::vector<SourceCurve> onSurface(const TriangleMesh& mesh, const FlatLine& line)
{
  std::vector<geodesic::LocatedPolyline> polylines(1);
  polylines[0].points.assign(line.points.begin(), line.points.end());
  polylines[0].closed = line.closed;
  polylines[0].name = "the line";
  geodesic::SnapOptions options;
  geodesic::PolylineLocator(mesh).locate(polylines, options.coordinatePrecision);
  return geodesic::putOntoSurface(mesh, polylines, options, geodesic::joinByShortestPaths(mesh))
    .curves;
}

CappedMesh flatMesh(Random& random)
{
  const PlainMesh mesh = randomPlanar(random.between(1, 6), random.between(1, 6), random);
  return withCaps(mesh, getenv("SEV")?Caps::Several:Caps::One, random.uniform(0.3, 1.0), random);
}

void expectStraightPaths(const TriangleMesh& engine, const PlainMesh& mesh,
  const std::vector<SourceCurve>& curves, const FlatLine& line, double size, Random& random)
{
  const PathChecker checker(mesh);
  std::vector<SurfacePoint> targets;
  for (Index i = 0; i < 12; ++i)
  {
    targets.push_back(enginePoint(engine, randomPoint(mesh, random)));
  }
  const std::vector<geodesic::PathToSource> paths =
    geodesic::pathsToSource(engine, curves, targets);
  for (std::size_t i = 0; i < targets.size(); ++i)
  {
    SCOPED_TRACE("path " + std::to_string(i));
    const double distance = line.distance(flat(geodesic::position(engine, targets[i])));
    ASSERT_GE(paths[i].points.size(), 2u);
    const std::vector<PathPoint> plain = checker.plain(paths[i].points);
    EXPECT_NEAR(PathChecker::length(plain), distance, FlatAccuracy * size);
    EXPECT_LE(line.distance(flat(plain.back().place)), FlatAccuracy * size);
    for (std::size_t p = 1; p < plain.size(); ++p)
    {
      EXPECT_FALSE(checker.commonFaces(plain[p - 1], plain[p]).empty()) << "piece " << p;
    }
  }
}

} // anonymous namespace

TEST(FacesWithoutArea, DistancesPathsAndSidesInAConvexDomainAreThoseOfThePlane)
{
  double worst = 0.0;
  std::size_t sides = 0;
  for (std::uint64_t seed = 0; seed < numberOfSeeds(300); ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed + 5100);
    const CappedMesh both = flatMesh(random);
    const PlainMesh& mesh = both.mesh;
    const FlatLine line = randomLine(mesh, both.conforming, random);
    const TriangleMesh engine = engineMesh(mesh);
    const double size = spaceDistance(mesh.points.front(), mesh.points[mesh.points.size() / 2]) + 2;
    try
    {
      const std::vector<SourceCurve> curves = onSurface(engine, line);
      geodesic::FrontOptions options;
      options.keepArrivals = true;
      const geodesic::DistanceField field =
        geodesic::solve(engine, curves, options, geodesic::KeepWindows::All);
      geodesic::NearestSource nearest(field, curves);
      const auto expectSide = [&](const Vec2& p, const geodesic::Foot& foot)
      {
        const double side = line.points.size() > 1 ? line.side(p) : 0.0;
        if (side != 0.0 && line.distance(p) > 1e-6)
        {
          ++sides;
          EXPECT_EQ(foot.isRight, side < 0.0) << "at " << p[0] << ", " << p[1];
        }
      };
      for (Id v = 0; v < engine.numberOfVertices(); ++v)
      {
        if (engine.cornersAt(v).size() == 0)
          continue;
        const Vec2 p = flat(mesh.points[v]);
        const double error = std::abs(field.vertexDistances()[v] - line.distance(p)) / size;
        EXPECT_LE(error, FlatAccuracy) << "vertex " << v;
        worst = std::max(worst, error);
        expectSide(p, nearest.atVertex(v));
      }
      for (Index i = 0; i < 30; ++i)
      {
        const SurfacePoint point = enginePoint(engine, randomPoint(mesh, random));
        const Vec2 p = flat(geodesic::position(engine, point));
        const double error = std::abs(field.distance(point) - line.distance(p)) / size;
        EXPECT_LE(error, FlatAccuracy) << "point " << i;
        worst = std::max(worst, error);
        expectSide(p, nearest.of(geodesic::lastPieceTo(field, point)));
      }
      expectStraightPaths(engine, mesh, curves, line, size, random);
    }
    catch (const std::exception& e)
    {
      ADD_FAILURE() << e.what();
    }
  }
  std::cout << "worst relative error " << worst << ", " << sides << " sides\n";
}

namespace
{

/// Aborts what has taken longer than it may: a run without an end is a failure, not a hang.
class TimeLimit
{
public:
  explicit TimeLimit(double seconds)
    : end_(std::chrono::steady_clock::now() +
        std::chrono::duration_cast<std::chrono::steady_clock::duration>(
          std::chrono::duration<double>(seconds)))
  {
  }

  geodesic::ProgressCallback callback() const
  {
    return [end = this->end_](double) { return std::chrono::steady_clock::now() < end; };
  }

private:
  std::chrono::steady_clock::time_point end_;
};

constexpr double SecondsForPockets = 20.0;

double lengthOf(const TriangleMesh& mesh, const std::vector<SurfacePoint>& path)
{
  double length = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i)
  {
    length +=
      spaceDistance(geodesic::position(mesh, path[i]), geodesic::position(mesh, path[i - 1]));
  }
  return length;
}

} // anonymous namespace

// Three faces without area make a pocket on the edge from 0 to 1, around which pieces of a path
// without length once led for ever.
TEST(FacesWithoutArea, APathAcrossAPocketEnds)
{
  for (const auto& [s, t] : { std::pair(0.3, 0.7), std::pair(0.7, 0.3), std::pair(0.5, 0.1) })
  {
    PlainMesh mesh;
    mesh.points = { { 0.0, 0.0, 0.0 }, { -0.666, 0.746, 0.0 }, { -1.079, -0.293, 0.0 },
      { 0.413, 1.039, 0.0 }, { -0.666 * s, 0.746 * s, 0.0 }, { -0.666 * t, 0.746 * t, 0.0 } };
    mesh.triangles = { { 0, 1, 2 }, { 1, 0, 3 }, { 0, 4, 1 }, { 5, 1, 4 }, { 0, 1, 5 } };
    const TriangleMesh engine = engineMesh(mesh);
    for (Index a = 0; a < 6; ++a)
    {
      for (Index b = 0; b < 6; ++b)
      {
        const TimeLimit limit(SecondsForPockets);
        const std::vector<SurfacePoint> path = geodesic::ShortestPathFinder(engine).between(
          SurfacePoint::atVertex(a), SurfacePoint::atVertex(b), limit.callback());
        EXPECT_NEAR(lengthOf(engine, path), spaceDistance(mesh.points[a], mesh.points[b]), 1e-12)
          << "from " << a << " to " << b;
      }
    }
  }
}

TEST(FacesWithoutArea, PocketsChangeNoDistanceAndPathsAcrossThemEnd)
{
  double worst = 0.0;
  for (std::uint64_t seed = 0; seed < numberOfSeeds(200); ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed + 8800);
    const PlainMesh plain = bumpySheet(
      random.between(1, 4), random.between(1, 4), 0, random.chance(0.5) ? 0.0 : 0.5, random);
    const PlainMesh mesh = withPockets(plain, random.between(1, 6), random);
    const TriangleMesh engine = engineMesh(mesh);
    const Index source = random.below(plain.points.size());
    Sources truthSource;
    truthSource.points = { vertexPoint(plain, source) };
    const BruteForceResult truth = bruteForceDistances(plain, truthSource);
    const double largest = largestFinite(truth.vertices);
    const TimeLimit limit(SecondsForPockets);
    std::vector<SurfacePoint> targets;
    for (Id v = 0; v < engine.numberOfVertices(); ++v)
    {
      targets.push_back(SurfacePoint::atVertex(v));
    }
    geodesic::PathsOptions options;
    options.progress = limit.callback();
    try
    {
      const std::vector<geodesic::PathToSource> paths = geodesic::pathsToSource(
        engine, { geodesic::pointCurve(SurfacePoint::atVertex(source)) }, targets, options);
      for (std::size_t v = 0; v < plain.points.size(); ++v)
      {
        const double error =
          std::abs(lengthOf(engine, paths[v].points) - truth.vertices[v]) / largest;
        EXPECT_LE(error, EngineAccuracy) << "vertex " << v;
        worst = std::max(worst, error);
      }
      const Id other = random.below(engine.numberOfVertices());
      geodesic::ShortestPathFinder(engine).between(
        SurfacePoint::atVertex(source), SurfacePoint::atVertex(other), limit.callback());
    }
    catch (const std::exception& e)
    {
      ADD_FAILURE() << e.what();
    }
  }
  std::cout << "worst relative error " << worst << "\n";
}
