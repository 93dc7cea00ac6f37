// SPDX-License-Identifier: BSD-3-Clause
#include "paths/EndCases.h"

#include "Tolerance.h"
#include "truth/AnalyticDistances.h"
#include "truth/RandomMeshKinds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace geodesictest
{

namespace
{

constexpr double Pi = 3.14159265358979323846;
/// From shorter paths no angle is compared.
constexpr double ShortPath = 1e-3;
/// From points beside an edge or a vertex, whose places are rounded.
constexpr double ShortPathBeside = 1e-2;
/// The last piece of a traced path may be as short as a fraction NearEdge of its face.
constexpr double AccuracyOfShortPieces =
  4.0 * geodesic::tolerance::PlaceRounding / geodesic::tolerance::NearEdge;

/// As fractions of a face: from less than the rounding of the point on.
const std::vector<double> Beside = { 1e-17, 1e-16, 3e-16, 1e-15, 2e-15, 5e-15, 1e-14, 1e-13, 1e-12,
  1e-11, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6 };

std::vector<MeshPoint> manyPoints(const PlainMesh& mesh, int others, Random& random)
{
  std::vector<MeshPoint> points;
  for (Index vertex = 0; vertex < mesh.points.size(); ++vertex)
  {
    points.push_back(vertexPoint(mesh, vertex));
  }
  for (int i = 0; i < others; ++i)
  {
    points.push_back(randomFacePoint(mesh, random));
    points.push_back(randomEdgePoint(mesh, random));
  }
  return points;
}

/// \name In a plane, where paths are straight
///@{

EndCase inPlane(PlainMesh mesh, std::vector<Polyline> sources, std::vector<MeshPoint> queries,
  double shortPath = ShortPath, bool bends = false)
{
  EndCase c{ std::move(mesh), std::move(sources), std::move(queries), {} };
  c.endsOf = [plain = c.mesh, plane = PlaneEnds(c.mesh, c.sources, bends), shortPath](
               const MeshPoint& query, const std::vector<PlainFrame>& frames)
  {
    std::vector<TrueEnd> ends = plane.of(position(plain, query), frames);
    return ends.front().length < shortPath ? std::vector<TrueEnd>() : ends;
  };
  c.isPlane = true;
  return c;
}

enum At : int
{
  InFace,
  OnEdge,
  AtVertex,
  OnBoundary
};

EndCase aPoint(Random& random, double at)
{
  PlainMesh plain = moved(randomPlanar(9, 7, random), random);
  plain = at != OnBoundary && random.chance(0.5) ? withFlippedFaces(plain, random) : plain;
  std::set<Index> boundary;
  for (const auto& [a, b] : boundaryEdges(plain))
  {
    boundary.insert({ a, b });
  }
  MeshPoint source = at == InFace ? randomFacePoint(plain, random) : randomEdgePoint(plain, random);
  if (at >= AtVertex)
  {
    Index vertex = random.below(plain.points.size());
    while ((boundary.count(vertex) > 0) != (at == OnBoundary))
    {
      vertex = random.below(plain.points.size());
    }
    source = vertexPoint(plain, vertex);
  }
  std::vector<MeshPoint> queries = manyPoints(plain, 200, random);
  EndCase c = inPlane(std::move(plain), { pointLine(source) }, std::move(queries));
  c.leastAngle = at == OnBoundary ? 0.0 : c.leastAngle;
  return c;
}

/// Turns left by a right angle: on its left the sector is pi / 2, on its right 3 pi / 2.
EndCase aBentLine(Random& random, double isReversed)
{
  constexpr Index n = 12;
  PlainMesh plain = regularGrid(n, n);
  std::vector<Index> vertices;
  for (Index i = 0; i < 10; ++i)
  {
    const Index x = std::min<Index>(3 + i, 7);
    const Index y = std::max<Index>(4, i);
    vertices.push_back(y * (n + 1) + x);
  }
  if (isReversed > 0.0)
  {
    std::reverse(vertices.begin(), vertices.end());
  }
  std::vector<MeshPoint> queries = manyPoints(plain, 200, random);
  const Polyline line = lineAlong(plain, vertices);
  return inPlane(std::move(plain), { line }, std::move(queries));
}

/// The middle one of three cells of one line is opposite to the others.
EndCase aLineOfThree(Random& random, double)
{
  constexpr Index n = 12;
  PlainMesh plain = regularGrid(n, 4);
  const auto row = [&](Index from, Index to)
  {
    std::vector<Index> vertices = { 2 * (n + 1) + from };
    while (vertices.back() != 2 * (n + 1) + to)
    {
      vertices.push_back(from < to ? vertices.back() + 1 : vertices.back() - 1);
    }
    return lineAlong(plain, vertices);
  };
  std::vector<Polyline> lines = { row(1, 4), row(8, 4), row(8, 11) };
  std::vector<MeshPoint> queries = manyPoints(plain, 100, random);
  return inPlane(std::move(plain), std::move(lines), std::move(queries));
}

/// Lies in the faces on both sides: the angle is that of the side from which the path comes, also
/// where its rounded end is nearer to the source in the other face.
EndCase anEdge(Random& random, double)
{
  PlainMesh plain = { { { 0, 0, 0 }, { 0.6, 0.8, 0.0 }, { -0.3, 1.1, 0 }, { 0.7, 0.1, 0 } },
    { { 0, 1, 2 }, { 1, 0, 3 } } };
  std::vector<MeshPoint> queries;
  for (int i = 0; i < 400; ++i)
  {
    const double u = random.uniform(0.1, 0.6);
    const double v = random.uniform(0.01, 0.3);
    queries.push_back({ random.below(2), { 1.0 - u - v, u, v } });
  }
  const Polyline edge = lineAlong(plain, { 0, 1 });
  EndCase c = inPlane(std::move(plain), { edge }, std::move(queries));
  c.accuracy = c.accuracyOfPath = 1e-14;
  return c;
}

/// Paths along edges and across faces, to a point and to a curve that ends there along an edge.
EndCase aCenterOfAHexagon(Random& random, double isCurve)
{
  PlainMesh plain = fan(6, Pi / 3.0, 1);
  std::vector<MeshPoint> queries = manyPoints(plain, 0, random);
  for (Index face = 0; face < 6; ++face)
  {
    queries.push_back({ face, { 0.2, 0.3, 0.5 } });
  }
  const Polyline source =
    isCurve > 0.0 ? lineAlong(plain, { 4, 0 }) : pointLine(vertexPoint(plain, 0));
  EndCase c = inPlane(std::move(plain), { source }, std::move(queries));
  c.accuracy = c.accuracyOfPath = 1e-14;
  return c;
}

EndCase aSegmentInAFace(Random& random, double)
{
  PlainMesh plain = regularGrid(8, 8);
  std::vector<MeshPoint> queries = manyPoints(plain, 150, random);
  EndCase c = inPlane(std::move(plain),
    { { { { 66, { 0.8, 0.1, 0.1 }, { 0.1, 0.2, 0.7 } } }, {} } }, std::move(queries));
  c.accuracy = c.accuracyOfPath = 1e-12;
  return c;
}

///@}
/// \name Beside an edge or a vertex, as from a click on it
///@{

EndCase besideInPlane(PlainMesh mesh, std::vector<Polyline> sources, Random& random, int others)
{
  std::vector<MeshPoint> queries = manyPoints(mesh, others, random);
  EndCase c =
    inPlane(std::move(mesh), std::move(sources), std::move(queries), ShortPathBeside, true);
  c.accuracyOfPath = AccuracyOfShortPieces;
  return c;
}

/// On both sides of the edge of two faces.
EndCase twoFaces(Random& random, double fraction)
{
  const Index face = random.below(2);
  const double along = face == 0 ? 0.4 : 0.6;
  const double first = 1.0 - along - 0.5 * fraction;
  return besideInPlane(
    { { { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, 1, 0 }, { 0.5, -1, 0 } }, { { 0, 1, 2 }, { 1, 0, 3 } } },
    { pointLine({ face, { first, 1.0 - first - fraction, fraction } }) }, random, 100);
}

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

using Place = MeshPoint (*)(const PlainMesh&, double, Random&);

PlainMesh randomRectangle(Random& random)
{
  const Index nx = random.between(2, 8);
  return randomPlanar(nx, random.between(2, 8), random);
}

/// Edges lie on lines through the apex.
PlainMesh flatFan(Random& random)
{
  const Index sectors = random.between(3, 10);
  return fan(sectors, 2.0 * Pi / sectors, random.between(1, 4));
}

/// One or two points, beside inner edges and beside the boundary.
template <PlainMesh (*makeMesh)(Random&), Place place>
EndCase pointsBeside(Random& random, double fraction)
{
  PlainMesh plain = moved(makeMesh(random), random);
  plain = random.chance(0.5) ? withFlippedFaces(plain, random) : plain;
  std::vector<Polyline> sources = { pointLine(place(plain, fraction, random)) };
  if (random.chance(0.5))
  {
    sources.push_back(pointLine(place(plain, fraction, random)));
  }
  return besideInPlane(std::move(plain), std::move(sources), random, 40);
}

EndCase segmentFrom(
  PlainMesh mesh, const MeshPoint& end, MeshPoint other, bool endsThere, Random& random, int others)
{
  const MeshSegment segment = { end.face, endsThere ? other.weights : end.weights,
    endsThere ? end.weights : other.weights };
  EndCase c = besideInPlane(std::move(mesh), { { { segment }, {} } }, random, others);
  c.accuracy = c.accuracyOfPath = 1e-6;
  return c;
}

template <Place place>
EndCase segmentBeside(Random& random, double fraction)
{
  PlainMesh plain = moved(randomRectangle(random), random);
  const MeshPoint end = place(plain, fraction, random);
  const MeshPoint other = { end.face, randomFacePoint(plain, random).weights };
  return segmentFrom(std::move(plain), end, other, random.chance(0.5), random, 40);
}

/// The rays on both sides of the curve's line are two windows. Their common end on the edge is
/// rounded, and the path that bends there is as long but for rounding.
EndCase segmentThatPointsBesideAVertex(Random& random, double fraction)
{
  PlainMesh plain = { { { 0, 0, 0 }, { 1, 0, 0 }, { 0.1, 0.2, 0 }, { 0.9, -0.3, 0 } },
    { { 0, 1, 2 }, { 1, 0, 3 } } };
  const MeshPoint end = { 0, { 0.6 - fraction, 0.4, fraction } };
  const Vec3 at = position(plain, end);
  const double direction = std::atan2(-0.3, 0.5) + random.uniform(-0.1, 0.1);
  const double x = at[0] - 0.1 * std::cos(direction);
  const double weight = (at[1] - 0.1 * std::sin(direction)) / 0.2;
  const MeshPoint begin = { 0, { 1.0 - x - 0.9 * weight, x - 0.1 * weight, weight } };
  EndCase c = segmentFrom(std::move(plain), end, begin, true, random, 0);
  c.queries = { vertexPoint(c.mesh, 3) };
  return c;
}

///@}
/// \name On other surfaces that unfold into the plane
///@{

EndCase aCylinder(Random& random, double source)
{
  constexpr Index sides = 12;
  EndCase c{ openCylinder(sides, 9, 10.0), {}, {}, {} };
  const auto vertex = static_cast<Index>(source);
  const Vec3 from = c.mesh.points[vertex];
  c.sources = { pointLine(vertexPoint(c.mesh, vertex)) };
  c.queries = manyPoints(c.mesh, 0, random);
  c.endsOf = [plain = c.mesh, vertex, from](
               const MeshPoint& query, const std::vector<PlainFrame>& frames)
  {
    const auto k = static_cast<std::size_t>(
      std::max_element(query.weights.begin(), query.weights.end()) - query.weights.begin());
    const Index to = plain.triangles[query.face][k];
    const double turn = std::remainder(double(to % sides) - double(vertex % sides), double(sides));
    if (to == vertex || std::abs(turn) > 0.5 * sides - 0.6)
    {
      return std::vector<TrueEnd>();
    }
    // The frame's face is flat: turned about the axis, its vectors are those of the unrolled one.
    const PlainFrame& frame = frames[0];
    const bool isBehind = frame.normal[1] * from[0] < frame.normal[0] * from[1];
    const double toMiddle = 2.0 * Pi * (vertex % sides + (isBehind ? -0.5 : 0.5)) / sides;
    const Vec3 around = { -std::sin(toMiddle), std::cos(toMiddle), 0.0 };
    const double up = plain.points[to][2] - from[2];
    const Vec3 away = { turn * around[0], turn * around[1], up };
    return std::vector<TrueEnd>{ { 0, std::hypot(turn, up), 0.0, angleIn(frame, away) } };
  };
  return c;
}

/// A line up the cylinder, or a ring around it.
EndCase aCurveOnACylinder(Random& random, double isRing)
{
  constexpr Index sides = 12;
  EndCase c{ openCylinder(sides, 9, 10.0), {}, {}, {} };
  std::vector<Index> vertices;
  for (Index i = 0; i <= (isRing > 0.0 ? sides : 4); ++i)
  {
    vertices.push_back(isRing > 0.0 ? 5 * sides + i % sides : (3 + i) * sides + 7);
  }
  c.sources = { lineAlong(c.mesh, vertices) };
  c.queries = manyPoints(c.mesh, 0, random);
  c.endsOf = [plain = c.mesh, vertices, isRing](
               const MeshPoint& query, const std::vector<PlainFrame>& frames)
  {
    const auto k = std::max_element(query.weights.begin(), query.weights.end());
    const Index to =
      plain.triangles[query.face][static_cast<std::size_t>(k - query.weights.begin())];
    const Vec3& first = plain.points[vertices.front()];
    const Vec3& last = plain.points[vertices.back()];
    const bool isOutward = frames[0].normal[0] * first[0] + frames[0].normal[1] * first[1] > 0.0;
    // Unrolled, seen from the side that the frame is on.
    const double up = plain.points[to][2];
    const double from = isRing > 0.0 ? 0.0 : 7.0;
    double turn = double(to % sides) - from;
    turn = isRing > 0.0 ? turn : std::remainder(turn, double(sides));
    const PlaneEnds plane(
      { isRing > 0.0 ? std::vector<Vec3>{ { -1.0, first[2], 0.0 }, { 13.0, first[2], 0.0 } }
                     : std::vector<Vec3>{ { 0.0, first[2], 0.0 }, { 0.0, last[2], 0.0 } } });
    std::vector<TrueEnd> ends =
      plane.of({ turn, up, 0.0 }, { { {}, {}, { 0.0, 0.0, isOutward ? 1.0 : -1.0 } } });
    if (ends.front().length < ShortPath || std::abs(turn) > (isRing > 0.0 ? 12.0 : 5.5))
    {
      return std::vector<TrueEnd>();
    }
    if (isRing > 0.0)
    {
      ends.front().arcLength = turn;
      ends.push_back(ends.front());
      ends.back().arcLength += turn > 0.0 ? 0.0 : sides; // its first point is its last
    }
    return ends;
  };
  return c;
}

/// Around the apex of a cone, or a saddle, the total angle is 2 pi.
EndCase anApex(Random& random, double angle)
{
  constexpr Index sectors = 8;
  constexpr Index n = 5;
  EndCase c{ fan(sectors, angle, n), {}, {}, {} };
  c.sources = { pointLine(vertexPoint(c.mesh, 0)) };
  c.queries = manyPoints(c.mesh, 200, random);
  c.endsOf = [plain = c.mesh, angle](const MeshPoint& query, const std::vector<PlainFrame>& frames)
  {
    const auto polar = [&](const MeshPoint& p)
    { return fanCoordinates(sectors, angle, n, plain, p); };
    const auto isAlongFrame = [&](const Vec3& p)
    { return dotProduct(p, frames[0].x) > (1.0 - 1e-12) * std::sqrt(dotProduct(p, p)); };
    const auto first = std::find_if(plain.points.begin() + 1, plain.points.end(), isAlongFrame);
    const Polar p = polar(query);
    const double turn =
      p.angle - polar(vertexPoint(plain, static_cast<Index>(first - plain.points.begin()))).angle;
    return p.radius < ShortPath
      ? std::vector<TrueEnd>()
      : std::vector<TrueEnd>{ { 0, p.radius, 0.0, turn * 2.0 * Pi / (sectors * angle) } };
  };
  return c;
}

/// Curves along spokes of a cone or a saddle, which begin or end at its apex or pass it.
class Spokes
{
public:
  struct Spoke
  {
    Index sector;
    bool isForward;
    Index source;
    /// Along the source.
    double arcLengthAtApex;
  };

  Spokes(double angle, std::vector<Spoke> spokes)
    : angle_(angle)
    , plain_(fan(Sectors, angle, Rings))
    , spokes_(std::move(spokes))
  {
  }

  const PlainMesh& mesh() const { return this->plain_; }

  Polyline line(const Spoke& spoke) const
  {
    std::map<double, Index> byRadius = { { 0.0, 0 } };
    for (Index vertex = 1; vertex < this->plain_.points.size(); ++vertex)
    {
      const Polar p = this->polar(vertexPoint(this->plain_, vertex));
      if (this->turn(spoke, p) < 1e-9 || this->turn(spoke, p) > Sectors * this->angle_ - 1e-9)
      {
        byRadius[p.radius] = vertex;
      }
    }
    std::vector<Index> vertices;
    for (const auto& [radius, vertex] : byRadius)
    {
      vertices.push_back(vertex);
    }
    if (!spoke.isForward)
    {
      std::reverse(vertices.begin(), vertices.end());
    }
    return lineAlong(this->plain_, vertices);
  }

  /// A spoke is a border of the sector on each of its sides, which unfolds into the plane.
  std::vector<TrueEnd> endsOf(const MeshPoint& query) const
  {
    const Polar p = this->polar(query);
    const auto isBefore = [&](const Spoke& a, const Spoke& b)
    { return this->turn(a, p) < this->turn(b, p); };
    const Spoke& before = *std::min_element(this->spokes_.begin(), this->spokes_.end(), isBefore);
    const Spoke& behind = *std::max_element(this->spokes_.begin(), this->spokes_.end(), isBefore);
    const double turn = this->turn(before, p);
    const double back = Sectors * this->angle_ - this->turn(behind, p);
    std::vector<TrueEnd> ends;
    for (const auto& [spoke, away, side] :
      { std::tuple(&before, turn, 0.5 * Pi), std::tuple(&behind, back, -0.5 * Pi) })
    {
      if (std::abs(away - 0.5 * Pi) < 1e-9 || p.radius * away < ShortPath)
      {
        return {};
      }
      const double sign = spoke->isForward ? 1.0 : -1.0;
      if (away < 0.5 * Pi)
      {
        ends.push_back({ spoke->source, p.radius * std::sin(away),
          spoke->arcLengthAtApex + sign * p.radius * std::cos(away), sign * side, 0.0, true });
      }
    }
    if (ends.empty() && before.source != behind.source && std::abs(turn - back) < 1e-9)
    {
      return {};
    }
    if (ends.empty())
    {
      ends.push_back(this->endAtApex(before, behind, turn, back));
      ends.back().length = p.radius;
    }
    const auto least = std::min_element(ends.begin(), ends.end(),
      [](const TrueEnd& a, const TrueEnd& b) { return a.length < b.length; });
    const double longest = least->length + 1e-9;
    ends.erase(std::remove_if(ends.begin(), ends.end(),
                 [&](const TrueEnd& end) { return end.length > longest; }),
      ends.end());
    return ends;
  }

private:
  static constexpr Index Sectors = 8;
  static constexpr Index Rings = 5;

  Polar polar(const MeshPoint& p) const
  {
    return fanCoordinates(Sectors, this->angle_, Rings, this->plain_, p);
  }
  /// Counterclockwise, in [0, total).
  double turn(const Spoke& from, const Polar& to) const
  {
    const double total = Sectors * this->angle_;
    const double turn = to.angle - from.sector * this->angle_;
    return turn - total * std::floor(turn / total);
  }
  /// Between spokes of one curve angles are scaled; else they count from the nearer spoke.
  static TrueEnd endAtApex(const Spoke& before, const Spoke& behind, double turn, double back)
  {
    const double first = before.isForward ? 0.0 : -Pi;
    if (before.source == behind.source)
    {
      const double scaled = &before == &behind ? 2.0 * Pi : Pi;
      return { before.source, 0.0, before.arcLengthAtApex, first + turn * scaled / (turn + back) };
    }
    return turn < back
      ? TrueEnd{ before.source, 0.0, before.arcLengthAtApex, first + turn }
      : TrueEnd{ behind.source, 0.0, behind.arcLengthAtApex, (behind.isForward ? 0.0 : Pi) - back };
  }

  double angle_;
  PlainMesh plain_;
  std::vector<Spoke> spokes_;
};

EndCase alongSpokes(const Spokes& spokes, std::vector<Polyline> sources, Random& random)
{
  return { spokes.mesh(), std::move(sources), manyPoints(spokes.mesh(), 200, random),
    [spokes](const MeshPoint& query, const std::vector<PlainFrame>&)
    { return spokes.endsOf(query); } };
}

EndCase aCurveToAnApex(Random& random, double angle)
{
  const Spokes::Spoke spoke = { 2, false, 0, 1.0 };
  const Spokes spokes(angle, { spoke });
  return alongSpokes(spokes, { spokes.line(spoke) }, random);
}

EndCase aCurveThroughAnApex(Random& random, double angle)
{
  const std::vector<Spokes::Spoke> parts = { { 1, false, 0, 1.0 }, { 4, true, 0, 1.0 } };
  const Spokes spokes(angle, parts);
  Polyline line = spokes.line(parts[0]);
  const Polyline onward = spokes.line(parts[1]);
  line.segments.insert(line.segments.end(), onward.segments.begin(), onward.segments.end());
  return alongSpokes(spokes, { line }, random);
}

EndCase curvesThatMeetInAnApex(Random& random, double angle)
{
  const std::vector<Spokes::Spoke> parts = { { 0, true, 0, 0.0 }, { 3, false, 1, 1.0 },
    { 6, true, 2, 0.0 } };
  const Spokes spokes(angle, parts);
  return alongSpokes(
    spokes, { spokes.line(parts[0]), spokes.line(parts[1]), spokes.line(parts[2]) }, random);
}

/// Two sheets share a corner: the angles of the second one follow those of the first.
EndCase aPointOfTwoSheets(Random& random, double)
{
  const PlainMesh second = regularGrid(4, 5);
  EndCase c{ joinedAtVertex(
               regularGrid(6, 5), 0, second, static_cast<Index>(second.points.size() - 1)),
    {}, {}, {} };
  c.sources = { pointLine(vertexPoint(c.mesh, 0)) };
  c.queries = manyPoints(c.mesh, 200, random);
  c.endsOf = [plain = c.mesh](const MeshPoint& query, const std::vector<PlainFrame>&)
  {
    const Vec3 p = position(plain, query);
    const double angle = std::atan2(p[1], p[0]);
    const double length = std::hypot(p[0], p[1]);
    return length < ShortPath
      ? std::vector<TrueEnd>()
      : std::vector<TrueEnd>{ { 0, length, 0.0,
          angle < -1e-12 || angle > 3.0 ? 0.5 * Pi + std::remainder(angle - Pi, 2.0 * Pi)
                                        : angle } };
  };
  return c;
}

/// Where pages meet: all but the first of them continue the first one.
EndCase aPointOnASpine(Random& random, double)
{
  EndCase c{ book(3, 4, 3, 0.0, random), {}, {}, {} };
  const MeshPoint source = { 0, { 0.4, 0.6, 0.0 } };
  c.sources = { pointLine(source) };
  c.queries = manyPoints(c.mesh, 200, random);
  const Vec3& third = c.mesh.points[c.mesh.triangles[0][2]];
  const double height = position(c.mesh, source)[2];
  c.endsOf = [plain = c.mesh, third, height](
               const MeshPoint& query, const std::vector<PlainFrame>& frames)
  {
    const Vec3 p = position(plain, query);
    const double away = std::hypot(p[0], p[1]);
    const double toThird = std::hypot(third[0], third[1]);
    const bool isOnFirst = p[0] * third[0] + p[1] * third[1] > (1.0 - 1e-9) * away * toThird;
    const double x = (isOnFirst ? away : -away) / toThird;
    const Vec3 to = { x * third[0], x * third[1], p[2] - height };
    const double length = std::hypot(away, to[2]);
    return length < ShortPath ? std::vector<TrueEnd>()
                              : std::vector<TrueEnd>{ { 0, length, 0.0, angleIn(frames[0], to) } };
  };
  return c;
}

/// Great circles; a sphere of many facets differs from the sphere by a fraction of its facets.
EndCase aPole(Random& random, double facets)
{
  EndCase c{ octasphere(static_cast<Index>(facets)), {}, {}, {} };
  const auto pole = std::max_element(c.mesh.points.begin(), c.mesh.points.end(),
    [](const Vec3& a, const Vec3& b) { return a[2] < b[2]; });
  c.sources = { pointLine(vertexPoint(c.mesh, static_cast<Index>(pole - c.mesh.points.begin()))) };
  c.queries = manyPoints(c.mesh, 0, random);
  c.accuracy = c.accuracyOfPath = c.accuracyOfDistance = 1.0 / facets;
  c.endsOf = [plain = c.mesh](const MeshPoint& query, const std::vector<PlainFrame>& frames)
  {
    const Vec3 p = position(plain, query);
    return std::abs(p[2]) > 0.9 ? std::vector<TrueEnd>()
                                : std::vector<TrueEnd>{ { 0, std::acos(p[2]), 0.0,
                                    angleIn(frames[0], { p[0], p[1], 0.0 }) } };
  };
  return c;
}

/// A cone or a saddle, developed around a source beside its apex.
class BesideAnApex
{
public:
  BesideAnApex(Random& random, double fraction)
    : sectors_(2 * random.between(2, 5))
    , angle_(random.uniform(0.3, 1.5) * 2.0 * Pi / this->sectors_)
    , rings_(random.between(1, 4))
    , plain_(fan(sectors_, angle_, rings_))
  {
    bool isInside = false;
    while (!isInside)
    {
      this->source_ = besideVertex(this->plain_, fraction, random);
      Barycentric& w = this->source_.weights;
      w[0] = 1.0 - w[1] - w[2]; // two are stored
      const auto k = static_cast<std::size_t>(std::max_element(w.begin(), w.end()) - w.begin());
      isInside = this->plain_.triangles[this->source_.face][k] == 0 &&
        *std::min_element(w.begin(), w.end()) > 0.0 && w[k] < 1.0;
    }
  }

  const PlainMesh& mesh() const { return this->plain_; }
  const MeshPoint& source() const { return this->source_; }
  double distance() const { return this->polar(this->source_).radius; }

  /// No end near the source, and where rounding decides: at the border between two ways, and in the
  /// faces around the apex where exactly its shadow begins.
  std::vector<TrueEnd> endsOf(const MeshPoint& query) const
  {
    const double total = this->sectors_ * this->angle_;
    const double distance = this->distance();
    const Polar q = this->polar(query);
    const double turn = this->turnTo(q);
    // The ways left and right of the apex differ by 2 distance sin(total / 2) times the turn from
    // the border between them, and each carries some roundings.
    const double rounding =
      q.radius <= 1.0 / this->rings_ ? geodesic::tolerance::Rounding / distance : 0.0;
    const double borderOfWays = 1e-9 + 8.0 * rounding / std::abs(std::sin(0.5 * total));
    const double borderOfShadow = 1e-9 + 64.0 * rounding;
    if (q.radius < ShortPathBeside || std::abs(0.5 * total - std::abs(turn)) < borderOfWays ||
      std::abs(Pi - std::abs(turn)) < borderOfShadow)
    {
      return {};
    }
    const Vec2 place = developed(std::abs(turn) < Pi ? q.radius : 0.0, turn);
    const Vec2 away = { place[0] - distance, place[1] };
    const double length = std::abs(turn) < Pi ? std::hypot(away[0], away[1]) : distance + q.radius;
    return { { 0, length, 0.0, this->fromFirstEdge(away) } };
  }

private:
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
  static Vec2 developed(double radius, double turn)
  {
    return { radius * std::cos(turn), radius * std::sin(turn) };
  }
  /// The angle of a direction at the source, from the first edge of its face.
  double fromFirstEdge(const Vec2& direction) const
  {
    Vec2 ends[2];
    for (std::size_t k = 0; k < 2; ++k)
    {
      MeshPoint corner = { this->source_.face, {} };
      corner.weights[k] = 1.0;
      const Polar p = this->polar(corner);
      ends[k] = developed(p.radius, this->turnTo(p));
    }
    const Vec2 edge = { ends[1][0] - ends[0][0], ends[1][1] - ends[0][1] };
    return std::atan2(edge[0] * direction[1] - edge[1] * direction[0],
      edge[0] * direction[0] + edge[1] * direction[1]);
  }

  Index sectors_;
  double angle_;
  Index rings_;
  PlainMesh plain_;
  MeshPoint source_;
};

EndCase besideAnApex(Random& random, double fraction)
{
  const BesideAnApex apex(random, fraction);
  EndCase c{ apex.mesh(), { pointLine(apex.source()) }, manyPoints(apex.mesh(), 100, random), {} };
  // Vertices lie on one line with the apex: paths may pass them on either side.
  c.accuracy += 4.0 * apex.distance();
  c.accuracyOfPath = AccuracyOfShortPieces + 4.0 * apex.distance();
  c.endsOf = [apex](const MeshPoint& query, const std::vector<PlainFrame>&)
  { return apex.endsOf(query); };
  return c;
}

///@}

} // anonymous namespace

Polyline pointLine(const MeshPoint& point)
{
  return { { { point.face, point.weights, point.weights } }, {} };
}

Polyline lineAlong(const PlainMesh& mesh, const std::vector<Index>& vertices)
{
  const auto cornerOf = [](const Triangle& t, Index vertex)
  { return static_cast<std::size_t>(std::find(t.begin(), t.end(), vertex) - t.begin()); };
  Polyline line;
  for (std::size_t i = 0; i + 1 < vertices.size(); ++i)
  {
    const auto holds = [&](const Triangle& t)
    { return cornerOf(t, vertices[i]) < 3 && cornerOf(t, vertices[i + 1]) < 3; };
    const auto t = std::find_if(mesh.triangles.begin(), mesh.triangles.end(), holds);
    MeshSegment segment = { static_cast<Index>(t - mesh.triangles.begin()), {}, {} };
    segment.from[cornerOf(*t, vertices[i])] = 1.0;
    segment.to[cornerOf(*t, vertices[i + 1])] = 1.0;
    line.segments.push_back(segment);
  }
  return line;
}

const std::vector<EndConfiguration>& endConfigurations()
{
  // Ends of windows on the edge are rounded to 400 roundings, as seen from so near.
  const std::vector<double> besideForCurves(Beside.begin() + 7, Beside.end());
  const std::vector<double> besideForDevelopments(Beside.begin() + 1, Beside.end());
  const std::uint64_t ten = meshesOfAKind(10);
  const std::uint64_t twenty = meshesOfAKind(20);
  static const std::vector<EndConfiguration> table = {
    { "PointInAFace", aPoint, { InFace }, twenty },
    { "PointOnAnEdge", aPoint, { OnEdge }, twenty },
    { "PointAtAVertex", aPoint, { AtVertex }, twenty, true },
    { "PointOnTheBoundary", aPoint, { OnBoundary }, twenty },
    { "BentLine", aBentLine, { 0.0, 1.0 }, 1, true },
    { "LineOfThreeCurves", aLineOfThree, { 0.0 }, 1, true },
    { "CurveAlongAnEdge", anEdge, { 0.0 } },
    { "CenterOfAHexagon", aCenterOfAHexagon, { 0.0, 1.0 }, 1, true },
    { "SegmentInAFace", aSegmentInAFace, { 0.0 } },
    { "PointBesideTheEdgeOfTwoFaces", twoFaces, Beside, 4 },
    { "PointsBesideEdges", pointsBeside<randomRectangle, besideEdge>, Beside, ten },
    { "PointsBesideEdgesOfAFlatFan", pointsBeside<flatFan, besideEdge>, Beside, ten },
    { "PointsBesideVertices", pointsBeside<randomRectangle, besideVertex>, Beside, ten },
    { "SegmentsBesideEdges", segmentBeside<besideEdge>, besideForCurves, ten },
    { "SegmentsBesideVertices", segmentBeside<besideVertex>, besideForCurves, ten },
    { "SegmentThatPointsBesideAVertex", segmentThatPointsBesideAVertex,
      { 1e-13, 2e-13, 4e-13, 1e-12 }, 200 },
    { "Cylinder", aCylinder, { 3 + 4 * 12, 7 + 5 * 12, 2 }, 1, true },
    { "CurvesOnACylinder", aCurveOnACylinder, { 0.0, 1.0 }, 1, true },
    { "ApexOfAConeOrASaddle", anApex, { 0.3, 0.7, 0.9, 1.3 }, 1, true },
    { "CurveToAnApex", aCurveToAnApex, { 0.3, 0.7, 0.9, 1.3 }, 1, true },
    { "CurveThroughAnApex", aCurveThroughAnApex, { 0.3, 0.7, 0.9, 1.3 }, 1, true },
    { "CurvesThatMeetInAnApex", curvesThatMeetInAnApex, { 0.3, 0.7, 0.9, 1.3 }, 1, true },
    { "PointOfTwoSheets", aPointOfTwoSheets, { 0.0 } },
    { "PointOnASpine", aPointOnASpine, { 0.0 }, twenty },
    { "PoleOfASphere", aPole, { 8, 32 } },
    { "PointBesideAnApex", besideAnApex, besideForDevelopments, ten, true },
  };
  return table;
}

}
