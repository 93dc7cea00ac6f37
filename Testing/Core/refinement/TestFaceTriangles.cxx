// SPDX-License-Identifier: BSD-3-Clause
// The triangles of a face that is not refined, and that refinement ends on any surface.
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
using geodesic::FaceTriangles;
using geodesic::Id;
using geodesic::Triangle;
using geodesic::TriangleMesh;

TEST(CutEdges, RunTheSameWayFromTheSameFaceForAnyOrderOfFaces)
{
  forMeshesInAnotherOrder(
    [](const TriangleMesh& one, const TriangleMesh& two, const Renumbered& other)
    {
      geodesic::CutEdges edges(one, one.numberOfVertices());
      geodesic::CutEdges otherEdges(two, two.numberOfVertices());
      for (Id halfedge = 0; halfedge < one.numberOfHalfedges(); ++halfedge)
      {
        const auto inOther = [&](Id h)
        {
          const Index face = TriangleMesh::faceOf(h);
          return TriangleMesh::halfedgeOf(
            other.faceMap[face], (TriangleMesh::indexInFace(h) + other.cornerShift[face]) % 3);
        };
        const Id edge = edges.ensure(halfedge);
        const Id otherEdge = otherEdges.ensure(inOther(halfedge));
        EXPECT_EQ(otherEdges[otherEdge].halfedge, inOther(edges[edge].halfedge));
      }
      EXPECT_EQ(otherEdges.size(), edges.size());
    });
}

TEST(FaceTriangles, PointsOfOneSideAreNoTriangle)
{
  std::array<FaceTriangles::Point, 3> corners;
  const geodesic::Vec2 places[] = { { 0.0, 0.0 }, { 1.0, 0.0 }, { 0.3, 0.7 } };
  for (std::size_t k = 0; k < 3; ++k)
  {
    corners[k].place = places[k];
    corners[k].weights = geodesic::cornerWeights(k);
    corners[k].number = static_cast<Id>(k);
  }
  FaceTriangles face(0, corners);
  FaceTriangles::Point point;
  point.weights = { 0.5, 0.5, 1e-3 }; // as if rounding had moved it
  point.place = { 0.5, 1e-3 };
  point.sides = 1;
  EXPECT_FALSE(face.isTriangle({ 0, 1, face.addPoint(point) }));
  EXPECT_TRUE(face.isTriangle({ 0, 1, 2 }));
  EXPECT_FALSE(face.isTriangle({ 1, 0, 2 }));
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
        faces.edges.split(
          { edge, piece, geodesic::SplitReason::Error, 0.0, random.uniform(0.1, 0.9) });
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

namespace
{

/// Solves on and refines a surface with caps and points beside each other.
///
/// \returns the seconds of a processor.
double refineAnySurface(Random& random)
{
  constexpr double most = 10.0; // seconds of a processor
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
    return 0.0;
  }
  const std::clock_t begin = std::clock();
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
    return 0.0;
  }
  const auto field = solveForRefinement(mesh, curves, tolerance, options);
  const geodesic::RefinedMesh refined = refineTo(field, tolerance);
  const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  EXPECT_LT(seconds, most) << refined.triangles.size() << " triangles";
  EXPECT_FALSE(refined.stoppedAtMaximum);
  const Points points(field, refined);
  expectFacesPartitioned(mesh, refined, points);
  expectWatertight(mesh, refined, points);
  return seconds;
}

}

// Faces without area, caps and needles of every size made refinement go on for ever.
TEST(RefinementOfAnySurface, EndsSoon)
{
  double worst = 0.0;
  for (Random& random : EachSeed(meshesOfAKind(100), 90000))
  {
    worst = std::max(worst, refineAnySurface(random));
  }
  std::cout << "the slowest took " << worst << " s\n";
}

// The edges of the first have thousands of windows: 19 s, when each was compared with all. On the
// others rays wind around tubes of caps, back to back: minutes, when they did so to the end. On the
// last one a thin face would be split for its shapes again and again, without a limit of that.
TEST(RefinementOfAnySurface, EndsSoonOnTheSlowestSurfaces)
{
  for (const std::uint64_t seed :
    { 140244U, 132911U, 137807U, 143061U, 146272U, 147286U, 141167U, 142383U })
  {
    Random random(seed);
    EXPECT_LT(refineAnySurface(random), 5.0) << "seed " << seed;
  }
}
