// SPDX-License-Identifier: BSD-3-Clause
// Surfaces with faces without area, with which CAD programs close T-vertices, as they are read:
// compared with straight lines in flat convex domains, and with brute force on the same surface
// without these faces. GEODESIC_TEST_SEEDS=FIRST,COUNT takes other seeds.
#include "EngineSupport.h"
#include "paths/PathChecker.h"
#include "refinement/RefinementSupport.h"
#include "truth/AnalyticDistances.h"
#include "truth/BruteForce.h"
#include "truth/CappedMeshes.h"

#include "field/NearestSource.h"
#include "field/SegmentEnvelope.h"
#include "paths/JoinPoints.h"
#include "paths/PathsToSource.h"
#include "source/BoundaryCurves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

using namespace geodesictest;
using geodesic::Id;
using geodesic::SourceCurve;
using geodesic::SurfacePoint;
using geodesic::TriangleMesh;

namespace
{

constexpr double Pi = 3.14159265358979323846;

Vec2 flat(const Vec3& p)
{
  return { p[0], p[1] };
}

Vec2 difference(const Vec2& a, const Vec2& b)
{
  return { a[0] - b[0], a[1] - b[1] };
}

double dot(const Vec2& a, const Vec2& b)
{
  return a[0] * b[0] + a[1] * b[1];
}

enum class Side
{
  Left,
  Right,
  /// Rounding decides.
  Unsure
};

/// A polyline in the plane of a flat surface.
struct FlatLine
{
  std::vector<Vec3> points;
  bool closed = false;

  std::size_t numberOfSegments() const { return this->points.size() - (this->closed ? 0 : 1); }
  Vec2 at(std::size_t i) const { return flat(this->points[i % this->points.size()]); }

  double length() const
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < this->numberOfSegments(); ++i)
    {
      sum += distanceToSegment(this->at(i), this->at(i + 1), this->at(i + 1));
    }
    return sum;
  }

  double distance(const Vec2& p) const
  {
    double least = distanceToSegment(p, this->at(0), this->at(0));
    for (std::size_t i = 0; i < this->numberOfSegments(); ++i)
    {
      least = std::min(least, distanceToSegment(p, this->at(i), this->at(i + 1)));
    }
    return least;
  }

  /// The side of the line that a point is on: the side of the nearest segment or, at the line's
  /// points, by angle. A line of one point has only a left-hand side.
  Side side(const Vec2& p) const
  {
    constexpr double Unsure = 1e-5; // well over what a joined line may lie beside this one
    const double distance = this->distance(p);
    double left = this->numberOfSegments() == 0 ? 0.0 : 2.0 * Pi; // angle to the nearest segment
    double right = 2.0 * Pi;
    std::vector<Vec2> feet;
    for (std::size_t i = 0; i < this->numberOfSegments(); ++i)
    {
      const Vec2 a = this->at(i);
      const Vec2 along = difference(this->at(i + 1), a);
      const double t = std::clamp(dot(difference(p, a), along) / dot(along, along), 0.0, 1.0);
      const Vec2 foot = { a[0] + t * along[0], a[1] + t * along[1] };
      if (distanceToSegment(p, foot, foot) <= distance + 1e-9)
      {
        const Vec2 d = difference(p, foot);
        const double turn = std::atan2(along[0] * d[1] - along[1] * d[0], dot(along, d));
        const double fromAlong = turn < 0.0 ? turn + 2.0 * Pi : turn;
        const double fromBack = std::fmod(fromAlong + Pi, 2.0 * Pi);
        left = std::min(left, t < 1.0 ? fromAlong : 2.0 * Pi - fromBack);
        right = std::min(right, t < 1.0 ? 2.0 * Pi - fromAlong : fromBack);
        feet.push_back(foot);
      }
    }
    const auto isElsewhere = [&feet](const Vec2& foot)
    { return distanceToSegment(foot, feet.front(), feet.front()) > Unsure; };
    const bool isUnsure = distance <= Unsure || std::abs(left - right) <= Unsure ||
      std::any_of(feet.begin(), feet.end(), isElsewhere);
    return isUnsure ? Side::Unsure : left < right ? Side::Left : Side::Right;
  }
};

/// Moves a point that is almost at a corner or on an edge of its face onto it.
MeshPoint notBesideEdges(MeshPoint point)
{
  double sum = 0.0;
  for (double& weight : point.weights)
  {
    weight = weight < 1e-6 ? 0.0 : weight;
    sum += weight;
  }
  for (double& weight : point.weights)
  {
    weight /= sum;
  }
  return point;
}

/// Vertices, points on edges and points in faces with area, joined by straight lines.
///
/// \param mayBeBeside whether some points are within rounding of a vertex or an edge. The engine
/// may
///        join these to the line by a piece in any direction, and so decide the side of points
///        beside the line's ends.
FlatLine randomLine(
  const PlainMesh& mesh, const PlainMesh& conforming, Random& random, bool mayBeBeside = true)
{
  FlatLine line;
  const Index count = random.between(1, 4);
  while (line.points.size() < count)
  {
    const auto ofFace = [&](const MeshPoint& point)
    { return position(conforming, mayBeBeside ? point : notBesideEdges(point)); };
    const Vec3 p = random.chance(0.5) ? mesh.points[random.below(mesh.points.size())]
                                      : ofFace(randomPoint(conforming, random));
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
  geodesic::LocatedPolyline polyline;
  polyline.points.assign(line.points.begin(), line.points.end());
  polyline.closed = line.closed;
  polyline.name = geodesic::PartName("the line");
  return curvesOnto(mesh, { polyline });
}

/// The engine's joins of the line's points. They are as short as the line up to a tie, so they may
/// lie beside it by about the root of that.
FlatLine joined(const TriangleMesh& mesh, const std::vector<SourceCurve>& curves)
{
  FlatLine result;
  for (const SourceCurve& curve : curves)
  {
    for (const SurfacePoint& point : curve.points)
    {
      result.points.push_back(geodesic::position(mesh, point));
    }
  }
  return result;
}

void expectSameLine(const FlatLine& line, const FlatLine& joined, double size)
{
  EXPECT_NEAR(joined.length(), line.length(), OrdinaryAccuracy * size);
  constexpr double rootOfTie = 1e-6;
  for (const Vec3& point : joined.points)
  {
    EXPECT_LE(line.distance(flat(point)), rootOfTie * size);
  }
}

/// \param mayBePockets or caps only.
CappedMesh flatMeshWithCaps(bool mayBePockets, Random& random)
{
  constexpr Caps kinds[] = { Caps::One, Caps::Several, Caps::Any };
  const Caps caps = kinds[random.below(mayBePockets ? 3 : 2)];
  const PlainMesh mesh = randomPlanar(random.between(1, 6), random.between(1, 6), random);
  return withCaps(mesh, caps, random.uniform(0.3, 1.0), random);
}

/// The same after its caps have been removed.
CappedMesh flatMesh(Random& random)
{
  CappedMesh both = flatMeshWithCaps(true, random);
  both.mesh = withoutFlatFaces(both.mesh).mesh;
  return both;
}

double sizeOf(const PlainMesh& mesh)
{
  return spaceDistance(mesh.points.front(), mesh.points[mesh.points.size() / 2]) + 2;
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
  const std::vector<FoundPath> paths = findPaths(engine, curves, targets);
  for (std::size_t i = 0; i < targets.size(); ++i)
  {
    SCOPED_TRACE("path " + std::to_string(i));
    const double distance = line.distance(flat(geodesic::position(engine, targets[i])));
    ASSERT_GE(paths[i].points.size(), 2u);
    const std::vector<PathPoint> plain = checker.plain(paths[i].points);
    EXPECT_NEAR(PathChecker::length(plain), distance, EngineAccuracy * size);
    EXPECT_LE(line.distance(flat(plain.back().place)), EngineAccuracy * size);
    for (std::size_t p = 1; p < plain.size(); ++p)
    {
      EXPECT_FALSE(checker.commonFaces(plain[p - 1], plain[p]).empty()) << "piece " << p;
    }
  }
}

} // anonymous namespace

namespace
{

/// A flat mesh with faces without area, and a line on it.
struct LineOnFlatMesh
{
  explicit LineOnFlatMesh(Random& random)
    : both(flatMesh(random))
    , line(randomLine(both.mesh, both.conforming, random))
    , engine(engineMesh(both.mesh))
    , size(sizeOf(both.mesh))
    , curves(onSurface(engine, line))
    , source(joined(engine, curves))
  {
  }

  CappedMesh both;
  FlatLine line;
  TriangleMesh engine;
  double size;
  std::vector<SourceCurve> curves;
  /// The line's place on the mesh.
  FlatLine source;
};

/// \returns the largest error of a distance, relative to the mesh's size.
double expectStraightDistances(const TriangleMesh& engine, const PlainMesh& mesh,
  const std::vector<SourceCurve>& curves, const FlatLine& line, double size, Random& random)
{
  const geodesic::DistanceField field =
    geodesic::solve(engine, curves, {}, geodesic::KeepWindows::All);
  double worst = 0.0;
  for (Id v = 0; v < engine.numberOfVertices(); ++v)
  {
    const double error = std::abs(field.vertexDistances()[v] - line.distance(flat(mesh.points[v])));
    EXPECT_LE(error, EngineAccuracy * size) << "vertex " << v;
    worst = std::max(worst, error / size);
  }
  for (Index i = 0; i < 30; ++i)
  {
    const SurfacePoint point = enginePoint(engine, randomPoint(mesh, random));
    const double error =
      std::abs(field.distance(point) - line.distance(flat(geodesic::position(engine, point))));
    EXPECT_LE(error, EngineAccuracy * size) << "point " << i;
    worst = std::max(worst, error / size);
  }
  return worst;
}

} // anonymous namespace

// A square of 3 x 3 points with vertex 9 on the edge from 4 to 7. The line's first segment crosses
// the face without area there and has no length.
TEST(FacesWithoutArea, ALineThatBeginsAtAVertexOnAnEdgeCountsOnBothSides)
{
  for (Random& random : EachSeed(100))
  {
    PlainMesh mesh;
    for (int y = 0; y < 3; ++y)
    {
      for (int x = 0; x < 3; ++x)
      {
        mesh.points.push_back({ 0.5 * x, 0.5 * y, 0.0 });
      }
    }
    mesh.points[4][0] += random.uniform(-0.2, 0.2);
    mesh.points[4][1] += random.uniform(-0.2, 0.2);
    const double t = random.uniform(0.1, 0.9);
    const Vec3 a = mesh.points[7];
    const Vec3 b = mesh.points[4];
    mesh.points.push_back({ (1.0 - t) * a[0] + t * b[0], (1.0 - t) * a[1] + t * b[1], 0.0 });
    mesh.triangles = { { 0, 1, 4 }, { 0, 4, 3 }, { 1, 2, 5 }, { 1, 5, 4 }, { 3, 4, 7 }, { 3, 7, 6 },
      { 4, 5, 8 }, { 4, 8, 9 }, { 9, 8, 7 }, { 4, 9, 7 } };
    mesh = withoutFlatFaces(mesh).mesh;
    const TriangleMesh engine = engineMesh(mesh);
    FlatLine line;
    line.points = { mesh.points[9], mesh.points[6] };
    const std::vector<SourceCurve> curves = onSurface(engine, line);
    expectStraightDistances(engine, mesh, curves, line, 1.0, random);
  }
}

TEST(FacesWithoutArea, DistancesAndPathsAcrossThemAreThoseOfThePlane)
{
  double worst = 0.0;
  for (Random& random : EachSeed(400, 5100))
  {
    const LineOnFlatMesh c(random);
    expectSameLine(c.line, c.source, c.size);
    worst = std::max(
      worst, expectStraightDistances(c.engine, c.both.mesh, c.curves, c.source, c.size, random));
    expectStraightPaths(c.engine, c.both.mesh, c.curves, c.source, c.size, random);
  }
  std::cout << "worst relative error " << worst << "\n";
}

namespace
{

/// Counts the points that get the wrong side of a line.
class SidesChecker
{
public:
  /// \param line on the mesh, which lies in the plane.
  void check(const PlainMesh& mesh, const FlatLine& line, Random& random)
  {
    const TriangleMesh engine = engineMesh(mesh);
    const std::vector<SourceCurve> curves = onSurface(engine, line);
    geodesic::FrontOptions options;
    options.keepArrivals = true;
    const geodesic::DistanceField field =
      geodesic::solve(engine, curves, options, geodesic::KeepWindows::All);
    geodesic::NearestSource nearest(field, geodesic::ReplicatedPatch(engine), curves);
    for (Id v = 0; v < engine.numberOfVertices(); ++v)
    {
      SCOPED_TRACE("vertex " + std::to_string(v));
      this->compare(line, flat(mesh.points[v]), nearest.atVertex(v));
    }
    for (Index i = 0; i < 30; ++i)
    {
      SCOPED_TRACE("point " + std::to_string(i));
      const SurfacePoint point = enginePoint(engine, randomPoint(mesh, random));
      this->compare(line, flat(geodesic::position(engine, point)),
        nearest.of(geodesic::incomingSegmentTo(field, point)));
    }
  }

  void report() const
  {
    std::cout << this->wrong_ << " of " << this->checked_ << " sides are wrong\n";
  }

private:
  void compare(const FlatLine& line, const Vec2& place, const geodesic::Foot& foot)
  {
    const Side side = line.side(place);
    if (side != Side::Unsure)
    {
      const bool isRight = side == Side::Right;
      EXPECT_TRUE(foot.isKnown());
      EXPECT_EQ(foot.isRight, isRight) << place[0] << ", " << place[1];
      ++this->checked_;
      this->wrong_ += !foot.isKnown() || foot.isRight != isRight;
    }
  }

  std::size_t checked_ = 0;
  std::size_t wrong_ = 0;
};

/// \param hasCaps or the mesh is cut at its T-vertices instead.
void compareSidesWithPlane(bool hasCaps)
{
  SidesChecker checker;
  for (Random& random : EachSeed(300, 5100))
  {
    const CappedMesh both = flatMesh(random);
    const PlainMesh& mesh = hasCaps ? both.mesh : both.conforming;
    checker.check(mesh, randomLine(mesh, both.conforming, random, false), random);
  }
  checker.report();
}

} // anonymous namespace

TEST(FacesWithoutArea, SidesOfALineAcrossThemAreThoseOfThePlane)
{
  compareSidesWithPlane(true);
}

TEST(FacesWithoutArea, SidesOfALineOnThatSurfaceWithoutThemAreThoseOfThePlane)
{
  compareSidesWithPlane(false);
}

namespace
{

/// Compares the envelope along part of a face's edge, or from a point of the face to a corner, with
/// the plane. \returns the largest error.
double errorAlongSegment(
  const geodesic::FaceDistance& face, const PlainMesh& mesh, const FlatLine& source, Random& random)
{
  const Index k = random.below(3);
  std::array<Barycentric, 2> ends = { geodesic::cornerWeights(k), randomWeights(random) };
  if (random.chance(0.7))
  {
    for (Barycentric& end : ends)
    {
      const double t = std::round(8.0 * random.uniform()) / 8.0;
      end = { 0.0, 0.0, 0.0 };
      end[k] = 1.0 - t;
      end[(k + 1) % 3] += t;
    }
  }
  const geodesic::Vec2 p = face.inPlane(ends[0]);
  const geodesic::Vec2 q = face.inPlane(ends[1]);
  geodesic::SegmentEnvelope envelope;
  double worst = 0.0;
  for (const geodesic::Window& w : envelope.along(face, p, q))
  {
    for (const double x : { w.begin, 0.5 * (w.begin + w.end), w.end })
    {
      const double t = x / norm(q - p);
      Barycentric place;
      for (std::size_t i = 0; i < 3; ++i)
      {
        place[i] = ends[0][i] + t * (ends[1][i] - ends[0][i]);
      }
      const double truth = source.distance(flat(position(mesh, MeshPoint{ face.face(), place })));
      worst = std::max({ worst, std::abs(w.distance(x) - truth),
        std::abs(face.distance(p + t * (q - p)) - truth) });
    }
  }
  return worst;
}

} // anonymous namespace

// A source on one edge of a face without area lies on the line of its other edges, too: its windows
// there run to both sides along their halfedge.
TEST(FacesWithoutArea, SegmentsAndRefinedMeshesHaveTheDistancesOfThePlane)
{
  constexpr double accuracy = 1e-6; // the root of a tie: the line may be beside its points
  double worstOfSegments = 0.0;
  double worstOfBounds = 0.0;
  for (Random& random : EachSeed(250, 31600))
  {
    const LineOnFlatMesh c(random);
    const geodesic::DistanceField field = solveKeepingAll(c.engine, c.curves);
    for (int i = 0; i < 40; ++i)
    {
      const geodesic::FaceDistance face(field, random.below(c.engine.numberOfFaces()));
      const double error = errorAlongSegment(face, c.both.mesh, c.source, random) / c.size;
      EXPECT_LE(error, accuracy) << "face " << face.face();
      worstOfSegments = std::max(worstOfSegments, error);
    }
    const geodesic::RefinedMesh refined = refineTo(field, 0.01 * c.size);
    EXPECT_LE(refined.errorBound, 0.01 * c.size);
    const Samples samples = sample(field, refined, 300, random);
    for (std::size_t i = 0; i < samples.places.size(); ++i)
    {
      const Vec2 place = flat(position(c.both.mesh, samples.places[i]));
      const double error = std::abs(samples.interpolant[i] - c.source.distance(place));
      EXPECT_LE(error, refined.errorBound + EngineAccuracy * c.size) << "sample " << i;
      worstOfBounds = std::max(worstOfBounds, error / refined.errorBound);
    }
  }
  std::cout << "worst relative error along segments " << worstOfSegments << ", of the bound "
            << worstOfBounds << "\n";
}

// Vertices leave the plane by more and more roundings: caps get an area, up to shapes that are
// thin, but no longer degenerate.
TEST(FacesWithHardlyAnyArea, AreRefinedWithFewFaces)
{
  std::size_t most = 0;
  for (Random& random : EachSeed(50, 31600))
  {
    const PlainMesh flat = flatMeshWithCaps(false, random).mesh;
    const double size = sizeOf(flat);
    for (const double bend : { 1e-16, 1e-15, 1e-14, 1e-12, 1e-9, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2 })
    {
      SCOPED_TRACE("bent by " + std::to_string(bend));
      PlainMesh bent = flat;
      for (Vec3& point : bent.points)
      {
        point[2] += bend * size * random.uniform(-1.0, 1.0);
      }
      const TriangleMesh engine = cleanedEngineMesh(bent);
      const Id source = static_cast<Id>(random.below(engine.numberOfVertices()));
      const geodesic::DistanceField field =
        solveKeepingAll(engine, { geodesic::pointCurve(SurfacePoint::atVertex(source)) });
      const geodesic::RefinedMesh refined = refineTo(field, 0.01 * size, 20000);
      EXPECT_FALSE(refined.stoppedAtMaximum);
      most = std::max(most, refined.triangles.size() / engine.numberOfFaces());
    }
  }
  std::cout << "at most " << most << " times the faces\n";
}

namespace
{

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
// without length once went in circles.
TEST(FacesWithoutArea, APathAcrossAPocketEnds)
{
  for (const auto& [s, t] : { std::pair(0.3, 0.7), std::pair(0.7, 0.3), std::pair(0.5, 0.1) })
  {
    PlainMesh mesh;
    mesh.points = { { 0.0, 0.0, 0.0 }, { -0.666, 0.746, 0.0 }, { -1.079, -0.293, 0.0 },
      { 0.413, 1.039, 0.0 }, { -0.666 * s, 0.746 * s, 0.0 }, { -0.666 * t, 0.746 * t, 0.0 } };
    mesh.triangles = { { 0, 1, 2 }, { 1, 0, 3 }, { 0, 4, 1 }, { 5, 1, 4 }, { 0, 1, 5 } };
    const TriangleMesh engine = cleanedEngineMesh(mesh);
    for (Index a = 0; a < 6; ++a)
    {
      for (Index b = 0; b < 6; ++b)
      {
        const std::vector<SurfacePoint> path = geodesic::joinByShortestPaths(engine)(
          SurfacePoint::atVertex(a), SurfacePoint::atVertex(b), {});
        EXPECT_NEAR(lengthOf(engine, path), spaceDistance(mesh.points[a], mesh.points[b]), 1e-12)
          << "from " << a << " to " << b;
      }
    }
  }
}

// A face without area that conducts has a height that it does not have in space, so that a point in
// it is farther from its corners than in space.
TEST(FacesWithoutArea, APathFromTheInsideOfOneIsFound)
{
  PlainMesh mesh;
  mesh.points = { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.5, 0.0, 0.0 }, { 0.5, 0.3, 0.0 },
    { 0.8, 0.3, 0.0 } };
  mesh.triangles = { { 0, 1, 2 }, { 2, 4, 3 } };
  const TriangleMesh engine = engineMesh(mesh);
  for (const double atApex : { 0.0, 0.3, 0.78, 0.99 })
  {
    const double rest = 0.5 * (1.0 - atApex);
    const std::vector<SurfacePoint> path = geodesic::joinByShortestPaths(engine)(
      geodesic::fromBarycentric(engine, 0, { rest, rest, atApex }), SurfacePoint::atVertex(3), {});
    ASSERT_GE(path.size(), 3U) << atApex;
    EXPECT_NEAR(lengthOf(engine, path), 0.3, 1e-12) << atApex;
  }
}

// The height of such a face lengthens paths over its longest edge to the corner there.
TEST(FacesWithoutArea, PathsToTheCornerOfOneThatConductsAreAsLongAsInSpace)
{
  for (const double at : { 0.5, 0.1, 1e-3, 1e-6, 1e-9 })
  {
    PlainMesh mesh;
    mesh.points = { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { at, 0.0, 0.0 }, { 0.4, -0.3, 0.0 } };
    mesh.triangles = { { 0, 1, 2 }, { 1, 0, 3 } };
    ASSERT_EQ(facesWithoutArea(mesh), 1U);
    const TriangleMesh engine = engineMesh(mesh);
    const auto from = [&](Index corner)
    {
      Sources source;
      source.points = { MeshPoint{ corner < 3 ? 0U : 1U, { 0.0, 0.0, 1.0 } } };
      return solveKeepingAll(engine, engineCurves(engine, source)).vertexDistances();
    };
    const double length = spaceDistance(mesh.points[2], mesh.points[3]);
    EXPECT_NEAR(from(2)[3], length, OrdinaryAccuracy * length) << at;
    EXPECT_NEAR(from(3)[2], length, OrdinaryAccuracy * length) << at;
  }
}
