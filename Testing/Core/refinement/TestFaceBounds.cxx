// SPDX-License-Identifier: BSD-3-Clause
// Bounds over a whole face compared with the distance through its windows, point by point.
#include "EngineSupport.h"

#include "refinement/FaceBounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace geodesictest;
using geodesic::FaceBounds;
using geodesic::MeasuredList;
using geodesic::TriangleMesh;
using geodesic::Window;
using geodesic::WindowRange;
using geodesic::WindowRuns;

namespace
{

constexpr double Rounding = 1e-12;

using Corners = std::array<double, 3>;
using Lists = std::array<std::vector<Window>, 3>;

/// One face in the xy plane, of any shape.
PlainMesh randomFace(Random& random)
{
  return { { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 },
             { random.uniform(-0.5, 1.5), random.uniform(0.05, 1.5), 0.0 } },
    { { 0, 1, 2 } } };
}

/// A list that has passed, with the distances at the ends of its halfedge.
geodesic::PassedList passed(
  geodesic::Id halfedge, std::vector<Window>& windows, const std::array<double, 2>& ends)
{
  return { halfedge, { windows.data(), static_cast<std::uint32_t>(windows.size()), 0 }, ends };
}

/// Lists through all halfedges, found to be in their bands.
geodesic::MeasuredLists listsInBands(const Corners& d)
{
  geodesic::MeasuredLists lists;
  for (geodesic::Id k = 0; k < 3; ++k)
  {
    lists.push_back({ { k, {}, { d[k], d[(k + 1) % 3] } }, true, true });
  }
  return lists;
}

/// Points of the face, its border included.
std::vector<Barycentric> pointsOfFace()
{
  constexpr int steps = 24;
  std::vector<Barycentric> points;
  for (int i = 0; i <= steps; ++i)
  {
    for (int j = 0; i + j <= steps; ++j)
    {
      const double u = static_cast<double>(i) / steps;
      const double v = static_cast<double>(j) / steps;
      points.push_back({ 1.0 - u - v, u, v });
    }
  }
  return points;
}

/// A window on the halfedge from 0 to 1, with a source at most this far away.
Window randomWindow(double begin, double end, double farthest, Random& random)
{
  Window w{};
  w.begin = begin;
  w.end = end;
  w.kind = Window::Kind::Circular;
  w.sourceX = random.uniform(-1.0, 2.0) * (farthest > 5.0 ? 0.3 * farthest : 1.0);
  w.sourceDepth = random.uniform(0.01, farthest);
  w.sigma = random.uniform(0.0, 0.3);
  return w;
}

/// The length of the shortest way through the window to a point, given by its place along the
/// halfedge and its height over it.
double throughWindow(const Window& w, double x, double height)
{
  const double straight = w.sourceX + (x - w.sourceX) * w.sourceDepth / (w.sourceDepth + height);
  const double at = std::clamp(straight, w.begin, w.end);
  return w.sigma + std::hypot(at - w.sourceX, w.sourceDepth) + std::hypot(x - at, height);
}

double throughHalfedge(const PlainMesh& mesh, std::size_t k, const std::vector<Window>& windows,
  const Barycentric& place)
{
  const Vec3& a = mesh.points[k];
  const Vec3& b = mesh.points[(k + 1) % 3];
  const Vec3 p = position(mesh, MeshPoint{ 0, place });
  const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
  const Vec2 along = { (b[0] - a[0]) / length, (b[1] - a[1]) / length };
  const Vec2 to = { p[0] - a[0], p[1] - a[1] };
  const double x = to[0] * along[0] + to[1] * along[1];
  const double height = std::max(0.0, along[0] * to[1] - along[1] * to[0]);
  double least = geodesic::Infinity;
  for (const Window& w : windows)
  {
    least = std::min(least, throughWindow(w, x, height));
  }
  return least;
}

double throughFace(const PlainMesh& mesh, const Lists& lists, const Barycentric& place)
{
  double least = geodesic::Infinity;
  for (std::size_t k = 0; k < 3; ++k)
  {
    least = std::min(least, throughHalfedge(mesh, k, lists[k], place));
  }
  return least;
}

Corners atCorners(const PlainMesh& mesh, const Lists& lists)
{
  return { throughFace(mesh, lists, { 1.0, 0.0, 0.0 }), throughFace(mesh, lists, { 0.0, 1.0, 0.0 }),
    throughFace(mesh, lists, { 0.0, 0.0, 1.0 }) };
}

double interpolant(const Corners& d, const Barycentric& place)
{
  return place[0] * d[0] + place[1] * d[1] + place[2] * d[2];
}

/// The largest difference of the distance over the interpolant, and under it.
FaceBounds measured(const PlainMesh& mesh, const Lists& lists, const Corners& d)
{
  FaceBounds largest{ 0.0, 0.0 };
  for (const Barycentric& place : pointsOfFace())
  {
    const double over = throughFace(mesh, lists, place) - interpolant(d, place);
    largest.above = std::max(largest.above, over);
    largest.below = std::max(largest.below, -over);
  }
  return largest;
}

/// One to three windows on some of the halfedges, at least one.
Lists randomLists(const TriangleMesh& mesh, double farthest, Random& random)
{
  Lists lists;
  do
  {
    for (geodesic::Id k = 0; k < 3; ++k)
    {
      const double length = mesh.length(k);
      for (Index i = random.below(3); i > 0; --i)
      {
        const double begin = random.chance(0.6) ? 0.0 : random.uniform(0.0, 0.5) * length;
        const double end = random.chance(0.6) ? length : random.uniform(0.6, 1.0) * length;
        lists[k].push_back(randomWindow(begin, end, farthest, random));
      }
    }
  } while (lists[0].empty() && lists[1].empty() && lists[2].empty());
  return lists;
}

}

TEST(FaceBounds, HoldWhereverTheWindowsComeFrom)
{
  int steep = 0;
  for (std::uint64_t seed = 0; seed < 4000; ++seed)
  {
    Random random(seed);
    const PlainMesh plain = randomFace(random);
    const TriangleMesh mesh = engineMesh(plain);
    const Lists lists = randomLists(mesh, seed % 2 == 0 ? 2.0 : 50.0, random);
    const Corners d = atCorners(plain, lists);
    std::array<WindowRange, 3> ranges;
    std::array<WindowRuns, 3> runs;
    for (std::size_t k = 0; k < 3; ++k)
    {
      ranges[k] = { lists[k].data(), lists[k].data() + lists[k].size() };
      runs[k] = lists[k].empty() ? WindowRuns() : WindowRuns(&ranges[k], &ranges[k] + 1);
    }
    const FaceBounds known = measured(plain, lists, d);
    const FaceBounds bounds = geodesic::boundsOfFace(mesh, 0, d, runs, geodesic::Infinity);
    EXPECT_LE(known.above, bounds.above + Rounding) << "seed " << seed;
    EXPECT_LE(known.below, bounds.below + Rounding) << "seed " << seed;
    for (const double limit : { 0.01, 0.1, 0.5 })
    {
      const FaceBounds limited = geodesic::boundsOfFace(mesh, 0, d, runs, limit);
      EXPECT_LE(known.above, limited.above + Rounding) << "seed " << seed;
      EXPECT_LE(known.below, limited.below + Rounding) << "seed " << seed;
    }
    steep += geodesic::slackOf(mesh.shape(0), d).below > 0.0 ? 1 : 0;
  }
  EXPECT_GT(steep, 100) << "few had an interpolant steeper than a distance";
}

// The middle of the longest edge is the place of the corner opposite, which the interpolant along
// the edge does not know.
TEST(FaceBounds, HoldInAFaceWithoutArea)
{
  const TriangleMesh mesh =
    engineMesh({ { { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, 0, 0 } }, { { 0, 1, 2 } } });
  const Corners d = { 0.5, 0.5, 0.0 };
  EXPECT_GE(geodesic::boundsOfFace(mesh, 0, d, {}, 10.0).below, 0.5);
  EXPECT_GE(geodesic::boundsByBand(mesh, 0, d, listsInBands(d), 0.4).below, 0.5);
}

namespace
{

/// A list that covers a halfedge except for small gaps, at distances of about 10; each window is
/// off the line between the ends by this much.
std::vector<Window> listNearLine(double length, double off, Random& random)
{
  std::vector<Window> list;
  const double slope = random.uniform(-0.9, 0.9);
  double x = random.chance(0.8) ? 0.0 : random.uniform(0.0, off);
  while (x < 0.9 * length)
  {
    Window w{};
    w.begin = x;
    w.end = random.chance(0.3) ? length : std::min(length, x + random.uniform(0.2, 0.5) * length);
    const double depth = std::sqrt(1.0 - slope * slope);
    const double distance = random.uniform(2.0, 9.0);
    w.kind = random.chance(0.3) ? Window::Kind::Linear : Window::Kind::Circular;
    w.sourceX = w.isLinear() ? slope : 0.5 * (w.begin + w.end) - slope * distance;
    w.sourceDepth = w.isLinear() ? depth : depth * distance;
    w.sigma = 10.0 + slope * w.begin - w.distance(w.begin) + random.uniform(-0.5, 0.5) * off;
    list.push_back(w);
    x = w.end + (random.chance(0.1) ? 0.5 * random.uniform() * off : 0.0);
  }
  return list;
}

}

// The distance is 0 all along the source.
TEST(QuickBound, IsNoLessThanTheInterpolantAtEitherEndOfASourceInTheFace)
{
  for (Random& random : EachSeed(2000))
  {
    const PlainMesh plain = randomPlanar(2, 2, random);
    const TriangleMesh mesh = engineMesh(plain);
    const MeshSegment segment{ random.below(mesh.numberOfFaces()), randomWeights(random),
      randomWeights(random) };
    const geodesic::DistanceField field =
      solveKeepingAll(mesh, engineCurves(mesh, Sources{ {}, { segment } }));
    constexpr double tolerance = 10.0; // more than any distance
    const double bound = geodesic::quickBoundOfFace(field, segment.face, tolerance);
    for (const Barycentric& end : { segment.from, segment.to })
    {
      double interpolant = 0.0;
      for (std::size_t k = 0; k < 3; ++k)
      {
        interpolant += end[k] * field.vertexDistances()[mesh.triangle(segment.face)[k]];
      }
      EXPECT_GE(bound, interpolant);
    }
  }
}

TEST(MeasuredList, SaysYesOnlyOfListsThatStayInTheBand)
{
  const TriangleMesh mesh =
    engineMesh({ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } } });
  std::array<int, 2> found{};
  for (Random& random : EachSeed(20000))
  {
    const double limit = std::pow(10.0, random.uniform(-3.0, -0.5));
    std::vector<Window> list = listNearLine(1.0, limit, random);
    const double atOrigin = list.front().distance(0.0) + random.uniform(-0.2, 0.2) * limit;
    const double atEnd = list.back().distance(1.0) + random.uniform(-0.2, 0.2) * limit;
    const MeasuredList inBand =
      geodesic::measuredList(mesh, passed(0, list, { atOrigin, atEnd }), 4.0 * limit);
    found[0] += inBand.hasNoneBelow ? 1 : 0;
    found[1] += inBand.hasNoneAbove ? 1 : 0;
    double covered = 0.0;
    for (const Window& w : list)
    {
      EXPECT_TRUE(!inBand.hasNoneAbove || w.begin - covered <= 0.25 * limit) << "a wide gap";
      covered = w.end;
      for (int k = 0; k <= 20; ++k)
      {
        const double x = w.begin + 0.05 * k * w.width();
        const double over = w.distance(x) - (atOrigin + (atEnd - atOrigin) * x);
        EXPECT_TRUE(!inBand.hasNoneAbove || over <= limit + Rounding) << over << " of " << limit;
        EXPECT_TRUE(!inBand.hasNoneBelow || -over <= limit + Rounding) << over << " of " << limit;
      }
    }
    EXPECT_TRUE(!inBand.hasNoneAbove || 1.0 - covered <= 0.25 * limit);
  }
  for (const int count : found)
  {
    EXPECT_GT(count, 1000);
    EXPECT_LT(count, 19000);
  }
}

// A nearly plane front from beyond one halfedge or two, sometimes a little off.
TEST(MeasuredList, BoundsOfTheFaceHoldWhereItsListsAreInTheirBands)
{
  int finite = 0;
  double nearest = 0.0;
  for (std::uint64_t seed = 0; seed < 20000; ++seed)
  {
    Random random(seed);
    const PlainMesh plain = randomFace(random);
    const TriangleMesh mesh = engineMesh(plain);
    const double limit = std::pow(10.0, random.uniform(-2.0, 0.0));
    Lists lists;
    for (geodesic::Id k = 0; k < 3; ++k)
    {
      if (k == seed % 3 || random.chance(0.3))
      {
        Window w = randomWindow(0.0, mesh.length(k), 20.0, random);
        w.sigma = 20.0 - w.distance(0.5 * w.end) + random.uniform(-1.0, 1.0) * limit;
        lists[k].push_back(w);
      }
    }
    Corners d = atCorners(plain, lists);
    for (double& distance : d)
    {
      distance += random.uniform(-0.9, 0.9) * limit;
    }
    geodesic::MeasuredLists measuredLists;
    for (geodesic::Id k = 0; k < 3; ++k)
    {
      if (!lists[k].empty())
      {
        measuredLists.push_back(
          geodesic::measuredList(mesh, passed(k, lists[k], { d[k], d[(k + 1) % 3] }), 4.0 * limit));
      }
    }
    const FaceBounds bounds = geodesic::boundsByBand(mesh, 0, d, measuredLists, 4.0 * limit);
    if (!(bounds.below < geodesic::Infinity))
    {
      continue;
    }
    ++finite;
    const FaceBounds known = measured(plain, lists, d);
    EXPECT_LE(known.above, bounds.above + Rounding) << "seed " << seed;
    EXPECT_LE(known.below, bounds.below + Rounding) << "seed " << seed;
    nearest = std::max({ nearest, known.above / bounds.above, known.below / bounds.below });
  }
  EXPECT_GT(finite, 1000);
  EXPECT_GT(nearest, 0.8) << "no face came near its bound";
}

// A list in its band may leave gaps of a quarter of the limit. In the middle of one the distance
// may be an eighth of the limit above the windows beside it.
TEST(MeasuredList, BoundsOfTheFaceAllowForTheGapsOfItsLists)
{
  const PlainMesh plain = { { { 0, 0, 0 }, { 1, 0, 0 }, { 0.3, 1, 0 } }, { { 0, 1, 2 } } };
  const Corners rise = { 0.0, 0.0, 1.0 };
  constexpr double limit = 0.1;
  const FaceBounds bounds =
    geodesic::boundsByBand(engineMesh(plain), 0, rise, listsInBands(rise), 4.0 * limit);
  EXPECT_GE(bounds.above, 1.125 * limit);
  EXPECT_GE(bounds.below, limit);
  EXPECT_LT(bounds.above, 2.0 * limit);
}
