// SPDX-License-Identifier: BSD-3-Clause
// What a window that passes through a face takes along, and where it ends. That all rays arrive,
// and straight, the distances of whole meshes show.
#include "EngineSupport.h"
#include "window/WindowSupport.h"

#include "window/FacePropagation.h"

#include <gtest/gtest.h>

using namespace geodesictest;
using geodesic::ApexQuery;
using geodesic::ApexSide;
using geodesic::CornerDistances;
using geodesic::Id;
using geodesic::Infinity;
using geodesic::LeavingWindows;
using geodesic::UnfoldedFace;
using geodesic::WindowRange;

namespace
{

constexpr CornerDistances Unknown = { Infinity, Infinity, Infinity };
constexpr Id Unlimited = 1000;

/// A face over a halfedge from (0, 0) to (1, 0).
UnfoldedFace faceWithApex(double x, double y)
{
  return geodesic::unfold(
    engineMesh({ { { 0, 0, 0 }, { 1, 0, 0 }, { x, y, 0 } }, { { 0, 1, 2 } } }), 0);
}

}

TEST(ApexQuery, TheErrorIsThatOfTheWindowThatGivesTheDistance)
{
  Window near = circularWindow(0.0, 0.5, 0.25, 0.1);
  near.error = 0.01;
  Window far = circularWindow(0.5, 1.0, 0.75, 0.1, 0.5);
  far.error = 0.02;
  const std::vector<Window> windows = { near, far };
  const WindowRange list = { windows.data(), windows.data() + windows.size() };
  std::vector<ApexSide> sides;
  EXPECT_EQ(fullApexQuery(list, geodesic::Vec2{ 0.3, 1.0 }, sides).shortest.nearest->error, 0.01);
  EXPECT_EQ(quickApexQuery(list, { 0.3, 1.0 }).nearest->error, 0.01);
}

TEST(FacePropagation, WindowsThatHaveCrossedTooManyFacesAreDropped)
{
  const UnfoldedFace face = faceWithApex(0.5, 1.0);
  Window w = circularWindow(0.0, 1.0, 0.5, 1.0);
  constexpr Id maximum = 7;
  std::vector<ApexSide> sides;
  LeavingWindows leaving;
  w.facesCrossed = maximum;
  propagateThroughFace(
    fullApexQuery({ &w, &w + 1 }, face.apex, sides), face, Unknown, maximum, leaving);
  EXPECT_EQ(leaving.left.windows().size(), 0u);
  EXPECT_EQ(leaving.right.windows().size(), 0u);
  w.facesCrossed = maximum - 1;
  propagateThroughFace(
    fullApexQuery({ &w, &w + 1 }, face.apex, sides), face, Unknown, maximum, leaving);
  ASSERT_EQ(leaving.left.windows().size(), 1u);
  ASSERT_EQ(leaving.right.windows().size(), 1u);
  EXPECT_EQ(leaving.left.windows()[0].facesCrossed, maximum);
}

TEST(FacePropagation, WindowsThatAPathThroughACornerBeatsAreDroppedAndTiesStay)
{
  // A window from (.5, -1) straight to the left edge of a face. The distance known at the face's
  // origin equals the straight path's, or is slightly smaller or larger.
  const UnfoldedFace face = faceWithApex(0.0, 1.0);
  const Window w = circularWindow(0.0, 0.2, 0.5, 1.0);
  const double straight = std::hypot(0.5, 1.0);
  std::vector<ApexSide> sides;
  const ApexQuery apex = fullApexQuery({ &w, &w + 1 }, face.apex, sides);
  LeavingWindows leaving;
  const auto count = [&](double atOrigin)
  {
    propagateThroughFace(apex, face, { atOrigin, Infinity, Infinity }, Unlimited, leaving);
    return leaving.left.windows().size();
  };
  // The ray through the window's far end meets the left edge 1/3 + ... from its origin.
  ASSERT_EQ(count(Infinity), 1u);
  const Window child = leaving.left.windows()[0];
  const double atFarEnd = child.distance(child.end);
  EXPECT_EQ(count(straight), 1u);
  EXPECT_EQ(count((atFarEnd - child.end) * (1.0 + 1e-9)), 1u);
  EXPECT_EQ(count(atFarEnd - child.end), 1u) << "a tie must stay";
  EXPECT_EQ(count((atFarEnd - child.end) * (1.0 - 1e-9)), 0u);
}
