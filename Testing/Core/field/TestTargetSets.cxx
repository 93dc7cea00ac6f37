// SPDX-License-Identifier: BSD-3-Clause
// Distances between sets of points, lines and regions, compared with brute force at places that are
// cut ever more densely where the least distance may be.
#include "EngineSupport.h"

#include "field/DistanceMatrix.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace geodesictest;
using geodesic::Id;
using geodesic::SurfacePoint;
using geodesic::TriangleMesh;

namespace
{

/// A set as the engine and as brute force take it.
struct PlacesOfSet
{
  std::vector<geodesic::SourceCurve> curves;
  Sources sources;
  /// For each face whether it is in a region of the set.
  std::vector<bool> isCovered;
};

MeshSegment edgeOf(Id halfedge)
{
  MeshSegment edge{ TriangleMesh::faceOf(halfedge), { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 } };
  edge.from[halfedge % 3] = 1.0;
  edge.to[(halfedge + 1) % 3] = 1.0;
  return edge;
}

/// Random faces around one, with holes.
std::vector<bool> randomRegion(const TriangleMesh& mesh, Random& random)
{
  const std::size_t wanted = 1 + random.below(random.chance(0.1) ? 1000 : 20);
  std::vector<bool> isIn(mesh.numberOfFaces(), false);
  std::vector<Id> faces = { static_cast<Id>(random.below(mesh.numberOfFaces())) };
  isIn[faces.front()] = true;
  for (std::size_t i = 0; i < faces.size() && faces.size() < wanted; ++i)
  {
    for (const Id halfedge : TriangleMesh::halfedgesOf(faces[i]))
    {
      const Id next = TriangleMesh::faceOf(mesh.nextSibling(halfedge));
      if (!isIn[next])
      {
        isIn[next] = true;
        faces.push_back(next);
      }
    }
  }
  for (std::size_t i = 1; i < faces.size(); ++i)
  {
    isIn[faces[i]] = !random.chance(0.1);
  }
  return isIn;
}

/// Every edge at which a region meets other faces, or none, is its outline. Paths also come to it
/// through vertices, where sheets meet in one.
void addRegion(const TriangleMesh& mesh, const std::vector<bool>& isIn, PlacesOfSet& set)
{
  std::vector<geodesic::SourceCurve> outline;
  std::vector<Id> covered;
  for (Id halfedge = 0; halfedge < mesh.numberOfHalfedges(); ++halfedge)
  {
    const Id face = TriangleMesh::faceOf(halfedge);
    if (!isIn[face])
    {
      continue;
    }
    if (covered.empty() || covered.back() != face)
    {
      covered.push_back(face);
    }
    bool isOutline = mesh.nextSibling(halfedge) == halfedge;
    for (Id s = mesh.nextSibling(halfedge); s != halfedge; s = mesh.nextSibling(s))
    {
      isOutline = isOutline || !isIn[TriangleMesh::faceOf(s)];
    }
    if (isOutline)
    {
      set.sources.segments.push_back(edgeOf(halfedge));
      outline.push_back({ { SurfacePoint::atVertex(mesh.origin(halfedge)),
                            SurfacePoint::atVertex(mesh.destination(halfedge)) },
        { face }, { 0, 0 } });
    }
  }
  for (const Id face : covered)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      MeshPoint corner{ face, { 0.0, 0.0, 0.0 } };
      corner.weights[k] = 1.0;
      set.sources.points.push_back(corner);
    }
  }
  if (outline.empty())
  {
    outline.push_back(
      geodesic::pointCurve(SurfacePoint::atVertex(mesh.triangle(covered.front())[0])));
  }
  outline.front().coveredFaces = covered;
  set.curves.insert(set.curves.end(), outline.begin(), outline.end());
  set.isCovered = isIn;
}

PlacesOfSet randomSet(const PlainMesh& plain, const TriangleMesh& mesh, Random& random)
{
  PlacesOfSet set;
  set.isCovered.assign(mesh.numberOfFaces(), false);
  std::vector<Polyline> lines;
  CurveMaker maker(plain, random);
  const std::size_t kind = random.below(4);
  for (std::size_t i = 0; i < 1 + random.below(3) && kind != 2; ++i)
  {
    lines.push_back(kind == 0 ? maker.point() : maker.any());
  }
  set.sources = toSources(lines);
  set.curves = engineCurves(mesh, lines);
  if (kind >= 2)
  {
    addRegion(mesh, randomRegion(mesh, random), set);
  }
  return set;
}

/// Whether a set has a point in a region of another one.
bool touchesRegion(const TriangleMesh& mesh, const PlacesOfSet& set, const PlacesOfSet& other)
{
  bool touches = false;
  for (Id face = 0; face < mesh.numberOfFaces(); ++face)
  {
    touches = touches || (set.isCovered[face] && other.isCovered[face]);
    for (const geodesic::SourceCurve& curve : set.curves)
    {
      for (const SurfacePoint& point : curve.points)
      {
        touches =
          touches || (other.isCovered[face] && contains(mesh, face, normalized(mesh, point)));
      }
    }
  }
  return touches;
}

/// A piece of a line.
struct Piece
{
  MeshSegment segment;
  double begin = 0.0;
  double end = 1.0;

  MeshPoint at(double t) const
  {
    MeshPoint point{ this->segment.face, {} };
    for (std::size_t k = 0; k < 3; ++k)
    {
      point.weights[k] = (1.0 - t) * this->segment.from[k] + t * this->segment.to[k];
    }
    return point;
  }
  double length(const PlainMesh& mesh) const
  {
    return spaceDistance(
      position(mesh, this->at(this->begin)), position(mesh, this->at(this->end)));
  }
};

/// The least distance is between these.
struct Bounds
{
  double below;
  double above;
};

constexpr int Rounds = 6;
constexpr int Cuts = 8;

/// The least distance of a set from sources: pieces that may have it, as slopes are at most 1, are
/// cut again.
Bounds leastDistance(const PlainMesh& mesh, const Sources& from, const Sources& to)
{
  std::vector<Piece> pieces;
  for (const MeshSegment& segment : to.segments)
  {
    pieces.push_back({ segment });
  }
  Bounds least{ geodesic::Infinity, geodesic::Infinity };
  for (const double distance : bruteForceDistances(mesh, from, to.points).queries)
  {
    least.above = std::min(least.above, distance);
  }
  for (int round = 0; round < Rounds && !pieces.empty(); ++round)
  {
    std::vector<MeshPoint> places;
    for (const Piece& piece : pieces)
    {
      for (int cut = 0; cut <= Cuts; ++cut)
      {
        places.push_back(piece.at(piece.begin + (piece.end - piece.begin) * cut / Cuts));
      }
    }
    const std::vector<double> distances = bruteForceDistances(mesh, from, places).queries;
    least.above = std::min(least.above, *std::min_element(distances.begin(), distances.end()));
    least.below = least.above;
    std::vector<Piece> next;
    for (std::size_t i = 0; i < pieces.size(); ++i)
    {
      for (int cut = 0; cut < Cuts; ++cut)
      {
        Piece piece = pieces[i];
        const double step = (piece.end - piece.begin) / Cuts;
        piece.begin += cut * step;
        piece.end = piece.begin + step;
        const double* ends = &distances[i * (Cuts + 1) + static_cast<std::size_t>(cut)];
        const double possible = 0.5 * (ends[0] + ends[1] - piece.length(mesh));
        if (possible < least.above)
        {
          least.below = std::min(least.below, possible);
          next.push_back(piece);
        }
      }
    }
    pieces = next;
  }
  least.below = std::min(least.below, least.above);
  return least;
}

/// Random sets on a random mesh, and the distances between them.
struct SetsCase
{
  SetsCase(const MeshKind& kind, std::uint64_t seed)
    : random(seed)
    , plain(kind.make(random.between(10, 60), random))
    , mesh(engineMesh(plain))
  {
    for (std::size_t i = 0; i < 4; ++i)
    {
      places.push_back(randomSet(plain, mesh, random));
      sets.push_back(places.back().curves);
    }
  }

  Bounds truth(std::size_t from, std::size_t to) const
  {
    if (touchesRegion(this->mesh, this->places[from], this->places[to]) ||
      touchesRegion(this->mesh, this->places[to], this->places[from]))
    {
      return { 0.0, 0.0 };
    }
    return leastDistance(this->plain, this->places[from].sources, this->places[to].sources);
  }

  Random random;
  PlainMesh plain;
  TriangleMesh mesh;
  std::vector<PlacesOfSet> places;
  geodesic::CurveSets sets;
};

bool agree(double a, double b, double difference)
{
  return a == b || std::abs(a - b) <= difference;
}

class SetsOfTargets : public ::testing::TestWithParam<MeshKind>
{
};

}

TEST_P(SetsOfTargets, HaveTheLeastDistanceOfPointsLinesAndOutlines)
{
  std::size_t between = 0;
  for (std::uint64_t seed = 0; seed < meshesOfAKind(10); ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const SetsCase c(GetParam(), seed + 530000);
    const auto table = geodesic::distancesBetween(c.mesh, c.sets);
    double largest = 1e-300;
    for (const std::vector<double>& row : table)
    {
      largest = std::max(largest, largestFinite(row));
    }
    for (std::size_t i = 0; i < c.sets.size(); ++i)
    {
      EXPECT_EQ(table[i][i], 0.0);
      for (std::size_t j = i + 1; j < c.sets.size(); ++j)
      {
        const Bounds truth = c.truth(i, j);
        EXPECT_EQ(table[i][j], table[j][i]);
        const double rounding = accuracyOn(GetParam()) * largest;
        EXPECT_GE(table[i][j], truth.below - rounding) << i << ", " << j;
        EXPECT_LE(table[i][j], truth.above + rounding) << i << ", " << j;
        between += truth.above > 0.0 && truth.above < geodesic::Infinity ? 1 : 0;
      }
    }
  }
  EXPECT_GT(between, 0U);
}

TEST_P(SetsOfTargets, HaveTheSameDistancesFromEitherSideAndWithinAMaximum)
{
  for (std::uint64_t seed = 0; seed < meshesOfAKind(10); ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const SetsCase c(GetParam(), seed + 540000);
    const auto table = geodesic::distancesBetween(c.mesh, c.sets);
    const geodesic::CurveSets two(c.sets.begin(), c.sets.begin() + 2);
    const auto fromTwo = geodesic::distanceMatrix(c.mesh, two, c.sets);
    const auto toTwo = geodesic::distanceMatrix(c.mesh, c.sets, two);
    double largest = 1e-300;
    for (const std::vector<double>& row : table)
    {
      largest = std::max(largest, largestFinite(row));
    }
    const double rounding = accuracyOn(GetParam()) * largest;
    const double limit = 0.4 * largest;
    const auto limited = geodesic::distancesBetween(c.mesh, c.sets, limit);
    for (std::size_t i = 0; i < c.sets.size(); ++i)
    {
      for (std::size_t j = 0; j < c.sets.size(); ++j)
      {
        if (i < 2)
        {
          EXPECT_TRUE(agree(fromTwo[i][j], table[i][j], rounding))
            << i << ", " << j << ": " << fromTwo[i][j] << " for " << table[i][j];
          EXPECT_TRUE(agree(toTwo[j][i], table[i][j], rounding))
            << i << ", " << j << ": " << toTwo[j][i] << " for " << table[i][j];
        }
        if (!agree(table[i][j], limit, rounding))
        {
          EXPECT_TRUE(agree(
            limited[i][j], table[i][j] <= limit ? table[i][j] : geodesic::Infinity, rounding));
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, SetsOfTargets, ::testing::ValuesIn(meshKinds()),
  [](const auto& instance) { return std::string(instance.param.name); });

TEST(TargetSets, MayBeEmptyAsSourcesAndAsTargets)
{
  PlainMesh plain;
  plain.points = { { 0, 0, 0 }, { 3, 0, 0 }, { 0, 4, 0 } };
  plain.triangles = { { 0, 1, 2 } };
  const TriangleMesh mesh = engineMesh(plain);
  const geodesic::CurveSets sets = { {}, { geodesic::pointCurve(SurfacePoint::atVertex(0)) },
    { { { SurfacePoint::atVertex(1), SurfacePoint::atVertex(2) }, { 0 }, { 0, 0 } } } };
  const auto table = geodesic::distancesBetween(mesh, sets);
  EXPECT_EQ(table[0], std::vector<double>(3, geodesic::Infinity));
  EXPECT_EQ(table[1][0], geodesic::Infinity);
  EXPECT_NEAR(table[1][2], 2.4, 1e-15) << "the height, between the vertices";
  EXPECT_EQ(geodesic::distanceMatrix(mesh, sets, geodesic::CurveSets(2))[1],
    std::vector<double>(2, geodesic::Infinity));
}
