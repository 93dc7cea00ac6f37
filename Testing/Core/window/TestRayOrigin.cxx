// SPDX-License-Identifier: BSD-3-Clause
// The origins of rays: each kind keeps its number and its flags in 32 bits.
#include "window/RayOrigin.h"

#include <gtest/gtest.h>

#include <vector>

using geodesic::Id;
using geodesic::MaximumVertices;
using geodesic::RayOrigin;

namespace
{

constexpr Id Last = RayOrigin::MaximumOnCurves - 1;

/// What an origin on a curve says, as it is and in a mirror.
void expectOnCurve(const RayOrigin& origin, bool isPoint, bool isRight, bool isMirrored)
{
  for (const RayOrigin& seen : { origin, origin.mirrored() })
  {
    EXPECT_TRUE(seen.isKnown());
    EXPECT_FALSE(seen.isVertex());
    EXPECT_TRUE(seen.isOnCurve());
    EXPECT_EQ(seen.isPoint(), isPoint);
    EXPECT_EQ(seen.isRight(), isRight);
  }
  EXPECT_EQ(origin.isMirrored(), isMirrored);
  EXPECT_EQ(origin.mirrored().isMirrored(), !isMirrored);
  EXPECT_EQ(origin.mirrored().mirrored(), origin);
}

TEST(RayOrigin, NoneIsOfNoKind)
{
  const RayOrigin none;
  EXPECT_FALSE(none.isKnown());
  EXPECT_FALSE(none.isVertex());
  EXPECT_FALSE(none.isOnCurve());
  EXPECT_FALSE(none.isPoint());
  EXPECT_EQ(none.mirrored(), none);
}

TEST(RayOrigin, AVertexKeepsItsIdAlsoInAMirror)
{
  for (const Id id : { 0U, 1U, 2U, 3U, MaximumVertices - 2, MaximumVertices - 1 })
  {
    const RayOrigin origin = RayOrigin::vertex(id);
    EXPECT_TRUE(origin.isKnown());
    EXPECT_TRUE(origin.isVertex());
    EXPECT_FALSE(origin.isOnCurve());
    EXPECT_FALSE(origin.isPoint());
    EXPECT_EQ(origin.vertex(), id);
    EXPECT_EQ(origin.mirrored(), origin);
  }
}

TEST(RayOrigin, ASideOfACurveKeepsCurveAndSideAlsoInAMirror)
{
  for (const Id curve : { Id(0), Id(1), Last - 1, Last })
  {
    for (const bool isRight : { false, true })
    {
      const RayOrigin origin = RayOrigin::curveSide(curve, isRight);
      expectOnCurve(origin, false, isRight, false);
      EXPECT_EQ(origin.curve(), curve);
      EXPECT_EQ(origin.mirrored().curve(), curve);
    }
  }
}

TEST(RayOrigin, APointOfACurveKeepsPointAndSideAlsoInAMirror)
{
  for (const Id point : { Id(0), Id(1), Last - 1, Last })
  {
    for (const bool isRight : { false, true })
    {
      for (const bool isMirrored : { false, true })
      {
        const RayOrigin origin = RayOrigin::pointSide(point, isRight, isMirrored);
        expectOnCurve(origin, true, isRight, isMirrored);
        EXPECT_EQ(origin.point(), point);
        EXPECT_EQ(origin.mirrored().point(), point);
      }
    }
  }
}

TEST(RayOrigin, DifferentOriginsAreNotEqual)
{
  std::vector<RayOrigin> all = { RayOrigin() };
  for (const Id number : { 0U, 1U, 2U, 3U, 4U, 8U, 12U })
  {
    all.push_back(RayOrigin::vertex(number));
    for (const bool isRight : { false, true })
    {
      const RayOrigin curve = RayOrigin::curveSide(number, isRight);
      const RayOrigin point = RayOrigin::pointSide(number, isRight);
      all.insert(all.end(), { curve, curve.mirrored(), point, point.mirrored() });
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    for (std::size_t j = 0; j < all.size(); ++j)
    {
      EXPECT_EQ(all[i] == all[j], i == j);
      EXPECT_EQ(all[i] != all[j], i != j);
    }
  }
}

// In a mirror right is left, and counterclockwise turns are clockwise.
TEST(RayOrigin, LengthsAndAnglesChangeTheirSignInAMirror)
{
  const RayOrigin left = RayOrigin::curveSide(5, false);
  const RayOrigin right = RayOrigin::curveSide(5, true);
  EXPECT_EQ(left.alongCurve(2.0), 2.0);
  EXPECT_EQ(left.mirrored().alongCurve(2.0), -2.0);
  EXPECT_EQ(right.alongCurve(2.0), -2.0);
  EXPECT_EQ(right.mirrored().alongCurve(2.0), 2.0);
  for (const bool isRight : { false, true })
  {
    const RayOrigin point = RayOrigin::pointSide(5, isRight);
    EXPECT_EQ(point.aroundPoint(2.0), 2.0);
    EXPECT_EQ(point.mirrored().aroundPoint(2.0), -2.0);
  }
}

TEST(RayOrigin, MorePointsThanCanBeNumberedAreAnError)
{
  EXPECT_THROW(RayOrigin::pointSide(Last + 1, false), geodesic::SourceError);
  EXPECT_THROW(RayOrigin::curveSide(Last + 1, false), geodesic::SourceError);
}

} // anonymous namespace
