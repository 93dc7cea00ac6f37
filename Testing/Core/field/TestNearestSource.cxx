// SPDX-License-Identifier: BSD-3-Clause
// What is nearest, where on it a shortest path ends, from which side it comes, and the gradient:
// against the brute force from one curve alone, from the foot alone, and at steps against the
// gradient.
#include "EngineSupport.h"
#include "truth/RandomMeshKinds.h"

#include "field/NearestSource.h"
#include "refinement/AdaptiveRefinement.h"
#include "refinement/SolveForRefinement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <string>
#include <utility>

using namespace geodesictest;
using geodesic::Foot;
using geodesic::Id;
using geodesic::LastPiece;
using geodesic::NearestSource;
using geodesic::SurfacePoint;

namespace
{

constexpr std::uint64_t MeshesOfAKind = 12;
constexpr std::size_t NumberOfQueries = 40;
constexpr std::size_t FeetTried = 6;
/// Of unit edges.
constexpr double RefinementTolerance = 0.02;

geodesic::DistanceField solveWithArrivals(const geodesic::TriangleMesh& mesh,
  const std::vector<geodesic::SourceCurve>& curves, double maximumDistance = geodesic::Infinity)
{
  geodesic::FrontOptions options;
  options.keepArrivals = true;
  options.maximumDistance = maximumDistance;
  return geodesic::solve(mesh, curves, options, geodesic::KeepWindows::All);
}

MeshPoint plainPoint(const geodesic::TriangleMesh& mesh, const SurfacePoint& point)
{
  const Id face = geodesic::someFace(mesh, point);
  return { face, geodesic::barycentric(mesh, point, face) };
}

enum class At
{
  /// All vertices and the queries of the case.
  VerticesAndQueries,
  /// Points that refinement adds, some of them, with the windows that it keeps.
  RefinedPoints
};

geodesic::DistanceField solveFor(
  At at, const geodesic::TriangleMesh& mesh, const std::vector<geodesic::SourceCurve>& curves)
{
  geodesic::FrontOptions options;
  options.keepArrivals = true;
  return at == At::RefinedPoints
    ? geodesic::solveForRefinement(mesh, curves, RefinementTolerance, options)
    : geodesic::solve(mesh, curves, options, geodesic::KeepWindows::All);
}

/// A point of a face as it is; one of another face, which lies a rounding beside a corner, as that.
SurfacePoint inFaceOrAtCorner(
  const geodesic::TriangleMesh& mesh, const SurfacePoint& point, Id face)
{
  if (geodesic::contains(mesh, face, point))
  {
    return point;
  }
  const Id own = geodesic::someFace(mesh, point);
  const geodesic::Barycentric weights = geodesic::barycentric(mesh, point, own);
  const auto largest = std::max_element(weights.begin(), weights.end());
  EXPECT_GT(*largest, 1.0 - 1e-12);
  return SurfacePoint::atVertex(
    mesh.triangle(own)[static_cast<std::size_t>(largest - weights.begin())]);
}

/// A random case, solved, and the points that are asked for.
struct Solved
{
  RandomCase plain;
  geodesic::TriangleMesh mesh;
  std::vector<geodesic::SourceCurve> curves;
  geodesic::DistanceField field;
  NearestSource nearest;
  std::vector<SurfacePoint> points;
  std::vector<double> truth;
  double largest;

  Solved(const MeshKind& kind, std::uint64_t seed, At at)
    : plain(randomCase(kind, seed, NumberOfQueries))
    , mesh(engineMesh(plain.mesh))
    , curves(engineCurves(mesh, plain.curves))
    , field(solveFor(at, mesh, curves))
    , nearest(field, curves)
    , largest(largestFinite(plain.truth.vertices))
  {
    if (at == At::RefinedPoints)
    {
      takeRefinedPoints();
      return;
    }
    truth = plain.truth.vertices;
    for (Id vertex = 0; vertex < mesh.numberOfVertices(); ++vertex)
    {
      points.push_back(SurfacePoint::atVertex(vertex));
    }
    for (const MeshPoint& query : plain.queries)
    {
      points.push_back(geodesic::normalized(mesh, enginePoint(mesh, query)));
    }
    truth.insert(truth.end(), plain.truth.queries.begin(), plain.truth.queries.end());
  }

  void takeRefinedPoints()
  {
    geodesic::RefinementOptions options;
    options.tolerance = RefinementTolerance;
    options.maximumFaces = 20 * mesh.numberOfFaces();
    const geodesic::RefinedMesh refined = geodesic::refine(field, options);
    const std::size_t step = refined.points.size() / NumberOfQueries + 1;
    std::vector<MeshPoint> places;
    for (std::size_t i = 0; i < refined.points.size(); i += step)
    {
      points.push_back(refined.points[i].place);
      places.push_back(plainPoint(mesh, refined.points[i].place));
    }
    truth = bruteForceDistances(plain.mesh, toSources(plain.curves), places).queries;
  }

  /// The true distances of the points from one of the curves.
  std::vector<double> distancesFrom(const Polyline& curve) const
  {
    std::vector<MeshPoint> places;
    for (const SurfacePoint& point : points)
    {
      places.push_back(plainPoint(mesh, point));
    }
    return bruteForceDistances(plain.mesh, toSources({ curve }), places).queries;
  }

  Foot footAt(std::size_t i)
  {
    return points[i].kind == SurfacePoint::Kind::Vertex
      ? nearest.atVertex(points[i].id)
      : nearest.of(geodesic::lastPieceTo(field, points[i]));
  }
};

class NearestSources : public ::testing::TestWithParam<std::tuple<MeshKind, At>>
{
protected:
  const MeshKind& kind() const { return kind_; }
  At at() const { return std::get<1>(GetParam()); }

private:
  const MeshKind kind_ = std::get<0>(GetParam());
};

} // anonymous namespace

// The distance from the curve that is named, alone, is the field's.
TEST_P(NearestSources, AreAsFarAsTheField)
{
  double worst = 0.0;
  for (std::uint64_t seed = 0; seed < MeshesOfAKind; ++seed)
  {
    Solved s(kind(), seed, at());
    std::vector<std::vector<double>> alone;
    for (const Polyline& curve : s.plain.curves)
    {
      alone.push_back(s.distancesFrom(curve));
    }
    for (std::size_t i = 0; i < s.points.size(); ++i)
    {
      const Foot foot = s.footAt(i);
      ASSERT_EQ(foot.isKnown(), s.truth[i] < geodesic::Infinity)
        << kind().name << ", seed " << seed << ", point " << i;
      if (!foot.isKnown())
      {
        continue;
      }
      const double error = std::abs(alone[foot.curve][i] - s.truth[i]) / s.largest;
      EXPECT_LE(error, accuracyOn(kind()))
        << kind().name << ", seed " << seed << ", point " << i << ", curve " << foot.curve;
      worst = std::max(worst, error);
    }
  }
  std::cout << "worst relative error of the named curve on " << kind().name << ": " << worst
            << "\n";
}

// The distance from the foot, as a point, is the field's.
TEST_P(NearestSources, HaveTheirFeetAsFarAsTheField)
{
  double worst = 0.0;
  for (std::uint64_t seed = 0; seed < MeshesOfAKind; ++seed)
  {
    Solved s(kind(), seed, at());
    Random random(seed);
    for (std::size_t n = 0; n < FeetTried; ++n)
    {
      const std::size_t i = random.below(s.points.size());
      const Foot foot = s.footAt(i);
      if (!foot.isKnown())
      {
        continue;
      }
      const SurfacePoint at = s.nearest.pointOf(foot);
      Sources source;
      source.points = { plainPoint(s.mesh, at) };
      const double distance =
        bruteForceDistances(s.plain.mesh, source, { plainPoint(s.mesh, s.points[i]) }).queries[0];
      const double error = std::abs(distance - s.truth[i]) / s.largest;
      EXPECT_LE(error, accuracyOn(kind()))
        << kind().name << ", seed " << seed << ", point " << i << ", curve " << foot.curve << " at "
        << foot.place << ", distance " << distance << ", truth " << s.truth[i];
      worst = std::max(worst, error);
    }
  }
  std::cout << "worst relative error of the foot on " << kind().name << ": " << worst << "\n";
}

// A short step against the gradient, in the face that the path comes through, lowers the distance
// by its length.
TEST_P(NearestSources, AreComeNearerToAgainstTheGradient)
{
  double worst = 0.0;
  for (std::uint64_t seed = 0; seed < MeshesOfAKind; ++seed)
  {
    Solved s(kind(), seed, at());
    std::vector<MeshPoint> steps;
    std::vector<std::size_t> of;
    std::vector<double> lengths;
    for (std::size_t i = 0; i < s.points.size(); ++i)
    {
      const LastPiece piece = geodesic::lastPieceTo(s.field, s.points[i]);
      const geodesic::Vec3 gradient = geodesic::gradientOf(s.mesh, piece);
      const bool isOff = s.truth[i] < geodesic::Infinity && s.truth[i] > 1e-9 * s.largest;
      if (!isOff)
      {
        continue;
      }
      const double size = geodesic::norm(gradient);
      ASSERT_NEAR(size, 1.0, 1e-14) << kind().name << ", seed " << seed << ", point " << i;
      // The step in barycentric coordinates, by the frame of the piece.
      const Id face = geodesic::TriangleMesh::faceOf(piece.frame);
      const geodesic::Barycentric at =
        geodesic::barycentric(s.mesh, inFaceOrAtCorner(s.mesh, s.points[i], face), face);
      const double pieceLength = geodesic::norm(piece.direction);
      const geodesic::FaceShape& shape = s.mesh.shape(face);
      const double step = 1e-3 * std::min(shape.area2 / shape.longest(), s.truth[i]);
      geodesic::Vec2 corners[3];
      for (std::size_t k = 0; k < 3; ++k)
      {
        corners[k] = geodesic::inHalfedgeFrame(s.mesh, piece.frame, geodesic::cornerWeights(k));
      }
      const geodesic::Vec2 move = (-step / pieceLength) * piece.direction;
      geodesic::Barycentric change;
      double part = 1.0; // of the step, to stay in the face
      for (std::size_t k = 0; k < 3; ++k)
      {
        const geodesic::Vec2 edge = corners[(k + 2) % 3] - corners[(k + 1) % 3];
        change[k] = geodesic::cross(edge, move) / shape.area2;
        part = at[k] + change[k] < -1e-12 ? std::min(part, -at[k] / change[k]) : part;
      }
      // A point may lie a rounding beside an edge or a vertex, but a vertex has all of its step.
      const bool isVertex = s.points[i].kind == SurfacePoint::Kind::Vertex;
      EXPECT_GE(part, isVertex ? 1.0 - 1e-6 : 0.0)
        << "the step leaves the face: " << kind().name << ", seed " << seed << ", point " << i;
      geodesic::Barycentric moved;
      for (std::size_t k = 0; k < 3; ++k)
      {
        moved[k] = std::max(at[k] + part * change[k], 0.0);
      }
      steps.push_back({ face, moved });
      of.push_back(i);
      lengths.push_back(part * step);
    }
    const BruteForceResult truth =
      bruteForceDistances(s.plain.mesh, toSources(s.plain.curves), steps);
    for (std::size_t n = 0; n < of.size(); ++n)
    {
      const double lowered = s.truth[of[n]] - truth.queries[n];
      const double error = std::abs(lowered - lengths[n]) / s.largest;
      EXPECT_LE(error, accuracyOn(kind()))
        << kind().name << ", seed " << seed << ", point " << of[n] << ": lowered by " << lowered
        << ", step " << lengths[n];
      worst = std::max(worst, error);
    }
  }
  std::cout << "worst relative error of a step on " << kind().name << ": " << worst << "\n";
}

INSTANTIATE_TEST_SUITE_P(Kinds, NearestSources,
  ::testing::Combine(
    ::testing::ValuesIn(meshKinds()), ::testing::Values(At::VerticesAndQueries, At::RefinedPoints)),
  [](const auto& instance)
  {
    const bool isRefined = std::get<1>(instance.param) == At::RefinedPoints;
    return std::string(std::get<0>(instance.param).name) + (isRefined ? "Refined" : "");
  });

namespace
{

/// A region of an oriented mesh, the points where a function that is linear in each face is
/// positive, and its rim: pieces of curves that run with the region to their left, or, reversed, to
/// their right. The rim crosses faces, follows edges and goes through vertices.
class Region
{
public:
  Region(const PlainMesh& mesh, Random& random)
    : mesh_(mesh)
    , values_(mesh.points.size())
  {
    // Few levels, so that many vertices are at 0.
    const bool isSmooth = random.chance(0.5);
    const bool isCoarse = random.chance(0.5);
    const Vec3 centre = mesh.points[random.below(mesh.points.size())];
    const double radius =
      random.uniform(0.1, 0.9) * spaceDistance(centre, mesh.points[random.below(values_.size())]);
    for (std::size_t v = 0; v < values_.size(); ++v)
    {
      const double smooth = radius - spaceDistance(centre, mesh.points[v]);
      const double any = isSmooth ? smooth / (radius + 1e-300) : random.uniform(-1.0, 1.0);
      values_[v] = isCoarse ? std::round(1.6 * any) : any;
    }
    findSegments();
    joinSegments(random);
  }

  const std::vector<Polyline>& curves() const { return curves_; }
  bool isReversed(Id curve) const { return isReversed_[curve]; }

  /// Whether a point is in the region; a point on the rim may be either.
  bool contains(const MeshPoint& point) const
  {
    const Triangle& t = mesh_.triangles[point.face];
    double value = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      value += point.weights[k] * values_[t[k]];
    }
    // An edge at 0 between two faces of the region is no rim.
    const bool isFaceIn =
      std::any_of(t.begin(), t.end(), [&](Index v) { return values_[v] > 0.0; });
    return value > 0.0 || (value == 0.0 && isFaceIn);
  }

private:
  /// Where a rim segment begins or ends: a vertex, twice, or an edge.
  using Place = std::pair<Index, Index>;

  struct Segment
  {
    MeshSegment inFace;
    Place from;
    Place to;
  };

  Place addEnd(Index face, std::size_t k, Barycentric& weights) const
  {
    const Triangle& t = mesh_.triangles[face];
    const Index a = t[k];
    const Index b = t[(k + 1) % 3];
    if (values_[a] == 0.0)
    {
      weights[k] = 1.0;
      return { a, a };
    }
    const bool isAscending = a < b; // the same bits in both faces
    const double low = values_[isAscending ? a : b];
    const double high = values_[isAscending ? b : a];
    // Counted from either end it is the same point, to the last bit.
    const double fraction = 1.0 - (1.0 - low / (low - high));
    weights[k] = isAscending ? 1.0 - fraction : fraction;
    weights[(k + 1) % 3] = isAscending ? fraction : 1.0 - fraction;
    return { std::min(a, b), std::max(a, b) };
  }

  // With the region to the left a segment leaves where the value rises, and ends where it falls, on
  // the way around the face: rotated by a quarter, the gradient points to its left.
  void findSegments()
  {
    std::map<Place, Index> negativeBeside; // faces beyond edges at 0, by the halfedge of the other
    for (Index f = 0; f < mesh_.triangles.size(); ++f)
    {
      const Triangle& t = mesh_.triangles[f];
      if (std::none_of(t.begin(), t.end(), [&](Index v) { return values_[v] > 0.0; }))
      {
        for (std::size_t k = 0; k < 3; ++k)
        {
          negativeBeside[{ t[(k + 1) % 3], t[k] }] = f;
        }
      }
    }
    for (Index f = 0; f < mesh_.triangles.size(); ++f)
    {
      const Triangle& t = mesh_.triangles[f];
      const auto value = [&](std::size_t k) { return values_[t[k % 3]]; };
      Segment segment;
      segment.inFace = { f, { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 } };
      bool isThere = false;
      for (std::size_t k = 0; k < 3; ++k)
      {
        if (value(k) == 0.0 && value(k + 1) == 0.0 && value(k + 2) > 0.0)
        {
          if (negativeBeside.count({ t[k], t[(k + 1) % 3] }) != 0)
          {
            segment.from = addEnd(f, k, segment.inFace.from);
            segment.to = addEnd(f, (k + 1) % 3, segment.inFace.to);
            segments_.push_back(segment);
          }
        }
      }
      const bool hasPositive = value(0) > 0.0 || value(1) > 0.0 || value(2) > 0.0;
      const bool hasNegative = value(0) < 0.0 || value(1) < 0.0 || value(2) < 0.0;
      if (!hasPositive || !hasNegative)
      {
        continue;
      }
      for (std::size_t k = 0; k < 3; ++k)
      {
        // Out of the region along the halfedge: the segment begins there, as the region is then to
        // the left of the way across the face.
        const bool falls = (value(k) > 0.0 && value(k + 1) < 0.0) ||
          (value(k) == 0.0 && value(k + 1) < 0.0 && value(k + 2) > 0.0);
        const bool rises = (value(k) < 0.0 && value(k + 1) > 0.0) ||
          (value(k) == 0.0 && value(k + 1) > 0.0 && value(k + 2) < 0.0);
        if (falls)
        {
          segment.from = addEnd(f, k, segment.inFace.from);
          isThere = true;
        }
        if (rises)
        {
          segment.to = addEnd(f, k, segment.inFace.to);
        }
      }
      if (isThere)
      {
        segments_.push_back(segment);
      }
    }
  }

  // Pieces of random lengths, half of them run the other way.
  void joinSegments(Random& random)
  {
    std::map<Place, std::vector<std::size_t>> leaving;
    for (std::size_t s = 0; s < segments_.size(); ++s)
    {
      leaving[segments_[s].from].push_back(s);
    }
    std::vector<bool> isDone(segments_.size(), false);
    const double goOn = random.chance(0.3) ? 1.0 : random.uniform(0.3, 0.95);
    for (std::size_t first = 0; first < segments_.size(); ++first)
    {
      if (isDone[first])
      {
        continue;
      }
      Polyline curve;
      for (std::size_t s = first; s < segments_.size();)
      {
        isDone[s] = true;
        curve.segments.push_back(segments_[s].inFace);
        const std::vector<std::size_t>& next = leaving[segments_[s].to];
        const auto free =
          std::find_if(next.begin(), next.end(), [&](auto n) { return !isDone[n]; });
        s = free != next.end() && random.chance(goOn) ? *free : segments_.size();
      }
      isReversed_.push_back(random.chance(0.5));
      curves_.push_back(isReversed_.back() ? reversed(curve) : curve);
    }
  }

  const PlainMesh& mesh_;
  std::vector<double> values_;
  std::vector<Segment> segments_;
  std::vector<Polyline> curves_;
  std::vector<bool> isReversed_;
};

/// As putOntoSurface() has them: all curves have a point on an edge by the same halfedge.
std::vector<geodesic::SourceCurve> curvesWithSharedPoints(
  const geodesic::TriangleMesh& mesh, const std::vector<Polyline>& lines)
{
  std::vector<geodesic::SourceCurve> curves = engineCurves(mesh, lines);
  for (geodesic::SourceCurve& curve : curves)
  {
    for (SurfacePoint& point : curve.points)
    {
      if (point.kind == SurfacePoint::Kind::Edge)
      {
        const Id edge = mesh.edgeOf(point.id);
        const bool isSame = mesh.origin(edge) == mesh.origin(point.id);
        point = SurfacePoint::onEdge(edge, isSame ? point.u : 1.0 - point.u);
      }
    }
  }
  return curves;
}

/// Turns faces so that neighbours have one orientation, as far as that goes.
PlainMesh oriented(PlainMesh mesh)
{
  std::map<std::pair<Index, Index>, std::vector<Index>> facesOfEdge;
  for (Index f = 0; f < mesh.triangles.size(); ++f)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      facesOfEdge[std::minmax(mesh.triangles[f][k], mesh.triangles[f][(k + 1) % 3])].push_back(f);
    }
  }
  const auto runs = [&](Index f, Index a, Index b)
  {
    const Triangle& t = mesh.triangles[f];
    return (t[0] == a && t[1] == b) || (t[1] == a && t[2] == b) || (t[2] == a && t[0] == b);
  };
  std::vector<bool> isDone(mesh.triangles.size(), false);
  for (Index first = 0; first < mesh.triangles.size(); ++first)
  {
    std::vector<Index> waiting;
    if (!isDone[first])
    {
      waiting.push_back(first);
      isDone[first] = true;
    }
    while (!waiting.empty())
    {
      const Index f = waiting.back();
      waiting.pop_back();
      const Triangle t = mesh.triangles[f];
      for (std::size_t k = 0; k < 3; ++k)
      {
        for (const Index other : facesOfEdge[std::minmax(t[k], t[(k + 1) % 3])])
        {
          if (!isDone[other])
          {
            if (runs(other, t[k], t[(k + 1) % 3]))
            {
              std::swap(mesh.triangles[other][1], mesh.triangles[other][2]);
            }
            isDone[other] = true;
            waiting.push_back(other);
          }
        }
      }
    }
  }
  return mesh;
}

/// Whether all faces have one orientation and those around each vertex follow one another.
bool isOrientedManifold(const PlainMesh& mesh)
{
  std::map<std::pair<Index, Index>, Index> nextAround; // the next spoke, by vertex and spoke
  std::vector<std::size_t> corners(mesh.points.size(), 0);
  for (const Triangle& t : mesh.triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const bool isNew = nextAround.insert({ { t[k], t[(k + 1) % 3] }, t[(k + 2) % 3] }).second;
      if (!isNew)
      {
        return false;
      }
      ++corners[t[k]];
    }
  }
  std::map<std::pair<Index, Index>, Index> before;
  for (const auto& [at, next] : nextAround)
  {
    before[{ at.first, next }] = at.second;
  }
  for (const auto& [at, next] : nextAround)
  {
    // From a corner at which nothing ends before, or from any.
    Index begin = at.second;
    for (std::size_t n = 0; n < corners[at.first] && before.count({ at.first, begin }) != 0; ++n)
    {
      begin = before[{ at.first, begin }];
    }
    std::size_t count = 0;
    for (auto corner = nextAround.find({ at.first, begin });
         corner != nextAround.end() && count <= corners[at.first];
         corner = nextAround.find({ at.first, corner->second }))
    {
      ++count;
      if (corner->second == begin)
      {
        break;
      }
    }
    if (count != corners[at.first])
    {
      return false;
    }
  }
  return true;
}

class SidesOfRegions : public ::testing::TestWithParam<MeshKind>
{
};

}

// No path leaves a region but over its rim, so that all shortest paths from the inside come to the
// rim from the region's side, and all from the outside from the other.
TEST_P(SidesOfRegions, AreInsideAndOutside)
{
  std::size_t told[2] = { 0, 0 };
  for (std::uint64_t seed = 0; seed < MeshesOfAKind; ++seed)
  {
    Random random(seed + 64000);
    const PlainMesh plain = oriented(compacted(GetParam().make(randomSize(random), random)));
    if (!isOrientedManifold(plain))
    {
      continue;
    }
    const Region region(plain, random);
    if (region.curves().empty())
    {
      continue;
    }
    const geodesic::TriangleMesh mesh = engineMesh(plain);
    const std::vector<geodesic::SourceCurve> curves = curvesWithSharedPoints(mesh, region.curves());
    const geodesic::DistanceField field = solveWithArrivals(mesh, curves);
    const double largest = largestFinite(field.vertexDistances());
    NearestSource nearest(field, curves);
    const auto expectSide = [&](const MeshPoint& point, const Foot& foot, double distance)
    {
      if (!foot.isKnown() || distance < 1e-9 * largest)
      {
        return;
      }
      const bool isInside = region.contains(point);
      ++told[isInside ? 1 : 0];
      EXPECT_EQ(foot.isRight != region.isReversed(foot.curve), !isInside)
        << GetParam().name << ", seed " << seed << ", face " << point.face << ", distance "
        << distance << ", curve " << foot.curve << " at " << foot.place;
    };
    for (Index vertex = 0; vertex < plain.points.size(); ++vertex)
    {
      expectSide(
        vertexPoint(plain, vertex), nearest.atVertex(vertex), field.vertexDistances()[vertex]);
    }
    for (const MeshPoint& query : randomPoints(plain, 4 * NumberOfQueries, random))
    {
      const SurfacePoint at = geodesic::normalized(mesh, enginePoint(mesh, query));
      expectSide(query, nearest.of(geodesic::lastPieceTo(field, at)), field.distance(at));
    }
  }
  const std::string name = GetParam().name;
  const bool hasSides = name != "MoebiusStrip" && name != "Book" && name != "FlatBook" &&
    name != "BowTie" && name != "SaddleFans";
  EXPECT_EQ(hasSides, told[0] > 0 && told[1] > 0);
  std::cout << name << ": " << told[1] << " points inside, " << told[0] << " outside\n";
}

INSTANTIATE_TEST_SUITE_P(Kinds, SidesOfRegions, ::testing::ValuesIn(meshKinds()),
  [](const auto& instance) { return std::string(instance.param.name); });

// Parallel rays of neighbors stay one window: cells of a line cost no more than the line.
TEST(NearestSource, ALineOfManyCurvesIsOneToTheFront)
{
  const geodesic::TriangleMesh mesh = engineMesh(regularGrid(16, 16));
  const auto along = [&](double from, double to)
  {
    geodesic::SourceCurve curve;
    curve.points = { SurfacePoint::inFace(0, 0.0, 0.0), SurfacePoint::inFace(0, 0.0, 0.0) };
    const geodesic::Barycentric a = { 0.7 - 0.4 * from, 0.1 + 0.4 * from, 0.2 };
    const geodesic::Barycentric b = { 0.7 - 0.4 * to, 0.1 + 0.4 * to, 0.2 };
    curve.points[0] = geodesic::fromBarycentric(mesh, 0, a);
    curve.points[1] = geodesic::fromBarycentric(mesh, 0, b);
    curve.faces = { 0 };
    curve.isCut = { 0, 0 };
    return curve;
  };
  constexpr int count = 20;
  std::vector<geodesic::SourceCurve> parts;
  for (int i = 0; i < count; ++i)
  {
    const double begin = i / static_cast<double>(count);
    const double end = (i + 1) / static_cast<double>(count);
    parts.push_back(i % 3 == 1 ? along(end, begin) : along(begin, end));
  }
  const geodesic::DistanceField whole = solveWithArrivals(mesh, { along(0.0, 1.0) });
  const geodesic::DistanceField field = solveWithArrivals(mesh, parts);
  // Each part goes through the few edges around its face on its own.
  EXPECT_LE(field.windowsPropagated(), whole.windowsPropagated() + 12 * count);
  EXPECT_LE(worstError(field.vertexDistances(), whole.vertexDistances(), 16.0), OrdinaryAccuracy);

  // Each of the parts is the nearest to what lies beside its middle, on the side that it sees.
  NearestSource nearest(field, parts);
  for (int i = 0; i < count; ++i)
  {
    const double middle = (i + 0.5) / count;
    for (const bool above : { false, true })
    {
      geodesic::Barycentric place = { 0.7 - 0.4 * middle, 0.1 + 0.4 * middle, 0.2 };
      const double change = above ? 0.05 : -0.05; // at right angles to the first halfedge
      const geodesic::FaceShape& shape = mesh.shape(0);
      const double foot = shape.cornerDot[0] / (shape.length[0] * shape.length[0]);
      place[2] += change;
      place[1] -= change * foot;
      place[0] -= change * (1.0 - foot);
      const Foot found =
        nearest.of(geodesic::lastPieceTo(field, geodesic::fromBarycentric(mesh, 0, place)));
      EXPECT_EQ(found.curve, static_cast<Id>(i));
      EXPECT_EQ(found.isRight, above == (i % 3 == 1)) << "part " << i << (above ? " above" : "");
    }
  }
}
