// SPDX-License-Identifier: BSD-3-Clause
// Sources that are points beside an edge or a vertex, as from a click on it: the angles of paths,
// which source is the nearest, and its place.
#include "RanksSupport.h"
#include "Seeds.h"
#include "truth/AnalyticDistances.h"

#include "Tolerance.h"
#include "field/NearestSource.h"
#include "paths/PathsToSource.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <mutex>
#include <optional>

using namespace geodesictest;
using geodesic::Foot;
using geodesic::Id;
using geodesic::NearestSource;
using geodesic::SurfacePoint;
namespace tolerance = geodesic::tolerance;

namespace
{

constexpr double Pi = 3.14159265358979323846;

/// As fractions of a face: from less than the rounding of the point on.
const double Fractions[] = { 1e-17, 1e-16, 3e-16, 1e-15, 2e-15, 5e-15, 1e-14, 1e-13, 1e-12, 1e-11,
  1e-10, 1e-9, 1e-8, 1e-7, 1e-6 };

/// In radians, of paths longer than ShortPath: the rounding of places and of unfolding.
constexpr double Accuracy = 1e-11;
constexpr double ShortPath = 1e-2;

/// Of a path as it is traced: its last piece has rounded ends, and may be as short as a fraction
/// NearEdge of its face.
constexpr double AccuracyOfEnds = 4.0 * tolerance::PlaceRounding / tolerance::NearEdge;

double gapOfAngles(double a, double b)
{
  return std::abs(std::remainder(a - b, 2.0 * Pi));
}

Vec3 minus(const Vec3& a, const Vec3& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

double angleIn(const geodesic::SourceFrame& frame, const Vec3& v)
{
  return std::atan2(geodesic::dot(v, frame.y), geodesic::dot(v, frame.x));
}

std::vector<Polyline> polylinesAt(const std::vector<MeshPoint>& points)
{
  std::vector<Polyline> polylines;
  for (const MeshPoint& point : points)
  {
    polylines.push_back({ { { point.face, point.weights, point.weights } }, {} });
  }
  return polylines;
}

/// Each point as a source of its own, by its number.
std::vector<geodesic::SourceCurve> curvesAt(
  const geodesic::TriangleMesh& mesh, const std::vector<MeshPoint>& points)
{
  std::vector<geodesic::SourceCurve> curves = engineCurves(mesh, polylinesAt(points));
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    curves[i].source = static_cast<Id>(i);
  }
  return curves;
}

/// A field around points, and its feet.
struct Solved
{
  geodesic::TriangleMesh mesh;
  std::vector<geodesic::SourceCurve> curves;
  geodesic::DistanceField field;
  NearestSource nearest;

  static geodesic::FrontOptions withAngles()
  {
    geodesic::FrontOptions options;
    options.keepArrivals = true;
    options.keepAngles = true;
    return options;
  }

  Solved(const PlainMesh& plain, const std::vector<MeshPoint>& points)
    : mesh(engineMesh(plain))
    , curves(curvesAt(mesh, points))
    , field(geodesic::solve(mesh, curves, withAngles(), geodesic::KeepWindows::All))
    , nearest(field, geodesic::ReplicatedPatch(mesh), curves)
  {
  }

  Foot footOf(const MeshPoint& point)
  {
    const SurfacePoint p = geodesic::normalized(mesh, enginePoint(mesh, point));
    return p.kind == SurfacePoint::Kind::Vertex ? nearest.atVertex(p.id)
                                                : nearest.of(geodesic::incomingSegmentTo(field, p));
  }

  /// Of the paths of some targets.
  std::vector<geodesic::PathEnd> endsOf(const std::vector<SurfacePoint>& targets) const
  {
    std::vector<geodesic::PathEnd> ends(targets.size());
    geodesic::pathsToSource(geodesic::MeshPartition(mesh), geodesic::ReplicatedPatch(mesh), curves,
      targets, {},
      [&](std::size_t target, const geodesic::PathToSource& path) { ends[target] = path.end; });
    return ends;
  }
};

/// The worst angles of a test.
struct Worst
{
  double straight = 0.0;
  /// Of paths that bend at a vertex and are as long up to a tie.
  double bent = 0.0;
  std::size_t count = 0;
  std::size_t countBent = 0;

  void print(double fraction) const
  {
    std::cout << "beside it " << fraction << ": " << this->count << " paths, worst angle "
              << this->straight << "; " << this->countBent << " bent ones, worst angle "
              << this->bent << "\n";
  }
};

double sizeOf(const PlainMesh& mesh)
{
  double size = 0.0;
  for (const Vec3& point : mesh.points)
  {
    size = std::max(size, geodesic::norm(minus(point, mesh.points[0])));
  }
  return size;
}

/// The point of a segment, or of a point given twice, that is the nearest.
Vec3 nearestOn(const Vec3& a, const Vec3& b, const Vec3& point)
{
  const Vec3 along = minus(b, a);
  const double square = geodesic::dot(along, along);
  const double t = square > 0.0 ? geodesic::dot(minus(point, a), along) / square : 0.0;
  return t < 1.0 ? minus(a, geodesic::operator*(-std::max(t, 0.0), along)) : b;
}

/// The least error of an angle, as that of a path from the source, a segment from a to b, which
/// bends at a vertex and is as long as the straight one up to two ties: one on the way, one where
/// ways through the last face are compared. Its direction carries the rounding of both its places,
/// as seen from one to the other.
double leastErrorOfBent(const PlainMesh& mesh, const Vec3& a, const Vec3& b, const Vec3& query,
  const geodesic::SourceFrame& frame, double angle)
{
  double least = Pi;
  const double straight = geodesic::norm(minus(query, nearestOn(a, b, query)));
  const double size = straight + sizeOf(mesh);
  for (const Vec3& vertex : mesh.points)
  {
    const Vec3 way = minus(vertex, nearestOn(a, b, vertex));
    const double toVertex = geodesic::norm(way);
    if (toVertex + geodesic::norm(minus(query, vertex)) <= straight + 2.0 * tolerance::Tie * size)
    {
      const double rounding = 2.0 * tolerance::Rounding * size / toVertex;
      const double error = gapOfAngles(angle, angleIn(frame, way)) - rounding;
      least = std::min(least, std::max(error, 0.0));
    }
  }
  return least;
}

/// Compares answers in the plane with straight lines.
class InThePlane
{
public:
  InThePlane(const PlainMesh& plain, const std::vector<MeshPoint>& sources, Worst& worst)
    : plain_(plain)
    , solved_(plain, sources)
    , worst_(worst)
  {
    for (const MeshPoint& source : sources)
    {
      this->sources_.push_back(position(plain, source));
      this->isAtVertex_.push_back(*std::max_element(source.weights.begin(), source.weights.end()) >
        1.0 - 2.0 * tolerance::Rounding);
    }
    for (const Vec3& point : plain.points)
    {
      this->largest_ = std::max(this->largest_, geodesic::largestCoordinate(point));
    }
  }

  /// Left out are queries near the source, and those that two sources are equally near to.
  void compare(const std::vector<MeshPoint>& queries)
  {
    std::vector<MeshPoint> compared;
    std::vector<SurfacePoint> targets;
    for (const MeshPoint& query : queries)
    {
      if (this->nearestTo(query) != geodesic::NoId)
      {
        compared.push_back(query);
        targets.push_back(
          geodesic::normalized(this->solved_.mesh, enginePoint(this->solved_.mesh, query)));
      }
    }
    const std::vector<geodesic::PathEnd> ends = this->solved_.endsOf(targets);
    for (std::size_t i = 0; i < compared.size(); ++i)
    {
      SCOPED_TRACE("query " + std::to_string(i));
      this->compareFoot(compared[i]);
      const Id nearest = this->nearestTo(compared[i]);
      EXPECT_EQ(ends[i].source, nearest);
      if (!this->isAtVertex_[nearest])
      {
        this->compareAngle(ends[i].angle, AccuracyOfEnds, nearest, compared[i]);
      }
    }
  }

private:
  Vec3 straightTo(const MeshPoint& query, Id source) const
  {
    return minus(position(this->plain_, query), this->sources_[source]);
  }

  // NoId for what is left out.
  Id nearestTo(const MeshPoint& query) const
  {
    std::vector<double> distances;
    for (Id source = 0; source < this->sources_.size(); ++source)
    {
      distances.push_back(geodesic::norm(this->straightTo(query, source)));
    }
    const auto nearest =
      static_cast<Id>(std::min_element(distances.begin(), distances.end()) - distances.begin());
    const bool isTie = distances.size() == 2 && std::abs(distances[0] - distances[1]) < 1e-9;
    return isTie || distances[nearest] < ShortPath ? geodesic::NoId : nearest;
  }

  void compareFoot(const MeshPoint& query)
  {
    const Id nearest = this->nearestTo(query);
    const Foot foot = this->solved_.footOf(query);
    EXPECT_EQ(foot.curve, nearest);
    EXPECT_FALSE(foot.isRight);
    EXPECT_EQ(this->solved_.nearest.arcLengthOf(foot), 0.0);
    const Vec3 closest =
      geodesic::position(this->solved_.mesh, this->solved_.nearest.pointOf(foot));
    EXPECT_LE(geodesic::norm(minus(closest, this->sources_[nearest])),
      2.0 * tolerance::PositionRoundings * tolerance::Rounding * this->largest_);
    this->compareAngle(this->solved_.nearest.angleOf(foot), Accuracy, nearest, query);
  }

  // The path leaves straight to the query, or to a vertex at which it bends.
  void compareAngle(double angle, double accuracy, Id nearest, const MeshPoint& query)
  {
    const geodesic::SourceFrame frame = this->solved_.nearest.frameOf(nearest);
    const double error = gapOfAngles(angle, angleIn(frame, this->straightTo(query, nearest)));
    ++this->worst_.count;
    if (error <= accuracy)
    {
      this->worst_.straight = std::max(this->worst_.straight, error);
      return;
    }
    const Vec3& source = this->sources_[nearest];
    const double least = std::min(error,
      leastErrorOfBent(this->plain_, source, source, position(this->plain_, query), frame, angle));
    EXPECT_LE(least, accuracy) << "off by " << error;
    ++this->worst_.countBent;
    this->worst_.bent = std::max(this->worst_.bent, error);
  }

  const PlainMesh& plain_;
  Solved solved_;
  std::vector<Vec3> sources_;
  /// Up to the rounding of its place, so that paths may end at the vertex.
  std::vector<bool> isAtVertex_;
  double largest_ = 0.0;
  Worst& worst_;
};

/// A point at this fraction of a face from one of its edges, not near a vertex.
MeshPoint besideEdge(const PlainMesh& mesh, double fraction, Random& random)
{
  MeshPoint p = { random.below(mesh.triangles.size()), {} };
  const Index k = random.below(3);
  const double along = random.uniform(0.1, 0.9);
  p.weights[k] = fraction;
  p.weights[(k + 1) % 3] = along * (1.0 - fraction);
  p.weights[(k + 2) % 3] = 1.0 - p.weights[k] - p.weights[(k + 1) % 3];
  return p;
}

std::vector<MeshPoint> verticesAndOthers(const PlainMesh& mesh, std::size_t others, Random& random)
{
  std::vector<MeshPoint> points;
  for (Index vertex = 0; vertex < mesh.points.size(); ++vertex)
  {
    points.push_back(vertexPoint(mesh, vertex));
  }
  for (std::size_t i = 0; i < others; ++i)
  {
    points.push_back(randomFacePoint(mesh, random));
    points.push_back(randomEdgePoint(mesh, random));
  }
  return points;
}

/// A point at this fraction of a face from one of its corners, sometimes on an edge.
MeshPoint besideVertex(const PlainMesh& mesh, double fraction, Random& random)
{
  MeshPoint p = { random.below(mesh.triangles.size()), {} };
  const Index k = random.below(3);
  const double along = random.chance(0.2) ? 0.0 : random.uniform(0.0, 1.0);
  p.weights[(k + 1) % 3] = along * fraction;
  p.weights[(k + 2) % 3] = (1.0 - along) * fraction;
  p.weights[k] = 1.0 - p.weights[(k + 1) % 3] - p.weights[(k + 2) % 3];
  return p;
}

using MakeSource = MeshPoint (*)(const PlainMesh&, double, Random&);
using MakeMesh = PlainMesh (*)(Random&);

/// Points beside inner edges and beside the boundary.
void compareOnRandom(MakeMesh make, std::uint64_t meshes, MakeSource source = besideEdge)
{
  const Seeds seeds = seedsOfTest(meshes);
  for (const double fraction : Fractions)
  {
    Worst worst;
    for (std::uint64_t seed = seeds.first; seed < seeds.end(); ++seed)
    {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", 10^" + std::to_string(std::log10(fraction)));
      Random random(seed);
      PlainMesh plain = moved(make(random), random);
      plain = random.chance(0.5) ? withFlippedFaces(plain, random) : plain;
      std::vector<MeshPoint> sources = { source(plain, fraction, random) };
      if (random.chance(0.5))
      {
        sources.push_back(source(plain, fraction, random));
      }
      InThePlane plane(plain, sources, worst);
      plane.compare(verticesAndOthers(plain, 40, random));
    }
    worst.print(fraction);
  }
}

/// Compares angles in the plane with those of a segment that ends beside an edge or a vertex.
class SegmentInThePlane
{
public:
  SegmentInThePlane(const PlainMesh& plain, const MeshPoint& end, const MeshPoint& other,
    bool endsThere, Worst& worst)
    : plain_(plain)
    , a_(position(plain, endsThere ? other : end))
    , b_(position(plain, endsThere ? end : other))
    , mesh_(engineMesh(plain))
    , curves_(engineCurves(mesh_,
        { { { { end.face, endsThere ? other.weights : end.weights,
              endsThere ? end.weights : other.weights } },
          {} } }))
    , field_(geodesic::solve(mesh_, curves_, Solved::withAngles(), geodesic::KeepWindows::All))
    , nearest_(field_, geodesic::ReplicatedPatch(mesh_), curves_)
    , worst_(worst)
  {
  }

  void compare(const MeshPoint& query)
  {
    const Vec3 place = position(this->plain_, query);
    const Vec3 nearest = nearestOn(this->a_, this->b_, place);
    const Vec3 straight = minus(place, nearest);
    if (geodesic::norm(straight) < ShortPath)
    {
      return;
    }
    const SurfacePoint p = geodesic::normalized(this->mesh_, enginePoint(this->mesh_, query));
    const Foot foot = p.kind == SurfacePoint::Kind::Vertex
      ? this->nearest_.atVertex(p.id)
      : this->nearest_.of(geodesic::incomingSegmentTo(this->field_, p));
    const double arcLength = geodesic::norm(minus(nearest, this->a_));
    const double length = geodesic::norm(minus(this->b_, this->a_));
    SCOPED_TRACE(std::to_string(arcLength / length) + " along the segment");
    EXPECT_NEAR(this->nearest_.arcLengthOf(foot), arcLength, 1e-6 * length);
    const geodesic::SourceFrame frame = this->nearest_.frameOf(0);
    const auto errorOf = [&](double angle)
    {
      return std::min(gapOfAngles(angle, angleIn(frame, straight)),
        leastErrorOfBent(this->plain_, this->a_, this->b_, place, frame, angle));
    };
    const double error = errorOf(this->nearest_.angleOf(foot));
    EXPECT_LE(error, 1e-6);
    EXPECT_TRUE(
      arcLength == 0.0 || arcLength == length || foot.isRight == (angleIn(frame, straight) < 0.0));
    geodesic::PathEnd end;
    geodesic::pathsToSource(geodesic::MeshPartition(this->mesh_),
      geodesic::ReplicatedPatch(this->mesh_), this->curves_, { p }, {},
      [&](std::size_t, const geodesic::PathToSource& path) { end = path.end; });
    EXPECT_LE(errorOf(end.angle), 1e-6) << "its path";
    ++this->worst_.count;
    this->worst_.straight = std::max(this->worst_.straight, error);
  }

private:
  const PlainMesh& plain_;
  Vec3 a_;
  Vec3 b_;
  geodesic::TriangleMesh mesh_;
  std::vector<geodesic::SourceCurve> curves_;
  geodesic::DistanceField field_;
  NearestSource nearest_;
  Worst& worst_;
};

/// Compares answers on a cone or a saddle with its development, around a source beside the apex.
class OnAFan
{
public:
  OnAFan(Index sectors, double angle, Index rings, double fraction, Random& random, Worst& worst)
    : sectors_(sectors)
    , angle_(angle)
    , rings_(rings)
    , plain_(fan(sectors, angle, rings))
    , source_(this->besideApex(fraction, random))
    , solved_(plain_, { source_ })
    , worst_(worst)
  {
    const SurfacePoint stored =
      geodesic::normalized(this->solved_.mesh, this->solved_.curves[0].points[0]);
    if (stored.kind != SurfacePoint::Kind::Face)
    {
      return; // it is at the apex, or on an edge, by rounding
    }
    // Of its three weights two are stored.
    const geodesic::Barycentric weights =
      geodesic::barycentric(this->solved_.mesh, stored, stored.id);
    std::copy(weights.begin(), weights.end(), this->source_.weights.begin());
    for (const MeshPoint& query : verticesAndOthers(this->plain_, 100, random))
    {
      this->compare(this->solved_.footOf(query), this->solved_.nearest, query);
    }
    forEachCut(this->plain_, { { 2, true }, { 5, false } }, random,
      [this](const CutMesh& cut) { this->compareOnRanks(cut); });
  }

private:
  MeshPoint besideApex(double fraction, Random& random) const
  {
    for (;;)
    {
      const MeshPoint p = besideVertex(this->plain_, fraction, random);
      if (this->plain_.triangles[p.face][largestWeight(p)] == 0 && !isOnEdge(p))
      {
        return p;
      }
    }
  }
  static bool isOnEdge(const MeshPoint& p)
  {
    return std::count(p.weights.begin(), p.weights.end(), 0.0) > 0;
  }
  static std::size_t largestWeight(const MeshPoint& p)
  {
    return static_cast<std::size_t>(
      std::max_element(p.weights.begin(), p.weights.end()) - p.weights.begin());
  }

  Polar polar(const MeshPoint& p) const
  {
    return fanCoordinates(this->sectors_, this->angle_, this->rings_, this->plain_, p);
  }
  /// From the source's angle around the apex, by the shorter way.
  double turnTo(const Polar& p) const
  {
    return std::remainder(
      p.angle - this->polar(this->source_).angle, this->sectors_ * this->angle_);
  }
  Vec2 developed(double radius, double turn) const
  {
    return { radius * std::cos(turn), radius * std::sin(turn) };
  }
  /// The angle of a direction at the source, from the first edge of its face.
  double fromFirstEdge(Vec2 direction) const
  {
    Vec2 ends[2];
    for (std::size_t k = 0; k < 2; ++k)
    {
      MeshPoint corner = { this->source_.face, {} };
      corner.weights[k] = 1.0;
      const Polar p = this->polar(corner);
      ends[k] = this->developed(p.radius, this->turnTo(p));
    }
    const Vec2 edge = { ends[1][0] - ends[0][0], ends[1][1] - ends[0][1] };
    return std::atan2(edge[0] * direction[1] - edge[1] * direction[0],
      edge[0] * direction[0] + edge[1] * direction[1]);
  }

  /// No value near the source, and where rounding decides: at the border between two ways, and in
  /// the faces around the apex where exactly its shadow begins.
  std::optional<double> expectedAt(const MeshPoint& query) const
  {
    const double total = this->sectors_ * this->angle_;
    const double distance = this->polar(this->source_).radius;
    const Polar q = this->polar(query);
    const double turn = this->turnTo(q);
    // The ways left and right of the apex differ by 2 distance sin(total / 2) times the turn from
    // the border between them, and each carries some roundings.
    const double rounding = q.radius <= 1.0 / this->rings_ ? tolerance::Rounding / distance : 0.0;
    const double borderOfWays = 1e-9 + 8.0 * rounding / std::abs(std::sin(0.5 * total));
    const double borderOfShadow = 1e-9 + 64.0 * rounding;
    if (q.radius < ShortPath || std::abs(0.5 * total - std::abs(turn)) < borderOfWays ||
      std::abs(Pi - std::abs(turn)) < borderOfShadow)
    {
      return std::nullopt;
    }
    const Vec2 place = this->developed(std::abs(turn) < Pi ? q.radius : 0.0, turn);
    return this->fromFirstEdge({ place[0] - distance, place[1] });
  }

  void compare(const Foot& foot, NearestSource& nearest, const MeshPoint& query)
  {
    if (const std::optional<double> expected = this->expectedAt(query))
    {
      EXPECT_EQ(foot.curve, 0U);
      const double error = gapOfAngles(nearest.angleOf(foot), *expected);
      // Vertices lie on one line with the apex: paths may pass them on either side.
      EXPECT_LE(error, Accuracy + 4.0 * this->polar(this->source_).radius)
        << "turn " << this->turnTo(this->polar(query)) << " of " << this->sectors_ * this->angle_;
      ++this->worst_.count;
      this->worst_.straight = std::max(this->worst_.straight, error);
    }
  }

  void compareOnRanks(const CutMesh& cut)
  {
    std::mutex mutex;
    onRanks(cut, polylinesAt({ this->source_ }), 0,
      [&](const RankOfRun& rank)
      {
        const geodesic::DistanceField field = geodesic::solve(
          rank.part, rank.sources, Solved::withAngles(), geodesic::KeepWindows::None);
        NearestSource nearest(field, rank.patch, rank.curvesOnPatch);
        const std::lock_guard<std::mutex> lock(mutex);
        for (Id vertex = 0; vertex < rank.wholeVertices.size(); ++vertex)
        {
          this->compare(nearest.atVertex(vertex), nearest,
            vertexPoint(this->plain_, rank.wholeVertices[vertex]));
        }
      });
  }

  Index sectors_;
  double angle_;
  Index rings_;
  PlainMesh plain_;
  MeshPoint source_;
  Solved solved_;
  Worst& worst_;
};

} // anonymous namespace

// On both sides of the edge of two faces; angles from the first edge of the point's face.
TEST(SourceAnglesBesideEdges, OfTwoFacesAreThoseOfTheStraightLine)
{
  const PlainMesh plain = { { { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, 1, 0 }, { 0.5, -1, 0 } },
    { { 0, 1, 2 }, { 1, 0, 3 } } };
  for (const double fraction : Fractions)
  {
    Worst worst;
    Random random(0);
    for (const Index face : { 0U, 1U })
    {
      const double along = face == 0 ? 0.4 : 0.6;
      const double first = 1.0 - along - 0.5 * fraction;
      const MeshPoint source = { face, { first, 1.0 - first - fraction, fraction } };
      SCOPED_TRACE("face " + std::to_string(face) + ", " + std::to_string(std::log10(fraction)));
      InThePlane plane(plain, { source }, worst);
      plane.compare(verticesAndOthers(plain, 100, random));
    }
    worst.print(fraction);
  }
}

TEST(SourceAnglesBesideEdges, OnPlanarMeshesAreThoseOfTheStraightLine)
{
  compareOnRandom([](Random& random)
    { return randomPlanar(random.between(2, 8), random.between(2, 8), random); },
    meshesOfAKind(10));
}

// Edges lie on lines through the apex.
TEST(SourceAnglesBesideEdges, OnFlatFansAreThoseOfTheStraightLine)
{
  compareOnRandom(
    [](Random& random)
    {
      const Index sectors = random.between(3, 10);
      return fan(sectors, 2.0 * Pi / sectors, random.between(1, 4));
    },
    meshesOfAKind(10));
}

TEST(SourceAnglesBesideVertices, OnPlanarMeshesAreThoseOfTheStraightLine)
{
  compareOnRandom([](Random& random)
    { return randomPlanar(random.between(2, 8), random.between(2, 8), random); },
    meshesOfAKind(10), besideVertex);
}

// The rays on both sides of the curve's line are two windows. Their common end on the edge is
// rounded, and the path that bends there is as long but for rounding.
TEST(SourceAnglesBesideEdges, OfACurveThatPointsBesideAVertexAreThoseInThePlane)
{
  const PlainMesh plain = { { { 0, 0, 0 }, { 1, 0, 0 }, { 0.1, 0.2, 0 }, { 0.9, -0.3, 0 } },
    { { 0, 1, 2 }, { 1, 0, 3 } } };
  Worst worst;
  for (const double fraction : { 1e-13, 2e-13, 4e-13, 1e-12 })
  {
    for (int i = -100; i <= 100; ++i)
    {
      const double turn = 0.001 * i;
      SCOPED_TRACE(std::to_string(fraction / 1e-13) + "e-13, " + std::to_string(turn));
      const MeshPoint end = { 0, { 0.6 - fraction, 0.4, fraction } };
      const Vec3 at = position(plain, end);
      const double direction = std::atan2(-0.3, 0.5) + turn;
      const double x = at[0] - 0.1 * std::cos(direction);
      const double y = at[1] - 0.1 * std::sin(direction);
      const double weight = y / 0.2;
      const MeshPoint begin = { 0, { 1.0 - x - 0.9 * weight, x - 0.1 * weight, weight } };
      SegmentInThePlane segment(plain, end, begin, true, worst);
      segment.compare(vertexPoint(plain, 3));
    }
  }
  worst.print(1e-13);
}

TEST(SourceAnglesBesideElements, OfCurvesThatEndThereAreThoseInThePlane)
{
  const Seeds seeds = seedsOfTest(meshesOfAKind(10));
  for (const MakeSource source : { besideEdge, besideVertex })
  {
    for (const double fraction : Fractions)
    {
      if (fraction < 400.0 * tolerance::Rounding)
      {
        continue; // ends of windows on the edge are rounded to as much, as seen from so near
      }
      Worst worst;
      for (std::uint64_t seed = seeds.first; seed < seeds.end(); ++seed)
      {
        SCOPED_TRACE(
          "seed " + std::to_string(seed) + ", 10^" + std::to_string(std::log10(fraction)));
        Random random(seed);
        const PlainMesh plain =
          moved(randomPlanar(random.between(2, 8), random.between(2, 8), random), random);
        const MeshPoint end = source(plain, fraction, random);
        MeshPoint other = randomFacePoint(plain, random);
        other.face = end.face;
        SegmentInThePlane segment(plain, end, other, random.chance(0.5), worst);
        for (const MeshPoint& query : verticesAndOthers(plain, 40, random))
        {
          segment.compare(query);
        }
      }
      worst.print(fraction);
    }
  }
}

TEST(SourceAnglesBesideVertices, OnConesAndSaddlesAreThoseOfTheDevelopment)
{
  const Seeds seeds = seedsOfTest(meshesOfAKind(10));
  for (const double fraction : Fractions)
  {
    Worst worst;
    for (std::uint64_t seed = seeds.first; seed < seeds.end() && 1.0 - fraction < 1.0; ++seed)
    {
      Random random(seed);
      const Index sectors = 2 * random.between(2, 5);
      const double total = random.uniform(0.3, 1.5) * 2.0 * Pi;
      SCOPED_TRACE("seed " + std::to_string(seed) + ", 10^" + std::to_string(std::log10(fraction)));
      OnAFan(sectors, total / sectors, random.between(1, 4), fraction, random, worst);
    }
    worst.print(fraction);
  }
}
