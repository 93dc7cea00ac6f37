// SPDX-License-Identifier: BSD-3-Clause
// The triangles of polygons against what is known of their outlines: areas, places inside.
#include "mesh/PolygonTriangles.h"
#include "mesh/SideOfLine.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace
{

using namespace geodesic;

/// Corners with whole numbers, of which areas are exact.
struct Corner
{
  std::int64_t x = 0;
  std::int64_t y = 0;
  bool operator<(const Corner& other) const
  {
    return this->x != other.x ? this->x < other.x : this->y < other.y;
  }
  bool operator==(const Corner& other) const { return this->x == other.x && this->y == other.y; }
};
using Outline = std::vector<Corner>;

std::int64_t twiceArea(const Corner& a, const Corner& b, const Corner& c)
{
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

std::int64_t twiceArea(const Outline& outline)
{
  std::int64_t area = 0;
  for (std::size_t i = 1; i + 1 < outline.size(); ++i)
  {
    area += twiceArea(outline[0], outline[i], outline[i + 1]);
  }
  return area;
}

std::vector<Vec3> inSpace(const Outline& outline)
{
  std::vector<Vec3> points;
  for (const Corner& c : outline)
  {
    points.push_back({ static_cast<double>(c.x), static_cast<double>(c.y), 0.0 });
  }
  return points;
}

/// Whether (x, y) lies within the outline, by the number of edges to the right of it.
bool isInside(const Outline& outline, double x, double y)
{
  bool isIn = false;
  for (std::size_t i = 0; i < outline.size(); ++i)
  {
    const Corner& a = outline[i];
    const Corner& b = outline[(i + 1) % outline.size()];
    const auto ax = static_cast<double>(a.x);
    const auto ay = static_cast<double>(a.y);
    const auto bx = static_cast<double>(b.x);
    const auto by = static_cast<double>(b.y);
    if ((ay > y) != (by > y) && x < ax + (bx - ax) * (y - ay) / (by - ay))
    {
      isIn = !isIn;
    }
  }
  return isIn;
}

/// n - 2 triangles, each with area, which together have the area of the outline and cover each
/// place inside once and no other.
///
/// \param flat how many triangles may be without area.
void expectTriangulation(
  const Outline& outline, std::mt19937& random, const std::string& what, int flat = 0)
{
  SCOPED_TRACE(what);
  const PolygonTriangles cut = triangulatePolygon(inSpace(outline));
  EXPECT_FALSE(cut.crossesItself);
  ASSERT_EQ(cut.triangles.size() + 2, outline.size());
  std::int64_t area = 0;
  int withoutArea = 0;
  std::vector<Outline> triangles;
  for (const Triangle& t : cut.triangles)
  {
    triangles.push_back({ outline[t[0]], outline[t[1]], outline[t[2]] });
    const std::int64_t own = twiceArea(triangles.back());
    EXPECT_GE(own, 0);
    withoutArea += own == 0 ? 1 : 0;
    area += own;
  }
  EXPECT_LE(withoutArea, flat);
  EXPECT_EQ(area, twiceArea(outline));
  const auto range = std::minmax_element(outline.begin(), outline.end());
  std::uniform_real_distribution<double> at(
    static_cast<double>(range.first->x), static_cast<double>(range.second->x));
  for (int i = 0; i < 50; ++i)
  {
    const double x = at(random);
    const double y = at(random);
    const auto covers = [&](const Outline& triangle) { return isInside(triangle, x, y); };
    EXPECT_EQ(
      std::count_if(triangles.begin(), triangles.end(), covers), isInside(outline, x, y) ? 1 : 0);
  }
}

Outline reversed(Outline outline)
{
  std::reverse(outline.begin(), outline.end());
  return outline;
}

/// A polygon that is seen whole from its center. Counterclockwise, with even coordinates.
Outline star(Corner center, double radius, std::mt19937& random)
{
  std::uniform_real_distribution<double> of(0.0, 1.0);
  for (;;)
  {
    const auto count = 3 + random() % 8;
    Outline outline;
    for (std::size_t i = 0; i < count; ++i)
    {
      const double angle =
        FullAngle * (static_cast<double>(i) + 0.8 * of(random)) / static_cast<double>(count);
      const double r = radius * (0.2 + 0.8 * of(random));
      outline.push_back({ center.x + 2 * std::llround(0.5 * r * std::cos(angle)),
        center.y + 2 * std::llround(0.5 * r * std::sin(angle)) });
    }
    bool isStar = true;
    for (std::size_t i = 0; i < count; ++i)
    {
      isStar = isStar && twiceArea(center, outline[i], outline[(i + 1) % count]) > 0;
    }
    if (isStar)
    {
      return outline;
    }
  }
}

bool isBetween(const Corner& a, const Corner& b, const Corner& p)
{
  return twiceArea(a, b, p) == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) &&
    std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
}

/// Whether two segments have a place in common.
bool meet(const Corner& a, const Corner& b, const Corner& c, const Corner& d)
{
  const auto side = [](std::int64_t area) { return area > 0 ? 1 : (area < 0 ? -1 : 0); };
  return (side(twiceArea(a, b, c)) * side(twiceArea(a, b, d)) < 0 &&
           side(twiceArea(c, d, a)) * side(twiceArea(c, d, b)) < 0) ||
    isBetween(a, b, c) || isBetween(a, b, d) || isBetween(c, d, a) || isBetween(c, d, b);
}

/// Whether a segment meets an outline beside its own ends.
bool isBlocked(const Corner& a, const Corner& b, const Outline& outline)
{
  for (std::size_t i = 0; i < outline.size(); ++i)
  {
    const Corner& p = outline[i];
    const Corner& q = outline[(i + 1) % outline.size()];
    const bool hasEnd = p == a || q == a || p == b || q == b;
    const bool isOn = (!(p == a) && !(p == b) && isBetween(a, b, p)) ||
      (!(q == a) && !(q == b) && isBetween(a, b, q));
    if (isOn || (hasEnd ? isBetween(p, q, a) && isBetween(p, q, b) : meet(a, b, p, q)) ||
      (!(p == a) && !(q == a) && isBetween(p, q, a)) ||
      (!(p == b) && !(q == b) && isBetween(p, q, b)))
    {
      return true;
    }
  }
  return false;
}

/// Whether the way to a place leads into the polygon at its corner i.
bool leadsInside(const Outline& outline, std::size_t i, const Corner& to)
{
  const Corner& before = outline[(i + outline.size() - 1) % outline.size()];
  const Corner& here = outline[i];
  const Corner& after = outline[(i + 1) % outline.size()];
  const bool isLeftOfOut = twiceArea(here, after, to) > 0;
  const bool isLeftOfIn = twiceArea(before, here, to) > 0;
  return twiceArea(before, here, after) > 0 ? isLeftOfOut && isLeftOfIn : isLeftOfOut || isLeftOfIn;
}

/// Joins a hole with the outline by an edge there and back.
bool bridge(
  Outline& outline, const Outline& hole, const std::vector<Outline>& others, std::mt19937& random)
{
  const Outline inner = reversed(hole);
  for (int trial = 0; trial < 200; ++trial)
  {
    const std::size_t i = random() % outline.size();
    const std::size_t k = random() % inner.size();
    const auto blocks = [&](const Outline& other)
    { return isBlocked(outline[i], inner[k], other); };
    if (!leadsInside(outline, i, inner[k]) || !leadsInside(inner, k, outline[i]) ||
      blocks(outline) || blocks(inner) || std::any_of(others.begin(), others.end(), blocks))
    {
      continue;
    }
    Outline way(inner.begin() + static_cast<std::ptrdiff_t>(k), inner.end());
    way.insert(way.end(), inner.begin(), inner.begin() + static_cast<std::ptrdiff_t>(k) + 1);
    way.push_back(outline[i]);
    outline.insert(outline.begin() + static_cast<std::ptrdiff_t>(i) + 1, way.begin(), way.end());
    return true;
  }
  return false;
}

/// With a corner in the middle of some edges; on both ways of a bridge.
Outline withMiddles(const Outline& outline)
{
  Outline more;
  for (std::size_t i = 0; i < outline.size(); ++i)
  {
    const Corner& a = outline[i];
    const Corner& b = outline[(i + 1) % outline.size()];
    more.push_back(a);
    if ((a.x + b.x + a.y + b.y) % 3 != 0)
    {
      more.push_back({ (a.x + b.x) / 2, (a.y + b.y) / 2 });
    }
  }
  return more;
}

TEST(PolygonTriangles, CoverAStarOnce)
{
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i)
  {
    const Outline outline = star({ 0, 0 }, i % 2 == 0 ? 1000.0 : 20.0, random);
    expectTriangulation(outline, random, "star " + std::to_string(i));
    expectTriangulation(withMiddles(outline), random, "with middles " + std::to_string(i));
  }
}

TEST(PolygonTriangles, LeaveHolesBehindBridgesOpen)
{
  std::mt19937 random(2);
  int made = 0;
  for (int i = 0; i < 1000; ++i)
  {
    const std::int64_t size = 1000;
    Outline outline = { { -size, -size }, { 3 * size, -size }, { 3 * size, 3 * size },
      { -size, 3 * size } };
    std::vector<Outline> holes;
    for (const Corner& center : { Corner{ 0, 0 }, Corner{ 2 * size, 0 },
           Corner{ 2 * size, 2 * size }, Corner{ 0, 2 * size } })
    {
      if (random() % 3 != 0)
      {
        holes.push_back(star(center, 0.9 * size, random));
      }
    }
    bool isBridged = true;
    while (!holes.empty() && isBridged)
    {
      const Outline hole = holes.back();
      holes.pop_back();
      isBridged = bridge(outline, hole, holes, random);
    }
    if (isBridged)
    {
      ++made;
      expectTriangulation(outline, random, "holes " + std::to_string(i));
      expectTriangulation(withMiddles(outline), random, "holes, middles " + std::to_string(i));
    }
  }
  EXPECT_GT(made, 800);
}

/// In the middle of the bridge to a hole is a corner of another one: one triangle without area has
/// to join the two ways.
TEST(PolygonTriangles, AreThereWhereABridgeRunsAlongACorner)
{
  std::mt19937 random(3);
  const Outline outline = { { 0, 0 }, { 40, 0 }, { 40, 40 }, { 0, 40 }, // the square
    { 0, 0 }, { 20, 20 }, { 20, 30 }, { 30, 30 }, { 20, 20 },           // a hole
    { 30, 20 }, { 20, 20 } };                                           // a slit
  expectTriangulation(outline, random, "a hole and a slit at its beginning");
  const Outline touching = { { 0, 0 }, { 40, 0 }, { 40, 40 }, { 0, 40 }, { 0, 0 }, { 10, 10 },
    { 10, 16 }, { 16, 16 }, { 20, 20 }, { 20, 30 }, { 30, 30 }, { 20, 20 }, { 10, 10 } };
  expectTriangulation(touching, random, "a bridge along the corners of another hole", 1);
}

TEST(PolygonTriangles, AreFlatOnlyAtEdgesThatStickOut)
{
  std::mt19937 random(4);
  expectTriangulation({ { 0, 0 }, { 0, -2 }, { 0, 0 }, { 2, 0 }, { 2, -2 }, { 2, 0 }, { 4, 0 },
                        { 4, -2 }, { 4, 0 }, { 6, 20 }, { -2, 20 } },
    random, "a comb of edges", 6);
  expectTriangulation({ { 0, 0 }, { 2, 0 }, { 4, -2 }, { 2, 0 }, { 2, 2 }, { 0, 2 } }, random,
    "a square with an edge outside", 2);
  expectTriangulation(
    { { 0, 0 }, { 2, 0 }, { 0, 2 }, { 0, 0 }, { -4, -2 }, { -6, -2 }, { -4, -6 }, { -4, -2 } },
    random, "two triangles and an edge between them", 4);
}

/// At all sizes, thin, and tilted.
TEST(PolygonTriangles, HaveTheAreaOfSmallAndThinOutlines)
{
  std::mt19937 random(5);
  for (const double size : { 1.0, 1e-6, 1e-7, 0x1p-1000, 0x1p1000 })
  {
    for (const double thinness : { 1.0, 1e-5, 1e-9 })
    {
      for (int i = 0; i < 300; ++i)
      {
        const std::vector<Vec3> whole = inSpace(star({ 0, 0 }, 1e6, random));
        std::vector<Vec3> points;
        for (const Vec3& p : whole)
        {
          const double x = 1e-6 * p[0];
          const double y = 1e-6 * thinness * p[1];
          points.push_back(i % 3 == 0 ? Vec3{ x, y, 0.0 }
              : i % 3 == 1            ? Vec3{ 0.5, y, x }
                                      : Vec3{ 0.6 * x + 0.8 * y, 0.3 * x - y, x });
        }
        std::vector<Vec3> scaled = points;
        for (Vec3& p : scaled)
        {
          p = size * p;
        }
        const PolygonTriangles cut = triangulatePolygon(scaled);
        EXPECT_FALSE(cut.crossesItself && thinness > 1e-6);
        ASSERT_EQ(cut.triangles.size() + 2, points.size());
        double area = 0.0;
        for (const Triangle& t : cut.triangles)
        {
          area += norm(cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]));
        }
        Vec3 outline{};
        for (std::size_t k = 1; k + 1 < points.size(); ++k)
        {
          outline = outline + cross(points[k] - points[0], points[k + 1] - points[0]);
        }
        // The coordinates of tilted ones are rounded.
        const double rounding = 100.0 * 1e-16 / thinness;
        EXPECT_NEAR(area, norm(outline), (rounding + 1e-13) * norm(outline))
          << "size " << size << ", thinness " << thinness << ", star " << i;
      }
    }
  }
}

TEST(PolygonTriangles, SayWhereAnOutlineCrossesItself)
{
  std::mt19937 random(6);
  int crossing = 0;
  for (int i = 0; i < 2000; ++i)
  {
    Outline outline;
    for (std::size_t k = 4 + random() % 9; k > 0; --k)
    {
      outline.push_back({ static_cast<int>(random() % 10000), static_cast<int>(random() % 10000) });
    }
    bool isCrossing = false;
    for (std::size_t a = 0; a < outline.size(); ++a)
    {
      for (std::size_t b = a + 2; b < outline.size() && b - a + 1 < outline.size(); ++b)
      {
        isCrossing = isCrossing ||
          meet(outline[a], outline[a + 1], outline[b], outline[(b + 1) % outline.size()]);
      }
    }
    const PolygonTriangles cut = triangulatePolygon(inSpace(outline));
    EXPECT_EQ(cut.crossesItself, isCrossing) << i;
    EXPECT_EQ(cut.triangles.size() + 2, outline.size());
    crossing += isCrossing ? 1 : 0;
  }
  EXPECT_GT(crossing, 1000);
  EXPECT_LT(crossing, 1990);
  const auto ofStar = [](std::size_t count, std::size_t step)
  {
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < count; ++i)
    {
      const double angle = FullAngle * static_cast<double>(i * step) / static_cast<double>(count);
      points.push_back({ std::cos(angle), std::sin(angle), 0.0 });
    }
    return points;
  };
  EXPECT_FALSE(triangulatePolygon(ofStar(7, 1)).crossesItself);
  EXPECT_TRUE(triangulatePolygon(ofStar(5, 2)).crossesItself) << "a pentagram";
  EXPECT_TRUE(triangulatePolygon(ofStar(7, 3)).crossesItself) << "winds around its center thrice";
}

TEST(PolygonTriangles, OfCornersOnOneLineAreAFanWithoutAWord)
{
  for (const Vec3& along : { Vec3{ 1.0, 0.0, 0.0 }, Vec3{ 0.1, -0.7, 0.3 } })
  {
    std::vector<Vec3> points;
    for (const double t : { 0.0, 0.3, 0.7, 1.1, 0.4 })
    {
      points.push_back(t * along);
    }
    const PolygonTriangles cut = triangulatePolygon(points);
    EXPECT_FALSE(cut.crossesItself);
    for (Vec3& p : points)
    {
      std::transform(p.begin(), p.end(), p.begin(), [](double x) { return float(x); });
    }
    EXPECT_FALSE(triangulatePolygon(points).crossesItself) << "in single precision";
    ASSERT_EQ(cut.triangles.size(), 3U);
    for (Id i = 0; i < 3; ++i)
    {
      EXPECT_EQ(cut.triangles[i], (Triangle{ 0, i + 1, i + 2 }));
    }
  }
}

/// Several passes over all 10,000 corners for each ear would take minutes.
TEST(PolygonTriangles, OfManyCornersAreFound)
{
  std::mt19937 random(7);
  for (const int kind : { 0, 1, 2 })
  {
    Outline outline;
    const std::int64_t count = 5000;
    for (std::int64_t i = 0; i < 2 * count && kind < 2; ++i)
    {
      const double angle = Pi * static_cast<double>(i) / static_cast<double>(count);
      const double radius = kind == 0 ? 1e8 : 5e7 + static_cast<double>(random() % 50000000);
      outline.push_back(
        { std::llround(radius * std::cos(angle)), std::llround(radius * std::sin(angle)) });
    }
    for (std::int64_t i = 0; i < 2 * count && kind == 2; ++i) // a comb, thin everywhere
    {
      const bool isBack = i >= count;
      const std::int64_t x = isBack ? 2 * count - 1 - i : i;
      outline.push_back({ 10 * x, (x % 2 == 0 ? 0 : -100000) + (isBack ? 10 : 0) });
    }
    expectTriangulation(outline, random, "kind " + std::to_string(kind));
  }
}

/// Points on the line y = x, moved by the last digit alone.
TEST(PolygonTriangles, KnowTheSideOfALineExactly)
{
  std::mt19937 random(8);
  std::uniform_real_distribution<double> at(-1.0, 1.0);
  for (int i = 0; i < 10000; ++i)
  {
    const double far = std::ldexp(1.0, static_cast<int>(random() % 60));
    const double a = at(random);
    const double b = a + far;
    const double c = i % 2 == 0 ? at(random) : at(random) * far;
    const double above = std::nextafter(c, Infinity);
    EXPECT_EQ(sideOfLine({ a, a }, { b, b }, { c, c }), 0);
    EXPECT_EQ(sideOfLine({ a, a }, { b, b }, { c, above }), 1);
    EXPECT_EQ(sideOfLine({ a, a }, { b, b }, { above, c }), -1);
    EXPECT_EQ(sideOfLine({ c, above }, { a, a }, { b, b }), 1);
  }
}

}
