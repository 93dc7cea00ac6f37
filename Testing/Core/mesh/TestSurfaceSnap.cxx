// SPDX-License-Identifier: BSD-3-Clause
// A point in space goes from the closest point of its face, which PlacesBesideSurface asks for,
// onto a vertex or an edge within its precision.
#include "EngineSupport.h"

#include "mesh/SurfaceSnap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace geodesictest;
using geodesic::SnappedPoint;
using geodesic::snapToFace;
using geodesic::SurfacePoint;
using geodesic::TriangleMesh;

namespace
{

constexpr double Epsilon = std::numeric_limits<double>::epsilon();
constexpr double FloatEpsilon = std::numeric_limits<float>::epsilon();

}

TEST(SurfaceSnap, WithinItsPrecisionAPointGoesOntoAVertexOrAnEdgeAndNotBeyond)
{
  const PlainMesh plain = { { { 1, 1, 1 }, { 3, 1, 1 }, { 1, 3, 1 } }, { { 0, 1, 2 } } };
  const TriangleMesh mesh = engineMesh(plain);
  const double precision = 4.0 * FloatEpsilon * 3.0; // SnapRoundings, of the largest coordinate
  const auto kind = [&](const Vec3& p) { return snapToFace(mesh, 0, p, FloatEpsilon).place.kind; };
  EXPECT_EQ(kind({ 1 + 0.6 * precision, 1 + 0.6 * precision, 1 }), SurfacePoint::Kind::Vertex);
  EXPECT_EQ(kind({ 1 + 1.1 * precision, 1 + 0.5 * precision, 1 }), SurfacePoint::Kind::Edge);
  EXPECT_EQ(kind({ 2, 1 + 0.9 * precision, 1 }), SurfacePoint::Kind::Edge);
  EXPECT_EQ(kind({ 1.5, 1 + 1.1 * precision, 1 }), SurfacePoint::Kind::Face);
  EXPECT_EQ(kind({ 2.0 - precision, 2.0, 1 }), SurfacePoint::Kind::Edge);
}

TEST(SurfaceSnap, OfTwoEdgesWithinThePrecisionTheNearerOneIsTaken)
{
  // The two long edges of a needle, at an angle of .1, and a point nearer to one of them.
  const PlainMesh plain = { { { 0, 0, 0 }, { 10, 0, 0 }, { 10, 1, 0 } }, { { 0, 1, 2 } } };
  for (Index first = 0; first < 3; ++first)
  {
    PlainMesh turned = plain;
    const Triangle t = { first, (first + 1) % 3, (first + 2) % 3 };
    turned.triangles = { t };
    const TriangleMesh mesh = engineMesh(turned);
    const double width = 0.1; // of the needle at x = 1
    // Both edges are within the precision, which is within a tenth of the face's altitudes.
    const double precision = 0.09 / 4.0 / 10.0;
    for (const double y : { 0.3 * width, 0.7 * width })
    {
      const SnappedPoint snapped = snapToFace(mesh, 0, { 1, y, 0 }, precision);
      ASSERT_EQ(snapped.place.kind, SurfacePoint::Kind::Edge);
      const auto ends =
        std::minmax({ mesh.origin(snapped.place.id), mesh.destination(snapped.place.id) });
      EXPECT_EQ(ends.first, 0u);
      EXPECT_EQ(ends.second, y < 0.5 * width ? 1u : 2u) << "first corner " << first;
      EXPECT_NEAR(snapped.distance, 0.3 * width, 0.01 * width);
    }
  }
}

TEST(SurfaceSnap, FarFromTheOriginAPointKeepsItsPlaceInTheFace)
{
  // The precision is as large as the face; only points beside vertices and edges are moved.
  const double far = 1.0 / FloatEpsilon;
  const PlainMesh plain = { { { far, 0, 0 }, { far + 1, 0, 0 }, { far, 1, 0 } }, { { 0, 1, 2 } } };
  const TriangleMesh mesh = engineMesh(plain);
  const SnappedPoint inside = snapToFace(mesh, 0, { far + 0.25, 0.25, 0 }, FloatEpsilon);
  EXPECT_EQ(inside.place.kind, SurfacePoint::Kind::Face);
  EXPECT_LE(inside.tolerance, 0.1);
  EXPECT_EQ(snapToFace(mesh, 0, { far + 0.05, 0.05, 0 }, FloatEpsilon).place.kind,
    SurfacePoint::Kind::Vertex);
}

// The precision of a point follows from the largest of its own coordinates, too.
TEST(SurfaceSnap, APointFarFromTheFaceIsAsPreciseAsItsCoordinates)
{
  const TriangleMesh mesh =
    engineMesh({ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } } });
  constexpr double beside = 1e-8; // less than a rounding at a height of 1e9, more than at 1
  const auto kindAt = [&](double x, double y, double height) {
    return snapToFace(mesh, 0, { x, y, height }, Epsilon).place.kind;
  };
  EXPECT_EQ(kindAt(beside, beside, 1e9), SurfacePoint::Kind::Vertex);
  EXPECT_EQ(kindAt(0.4, beside, 1e9), SurfacePoint::Kind::Edge);
  EXPECT_EQ(kindAt(beside, beside, 1.0), SurfacePoint::Kind::Face);
  EXPECT_EQ(kindAt(0.4, beside, 1.0), SurfacePoint::Kind::Face);
}
