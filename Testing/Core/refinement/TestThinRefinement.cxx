// SPDX-License-Identifier: BSD-3-Clause
// Refined surfaces of thin triangles: the surface stays, the bound holds everywhere, angles do not
// get smaller than half the input's, and long edges get no more points than their distance needs.
#include "EngineSupport.h"
#include "refinement/RefinementSupport.h"

#include "refinement/SolveForRefinement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

using namespace geodesictest;
using geodesic::DistanceField;
using geodesic::Id;
using geodesic::RefinedMesh;
using geodesic::TriangleMesh;

namespace
{

constexpr double Pi = 3.14159265358979323846;

PlainMesh strips(Random& random)
{
  const Index sides = random.between(8, 60);
  return openCylinder(sides, 1, random.uniform(1.0, 20.0) * static_cast<double>(sides));
}

PlainMesh thinTorus(Random& random)
{
  return torus(random.between(3, 8), random.between(40, 100), random.uniform(2.0, 20.0));
}

PlainMesh tallCone(Random& random)
{
  const Index sides = random.between(8, 60);
  return roundCone(
    sides, random.between(1, 3), random.uniform(1.0, 10.0) * static_cast<double>(sides));
}

/// A square plate with a round hole, as CAD programs triangulate it: from the corners of the square
/// fans go to the hole, and the walls are strips.
PlainMesh plateWithHole(Random& random)
{
  const Index inQuarter = random.between(4, 20);
  const Index around = 4 * inQuarter;
  const double thickness = random.uniform(0.05, 5.0);
  PlainMesh mesh;
  for (const double z : { 0.0, thickness })
  {
    for (Index i = 0; i < around; ++i)
    {
      const double angle = 2.0 * Pi * static_cast<double>(i) / static_cast<double>(around);
      mesh.points.push_back({ std::cos(angle), std::sin(angle), z });
    }
    for (Index k = 0; k < 4; ++k)
    {
      const double angle = 0.5 * Pi * (static_cast<double>(k) + 0.5);
      mesh.points.push_back({ 6.0 * std::cos(angle), 6.0 * std::sin(angle), z });
    }
  }
  const Index layer = around + 4;
  const auto addBoth = [&](Index a, Index b, Index c) // above, and below the other way round
  {
    mesh.triangles.push_back({ layer + a, layer + b, layer + c });
    mesh.triangles.push_back({ a, c, b });
  };
  const auto addWall = [&](Index a, Index b)
  {
    mesh.triangles.push_back({ a, b, layer + b });
    mesh.triangles.push_back({ a, layer + b, layer + a });
  };
  for (Index k = 0; k < 4; ++k)
  {
    const Index corner = around + k;
    const Index next = around + (k + 1) % 4;
    for (Index i = k * inQuarter; i < (k + 1) * inQuarter; ++i)
    {
      addBoth((i + 1) % around, i, corner);
      addWall((i + 1) % around, i);
    }
    addBoth((k + 1) * inQuarter % around, corner, next);
    addWall(corner, next);
  }
  return mesh;
}

/// The smallest angle of triangles; of the refined ones only if their face was cut.
double smallestAngle(const std::array<Vec3, 3>& p)
{
  double least = Pi;
  for (std::size_t k = 0; k < 3; ++k)
  {
    using namespace geodesic;
    const Vec3 a = p[(k + 1) % 3] - p[k];
    const Vec3 b = p[(k + 2) % 3] - p[k];
    least = std::min(least, std::atan2(norm(cross(a, b)), dot(a, b)));
  }
  return least;
}

double smallestAngle(const TriangleMesh& mesh)
{
  double least = Pi;
  for (Id face = 0; face < mesh.numberOfFaces(); ++face)
  {
    const geodesic::Triangle& t = mesh.triangle(face);
    least =
      std::min(least, smallestAngle({ mesh.point(t[0]), mesh.point(t[1]), mesh.point(t[2]) }));
  }
  return least;
}

double smallestAngle(const DistanceField& field, const RefinedMesh& refined)
{
  const Points points(field, refined);
  double least = Pi;
  for (const geodesic::Triangle& t : refined.triangles)
  {
    least = std::min(least,
      smallestAngle({ points.position(t[0]), points.position(t[1]), points.position(t[2]) }));
  }
  return least;
}

/// Refines the distance to a random point: the surface, half of its smallest angle, and the bound
/// of the error hold.
void checkRefinement(const PlainMesh& plain, Random& random)
{
  const TriangleMesh mesh = engineMesh(plain);
  const auto curves = engineCurves(mesh, Sources{ { randomPoint(plain, random) }, {} });
  const DistanceField whole = solveKeepingAll(mesh, curves);
  const double largest = largestFinite(whole.vertexDistances());
  const double tolerance = largest * random.uniform(0.0005, 0.01);
  const RefinedMesh refined = refineTo(solveForRefinement(mesh, curves, tolerance), tolerance);
  EXPECT_LE(refined.errorBound, tolerance);
  expectSameSurface(whole, refined);
  EXPECT_GE(smallestAngle(whole, refined), 0.5 * smallestAngle(mesh));
  constexpr int inEachTriangle = 100;
  EXPECT_LE(largestDifferenceInside(whole, refined, inEachTriangle, random),
    refined.errorBound + EngineAccuracy * largest);
}

struct ThinKind
{
  const char* name;
  PlainMesh (*make)(Random& random);
};

class ThinRefinement : public ::testing::TestWithParam<ThinKind>
{
};

}

TEST_P(ThinRefinement, KeepsTheSurfaceItsAnglesAndTheBound)
{
  for (Random& random : EachSeed(20))
  {
    checkRefinement(GetParam().make(random), random);
  }
}

// A round triangle whose edge is halved gets parts with the cuts of its thin neighbours. In this
// plate they left less than half of the smallest angle.
TEST(RefinementBesideThinTriangles, KeepsTheAnglesOfARoundOne)
{
  Random random(3104);
  const PlainMesh plate = plateWithHole(random);
  checkRefinement(plate, random);
}

// A point inside a thin face, over the middle of a long piece of its side, made a cap with it.
TEST(RefinementInThinTriangles, LeavesNoCapOnASide)
{
  for (const auto& [make, seed] : { std::pair(strips, 990048U), std::pair(tallCone, 990128U) })
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    const PlainMesh thin = make(random);
    checkRefinement(thin, random);
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, ThinRefinement,
  ::testing::Values(ThinKind{ "Strips", strips }, ThinKind{ "Torus", thinTorus },
    ThinKind{ "Cone", tallCone }, ThinKind{ "PlateWithHole", plateWithHole }),
  [](const auto& instance) { return std::string(instance.param.name); });
