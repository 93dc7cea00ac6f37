// SPDX-License-Identifier: BSD-3-Clause
// Places of a face in the frames of its halfedges have the same distances as in space.
#include "EngineSupport.h"

#include "mesh/HalfedgeFrame.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace geodesictest;
using geodesic::Id;
using geodesic::TriangleMesh;
using PlanePoint = geodesic::Vec2;

namespace
{

constexpr double Accuracy = 1e-14;

PlainMesh someTriangles(Random& random)
{
  PlainMesh mesh;
  for (Index f = 0; f < 200; ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      mesh.points.push_back(
        { random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0) });
    }
    mesh.triangles.push_back({ 3 * f, 3 * f + 1, 3 * f + 2 });
  }
  return mesh;
}

}

TEST(HalfedgeFrame, DistancesAreThoseInSpace)
{
  Random random(1);
  const PlainMesh plain = someTriangles(random);
  const TriangleMesh mesh = engineMesh(plain);
  for (Id face = 0; face < mesh.numberOfFaces(); ++face)
  {
    const Barycentric a = randomWeights(random);
    const Barycentric b = randomWeights(random);
    const double truth = spaceDistance(position(plain, { face, a }), position(plain, { face, b }));
    for (Id halfedge = 3 * face; halfedge < 3 * face + 3; ++halfedge)
    {
      const PlanePoint p = inHalfedgeFrame(mesh, halfedge, a);
      const PlanePoint q = inHalfedgeFrame(mesh, halfedge, b);
      EXPECT_NEAR(norm(p - q), truth, 10.0 * Accuracy);
      EXPECT_GE(p.y, 0.0) << "the face lies above";
    }
    EXPECT_NEAR(distanceInFace(mesh, face, a, b), truth, 10.0 * Accuracy);
  }
}

TEST(HalfedgeFrame, TheHalfedgeIsTheAxisAndTheApexIsOpposite)
{
  Random random(2);
  const TriangleMesh mesh = engineMesh(someTriangles(random));
  for (Id halfedge = 0; halfedge < mesh.numberOfHalfedges(); ++halfedge)
  {
    std::array<Barycentric, 3> corners = {};
    for (std::size_t k = 0; k < 3; ++k)
    {
      corners[k][(halfedge + k) % 3] = 1.0;
    }
    const PlanePoint origin = inHalfedgeFrame(mesh, halfedge, corners[0]);
    const PlanePoint destination = inHalfedgeFrame(mesh, halfedge, corners[1]);
    EXPECT_EQ(norm(origin), 0.0);
    EXPECT_NEAR(norm(destination - PlanePoint{ mesh.length(halfedge), 0.0 }), 0.0, Accuracy);
    EXPECT_NEAR(
      norm(inHalfedgeFrame(mesh, halfedge, corners[2]) - apexOf(mesh, halfedge)), 0.0, Accuracy);
  }
}

TEST(HalfedgeFrame, AHalfedgeWithoutLengthHasAFrame)
{
  const TriangleMesh mesh({ { 1, 1, 0 }, { 1, 1, 0 }, { 4, 5, 0 } }, { { 0, 1, 2 } });
  EXPECT_EQ(mesh.length(0), 0.0);
  EXPECT_DOUBLE_EQ(norm(inHalfedgeFrame(mesh, 0, { 0.0, 0.0, 1.0 })), 5.0);
  EXPECT_EQ(mesh.length(longestHalfedge(mesh, 0)), 5.0);
}
