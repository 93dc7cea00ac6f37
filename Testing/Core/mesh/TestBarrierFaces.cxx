// SPDX-License-Identifier: BSD-3-Clause
// Which points lie in barriers: those that are closer to a barrier than to any other face.
#include "EngineSupport.h"

#include "mesh/BarrierFaces.h"

#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>

namespace
{

using namespace geodesic;
using geodesictest::PlainMesh;
using geodesictest::Random;

/// A surface of which some faces are barriers.
class Barriers
{
public:
  Barriers(const PlainMesh& mesh, const std::vector<bool>& isBarrier)
    : open_(mesh.points, pick(mesh, isBarrier, false))
    , barrierMesh_(mesh.points, pick(mesh, isBarrier, true))
    , locator_(MeshPartition(this->open_))
    , barriers_(MeshPartition(this->open_), MeshPartition(this->barrierMesh_))
  {
  }

  Id at(const Vec3& point, double precision = DBL_EPSILON)
  {
    return this->barriers_
      .barriersAt({ point }, this->locator_.closest({ point }, { 1 }, precision), precision)
      .front()
      .id;
  }
  const TriangleMesh& mesh() const { return this->barrierMesh_; }

private:
  static std::vector<Triangle> pick(
    const PlainMesh& mesh, const std::vector<bool>& isBarrier, bool wanted)
  {
    std::vector<Triangle> triangles;
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
    {
      if (isBarrier[f] == wanted)
      {
        triangles.push_back(mesh.triangles[f]);
      }
    }
    return triangles;
  }

  TriangleMesh open_;
  TriangleMesh barrierMesh_;
  SurfaceLocator locator_;
  BarrierFaces barriers_;
};

/// A grid of 4 x 4 squares whose middle 2 x 2 squares are barriers.
Barriers gridWithBarrier()
{
  const PlainMesh mesh = geodesictest::regularGrid(4, 4);
  std::vector<bool> isBarrier;
  for (const geodesictest::Triangle& t : mesh.triangles)
  {
    const auto middle = [&](std::size_t axis)
    {
      const double sum =
        mesh.points[t[0]][axis] + mesh.points[t[1]][axis] + mesh.points[t[2]][axis];
      return sum > 3.0 && sum < 9.0;
    };
    isBarrier.push_back(middle(0) && middle(1));
  }
  return Barriers(mesh, isBarrier);
}

TEST(BarrierFaces, APointInsideABarrierIsInTheFaceThatHoldsIt)
{
  Barriers barriers = gridWithBarrier();
  ASSERT_EQ(barriers.mesh().numberOfFaces(), 8u);
  for (Id face = 0; face < barriers.mesh().numberOfFaces(); ++face)
  {
    const Triangle& t = barriers.mesh().triangle(face);
    const Vec3 centre = (1.0 / 3.0) *
      (barriers.mesh().point(t[0]) + barriers.mesh().point(t[1]) + barriers.mesh().point(t[2]));
    EXPECT_EQ(barriers.at(centre), face);
    EXPECT_EQ(barriers.at(centre + Vec3{ 0.0, 0.0, 0.3 }), face) << "above it";
  }
  EXPECT_NE(barriers.at({ 2.0, 2.0, 0.0 }), NoId) << "a vertex of barriers only";
  EXPECT_NE(barriers.at({ 1.5, 2.0, 0.0 }), NoId) << "on an edge between barriers";
}

TEST(BarrierFaces, TheRimLiesOutside)
{
  Barriers barriers = gridWithBarrier();
  for (const double along : { 1.0, 1.25, 1.7, 2.0, 3.0 })
  {
    for (const double side : { 1.0, 3.0 })
    {
      for (const double height : { 0.0, 0.2 })
      {
        EXPECT_EQ(barriers.at({ side, along, height }), NoId);
        EXPECT_EQ(barriers.at({ along, side, height }), NoId);
      }
    }
  }
  EXPECT_EQ(barriers.at({ 0.5, 2.0, 0.0 }), NoId);
  EXPECT_EQ(barriers.at({ -5.0, 2.0, 0.0 }), NoId) << "beside the surface";
}

TEST(BarrierFaces, APointIsOnTheRimWithinThePrecisionOfItsCoordinates)
{
  Barriers barriers = gridWithBarrier();
  EXPECT_EQ(barriers.at({ 1.0 + 2e-16, 2.0, 0.0 }), NoId);
  EXPECT_NE(barriers.at({ 1.0 + 1e-7, 2.0, 0.0 }), NoId);
  EXPECT_EQ(barriers.at({ 1.0 + 1e-7, 2.0, 0.0 }, FLT_EPSILON), NoId);
  EXPECT_NE(barriers.at({ 1.0 + 1e-4, 2.0, 0.0 }, FLT_EPSILON), NoId);
}

// The barrier is only a few roundings of its coordinates wide: a rounded point of the rim is nearer
// to the barrier's middle than the distance for snapping it back onto the rim.
TEST(BarrierFaces, APointARoundingInsideANarrowBarrierFarFromTheOriginIsOnTheRim)
{
  const double far = std::ldexp(1.0, 27);
  const double rounding = far * DBL_EPSILON;
  const double width = 16.0 * rounding;
  const PlainMesh mesh = { { { far, 0.0, 0.0 }, { far + width, 0.5, 0.0 }, { far, 1.0, 0.0 },
                             { far - 1.0, 0.5, 0.0 } },
    { { 0, 1, 2 }, { 0, 2, 3 } } };
  Barriers barriers(mesh, { true, false });
  EXPECT_EQ(barriers.at({ far, 0.5, 0.0 }), NoId);
  EXPECT_EQ(barriers.at({ far + 2.0 * rounding, 0.5, 0.0 }), NoId);
  EXPECT_NE(barriers.at({ far + 0.5 * width, 0.5, 0.0 }), NoId);
}

TEST(BarrierFaces, WhereABarrierAndAnotherFaceCoincideThePointIsOnTheOther)
{
  const PlainMesh sheet = geodesictest::regularGrid(2, 2);
  const PlainMesh both = geodesictest::merged(sheet, sheet);
  std::vector<bool> isBarrier(both.triangles.size(), false);
  std::fill(
    isBarrier.begin() + static_cast<std::ptrdiff_t>(sheet.triangles.size()), isBarrier.end(), true);
  Barriers barriers(both, isBarrier);
  Random random(5);
  for (int i = 0; i < 100; ++i)
  {
    EXPECT_EQ(barriers.at({ random.uniform(0, 2), random.uniform(0, 2), 0.1 }), NoId);
  }
}

TEST(BarrierFaces, OnRandomMeshesPointsOfFacesAreInThem)
{
  Random random(17);
  for (int i = 0; i < 20; ++i)
  {
    const PlainMesh mesh = geodesictest::bumpySheet(8, 8, 2, 0.3, random);
    std::vector<bool> isBarrier(mesh.triangles.size());
    for (std::size_t f = 0; f < isBarrier.size(); ++f)
    {
      isBarrier[f] = f == 0 || (f > 1 && random.chance(0.3));
    }
    Barriers barriers(mesh, isBarrier);
    for (int k = 0; k < 50; ++k)
    {
      const geodesictest::MeshPoint place = geodesictest::randomFacePoint(mesh, random);
      EXPECT_EQ(barriers.at(geodesictest::position(mesh, place)) != NoId, isBarrier[place.face]);
    }
  }
}

TEST(TriangleMesh, TheHalfedgeBetweenVerticesIsOneOfTheirEdgeInEitherDirection)
{
  Random random(4);
  const TriangleMesh mesh = geodesictest::engineMesh(
    geodesictest::withFlippedFaces(geodesictest::book(3, 3, 2, 0.1, random), random));
  for (Id a = 0; a < mesh.numberOfVertices(); ++a)
  {
    for (Id b = 0; b < mesh.numberOfVertices(); ++b)
    {
      bool isEdge = false;
      for (Id s = 0; s < mesh.numberOfHalfedges(); ++s)
      {
        isEdge = isEdge || (mesh.origin(s) == a && mesh.destination(s) == b) ||
          (mesh.origin(s) == b && mesh.destination(s) == a);
      }
      const Id found = mesh.halfedgeBetween(a, b);
      ASSERT_EQ(found != NoId, isEdge);
      if (isEdge)
      {
        EXPECT_EQ(std::minmax(mesh.origin(found), mesh.destination(found)), std::minmax(a, b));
      }
    }
  }
}

} // anonymous namespace
