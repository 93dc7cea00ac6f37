// SPDX-License-Identifier: BSD-3-Clause
// Unfolding a face, the queries of its apex, and windows that pass through it, compared with
// straight lines in the plane of the face.
#include "EngineSupport.h"
#include "window/WindowSupport.h"

#include "mesh/HalfedgeFrame.h"
#include "window/FacePropagation.h"

#include <gtest/gtest.h>

using namespace geodesictest;
using geodesic::ApexDistance;
using geodesic::ApexQuery;
using geodesic::ApexSide;
using geodesic::CornerDistances;
using geodesic::Id;
using geodesic::Infinity;
using geodesic::LeavingWindows;
using geodesic::UnfoldedFace;
using geodesic::WindowListBuilder;
using geodesic::WindowRange;
using PlanePoint = geodesic::Vec2;

namespace
{

constexpr double Accuracy = 1e-13;
constexpr CornerDistances Unknown = { Infinity, Infinity, Infinity };
constexpr Id Unlimited = 1000;

/// A triangle in space: halfedge 0 has the given length and a random direction, and the apex lies
/// at the given place above it.
geodesic::TriangleMesh triangle(double length, PlanePoint apex)
{
  const geodesic::Vec3 origin = { 0.3, -0.2, 0.1 };
  const geodesic::Vec3 along = { 2.0 / 3.0, 2.0 / 3.0, 1.0 / 3.0 };
  const geodesic::Vec3 above = { -2.0 / 3.0, 1.0 / 3.0, 2.0 / 3.0 };
  using geodesic::operator+;
  using geodesic::operator*;
  return geodesic::TriangleMesh(
    { origin, origin + length * along, origin + apex.x * along + apex.y * above }, { { 0, 1, 2 } });
}

struct RandomFace
{
  explicit RandomFace(Random& random)
    : length(random.uniform(0.5, 2.0))
    , apex({ random.uniform(-1.0, 3.0), random.uniform(0.05, 2.0) })
    , face(geodesic::unfold(triangle(length, apex), 0))
  {
  }

  /// A point of the left edge (from the origin to the apex) or of the right one (from the apex to
  /// the destination).
  PlanePoint onLeft(double x) const { return (x / this->face.leftLength) * this->apex; }
  PlanePoint onRight(double x) const
  {
    return this->apex +
      (x / this->face.rightLength) * (PlanePoint{ this->length, 0.0 } - this->apex);
  }

  double length;
  PlanePoint apex;
  UnfoldedFace face;
};

/// Windows on a halfedge of the distance from weighted points and from a wave: they cover it
/// without gaps and have equal distances where they meet.
WindowListBuilder fieldOn(double length, Random& random)
{
  WindowListBuilder builder;
  builder.reset(length);
  for (Index i = random.between(1, 6); i > 0; --i)
  {
    builder.append(circularWindow(0.0, length, random.uniform(-1.0, 2.0) * length,
      std::pow(10.0, random.uniform(-1.5, 1.0)), random.uniform(0.0, length)));
  }
  if (random.chance(0.5))
  {
    builder.append(linearWindow(0.0, length, random.uniform(-0.9, 0.9), random.uniform(1.0, 3.0)));
  }
  return builder;
}

/// The shortest straight or bent path through the list.
double exactThrough(const WindowRange& list, PlanePoint p)
{
  Extended least = Infinity;
  for (const Window& w : list)
  {
    least = std::min(least, exactBentDistance(w, p.x, p.y));
  }
  return static_cast<double>(least);
}

/// The value of a list at x; infinite in a gap.
double at(const WindowRange& list, double x)
{
  double least = Infinity;
  for (const Window& w : list)
  {
    least = x >= w.begin && x <= w.end ? std::min(least, w.distance(x)) : least;
  }
  return least;
}

/// Each window behind an edge continues one of the list straight.
template <typename OnEdge>
void expectStraight(const WindowRange& list, const WindowRange& children, const OnEdge& onEdge)
{
  for (const Window& child : children)
  {
    for (const double t : { 0.001, 0.3, 0.5, 0.999 })
    {
      const double x = child.begin + t * (child.end - child.begin);
      const PlanePoint p = onEdge(x);
      double nearest = Infinity;
      for (const Window& w : list)
      {
        const double hit = w.crossing(p);
        const bool held = hit > w.begin - 1e-9 && hit < w.end + 1e-9 &&
          std::abs(static_cast<double>(
            exactDistance(w, p.x, p.y) - exactBentDistance(w, p.x, p.y))) < 1e-9;
        const double off =
          std::abs(static_cast<double>(exactDistance(w, p.x, p.y)) - child.distance(x));
        nearest = held ? std::min(nearest, off) : nearest;
      }
      ASSERT_LE(nearest, Accuracy * (10.0 + child.distance(x))) << child << " at " << x;
    }
  }
}

/// No ray of the list that leaves through an edge is missing behind it, unless a path through a
/// corner is at least as short.
template <typename OnEdge>
void expectComplete(const WindowRange& list, const WindowRange& children, double length,
  double atBegin, double atEnd, const OnEdge& onEdge)
{
  constexpr int samples = 40;
  for (int k = 0; k < samples; ++k)
  {
    const double x = length * (k + 0.5) / samples;
    const PlanePoint p = onEdge(x);
    const double known = std::min({ at(children, x), atBegin + x, atEnd + (length - x) });
    for (const Window& w : list)
    {
      const double hit = w.crossing(p);
      if (hit > w.begin + 1e-12 && hit < w.end - 1e-12)
      {
        const double straight = static_cast<double>(exactDistance(w, p.x, p.y));
        ASSERT_LE(known, straight + 1e-11 * (10.0 + straight)) << w << " at " << x;
      }
    }
  }
}

}

TEST(ApexQuery, TheFullOneFindsTheShortestPathThroughAField)
{
  Random random(4);
  std::vector<ApexSide> sides;
  for (int i = 0; i < 2000; ++i)
  {
    const RandomFace r(random);
    const WindowListBuilder list = fieldOn(r.length, random);
    const ApexQuery query = fullApexQuery(list.range(), r.apex, sides);
    const double truth = exactThrough(list.range(), r.apex);
    ASSERT_NEAR(query.shortest.distance, truth, 1e-12 * (1.0 + truth));
    // and where it crosses the halfedge
    const double x = query.shortest.nearest->crossing(r.apex);
    ASSERT_NEAR(
      at(list.range(), x) + std::hypot(r.apex.x - x, r.apex.y), truth, 1e-12 * (1.0 + truth));
  }
}

TEST(ApexQuery, TheQuickOneFindsARealPath)
{
  Random random(6);
  std::vector<ApexSide> sides;
  int equal = 0;
  constexpr int lists = 2000;
  for (int i = 0; i < lists; ++i)
  {
    const RandomFace r(random);
    WindowListBuilder list = fieldOn(r.length, random);
    const ApexDistance quick = quickApexQuery(list.range(), r.apex);
    const double truth = exactThrough(list.range(), r.apex);
    ASSERT_GE(quick.distance, truth - 1e-12 * (1.0 + truth));
    const double x = quick.nearest->crossing(r.apex);
    ASSERT_NEAR(at(list.range(), x) + std::hypot(r.apex.x - x, r.apex.y), quick.distance,
      1e-12 * (1.0 + truth));
    equal += quick.distance <= truth * (1.0 + 1e-12) ? 1 : 0;
  }
  EXPECT_GT(equal, lists * 8 / 10) << "most paths are the shortest ones";
}

TEST(ApexQuery, OfAnEmptyListItIsInfinite)
{
  std::vector<ApexSide> sides;
  EXPECT_EQ(
    geodesic::fullApexQuery({}, geodesic::Vec2{ 0.5, 1.0 }, sides).shortest.distance, Infinity);
  EXPECT_EQ(geodesic::quickApexQuery({}, { 0.5, 1.0 }).distance, Infinity);
}

TEST(ApexQuery, TheErrorIsThatOfTheWindowThatGivesTheDistance)
{
  Window near = circularWindow(0.0, 0.5, 0.25, 0.1);
  near.error = 0.25;
  Window far = circularWindow(0.5, 1.0, 0.75, 0.1, 0.5);
  far.error = 0.5;
  const std::vector<Window> windows = { near, far };
  const WindowRange list = { windows.data(), windows.data() + windows.size() };
  std::vector<ApexSide> sides;
  EXPECT_EQ(fullApexQuery(list, geodesic::Vec2{ 0.3, 1.0 }, sides).shortest.nearest->error, 0.25);
  EXPECT_EQ(quickApexQuery(list, { 0.3, 1.0 }).nearest->error, 0.25);
}

TEST(FacePropagation, OnlyOneWindowThatContainsTheApexContinuesThroughBothEdges)
{
  // Three sources whose rays all pass through the apex; the middle one is the nearest.
  const geodesic::TriangleMesh mesh = triangle(3.0, { 1.5, 1.0 });
  const UnfoldedFace face = geodesic::unfold(mesh, 0);
  const std::vector<Window> windows = { circularWindow(0.0, 1.0, 0.0, 1.0, 0.4),
    circularWindow(1.0, 2.0, 1.5, 1.0, 0.0), circularWindow(2.0, 3.0, 3.0, 1.0, 0.4) };
  const WindowRange list = { windows.data(), windows.data() + windows.size() };
  std::vector<ApexSide> sides;
  const ApexQuery apex = fullApexQuery(list, face.apex, sides);
  for (const ApexSide side : sides)
  {
    EXPECT_EQ(side, ApexSide::Both);
  }
  EXPECT_EQ(apex.first, 1u);
  LeavingWindows leaving;
  propagateThroughFace(apex, face, Unknown, Unlimited, leaving);
  EXPECT_EQ(leaving.left.windows().size(), 2u);
  EXPECT_EQ(leaving.right.windows().size(), 2u);
}

TEST(FacePropagation, WindowsThatHaveCrossedTooManyFacesAreDropped)
{
  const UnfoldedFace face = geodesic::unfold(triangle(1.0, { 0.5, 1.0 }), 0);
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
  const UnfoldedFace face = geodesic::unfold(triangle(1.0, { 0.0, 1.0 }), 0);
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
