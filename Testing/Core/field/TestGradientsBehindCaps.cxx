// SPDX-License-Identifier: BSD-3-Clause
// The direction of the distance where paths come through faces without area, which close
// T-vertices: against the plane's directions, and against the same mesh with the T-vertices split.
#include "RanksSupport.h"
#include "Seeds.h"

#include "field/Gradients.h"
#include "field/IncomingSegment.h"
#include "front/Retention.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace geodesictest;
using geodesic::Id;
using geodesic::SurfacePoint;
using geodesic::TriangleMesh;

namespace
{

constexpr std::uint64_t FirstSeed = 87000;
constexpr std::uint64_t Meshes = 200;
constexpr std::uint64_t CutMeshes = 60;

/// The largest number of T-vertices on one edge. With many, some caps touch only other caps.
constexpr Index FewPlaces = 3;
constexpr Index ManyPlaces = 9;

/// Directions are not compared at points closer to the source than this; edges have length 1.
constexpr double NearSource = 0.01;

/// The engine treats two paths as equally long if their lengths differ by less than a tie (1e-12 of
/// the distance); their directions then differ by about the root of that. The worst of 3,300,000
/// directions was off by 4e-6, and all but six were right to 1e-9.
constexpr double Accuracy = 1e-5;

/// A mesh with T-vertices on some edges, and the same surface without them. The faces on one side
/// of such an edge have its T-vertices as corners, the face on the other side does not, and caps
/// (faces without area) close the gap. Vertices have the same numbers in both meshes.
struct CappedMesh
{
  PlainMesh capped;
  PlainMesh split;
  Index firstCap;
};

/// Triangulates a polygon without area, whose corners lie in a row, in a random way.
void addCaps(const std::vector<Index>& row, Random& random, std::vector<Triangle>& caps)
{
  if (row.size() < 3)
  {
    return;
  }
  const std::size_t middle = 1 + random.below(row.size() - 2);
  const auto at = row.begin() + static_cast<std::ptrdiff_t>(middle);
  caps.push_back({ row.front(), row.back(), row[middle] });
  addCaps({ row.begin(), at + 1 }, random, caps);
  addCaps({ at, row.end() }, random, caps);
}

/// The fan of a face with a row of vertices on one of its edges.
void addFan(const std::vector<Index>& row, Index apex, std::vector<Triangle>& triangles)
{
  for (std::size_t i = 0; i + 1 < row.size(); ++i)
  {
    triangles.push_back({ row[i], row[i + 1], apex });
  }
}

/// A halfedge of a mesh: its face and the corner where it begins.
struct FaceEdge
{
  Index face;
  std::size_t corner;
};

/// Edges of two faces, no two of them in one face.
std::vector<std::pair<FaceEdge, FaceEdge>> someEdges(const PlainMesh& mesh, Random& random)
{
  std::map<std::pair<Index, Index>, std::vector<FaceEdge>> around;
  for (Index face = 0; face < mesh.triangles.size(); ++face)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Triangle& t = mesh.triangles[face];
      around[std::minmax(t[k], t[(k + 1) % 3])].push_back({ face, k });
    }
  }
  std::set<Index> taken;
  std::vector<std::pair<FaceEdge, FaceEdge>> edges;
  for (const auto& [ends, faces] : around)
  {
    if (faces.size() == 2 && taken.count(faces[0].face) + taken.count(faces[1].face) == 0 &&
      random.chance(0.6))
    {
      const std::size_t side = random.below(2);
      edges.emplace_back(faces[side], faces[1 - side]);
      taken.insert({ faces[0].face, faces[1].face });
    }
  }
  return edges;
}

/// Some places on a segment.
std::vector<Vec3> placesBetween(const Vec3& a, const Vec3& b, Index most, Random& random)
{
  std::set<double> fractions;
  for (Index i = random.between(1, most); i > 0; --i)
  {
    // The sixteenths of a grid's edges have exact coordinates.
    fractions.insert(random.chance(0.5) ? random.uniform(0.1, 0.9) : random.between(2, 14) / 16.0);
  }
  std::vector<Vec3> places;
  for (const double t : fractions)
  {
    places.push_back(a);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      places.back()[axis] = (1.0 - t) * a[axis] + t * b[axis];
    }
  }
  return places;
}

CappedMesh withCaps(const PlainMesh& mesh, Index mostPlaces, Random& random)
{
  CappedMesh result{ mesh, mesh, 0 };
  std::vector<Triangle> caps;
  std::set<Index> taken;
  for (const auto& [with, without] : someEdges(mesh, random))
  {
    const Triangle& t = mesh.triangles[with.face];
    const Triangle& other = mesh.triangles[without.face];
    const Index a = t[with.corner];
    const Index b = t[(with.corner + 1) % 3];
    std::vector<Index> row = { a };
    for (const Vec3& p : placesBetween(mesh.points[a], mesh.points[b], mostPlaces, random))
    {
      row.push_back(static_cast<Index>(result.capped.points.size()));
      result.capped.points.push_back(p);
    }
    row.push_back(b);
    addCaps(row, random, caps);
    std::vector<Triangle> fan;
    addFan(row, t[(with.corner + 2) % 3], fan);
    std::reverse(row.begin(), row.end()); // as the other face's edge runs, but where that is turned
    std::vector<Triangle> otherFan;
    addFan(row, other[(without.corner + 2) % 3], otherFan);
    for (PlainMesh* each : { &result.capped, &result.split })
    {
      each->triangles[with.face] = fan.front();
      each->triangles.insert(each->triangles.end(), fan.begin() + 1, fan.end());
    }
    result.split.triangles[without.face] = otherFan.front();
    result.split.triangles.insert(
      result.split.triangles.end(), otherFan.begin() + 1, otherFan.end());
  }
  result.firstCap = static_cast<Index>(result.capped.triangles.size());
  result.capped.triangles.insert(result.capped.triangles.end(), caps.begin(), caps.end());
  result.split.points = result.capped.points;
  return result;
}

geodesic::DistanceField solveWithArrivals(
  const TriangleMesh& mesh, const std::vector<geodesic::SourceCurve>& curves)
{
  geodesic::FrontOptions options;
  options.keepArrivals = true;
  return geodesic::solve(mesh, curves, options, geodesic::KeepWindows::All);
}

geodesic::Vec3 gradientAt(const geodesic::DistanceField& field, const SurfacePoint& point)
{
  return geodesic::gradientOf(field.mesh(), geodesic::incomingSegmentTo(field, point));
}

std::string nameOf(const SurfacePoint& point)
{
  return (point.kind == SurfacePoint::Kind::Vertex ? "vertex " : "point of ") +
    std::to_string(point.id);
}

/// A point of a face, or a segment in it, at least a tenth of the face's heights from its edges.
Polyline randomSource(Index face, Random& random)
{
  const auto place = [&random]
  {
    const double a = random.uniform(0.1, 0.8);
    const double b = random.uniform(0.1, 0.9 - a);
    return Barycentric{ 1.0 - a - b, a, b };
  };
  const Barycentric from = place();
  return { { { face, from, random.chance(0.5) ? from : place() } }, {} };
}

Vec3 nearestOnSegment(const Vec3& p, const Vec3& a, const Vec3& b)
{
  double along = 0.0;
  double squared = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    along += (p[axis] - a[axis]) * (b[axis] - a[axis]);
    squared += (b[axis] - a[axis]) * (b[axis] - a[axis]);
  }
  const double t = squared > 0.0 ? std::min(std::max(along / squared, 0.0), 1.0) : 0.0;
  Vec3 nearest = a;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    nearest[axis] += t * (b[axis] - a[axis]);
  }
  return nearest;
}

/// A flat mesh with caps, and a source in it.
struct FlatCase
{
  PlainMesh plain;
  Polyline source;
  /// Of the source.
  Vec3 a;
  Vec3 b;

  FlatCase(Index mostPlaces, Random& random)
  {
    const Index nx = random.between(2, 5);
    const Index ny = random.between(2, 5);
    const PlainMesh flat = random.chance(0.5) ? regularGrid(nx, ny) : randomPlanar(nx, ny, random);
    const CappedMesh capped =
      withCaps(random.chance(0.5) ? flat : moved(flat, random), mostPlaces, random);
    this->plain = capped.capped;
    this->source = randomSource(random.below(capped.firstCap), random);
    const MeshSegment& segment = this->source.segments.front();
    this->a = position(this->plain, { segment.face, segment.from });
    this->b = position(this->plain, { segment.face, segment.to });
  }

  /// The difference between a gradient and the direction at a point; 0 where the source is too
  /// close.
  double errorAt(const Vec3& p, const Vec3& gradient) const
  {
    const Vec3 from = nearestOnSegment(p, this->a, this->b);
    const double distance = spaceDistance(p, from);
    Vec3 expected{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      expected[axis] = (p[axis] - from[axis]) / distance;
    }
    return distance > NearSource ? spaceDistance(gradient, expected) : 0.0;
  }
};

/// The worst error at the vertices, over all ranks that have them.
class OnRanks
{
public:
  OnRanks(const FlatCase& flat, const CutMesh& cut)
    : case_(flat)
  {
    onRanks(cut, { flat.source }, 0, [this](const RankOfRun& rank) { this->ask(rank); });
  }

  double worst() const { return this->worst_; }

private:
  void ask(const RankOfRun& rank)
  {
    const TriangleMesh& mesh = rank.part.mesh();
    geodesic::FrontOptions options;
    options.keepArrivals = true;
    geodesic::KeepFaces all(mesh);
    geodesic::FrontResult front = propagate(rank.part, rank.sources, options, all);
    const geodesic::DistanceField field(rank.part, std::move(front), all.release());
    std::vector<geodesic::Vec3> found;
    geodesic::Gradients gradients(field, found);
    for (Id vertex = 0; vertex < rank.wholeVertices.size(); ++vertex)
    {
      gradients.add(geodesic::incomingSegmentTo(field, SurfacePoint::atVertex(vertex)));
    }
    gradients.finish();
    const std::lock_guard<std::mutex> lock(this->mutex_);
    for (Id vertex = 0; vertex < rank.wholeVertices.size(); ++vertex)
    {
      this->worst_ = std::max(this->worst_, this->case_.errorAt(mesh.point(vertex), found[vertex]));
    }
  }

  const FlatCase& case_;
  double worst_ = 0.0;
  std::mutex mutex_;
};

}

TEST(GradientsBehindCaps, InThePlaneLeadStraightAwayFromTheSource)
{
  double worst = 0.0;
  const Seeds seeds = seedsOfTest(Meshes);
  for (std::uint64_t seed = seeds.first; seed < seeds.end(); ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed + FirstSeed);
    const FlatCase flat(FewPlaces, random);
    const TriangleMesh mesh = engineMesh(flat.plain);
    const geodesic::DistanceField field =
      solveWithArrivals(mesh, { engineCurve(mesh, flat.source) });
    std::vector<SurfacePoint> points;
    for (Id vertex = 0; vertex < mesh.numberOfVertices(); ++vertex)
    {
      points.push_back(SurfacePoint::atVertex(vertex));
    }
    for (const MeshPoint& p : randomPoints(flat.plain, 20, random))
    {
      points.push_back(enginePoint(mesh, p));
    }
    for (const SurfacePoint& point : points)
    {
      const double error = flat.errorAt(geodesic::position(mesh, point), gradientAt(field, point));
      EXPECT_LE(error, Accuracy) << nameOf(point);
      worst = std::max(worst, error);
    }
  }
  std::cout << "worst direction off by " << worst << "\n";
}

// Other ranks may own the faces on both sides of a cap, and the caps behind it.
TEST(GradientsBehindCaps, AreTheSameOnRanks)
{
  double worst = 0.0;
  const Seeds seeds = seedsOfTest(CutMeshes);
  for (std::uint64_t seed = seeds.first; seed < seeds.end(); ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed + FirstSeed);
    const FlatCase flat(ManyPlaces, random);
    const OnRanks ranks(
      flat, cutAtRandom(flat.plain, static_cast<int>(random.between(2, 4)), random));
    EXPECT_LE(ranks.worst(), Accuracy);
    worst = std::max(worst, ranks.worst());
  }
  std::cout << "worst direction off by " << worst << "\n";
}

TEST(GradientsBehindCaps, OnCurvedMeshesAreThoseWithoutCaps)
{
  double worst = 0.0;
  const Seeds seeds = seedsOfTest(Meshes);
  for (std::uint64_t seed = seeds.first; seed < seeds.end(); ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed + FirstSeed);
    const Index nx = random.between(2, 5);
    const CappedMesh both = withCaps(random.chance(0.5)
        ? bumpySheet(nx, random.between(2, 5), 0, random.uniform(0.1, 1.0), random)
        : octasphere(nx),
      FewPlaces, random);
    const TriangleMesh capped = engineMesh(both.capped);
    const TriangleMesh split = engineMesh(both.split);
    std::vector<Index> faces; // of both
    for (Index face = 0; face < std::min(both.firstCap, split.numberOfFaces()); ++face)
    {
      if (both.capped.triangles[face] == both.split.triangles[face])
      {
        faces.push_back(face);
      }
    }
    const Polyline source = randomSource(faces[random.below(faces.size())], random);
    const geodesic::DistanceField behindCaps =
      solveWithArrivals(capped, { engineCurve(capped, source) });
    const geodesic::DistanceField truth = solveWithArrivals(split, { engineCurve(split, source) });
    std::vector<std::pair<SurfacePoint, SurfacePoint>> points;
    for (Id vertex = 0; vertex < capped.numberOfVertices(); ++vertex)
    {
      points.emplace_back(SurfacePoint::atVertex(vertex), SurfacePoint::atVertex(vertex));
    }
    for (Index i = 0; i < 20; ++i)
    {
      const MeshPoint p = { faces[random.below(faces.size())], randomWeights(random) };
      points.emplace_back(enginePoint(capped, p), enginePoint(split, p));
    }
    for (const auto& [onCapped, onSplit] : points)
    {
      const double distance = geodesic::incomingSegmentTo(truth, onSplit).distance;
      if (distance > NearSource)
      {
        EXPECT_NEAR(geodesic::incomingSegmentTo(behindCaps, onCapped).distance, distance, 1e-11);
        const double error =
          spaceDistance(gradientAt(behindCaps, onCapped), gradientAt(truth, onSplit));
        EXPECT_LE(error, Accuracy) << nameOf(onCapped);
        worst = std::max(worst, error);
      }
    }
  }
  std::cout << "worst direction off by " << worst << "\n";
}

// The faces on each side of an edge have their own vertex at the same place of the edge.
TEST(GradientsBehindCaps, OfTwoVerticesAtOnePlaceAreTheSame)
{
  PlainMesh plain;
  plain.points = { { 0.0, -1.0, 0.0 }, { 0.0, 1.0, 0.0 }, { -1.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 },
    { 0.0, 0.25, 0.0 }, { 0.0, 0.25, 0.0 } };
  plain.triangles = { { 0, 4, 2 }, { 4, 1, 2 }, { 1, 5, 3 }, { 5, 0, 3 }, { 0, 5, 4 },
    { 4, 5, 1 } };
  const TriangleMesh mesh = engineMesh(plain);
  for (const Index face : { 0U, 1U, 2U, 3U })
  {
    const MeshPoint place = { face, { 0.3, 0.2, 0.5 } };
    const geodesic::DistanceField field = solveWithArrivals(
      mesh, { engineCurve(mesh, { { { face, place.weights, place.weights } }, {} }) });
    const Vec3 from = position(plain, place);
    const double distance = spaceDistance(plain.points[4], from);
    for (const Id vertex : { 4U, 5U })
    {
      const geodesic::Vec3 gradient = gradientAt(field, SurfacePoint::atVertex(vertex));
      EXPECT_NEAR(gradient[0], -from[0] / distance, 1e-14);
      EXPECT_NEAR(gradient[1], (0.25 - from[1]) / distance, 1e-14);
    }
  }
}

// A cap whose middle corner is a rounding beside an end of its long edge: the ray passes the longer
// of the other two edges, whichever end that is and wherever it comes.
TEST(GradientsBehindCaps, RaysDoNotPassEdgesAsShortAsRounding)
{
  const double beside = std::numeric_limits<double>::epsilon();
  for (const bool isAtEnd : { false, true })
  {
    PlainMesh mesh;
    mesh.points = { { 1, 0, 0 }, { 2, 0, 0 }, { isAtEnd ? 2 - beside : 1 + beside, 0, 0 },
      { 1.5, -1, 0 }, { 1.5, 1, 0 }, { isAtEnd ? 2.5 : 0.5, 0.5, 0 } };
    mesh.triangles = { { 0, 1, 2 }, { 1, 0, 3 } };
    mesh.triangles.push_back(isAtEnd ? Triangle{ 0, 2, 4 } : Triangle{ 2, 1, 4 });
    mesh.triangles.push_back(isAtEnd ? Triangle{ 2, 1, 5 } : Triangle{ 0, 2, 5 });
    const TriangleMesh engine = engineMesh(mesh);
    ASSERT_TRUE(engine.shape(0).hasZeroArea());
    for (const double x : { 0.0, 0.5 * beside, beside, 0.5, 1.0 - beside, 1.0 - 0.5 * beside, 1.0 })
    {
      SCOPED_TRACE(std::string(isAtEnd ? "end" : "begin") + ", x " + std::to_string(x));
      const geodesic::IncomingRay ray =
        geodesic::backToDirectionInSpace(engine, { 0, true, x, { 0.6, -0.8 } });
      EXPECT_EQ(TriangleMesh::faceOf(ray.halfedge), 2U);
      const geodesic::Vec3 direction = inSpace(engine, ray.halfedge, ray.direction);
      EXPECT_NEAR(direction[0], 0.6, 1e-12);
      EXPECT_NEAR(direction[1], -0.8, 1e-12);
    }
  }
}
