// SPDX-License-Identifier: BSD-3-Clause
#include "paths/PathChecker.h"

#include "paths/PathCorridor.h"
#include "paths/PathInStrip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

namespace geodesictest
{

using geodesic::SurfacePoint;

namespace
{

constexpr double Pi = 3.14159265358979323846;

double angle(const Vec3& at, const Vec3& a, const Vec3& b)
{
  Vec3 u{};
  Vec3 v{};
  for (std::size_t k = 0; k < 3; ++k)
  {
    u[k] = a[k] - at[k];
    v[k] = b[k] - at[k];
  }
  const Vec3 cross = { u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
    u[0] * v[1] - u[1] * v[0] };
  return std::atan2(std::sqrt(cross[0] * cross[0] + cross[1] * cross[1] + cross[2] * cross[2]),
    u[0] * v[0] + u[1] * v[1] + u[2] * v[2]);
}

}

PathChecker::PathChecker(const PlainMesh& mesh)
  : mesh_(mesh)
  , facesOfVertex_(mesh.points.size())
{
  for (Index f = 0; f < mesh.triangles.size(); ++f)
  {
    for (const Index v : mesh.triangles[f])
    {
      this->facesOfVertex_[v].push_back(f);
    }
  }
}

std::vector<PathPoint> PathChecker::plain(const std::vector<SurfacePoint>& path) const
{
  std::vector<PathPoint> result(path.size());
  std::transform(path.begin(), path.end(), result.begin(),
    [this](const SurfacePoint& p) { return this->plain(p); });
  return result;
}

/// Checks all properties of a shortest path of this length.
///
/// \param slack by how much the length may be off, and a bend may be longer than the straight
///        way. Lengths tell no more: a point that is off the straight way by a fraction of its
///        length makes it longer by the square of that.
void PathChecker::expectShortest(
  const std::vector<PathPoint>& path, double length, double slack) const
{
  double sum = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i)
  {
    ASSERT_FALSE(this->commonFaces(path[i - 1], path[i]).empty())
      << "piece " << i << " of " << path.size() - 1 << " is in no face";
    sum += spaceDistance(path[i - 1].place, path[i].place);
  }
  EXPECT_NEAR(sum, length, slack) << "length of a path of " << path.size() << " points";
  for (std::size_t i = 1; i + 1 < path.size(); ++i)
  {
    EXPECT_LE(this->bend(path[i - 1], path[i], path[i + 1]), slack)
      << "bent at point " << i << " of " << path.size() - 1 << ", which is "
      << (path[i].support.size() == 1      ? "a vertex"
             : path[i].support.size() == 2 ? "on an edge"
                                           : "in a face");
  }
}

void PathChecker::expectPath(const std::vector<SurfacePoint>& path, const MeshPoint& from,
  const Sources& sources, double distance, double slack) const
{
  if (distance == geodesic::Infinity)
  {
    EXPECT_TRUE(path.empty());
    return;
  }
  ASSERT_FALSE(path.empty());
  const std::vector<PathPoint> points = this->plain(path);
  EXPECT_LE(spaceDistance(points.front().place, position(this->mesh_, from)), slack);
  EXPECT_LE(distanceInSpace(this->mesh_, points.back().place, sources), slack)
    << "ends off the source";
  this->expectShortest(points, distance, slack);
}

PathPoint PathChecker::plain(const SurfacePoint& p) const
{
  PathPoint result;
  std::vector<std::pair<Index, double>> weights;
  if (p.kind == SurfacePoint::Kind::Vertex)
  {
    weights = { { p.id, 1.0 } };
  }
  else if (p.kind == SurfacePoint::Kind::Edge)
  {
    const Triangle& t = this->mesh_.triangles[p.id / 3];
    weights = { { t[p.id % 3], 1.0 - p.u }, { t[(p.id + 1) % 3], p.u } };
  }
  else
  {
    const Triangle& t = this->mesh_.triangles[p.id];
    weights = { { t[0], 1.0 - p.u - p.v }, { t[1], p.u }, { t[2], p.v } };
  }
  result.place = {};
  for (const auto& [vertex, weight] : weights)
  {
    result.support.insert(vertex);
    for (std::size_t k = 0; k < 3; ++k)
    {
      result.place[k] += weight * this->mesh_.points[vertex][k];
    }
  }
  return result;
}

std::vector<Index> PathChecker::commonFaces(const PathPoint& a, const PathPoint& b) const
{
  std::set<Index> all = a.support;
  all.insert(b.support.begin(), b.support.end());
  std::vector<Index> result;
  for (const Index f : this->facesOfVertex_[*all.begin()])
  {
    const Triangle& t = this->mesh_.triangles[f];
    if (std::all_of(all.begin(), all.end(),
          [&](Index v) { return std::find(t.begin(), t.end(), v) != t.end(); }))
    {
      result.push_back(f);
    }
  }
  return result;
}

/// An upper bound for how much shorter the path would be if it were pulled straight there.
double PathChecker::bend(const PathPoint& before, const PathPoint& p, const PathPoint& after) const
{
  const double arm =
    std::min(spaceDistance(before.place, p.place), spaceDistance(p.place, after.place));
  if (arm == 0.0)
  {
    return 0.0;
  }
  double turned = Pi;
  if (p.support.size() == 1)
  {
    turned = std::max(0.0, Pi - this->leastAngle(*p.support.begin(), before, after));
  }
  else
  {
    // A piece along an edge is in several faces.
    for (const Index f : this->commonFaces(before, p))
    {
      for (const Index g : this->commonFaces(p, after))
      {
        turned = std::min(turned, turn(f, before, p, g, after));
      }
    }
  }
  return 0.5 * arm * turned * turned;
}

/// The angle by which the path turns where it goes from one face to another, or on in the same
/// face.
double PathChecker::turn(
  Index f, const PathPoint& before, const PathPoint& p, Index g, const PathPoint& after) const
{
  if (f == g || p.support.size() == 3)
  {
    return Pi - angle(p.place, before.place, after.place);
  }
  // Across an edge, the angles on both sides against the same end of the edge add up to half a
  // turn. At the nearer end rounding may turn the edge.
  const Vec3& first = this->mesh_.points[*p.support.begin()];
  const Vec3& second = this->mesh_.points[*p.support.rbegin()];
  const bool isFirstNearer = spaceDistance(p.place, first) < spaceDistance(p.place, second);
  const Vec3& end = isFirstNearer ? second : first;
  return std::abs(Pi - angle(p.place, before.place, end) - angle(p.place, end, after.place));
}

/// The vertices around a vertex, in order; if the fan is closed, the first again at the end. Empty
/// if the faces are not one fan.
std::vector<Index> PathChecker::fanAround(Index vertex) const
{
  std::map<Index, std::vector<Index>> links;
  for (const Index f : this->facesOfVertex_[vertex])
  {
    const Triangle& t = this->mesh_.triangles[f];
    const auto k = static_cast<std::size_t>(std::find(t.begin(), t.end(), vertex) - t.begin());
    links[t[(k + 1) % 3]].push_back(t[(k + 2) % 3]);
    links[t[(k + 2) % 3]].push_back(t[(k + 1) % 3]);
  }
  Index first = links.begin()->first;
  for (const auto& [spoke, others] : links)
  {
    if (others.size() > 2)
    {
      return {};
    }
    first = others.size() == 1 ? spoke : first;
  }
  std::vector<Index> fan = { first, links[first].front() };
  while (fan.back() != first && links[fan.back()].size() == 2)
  {
    const std::vector<Index>& others = links[fan.back()];
    fan.push_back(others.front() == fan[fan.size() - 2] ? others.back() : others.front());
  }
  const bool isWhole = fan.size() - 1 == this->facesOfVertex_[vertex].size();
  return isWhole ? fan : std::vector<Index>{};
}

/// The smaller of the two angles between the path's pieces at a vertex; at the boundary the angle
/// on the surface. Half a turn, which passes every check, if the faces are not one fan.
double PathChecker::leastAngle(Index vertex, const PathPoint& before, const PathPoint& after) const
{
  const std::vector<Index> fan = this->fanAround(vertex);
  if (fan.empty())
  {
    return Pi;
  }
  const Vec3& centre = this->mesh_.points[vertex];
  double total = 0.0;
  std::map<const PathPoint*, double> angles;
  for (std::size_t i = 0; i + 1 < fan.size(); ++i)
  {
    const Vec3& spoke = this->mesh_.points[fan[i]];
    const std::set<Index> corners = { vertex, fan[i], fan[i + 1] };
    for (const PathPoint* p : { &before, &after })
    {
      if (std::includes(corners.begin(), corners.end(), p->support.begin(), p->support.end()))
      {
        angles.insert({ p, total + angle(centre, spoke, p->place) });
      }
    }
    total += angle(centre, spoke, this->mesh_.points[fan[i + 1]]);
  }
  const double between = std::abs(angles.at(&before) - angles.at(&after));
  return fan.front() == fan.back() ? std::min(between, total - between) : between;
}

double PathChecker::length(const std::vector<PathPoint>& path)
{
  double sum = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i)
  {
    sum += spaceDistance(path[i - 1].place, path[i].place);
  }
  return sum;
}

std::vector<FoundPath> findPathsInStrips(const geodesic::TriangleMesh& mesh,
  const std::vector<geodesic::SourceCurve>& curves, const std::vector<SurfacePoint>& targets)
{
  const geodesic::DistanceField field = solveKeepingAll(mesh, curves);
  const std::vector<double> toSource =
    geodesic::lowerBoundsOf(field.vertexDistances(), geodesic::Infinity);
  std::vector<FoundPath> paths(targets.size());
  for (std::size_t i = 0; i < targets.size(); ++i)
  {
    const geodesic::Id face = geodesic::someFace(mesh, targets[i]);
    const double distance = field.distance(targets[i]);
    if (distance < geodesic::Infinity)
    {
      const auto found =
        geodesic::pathInStrip(field.surface(), geodesic::ReplicatedPatch(mesh), curves,
          { { 0, face }, geodesic::toFacePoint(mesh, face, targets[i]), distance }, toSource, {});
      EXPECT_TRUE(found && !found->points.empty());
      paths[i].take(*found);
    }
  }
  return paths;
}

/// The distance through space from a place to the nearest source.
double distanceInSpace(const PlainMesh& mesh, const Vec3& place, const Sources& sources)
{
  double least = geodesic::Infinity;
  for (const MeshPoint& p : sources.points)
  {
    least = std::min(least, spaceDistance(place, position(mesh, p)));
  }
  for (const MeshSegment& s : sources.segments)
  {
    const Vec3 a = position(mesh, { s.face, s.from });
    const Vec3 b = position(mesh, { s.face, s.to });
    double along = 0.0;
    double square = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      along += (place[k] - a[k]) * (b[k] - a[k]);
      square += (b[k] - a[k]) * (b[k] - a[k]);
    }
    const double t = square > 0.0 ? std::clamp(along / square, 0.0, 1.0) : 0.0;
    least = std::min(least,
      spaceDistance(
        place, { a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2]) }));
  }
  return least;
}

}
