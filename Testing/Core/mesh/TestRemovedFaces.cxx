// SPDX-License-Identifier: BSD-3-Clause
// Faces without area are removed before there is a mesh: distances on what is left are those by
// brute force on the same surface cut without them. GEODESIC_TEST_SEEDS=FIRST,COUNT takes other
// seeds.
#include "EngineSupport.h"
#include "RanksSupport.h"
#include "truth/CappedMeshes.h"

#include "front/Retention.h"
#include "mesh/FacesWithoutArea.h"
#include "source/SourceWindows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <mutex>
#include <ostream>
#include <set>
#include <string>

using namespace geodesictest;
using geodesic::Id;
using geodesic::SourceCurve;
using geodesic::SurfacePoint;
using geodesic::TriangleMesh;

namespace
{

/// The distances of a surface's points before its faces without area were removed.
///
/// \param curvesOn the source: (engine's mesh) -> curves.
template <typename CurvesOn>
std::vector<double> distancesOf(const CleanedMesh& cleaned, const CurvesOn& curvesOn)
{
  const TriangleMesh engine = engineMesh(cleaned.mesh);
  const std::vector<double> found = geodesic::solve(engine, curvesOn(engine)).vertexDistances();
  std::vector<double> distances;
  for (const Index vertex : cleaned.vertexOf)
  {
    distances.push_back(found[vertex]);
  }
  return distances;
}

std::vector<double> distancesFrom(Index source, const CleanedMesh& cleaned)
{
  const std::vector<SourceCurve> curves = { geodesic::pointCurve(
    SurfacePoint::atVertex(cleaned.vertexOf[source])) };
  return distancesOf(cleaned, [&](const TriangleMesh&) { return curves; });
}

/// A kind of faces without area.
struct Kind
{
  const char* name;
  Caps caps;
  bool hasNeedles;
};
std::ostream& operator<<(std::ostream& os, const Kind& kind)
{
  return os << kind.name;
}
const Kind Kinds[] = { { "OneCapAnEdge", Caps::One, false },
  { "SeveralCapsAnEdge", Caps::Several, false }, { "FinsAndPockets", Caps::Any, false },
  { "LooseFaces", Caps::AnyAndLoose, false }, { "Needles", Caps::One, true },
  { "All", Caps::AnyAndLoose, true } };

/// How far vertices are moved off their places.
double randomOffset(Random& random)
{
  constexpr double offsets[] = { 0.0, 1e-17, 1e-16, 1e-15, 1e-14, 5e-14, 1e-13, 2e-13, 5e-13,
    1e-12 };
  return offsets[random.below(std::size(offsets))];
}

/// A sheet, or a book, which has edges of three faces.
CappedMesh randomSurface(const Kind& kind, double offset, Random& random)
{
  const Index n = random.between(1, 4);
  const Index m = random.between(1, 4);
  const double amplitude = random.uniform(0.0, 3.0);
  const PlainMesh plain = random.chance(0.6)
    ? bumpySheet(n, m, random.below(2), amplitude, random)
    : book(3, std::min(n, 3U), std::min(m, 2U), 0.1 * amplitude, random);
  CappedMesh both = withCaps(plain, kind.caps, random.uniform(0.1, 1.0), random, offset);
  if (kind.hasNeedles)
  {
    addNeedles(both, random.uniform(0.1, 1.0), random, offset);
  }
  return both;
}

/// A source: points and curves, or the boundary. Curves may lie on faces without area, and cross
/// them.
class RandomSource
{
public:
  RandomSource(const PlainMesh& conforming, bool mayBeBoundary, Random& random)
    : isBoundary_(mayBeBoundary && random.chance(0.15))
  {
    if (this->isBoundary_)
    {
      this->sources_ = boundarySources(engineMesh(conforming));
      return;
    }
    const std::vector<Polyline> curves = CurveMaker(conforming, random).anySource();
    this->sources_ = toSources(curves);
    for (const Polyline& curve : curves)
    {
      geodesic::LocatedPolyline& line = this->lines_.emplace_back();
      line.name = geodesic::PartName("the line");
      const auto add = [&](Index face, const Barycentric& weights) {
        line.points.push_back(position(conforming, MeshPoint{ face, weights }));
      };
      add(curve.segments[0].face, curve.segments[0].from);
      for (std::size_t i = 0; i < curve.segments.size() && !curve.isPoint(); ++i)
      {
        add(curve.segments[i].face, curve.segments[i].to);
      }
    }
  }

  std::vector<SourceCurve> curvesOn(const TriangleMesh& mesh) const
  {
    return this->isBoundary_ ? boundaryCurves(mesh) : curvesOnto(mesh, this->lines_);
  }

  /// By brute force on the surface without faces that have no area.
  std::vector<double> trueDistances(const CappedMesh& both) const
  {
    const std::vector<double> found = bruteForceDistances(both.conforming, this->sources_).vertices;
    std::vector<double> distances;
    for (const Index vertex : both.vertexOf)
    {
      distances.push_back(found[vertex]);
    }
    return distances;
  }

private:
  bool isBoundary_;
  Sources sources_;
  std::vector<geodesic::LocatedPolyline> lines_;
};

class RemovedFacesOfAKind : public ::testing::TestWithParam<Kind>
{
protected:
  /// \param find (surface, source) -> distances at its vertices.
  template <typename Find>
  void compare(std::uint64_t count, const Find& find)
  {
    double worst = 0.0;
    for (Random& random : EachSeed(count, 700000))
    {
      const double offset = randomOffset(random);
      const CappedMesh both = randomSurface(GetParam(), offset, random);
      // Loose faces have a boundary of their own, and so have short ones that are as high as they
      // may be long, relatively: these remain.
      const bool hasOneBoundary = GetParam().caps != Caps::AnyAndLoose && offset <= 1e-15;
      const RandomSource source(both.conforming, hasOneBoundary, random);
      const std::vector<double> truth = source.trueDistances(both);
      std::vector<double> found = find(both.mesh, source, random);
      found.resize(truth.size()); // without vertices that were added
      const double error = worstError(found, truth, std::max(1.0, largestFinite(truth)));
      EXPECT_LE(error, 1e-10);
      worst = std::max(worst, error);
    }
    std::cout << GetParam().name << ": worst relative error " << worst << "\n";
  }
};
INSTANTIATE_TEST_SUITE_P(Kinds, RemovedFacesOfAKind, ::testing::ValuesIn(Kinds),
  [](const auto& kind) { return kind.param.name; });

} // anonymous namespace

TEST_P(RemovedFacesOfAKind, ChangeNoDistance)
{
  compare(60,
    [](const PlainMesh& mesh, const RandomSource& source, Random&)
    {
      return distancesOf(withoutFlatFaces(mesh),
        [&](const TriangleMesh& engine) { return source.curvesOn(engine); });
    });
}

TEST_P(RemovedFacesOfAKind, ChangeNoPathLength)
{
  compare(20,
    [](const PlainMesh& mesh, const RandomSource& source, Random&)
    {
      const CleanedMesh cleaned = withoutFlatFaces(mesh);
      const TriangleMesh engine = engineMesh(cleaned.mesh);
      std::vector<SurfacePoint> targets;
      for (const Index vertex : cleaned.vertexOf)
      {
        targets.push_back(SurfacePoint::atVertex(vertex));
      }
      std::vector<double> lengths;
      for (const FoundPath& path : findPaths(engine, source.curvesOn(engine), targets))
      {
        lengths.push_back(path.points.empty() ? geodesic::Infinity : 0.0);
        for (std::size_t i = 1; i < path.places.size(); ++i)
        {
          lengths.back() += spaceDistance(path.places[i], path.places[i - 1]);
        }
      }
      return lengths;
    });
}

namespace
{

/// The faces that a rank has after those without area have been removed on all ranks.
struct CleanedPiece
{
  Piece piece;
  /// For each of the rank's points before, the key of the vertex that it has become.
  std::vector<std::uint64_t> keyOfPoint;
};

CleanedPiece cleanedPiece(const CutMesh& cut, geodesic::Exchange& exchange)
{
  Piece before = pieceOf(cut, exchange.rank());
  CleanedPiece cleaned;
  cleaned.piece.wholeVertices = before.wholeVertices;
  const std::size_t count = before.points.size();
  const geodesic::CutTriangles parts = geodesic::removeFacesWithoutArea(
    before.points, before.keys, Piece::EndOfKeys, before.triangles, {}, exchange);
  for (std::size_t i = 0; i < count; ++i)
  {
    cleaned.keyOfPoint.push_back(before.keys[parts.isEmpty() ? i : parts.same[i]]);
  }
  std::map<Id, Id> numbers;
  for (std::size_t f = 0; f < (parts.isEmpty() ? before.triangles : parts.parts).size(); ++f)
  {
    if (!parts.isEmpty() && !parts.areFaces[f])
    {
      continue;
    }
    geodesic::Triangle& t =
      cleaned.piece.triangles.emplace_back(parts.isEmpty() ? before.triangles[f] : parts.parts[f]);
    for (Id& corner : t)
    {
      const auto [found, isNew] =
        numbers.emplace(corner, static_cast<Id>(cleaned.piece.points.size()));
      if (isNew)
      {
        cleaned.piece.points.push_back(before.points[corner]);
        cleaned.piece.keys.push_back(before.keys[corner]);
      }
      corner = found->second;
    }
  }
  return cleaned;
}

/// Distances at the vertices of a cut mesh; NaN where ranks have found different ones.
std::vector<double> distancesOnRanks(const CutMesh& cut, const RandomSource& source)
{
  std::map<std::uint64_t, double> distanceOfKey;
  std::vector<std::uint64_t> keys(cut.mesh.points.size(), Piece::EndOfKeys);
  std::mutex mutex;
  MemoryRanks(cut.numberOfRanks)
    .run(
      [&](geodesic::Exchange& exchange)
      {
        const auto [piece, keyOfPoint] = cleanedPiece(cut, exchange);
        const geodesic::MeshPartition part(piece.points, piece.triangles, piece.keys, exchange);
        const geodesic::ReplicatedPatch patch(part, ownFacesOf(part));
        const geodesic::SourceWindows sources =
          makeSourceWindows(part, patch, source.curvesOn(patch.mesh()));
        geodesic::KeepNone none;
        const std::vector<double> found = propagate(part, sources, {}, none).vertexDistances;
        const std::lock_guard<std::mutex> lock(mutex);
        for (std::size_t i = 0; i < piece.keys.size(); ++i)
        {
          const double distance = distanceOfKey.emplace(piece.keys[i], found[i]).first->second;
          distanceOfKey[piece.keys[i]] = distance == found[i] ? distance : std::nan("");
        }
        for (std::size_t i = 0; i < keyOfPoint.size(); ++i)
        {
          keys[piece.wholeVertices[i]] = keyOfPoint[i];
        }
      });
  std::vector<double> distances;
  for (const std::uint64_t key : keys)
  {
    const auto found = distanceOfKey.find(key);
    distances.push_back(found == distanceOfKey.end() ? geodesic::Infinity : found->second);
  }
  return distances;
}

} // anonymous namespace

TEST_P(RemovedFacesOfAKind, ChangeNoDistanceOnRanks)
{
  compare(15,
    [](const PlainMesh& mesh, const RandomSource& source, Random& random)
    {
      const int ranks = static_cast<int>(random.between(2, 5));
      return distancesOnRanks(
        random.chance(0.5) ? cutInSpace(mesh, ranks, random) : cutAtRandom(mesh, ranks, random),
        source);
    });
}

// A path bends at vertex 5, the middle corner of face 2 5 3, and crosses that face.
TEST(RemovedFaces, APathBendsAtTheMiddleCornerOfACap)
{
  PlainMesh mesh;
  mesh.points = { { 0, 12, 0 }, { 0, 16, 0 }, { 4, 12, 2 }, { 4, 16, 2 }, { 8, 12, 2 },
    { 4, 14, 2 }, { 16.0 / 3.0, 14, 3 } };
  mesh.triangles = { { 0, 2, 3 }, { 0, 3, 1 }, { 3, 5, 6 }, { 5, 4, 6 }, { 2, 5, 3 } };
  const CleanedMesh cleaned = withoutFlatFaces(mesh);
  EXPECT_EQ(facesWithoutArea(cleaned.mesh), 0U);
  const double truth = std::sqrt(20.0) + std::sqrt(24.0);
  EXPECT_NEAR(distancesFrom(4, cleaned)[1], truth, 1e-13);
  EXPECT_NEAR(distancesFrom(1, cleaned)[4], truth, 1e-13);
}

// Two squares side by side that share no point of their common side from (1, 0) to (1, 1), but for
// a needle that joins their points at (1, 0) above a third square below: the slit above stays open.
TEST(RemovedFaces, ANeedleClosesNoSlitBesideIt)
{
  PlainMesh mesh;
  mesh.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, { 2, 0, 0 },
    { 2, 1, 0 }, { 1, 1, 0 }, { 1, -1, 0 } };
  mesh.triangles = { { 0, 1, 2 }, { 0, 2, 3 }, { 4, 5, 6 }, { 4, 6, 7 }, { 1, 8, 4 }, { 0, 8, 1 },
    { 8, 5, 4 } };
  // The tops of the slit are one vertex, so that its sides would become one edge.
  for (Triangle& t : mesh.triangles)
  {
    std::replace(t.begin(), t.end(), Index(7), Index(2));
  }
  const CleanedMesh cleaned = withoutFlatFaces(mesh);
  EXPECT_EQ(cleaned.vertexOf[4], cleaned.vertexOf[1]);
  const TriangleMesh engine = engineMesh(cleaned.mesh);
  // From the middle of one side to the middle of the other: around an end, not across.
  const std::vector<double> distances = distancesFrom(0, cleaned);
  EXPECT_NEAR(distances[5], 2.0, 1e-15);
  EXPECT_NEAR(distances[6], 1.0 + std::sqrt(2.0), 1e-15); // by (1, 0), or by (1, 1)
  for (geodesic::Id halfedge = 0; halfedge < engine.numberOfHalfedges(); ++halfedge)
  {
    const auto isAtSlit = [&](geodesic::Id vertex)
    { return engine.point(vertex)[0] == 1.0 && engine.point(vertex)[1] >= 0.0; };
    if (isAtSlit(engine.origin(halfedge)) && isAtSlit(engine.destination(halfedge)))
    {
      EXPECT_TRUE(engine.isBoundary(halfedge));
    }
  }
}

// Two caps beside the first face put vertex 0 onto both of its edges at vertex 1.
TEST(RemovedFaces, AVertexOfAThinFaceBetweenTwoCapsIsReached)
{
  PlainMesh mesh;
  mesh.points = { { 0, 0, 0 }, { -9e-13, 5e-13, 0 }, { 0.17, 1.2e-12, 0 }, { 0.182, 0, 0 },
    { 0.1, -1, 0 } };
  mesh.triangles = { { 2, 1, 3 }, { 0, 3, 1 }, { 0, 1, 2 }, { 0, 4, 3 } };
  ASSERT_EQ(facesWithoutArea(mesh), 2U);
  const CleanedMesh cleaned = withoutFlatFaces(mesh);
  for (const Triangle& t : cleaned.mesh.triangles)
  {
    EXPECT_TRUE(geodesic::hasThreeVertices(t));
  }
  const std::vector<double> distances = distancesFrom(4, cleaned);
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    EXPECT_NEAR(distances[i], spaceDistance(mesh.points[4], mesh.points[i]), 1e-11) << i;
  }
}

// Faces on a line of their own: one hangs at a vertex, one is the bridge to another part.
TEST(RemovedFaces, HangingFacesAndBridgesConductAlongTheirLines)
{
  PlainMesh mesh;
  mesh.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 3, 0, 0 }, { 2, 0, 0 }, { 4, 0, 0 },
    { 3, 1, 0 }, { 0, 3, 0 }, { 0, 2, 0 } };
  mesh.triangles = { { 0, 1, 2 }, { 1, 4, 3 }, { 3, 5, 6 }, { 2, 7, 8 } };
  const CleanedMesh cleaned = withoutFlatFaces(mesh);
  const std::vector<double> truth = { 0, 1, 1, 3, 2, 4, 1.0 + std::sqrt(5.0), 3, 2 };
  const std::vector<double> found = distancesFrom(0, cleaned);
  for (std::size_t i = 0; i < truth.size(); ++i)
  {
    EXPECT_NEAR(found[i], i == 6 ? 3.0 + 1.0 : truth[i], 1e-14) << i;
  }
}

// All corners on one line, and no face with area: every point is reached along the line.
TEST(RemovedFaces, ASurfaceOfSegmentsConductsAlongItsLine)
{
  Random random(3);
  for (int n = 0; n < 200; ++n)
  {
    PlainMesh line = { { { 0, 0, 0 }, { 1, 2, 3 } }, {} };
    std::vector<double> at = { 0.0, 1.0 };
    const Index count = random.between(3, 12);
    for (Index i = 2; i < count; ++i)
    {
      at.push_back(random.uniform(0.01, 0.99));
      line.points.push_back({ at.back(), 2 * at.back(), 3 * at.back() });
      line.triangles.push_back(random.chance(0.5) ? Triangle{ 0, 1, i } : Triangle{ i, 0, 1 });
    }
    const Index source = random.below(count);
    const std::vector<double> found = distancesFrom(source, withoutFlatFaces(line));
    for (Index i = 0; i < count; ++i)
    {
      EXPECT_NEAR(found[i], std::abs(at[i] - at[source]) * std::sqrt(14.0), 1e-10) << n;
    }
  }
}

namespace
{

/// The places of the corners of each face, in an order that does not depend on ranks.
using FaceSet = std::multiset<std::array<Vec3, 3>>;

void addFaces(const std::vector<geodesic::Vec3>& points,
  const std::vector<geodesic::Triangle>& triangles, FaceSet& faces)
{
  for (const geodesic::Triangle& t : triangles)
  {
    std::array<Vec3, 3> places = { points[t[0]], points[t[1]], points[t[2]] };
    std::sort(places.begin(), places.end());
    faces.insert(places);
  }
}

FaceSet facesOnRanks(const CutMesh& cut)
{
  FaceSet faces;
  std::mutex mutex;
  MemoryRanks(cut.numberOfRanks)
    .run(
      [&](geodesic::Exchange& exchange)
      {
        const Piece piece = cleanedPiece(cut, exchange).piece;
        const std::lock_guard<std::mutex> lock(mutex);
        addFaces(piece.points, piece.triangles, faces);
      });
  return faces;
}

} // anonymous namespace

TEST_P(RemovedFacesOfAKind, AreTheSameOnRanks)
{
  for (Random& random : EachSeed(12, 970000))
  {
    const PlainMesh mesh = randomSurface(GetParam(), randomOffset(random), random).mesh;
    const PlainMesh whole = withoutFlatFaces(mesh).mesh;
    FaceSet truth;
    addFaces(whole.points, whole.triangles, truth);
    for (const int ranks : { 2, 3, 5 })
    {
      EXPECT_TRUE(facesOnRanks(cutAtRandom(mesh, ranks, random)) == truth) << ranks << " ranks";
    }
  }
}
