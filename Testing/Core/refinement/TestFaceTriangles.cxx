// SPDX-License-Identifier: BSD-3-Clause
// The triangulation of one face, the points of an edge, and that refinement ends on any surface.
// GEODESIC_TEST_SEEDS=FIRST,COUNT takes other seeds.
#include "EngineSupport.h"
#include "refinement/RefinementSupport.h"
#include "truth/CappedMeshes.h"
#include "truth/RandomMeshKinds.h"

#include "refinement/CutEdges.h"
#include "refinement/FaceTriangles.h"
#include "refinement/RefinementOutput.h"
#include "refinement/SolveForRefinement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <iostream>
#include <string>

using namespace geodesictest;
using geodesic::Barycentric;
using geodesic::CutEdges;
using geodesic::FaceTriangles;
using geodesic::Id;
using geodesic::NoId;
using geodesic::Triangle;
using geodesic::TriangleMesh;

namespace
{

/// A random face in the plane, maybe a needle.
std::array<FaceTriangles::Point, 3> randomFace(Random& random)
{
  const double height = std::pow(10.0, random.uniform(-9.0, 0.5));
  std::array<FaceTriangles::Point, 3> corners;
  corners[0].place = { 0.0, 0.0 };
  corners[1].place = { 1.0, 0.0 };
  corners[2].place = { random.uniform(-0.5, 1.5), height };
  for (std::size_t k = 0; k < 3; ++k)
  {
    corners[k].weights = geodesic::cornerWeights(k);
    corners[k].number = static_cast<Id>(k);
  }
  return corners;
}

/// Splits a random side of a random part.
void splitAnywhere(FaceTriangles& face, Random& random)
{
  const Id part = static_cast<Id>(random.below(face.numberOfParts()));
  const std::size_t k = random.below(3);
  const Triangle& c = face.parts()[part].corners;
  const FaceTriangles::Point& a = face.points()[c[k]];
  const FaceTriangles::Point& b = face.points()[c[(k + 1) % 3]];
  FaceTriangles::Point point;
  const double weight = random.uniform(0.2, 0.8);
  point.weights = geodesic::between(a.weights, b.weights, weight);
  point.place = a.place + weight * (b.place - a.place);
  if (face.parts()[part].across[k] == NoId)
  {
    point.sides = static_cast<std::uint8_t>(a.sides & b.sides);
    ASSERT_NE(point.sides, 0);
  }
  face.split(part, k, face.addPoint(point));
}

double shareOf(const FaceTriangles& face, const Triangle& c)
{
  return determinant(
    face.points()[c[0]].weights, face.points()[c[1]].weights, face.points()[c[2]].weights);
}

/// Checks that the parts cover the face once, and that neighbours know each other.
void expectOneTriangulation(const FaceTriangles& face)
{
  double covered = 0.0;
  std::size_t sidesOfFace = 0;
  for (Id part = 0; part < face.numberOfParts(); ++part)
  {
    const FaceTriangles::Part& p = face.parts()[part];
    const double share = shareOf(face, p.corners);
    EXPECT_GT(share, 0.0);
    covered += share;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Id a = p.corners[k];
      const Id b = p.corners[(k + 1) % 3];
      EXPECT_EQ(p.across[k] == NoId, face.sideWith(a, b) < 3);
      if (p.across[k] == NoId)
      {
        ++sidesOfFace;
        continue;
      }
      const FaceTriangles::Part& other = face.parts()[p.across[k]];
      bool isThere = false;
      for (std::size_t j = 0; j < 3; ++j)
      {
        isThere = isThere ||
          (other.across[j] == part && other.corners[j] == b && other.corners[(j + 1) % 3] == a);
      }
      EXPECT_TRUE(isThere);
    }
  }
  EXPECT_NEAR(covered, 1.0, 1e-12);
  EXPECT_EQ(sidesOfFace, 3 + face.pointsOn(0) + face.pointsOn(1) + face.pointsOn(2));
  // Euler: three corners, points on sides, and points inside
  const std::size_t inside = face.points().size() - sidesOfFace;
  EXPECT_EQ(face.numberOfParts(), sidesOfFace - 2 + 2 * inside);
}

/// Whether d lies in the circle through a, b, c: the determinant, with all digits of long double.
bool isWellInCircle(geodesic::Vec2 a, geodesic::Vec2 b, geodesic::Vec2 c, geodesic::Vec2 d)
{
  const auto row = [d](geodesic::Vec2 p, long double(&r)[3])
  {
    r[0] = static_cast<long double>(p.x) - d.x;
    r[1] = static_cast<long double>(p.y) - d.y;
    r[2] = r[0] * r[0] + r[1] * r[1];
  };
  long double m[3][3];
  row(a, m[0]);
  row(b, m[1]);
  row(c, m[2]);
  long double size = 1.0L;
  long double det = 0.0L;
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    det += m[i][0] * (m[j][1] * m[k][2] - m[k][1] * m[j][2]);
    size *= std::sqrt(m[i][2]);
  }
  // The sine of the sum of two angles, times the four sides that they are between.
  const long double sides = size * std::sqrt(m[0][2] + m[1][2] + m[2][2]);
  return det > 1e-9L * sides;
}

} // anonymous namespace

TEST(FaceTriangles, SplitsAndFlipsKeepOneTriangulation)
{
  for (Random& random : EachSeed(300))
  {
    FaceTriangles face(0, randomFace(random));
    const Index splits = random.between(1, 60);
    for (Index i = 0; i < splits; ++i)
    {
      splitAnywhere(face, random);
      if (random.chance(0.5))
      {
        face.flipChanged();
      }
    }
    expectOneTriangulation(face);
  }
}

TEST(FaceTriangles, FlipsEndAtDelaunaysTriangles)
{
  for (Random& random : EachSeed(300, 5000))
  {
    FaceTriangles face(0, randomFace(random));
    for (Index i = random.between(2, 40); i > 0; --i)
    {
      splitAnywhere(face, random);
    }
    face.flipChanged(); // all have changed
    for (const FaceTriangles::Part& part : face.parts())
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        if (part.across[k] == NoId)
        {
          continue;
        }
        const Triangle& other = face.parts()[part.across[k]].corners;
        const Id apex = *std::find_if(other.begin(), other.end(),
          [&](Id corner)
          { return std::count(part.corners.begin(), part.corners.end(), corner) == 0; });
        const std::array<geodesic::Vec2, 3> c = face.places(part.corners);
        const Id self = static_cast<Id>(&part - face.parts().data());
        const std::array<Triangle, 2> flipped = face.flipped(self, k);
        EXPECT_FALSE(isWellInCircle(c[0], c[1], c[2], face.points()[apex].place) &&
          face.isTriangle(flipped[0]) && face.isTriangle(flipped[1]));
      }
    }
  }
}

TEST(FaceTriangles, PointsOfOneSideAreNoTriangle)
{
  Random random(1);
  FaceTriangles face(0, randomFace(random));
  FaceTriangles::Point point;
  point.weights = { 0.5, 0.5, 1e-3 }; // as if rounding had moved it
  point.place = { 0.5, 1e-3 };
  point.sides = 1;
  EXPECT_FALSE(face.isTriangle({ 0, 1, face.addPoint(point) }));
  EXPECT_TRUE(face.isTriangle({ 0, 1, 2 }));
  EXPECT_FALSE(face.isTriangle({ 1, 0, 2 }));
}

TEST(CutEdges, PointsLieInTheirOrderAndBetweenTheirParents)
{
  for (Random& random : EachSeed(100))
  {
    const TriangleMesh mesh = engineMesh(regularGrid(1, 1));
    CutEdges edges(mesh);
    const Id halfedge = static_cast<Id>(random.below(mesh.numberOfHalfedges()));
    const Id edge = edges.ensure(halfedge);
    EXPECT_EQ(edges.ensure(mesh.nextSibling(halfedge)), edge);
    EXPECT_EQ(edges.find(geodesic::TriangleMesh::nextInFace(halfedge)), NoId);
    const auto placeOf = [&](Id point)
    {
      return !edges.isVertex(point)                  ? edges.point(point).at
        : point == mesh.origin(edges[edge].halfedge) ? 0.0
                                                     : 1.0;
    };
    double length = 0.0;
    for (Index i = random.between(1, 30); i > 0; --i)
    {
      const Id piece = static_cast<Id>(random.below(edges[edge].numberOfPieces()));
      edges.split(edge, { piece, false, random.uniform(0.1, 0.9), 0.0 });
      const geodesic::PointOnEdge& added = edges.points().back();
      const double from = placeOf(added.parents[0]);
      const double to = placeOf(added.parents[1]);
      EXPECT_LT(from, added.at);
      EXPECT_GT(to, added.at);
      EXPECT_EQ(added.at, from + added.weight * (to - from));
      EXPECT_EQ(edges.pieceFrom(edge, from), piece);
      EXPECT_EQ(edges.pieceFrom(edge, added.at), piece + 1);
    }
    for (Id piece = 0; piece < edges[edge].numberOfPieces(); ++piece)
    {
      EXPECT_LT(edges.placeOfEnd(edge, piece), edges.placeOfEnd(edge, piece + 1));
      EXPECT_FALSE(edges[edge].pieces[piece].isKnown());
      length += edges.lengthOfPiece(edge, piece);
    }
    EXPECT_NEAR(length, mesh.length(halfedge), 1e-14);
  }
}

// Its neighbours split its edges, and no windows describe its inside: its triangles lie between the
// points of the edges only.
TEST(RefinedFaces, AFaceThatIsNotRefinedIsClosedBetweenThePointsOnItsEdges)
{
  for (Random& random : EachSeed(50))
  {
    const TriangleMesh mesh = engineMesh(bumpySheet(3, 3, 0, 0.5, random));
    const auto field =
      solveKeepingAll(mesh, { geodesic::pointCurve(geodesic::SurfacePoint::atVertex(0)) });
    geodesic::RefinedFaces faces(field);
    const Id face = static_cast<Id>(random.below(mesh.numberOfFaces()));
    std::size_t added = 0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Id edge = faces.edges.ensure(TriangleMesh::halfedgeOf(face, k));
      for (Index i = random.between(0, 4); i > 0; --i)
      {
        const Id piece = static_cast<Id>(random.below(faces.edges[edge].numberOfPieces()));
        faces.edges.split(edge, { piece, false, random.uniform(0.1, 0.9), 0.0 });
        ++added;
      }
    }
    std::vector<Triangle> triangles;
    geodesic::appendTriangles(faces, face, triangles);
    EXPECT_EQ(triangles.size(), 1 + added);
    const auto weightsOf = [&](Id point)
    {
      return barycentric(mesh,
        faces.edges.isVertex(point)
          ? geodesic::SurfacePoint::atVertex(point)
          : geodesic::SurfacePoint::onEdge(
              faces.edges[faces.edges.point(point).edge].halfedge, faces.edges.point(point).at),
        face);
    };
    double covered = 0.0;
    for (const Triangle& t : triangles)
    {
      const double share = determinant(weightsOf(t[0]), weightsOf(t[1]), weightsOf(t[2]));
      EXPECT_GT(share, 0.0);
      covered += share;
    }
    EXPECT_NEAR(covered, 1.0, 1e-12);
  }
}

// Faces without area, caps and needles of every size made refinement go on for ever.
TEST(RefinementOfAnySurface, EndsSoon)
{
  constexpr double most = 10.0; // seconds of a processor
  double worst = 0.0;
  for (Random& random : EachSeed(meshesOfAKind(100), 90000))
  {
    PlainMesh plain =
      meshKinds()[random.below(meshKinds().size())].make(random.between(4, 80), random);
    if (random.chance(0.5))
    {
      plain = withCaps(plain, Caps::Any, random.uniform(0.02, 0.5), random).mesh;
    }
    const double noise = std::pow(10.0, random.uniform(-17.0, -1.0));
    addNoise(plain, noise, random);
    const TriangleMesh mesh = cleanedEngineMesh(plain);
    const auto curves = random.chance(0.5)
      ? engineCurves(mesh, Sources{ { vertexPoint(plain, 0) }, {} })
      : geodesic::boundaryCurves(mesh);
    if (curves.empty())
    {
      continue;
    }
    geodesic::FrontOptions options;
    options.relativeError = random.chance(0.3) ? 0.01 : 0.0;
    // Faces may be many times longer than any distance.
    double size = largestFinite(geodesic::solve(mesh, curves, options).vertexDistances());
    for (Id halfedge = 0; halfedge < mesh.numberOfHalfedges(); ++halfedge)
    {
      size = std::max(size, mesh.length(halfedge));
    }
    const double tolerance = std::pow(10.0, random.uniform(-4.0, -1.0)) * size;
    if (!(tolerance > 0.0))
    {
      continue;
    }
    const auto field = solveForRefinement(mesh, curves, tolerance, options);
    const std::clock_t begin = std::clock(); // the front may make very many windows in a pocket
    const geodesic::RefinedMesh refined = refineTo(field, tolerance);
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    EXPECT_LT(seconds, most) << refined.triangles.size() << " triangles";
    EXPECT_FALSE(refined.stoppedAtMaximum);
    worst = std::max(worst, seconds);
    const Points points(field, refined);
    expectFacesPartitioned(mesh, refined, points);
    expectWatertight(mesh, refined, points);
  }
  std::cout << "the slowest took " << worst << " s\n";
}
