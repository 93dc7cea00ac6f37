// SPDX-License-Identifier: BSD-3-Clause
// The origins of rays: each kind keeps its number and its flags in 32 bits, up to the last number.
// What becomes of them on a surface, sides and angles show.
#include "window/RayOrigin.h"

#include <gtest/gtest.h>

using geodesic::Id;
using geodesic::MaximumVertices;
using geodesic::RayOrigin;

namespace
{

constexpr Id Last = RayOrigin::MaximumOnCurves - 1;

}

TEST(RayOrigin, KeepsItsKindAndItsNumberAlsoInAMirror)
{
  for (const Id number : { 0U, 1U, 2U, 3U, MaximumVertices - 2, MaximumVertices - 1 })
  {
    const geodesic::GlobalId id{ number };
    const RayOrigin origin = RayOrigin::vertex(id);
    EXPECT_TRUE(origin.isKnown() && origin.isVertex() && !origin.isOnCurve() && !origin.isPoint());
    EXPECT_EQ(origin.vertex(), id);
    EXPECT_EQ(origin.mirrored(), origin);
  }
  for (const Id number : { Id(0), Id(1), Last - 1, Last })
  {
    for (const bool isRight : { false, true })
    {
      const RayOrigin side = RayOrigin::curveSide(number, isRight);
      const RayOrigin point = RayOrigin::pointSide(number, isRight);
      for (const RayOrigin& origin : { side, point, side.mirrored(), point.mirrored() })
      {
        EXPECT_TRUE(origin.isKnown() && origin.isOnCurve() && !origin.isVertex());
        EXPECT_EQ(origin.isPoint() ? origin.point() : origin.curve(), number);
        EXPECT_EQ(origin.isRight(), isRight);
        EXPECT_EQ(origin.mirrored().mirrored(), origin);
        EXPECT_NE(origin.mirrored(), origin);
        EXPECT_NE(origin, RayOrigin::vertex(geodesic::GlobalId{ number }));
      }
      EXPECT_NE(side, point);
    }
  }
}

TEST(RayOrigin, MorePointsThanCanBeNumberedAreAnError)
{
  EXPECT_THROW(RayOrigin::pointSide(Last + 1, false), geodesic::SourceError);
  EXPECT_THROW(RayOrigin::curveSide(Last + 1, false), geodesic::SourceError);
}
