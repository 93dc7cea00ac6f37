// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/PolygonTriangles.h"

#include "Tolerance.h"
#include "mesh/EarClipper.h"
#include "mesh/SideOfLine.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <numeric>
#include <utility>

namespace geodesic
{

namespace
{

/// Twice the area, times the normal.
Vec3 areaOf(const std::vector<Vec3>& outline)
{
  Vec3 area{};
  for (std::size_t i = 1; i + 1 < outline.size(); ++i)
  {
    area = area + cross(outline[i] - outline[0], outline[i + 1] - outline[0]);
  }
  return area;
}

/// Whether all points lie on one line, but for the roundings of coordinates.
bool areOnOneLine(const std::vector<Vec3>& points, double precision)
{
  const auto farthest = std::max_element(points.begin(), points.end(),
    [&](const Vec3& p, const Vec3& q) { return norm(p - points[0]) < norm(q - points[0]); });
  const Vec3 along = *farthest - points[0];
  const double length = norm(along);
  return std::all_of(points.begin(), points.end(),
    [&](const Vec3& p)
    {
      const double rounding =
        precision * std::max(largestCoordinate(p), largestCoordinate(*farthest));
      return norm(cross(along, p - points[0])) <= tolerance::SeamRoundings * rounding * length;
    });
}

/// The outline without the coordinate along which it extends least, so that no digit is lost; or
/// projected along its normal.
std::vector<Vec2> projected(const std::vector<Vec3>& outline, const Vec3& normal, bool alongNormal)
{
  const auto size = [&](std::size_t k) { return std::abs(normal[k]); };
  const std::size_t k = size(2) >= size(0) && size(2) >= size(1) ? 2 : (size(1) >= size(0) ? 1 : 0);
  std::size_t x = (k + 1) % 3;
  std::size_t y = (k + 2) % 3;
  if (normal[k] < 0.0)
  {
    std::swap(x, y);
  }
  const double slopeX = alongNormal ? normal[x] / normal[k] : 0.0;
  const double slopeY = alongNormal ? normal[y] / normal[k] : 0.0;
  std::vector<Vec2> flat;
  flat.reserve(outline.size());
  for (const Vec3& p : outline)
  {
    flat.push_back({ p[x] - slopeX * p[k], p[y] - slopeY * p[k] });
  }
  return flat;
}

/// Whether two edges cross in the middle of both. Compares edges whose boxes meet.
bool doEdgesCross(const std::vector<Vec2>& flat)
{
  const std::size_t count = flat.size();
  const auto end = [&](std::size_t i) -> const Vec2& { return flat[i + 1 < count ? i + 1 : 0]; };
  const auto left = [&](std::size_t i) { return std::min(flat[i].x, end(i).x); };
  std::vector<std::size_t> edges(count);
  std::iota(edges.begin(), edges.end(), std::size_t(0));
  std::sort(edges.begin(), edges.end(),
    [&](std::size_t i, std::size_t k) { return std::pair(left(i), i) < std::pair(left(k), k); });
  const auto separates = [&](std::size_t i, std::size_t k)
  { return sideOfLine(flat[i], end(i), flat[k]) * sideOfLine(flat[i], end(i), end(k)) < 0; };
  for (std::size_t first = 0; first < count; ++first)
  {
    const std::size_t i = edges[first];
    const double right = std::max(flat[i].x, end(i).x);
    const auto [low, high] = std::minmax(flat[i].y, end(i).y);
    for (std::size_t next = first + 1; next < count && left(edges[next]) < right; ++next)
    {
      const std::size_t k = edges[next];
      if (std::max(flat[k].y, end(k).y) > low && std::min(flat[k].y, end(k).y) < high &&
        separates(i, k) && separates(k, i))
      {
        return true;
      }
    }
  }
  return false;
}

PolygonTriangles fanOf(std::size_t size, bool crossesItself)
{
  PolygonTriangles fan;
  for (Id i = 1; i + 1 < size; ++i)
  {
    fan.triangles.push_back({ 0, i, i + 1 });
  }
  fan.crossesItself = crossesItself;
  return fan;
}

PolygonTriangles cutInPlane(const std::vector<Vec3>& points, const Vec3& normal, bool alongNormal)
{
  const std::vector<Vec2> flat = projected(points, normal, alongNormal);
  PolygonTriangles result = clipEars(points, normal, flat);
  // Where an outline winds around a place twice, its ears may cover that twice.
  result.crossesItself = result.crossesItself || doEdgesCross(flat);
  return result;
}

}

PolygonTriangles triangulatePolygon(const std::vector<Vec3>& outline)
{
  double largest = 0.0;
  for (const Vec3& p : outline)
  {
    largest = isFinite(p) ? std::max(largest, largestCoordinate(p)) : Infinity;
  }
  if (!(largest > 0.0 && largest < Infinity))
  {
    return fanOf(outline.size(), false);
  }
  // Products stay in range; no digit changes.
  std::vector<Vec3> points = outline;
  const int exponent = -std::ilogb(largest);
  for (Vec3& p : points)
  {
    p = { std::ldexp(p[0], exponent), std::ldexp(p[1], exponent), std::ldexp(p[2], exponent) };
  }
  if (areOnOneLine(points, tolerance::Rounding))
  {
    return fanOf(points.size(), false);
  }
  const Vec3 area = areaOf(points);
  const double size = norm(area);
  if (!(size > 0.0))
  {
    return fanOf(points.size(), true);
  }
  const Vec3 normal = { area[0] / size, area[1] / size, area[2] / size };
  PolygonTriangles result = cutInPlane(points, normal, false);
  if (result.crossesItself)
  {
    PolygonTriangles other = cutInPlane(points, normal, true);
    if (!other.crossesItself)
    {
      return other;
    }
    // Files store single precision.
    if (areOnOneLine(points, FLT_EPSILON))
    {
      return fanOf(points.size(), false);
    }
  }
  return result;
}

}
