// SPDX-License-Identifier: BSD-3-Clause
// The nearest source, the foot of a shortest path, its side and the gradient: compared with brute
// force from one curve alone, from the foot alone, and a short step against the gradient.
#include "CaseWithoutTruth.h"
#include "EngineSupport.h"
#include "truth/RandomMeshKinds.h"

#include "field/NearestSource.h"
#include "refinement/AdaptiveRefinement.h"
#include "refinement/SolveForRefinement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <string>
#include <utility>

using namespace geodesictest;
using geodesic::Foot;
using geodesic::Id;
using geodesic::IncomingSegment;
using geodesic::NearestSource;
using geodesic::RayOrigin;
using geodesic::SurfacePoint;

namespace
{

constexpr std::uint64_t MeshesOfAKind = meshesOfAKind(6);
constexpr std::size_t NumberOfQueries = 40;
constexpr std::size_t FeetTried = 6;
/// Brute force takes more than half of the time, and longer on large meshes.
constexpr Index MostFaces = 150;
/// Relative to edges of length 1.
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
  /// Some of the points that refinement adds, with the windows that it keeps.
  RefinedPoints
};

geodesic::DistanceField solveFor(
  At at, const geodesic::TriangleMesh& mesh, const std::vector<geodesic::SourceCurve>& curves)
{
  geodesic::FrontOptions options;
  options.keepArrivals = true;
  return at == At::RefinedPoints
    ? solveForRefinement(mesh, curves, RefinementTolerance, options)
    : geodesic::solve(mesh, curves, options, geodesic::KeepWindows::All);
}

/// A point of a face as it is; a point of another face within rounding of a corner, as that corner.
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

/// A random case, solved, and its query points.
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

  Solved(RandomCase c, At at)
    : plain(std::move(c))
    , mesh(engineMesh(plain.mesh))
    , curves(engineCurves(mesh, plain.curves))
    , field(solveFor(at, mesh, curves))
    , nearest(field, geodesic::ReplicatedPatch(mesh), curves)
    , largest(largestFinite(field.vertexDistances()))
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
      : nearest.of(geodesic::incomingSegmentTo(field, points[i]));
  }
};

/// The first seeds, and those of cases that once failed: at a spine, a ray from within rounding of
/// a corner; in a sheet, a point in its own face within rounding of a vertex; across needles, a
/// path shorter than the rounding of their edges.
std::vector<std::uint64_t> seedsOf(const MeshKind& kind)
{
  std::vector<std::uint64_t> seeds(MeshesOfAKind);
  std::iota(seeds.begin(), seeds.end(), std::uint64_t(0));
  const std::map<std::string, std::uint64_t> failed = { { "Book", 502006 }, { "FlatBook", 502006 },
    { "WildSheet", 503009 }, { "Needles", 511006 } };
  const auto own = failed.find(kind.name);
  if (own != failed.end())
  {
    seeds.push_back(own->second);
  }
  return seeds;
}

// The distance from the nearest curve alone equals the field's.
void expectCurvesAsFar(Solved& s, double accuracy)
{
  std::vector<std::vector<double>> alone;
  for (const Polyline& curve : s.plain.curves)
  {
    alone.push_back(s.distancesFrom(curve));
  }
  for (std::size_t i = 0; i < s.points.size(); ++i)
  {
    const Foot foot = s.footAt(i);
    ASSERT_EQ(foot.isKnown(), s.truth[i] < geodesic::Infinity) << "point " << i;
    EXPECT_TRUE(
      !foot.isKnown() || std::abs(alone[foot.curve][i] - s.truth[i]) <= accuracy * s.largest)
      << "point " << i << ", curve " << foot.curve;
  }
}

// The distance from the foot alone equals the field's.
void expectFeetAsFar(Solved& s, double accuracy, Random& random)
{
  for (std::size_t n = 0; n < FeetTried; ++n)
  {
    const std::size_t i = random.below(s.points.size());
    const Foot foot = s.footAt(i);
    if (!foot.isKnown())
    {
      continue;
    }
    Sources source;
    source.points = { plainPoint(s.mesh, s.nearest.pointOf(foot)) };
    BruteForceOptions options;
    options.maximumDistance = 1.001 * s.truth[i];
    const double distance =
      bruteForceDistances(s.plain.mesh, source, { plainPoint(s.mesh, s.points[i]) }, options)
        .queries[0];
    EXPECT_LE(std::abs(distance - s.truth[i]), accuracy * s.largest)
      << "point " << i << ", curve " << foot.curve << " at " << foot.parameter << ", distance "
      << distance << ", truth " << s.truth[i];
  }
}

// A short step against the gradient, in the face that the path comes through, lowers the distance
// by the step's length.
void expectGradientsRight(const Solved& s, double accuracy)
{
  std::vector<MeshPoint> steps;
  std::vector<std::size_t> of;
  std::vector<double> lengths;
  for (std::size_t i = 0; i < s.points.size(); ++i)
  {
    const IncomingSegment piece = geodesic::incomingSegmentTo(s.field, s.points[i]);
    const geodesic::Vec3 gradient = geodesic::gradientOf(s.mesh, piece);
    const bool isOff = s.truth[i] < geodesic::Infinity && s.truth[i] > 1e-9 * s.largest;
    if (!isOff)
    {
      continue;
    }
    const double size = geodesic::norm(gradient);
    ASSERT_NEAR(size, 1.0, 1e-14) << "point " << i;
    // The step in barycentric coordinates, by the frame of the piece.
    const Id face = geodesic::TriangleMesh::faceOf(piece.ray.halfedge);
    const geodesic::Barycentric at =
      geodesic::barycentric(s.mesh, inFaceOrAtCorner(s.mesh, s.points[i], face), face);
    const double pieceLength = geodesic::norm(piece.ray.vector);
    const geodesic::FaceShape& shape = s.mesh.shape(face);
    const double step = 1e-3 * std::min(shape.area2 / shape.longest(), s.truth[i]);
    geodesic::Vec2 corners[3];
    for (std::size_t k = 0; k < 3; ++k)
    {
      corners[k] =
        geodesic::inHalfedgeFrame(s.mesh, piece.ray.halfedge, geodesic::cornerWeights(k));
    }
    const geodesic::Vec2 move = (-step / pieceLength) * piece.ray.vector;
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
    EXPECT_GE(part, isVertex ? 1.0 - 1e-6 : 0.0) << "the step leaves the face: point " << i;
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
    EXPECT_LE(std::abs(lowered - lengths[n]), accuracy * s.largest)
      << "point " << of[n] << ": lowered by " << lowered << ", step " << lengths[n];
  }
}

class NearestSources : public ::testing::TestWithParam<std::tuple<MeshKind, At>>
{
};

} // anonymous namespace

TEST_P(NearestSources, AreAsFarAsTheFieldInTheDirectionOfItsGradient)
{
  const auto& [kind, at] = GetParam();
  for (const std::uint64_t seed : seedsOf(kind))
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const bool isOrdinary = seed < MeshesOfAKind;
    const Index most = isOrdinary ? MostFaces : std::numeric_limits<Index>::max();
    Solved s(at == At::RefinedPoints ? caseWithoutTruth(kind, seed, NumberOfQueries, most)
                                     : randomCase(kind, seed, NumberOfQueries, most),
      at);
    Random random(seed);
    expectCurvesAsFar(s, accuracyOn(kind));
    expectFeetAsFar(s, accuracyOn(kind), random);
    expectGradientsRight(s, accuracyOn(kind));
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, NearestSources,
  ::testing::Combine(
    ::testing::ValuesIn(meshKinds()), ::testing::Values(At::VerticesAndQueries, At::RefinedPoints)),
  [](const auto& instance)
  {
    const bool isRefined = std::get<1>(instance.param) == At::RefinedPoints;
    return std::string(std::get<0>(instance.param).name) + (isRefined ? "Refined" : "");
  });

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
  NearestSource nearest(field, geodesic::ReplicatedPatch(field.mesh()), parts);
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
        nearest.of(geodesic::incomingSegmentTo(field, geodesic::fromBarycentric(mesh, 0, place)));
      EXPECT_EQ(found.curve, static_cast<Id>(i));
      EXPECT_EQ(found.isRight, above == (i % 3 == 1)) << "part " << i << (above ? " above" : "");
    }
  }
}

// Vertex 1 is a rounding beside vertex 0, which is one beside the source: the path to vertex 1
// comes from vertex 0, and that to vertex 0 not from vertex 1.
TEST(NearestSource, IsKnownWhereVerticesAreARoundingApart)
{
  PlainMesh plain;
  plain.points = { { 0, 0, 0 }, { -1e-16, 0, 0 }, { 1, -1, 0 }, { 1, 1, 0 }, { -1, 1, 0 },
    { -1, -1, 0 } };
  plain.triangles = { { 0, 2, 3 }, { 0, 3, 1 }, { 1, 3, 4 }, { 1, 4, 5 }, { 1, 5, 2 },
    { 1, 2, 0 } };
  const geodesic::TriangleMesh mesh = engineMesh(plain);
  const std::vector<geodesic::SourceCurve> curves = { geodesic::pointCurve(
    SurfacePoint::inFace(0, 1e-17, 1e-17)) };
  const geodesic::DistanceField field = solveWithArrivals(mesh, curves);
  const NearestSource nearest(field, geodesic::ReplicatedPatch(field.mesh()), curves);
  for (Id vertex = 0; vertex < mesh.numberOfVertices(); ++vertex)
  {
    EXPECT_EQ(nearest.atVertex(vertex).curve, 0U) << "vertex " << vertex;
  }
}

// Where rounding hides where a path came through, two vertices may each name the other. The engine
// must still find what comes from elsewhere.
TEST(NearestSource, IsSoughtNoLongerWhereTwoVerticesNameEachOther)
{
  const geodesic::TriangleMesh mesh = engineMesh(regularGrid(4, 1));
  const std::vector<geodesic::SourceCurve> curves = { geodesic::pointCurve(
    SurfacePoint::atVertex(0)) };
  geodesic::FrontOptions options;
  options.keepArrivals = true;
  geodesic::KeepNone none;
  geodesic::FrontResult front = geodesic::propagate(mesh, curves, options, none);
  // Vertices 4 and 9 are the ends of the last edge.
  const Id edge = mesh.halfedgeBetween(4, 9);
  const Id next = geodesic::TriangleMesh::nextInFace(edge);
  const Id previous = geodesic::TriangleMesh::previousInFace(edge);
  front.arrivals[mesh.origin(edge)] = { next,
    RayOrigin::vertex(geodesic::GlobalId{ mesh.destination(edge) }), 0.0 };
  front.arrivals[mesh.destination(edge)] = { previous,
    RayOrigin::vertex(geodesic::GlobalId{ mesh.origin(edge) }), mesh.length(previous) };
  const geodesic::DistanceField field(geodesic::MeshPartition(mesh), std::move(front), {});
  const NearestSource nearest(field, geodesic::ReplicatedPatch(field.mesh()), curves);
  for (Id vertex = 0; vertex < mesh.numberOfVertices(); ++vertex)
  {
    EXPECT_EQ(nearest.atVertex(vertex).isKnown(), vertex != 4 && vertex != 9) << vertex;
  }
}
