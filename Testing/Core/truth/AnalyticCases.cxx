// SPDX-License-Identifier: BSD-3-Clause
#include "truth/AnalyticCases.h"

#include "truth/AnalyticDistances.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace geodesictest
{

namespace
{

constexpr double Infinite = std::numeric_limits<double>::infinity();
constexpr double Pi = 3.14159265358979323846;
constexpr int NumberOfQueries = 60;

/// One to three points and segments, and query points.
AnalyticCase randomCase(PlainMesh mesh, Random& random)
{
  AnalyticCase result;
  result.mesh = std::move(mesh);
  const Index kind = random.below(3);
  const Index count = random.between(1, 3);
  for (Index i = 0; i < count; ++i)
  {
    if (kind == 0 || (kind == 2 && random.chance(0.5)))
    {
      result.sources.points.push_back(randomPoint(result.mesh, random));
    }
    else
    {
      result.sources.segments.push_back({ random.below(result.mesh.triangles.size()),
        randomWeights(random), randomWeights(random) });
    }
  }
  for (int i = 0; i < NumberOfQueries; ++i)
  {
    result.queries.push_back(randomPoint(result.mesh, random));
  }
  return result;
}

std::vector<MeshPoint> vertexPoints(const PlainMesh& mesh)
{
  std::vector<MeshPoint> points(mesh.points.size());
  for (Index f = 0; f < mesh.triangles.size(); ++f)
  {
    for (Index k = 0; k < 3; ++k)
    {
      MeshPoint& p = points[mesh.triangles[f][k]];
      p.face = f;
      p.weights = { 0.0, 0.0, 0.0 };
      p.weights[k] = 1.0;
    }
  }
  return points;
}

std::vector<MeshSegment> allSegments(const Sources& sources)
{
  std::vector<MeshSegment> segments = sources.segments;
  for (const MeshPoint& p : sources.points)
  {
    segments.push_back({ p.face, p.weights, p.weights });
  }
  return segments;
}

/// Sets the truth from place(mesh point), the coordinates of a point of the surface, and
/// distance(place, place, place), from a point to a segment.
template <typename Place, typename Distance>
void setTruth(AnalyticCase& c, const Place& place, const Distance& distance)
{
  const auto closest = [&](const MeshPoint& p)
  {
    double best = Infinite;
    for (const MeshSegment& s : allSegments(c.sources))
    {
      best = std::min(best,
        distance(place(p), place(MeshPoint{ s.face, s.from }), place(MeshPoint{ s.face, s.to })));
    }
    return best;
  };
  for (const MeshPoint& p : vertexPoints(c.mesh))
  {
    c.vertexTruth.push_back(closest(p));
  }
  for (const MeshPoint& p : c.queries)
  {
    c.queryTruth.push_back(closest(p));
  }
}

Vec2 planarPlace(const PlainMesh& mesh, const MeshPoint& p)
{
  const Vec3 x = position(mesh, p);
  return { x[0], x[1] };
}

void setPlanarTruth(AnalyticCase& c)
{
  setTruth(
    c, [&c](const MeshPoint& p) { return planarPlace(c.mesh, p); }, distanceToSegment);
}

void setVisibilityTruth(AnalyticCase& c)
{
  std::vector<Vec2> targets;
  for (const Vec3& p : c.mesh.points)
  {
    targets.push_back({ p[0], p[1] });
  }
  for (const MeshPoint& p : c.queries)
  {
    targets.push_back(planarPlace(c.mesh, p));
  }
  const PlanarDomain domain = planarDomain(c.mesh);
  std::vector<double> best(targets.size(), Infinite);
  for (const MeshSegment& s : allSegments(c.sources))
  {
    const std::vector<double> distances =
      domain.distances(planarPlace(c.mesh, MeshPoint{ s.face, s.from }),
        planarPlace(c.mesh, MeshPoint{ s.face, s.to }), targets);
    std::transform(best.begin(), best.end(), distances.begin(), best.begin(),
      [](double a, double b) { return std::min(a, b); });
  }
  const auto middle = best.begin() + static_cast<std::ptrdiff_t>(c.mesh.points.size());
  c.vertexTruth.assign(best.begin(), middle);
  c.queryTruth.assign(middle, best.end());
}

AnalyticCase fanCase(Index sectors, double totalAngle, Random& random)
{
  const double angle = totalAngle / sectors;
  const Index n = random.between(3, 9);
  AnalyticCase c = randomCase(fan(sectors, angle, n), random);
  setTruth(
    c, [&](const MeshPoint& p) { return fanCoordinates(sectors, angle, n, c.mesh, p); },
    [totalAngle](const Polar& p, const Polar& a, const Polar& b)
    { return coneDistance(totalAngle, p, a, b); });
  return c;
}

//----------------------------------------------------------------------------
/// A random triangulation of a rectangle, rotated in space: Euclidean distance.
AnalyticCase planeCase(Random& random)
{
  AnalyticCase c =
    randomCase(randomPlanar(random.between(4, 16), random.between(4, 16), random), random);
  setPlanarTruth(c);
  c.mesh = moved(c.mesh, random);
  return c;
}

/// The same, stretched to needles of aspect 1e3 to 1e5.
AnalyticCase stretchedPlaneCase(Random& random)
{
  const double aspect = std::pow(10.0, random.uniform(3.0, 5.0));
  const Index nx = random.between(4, 12);
  const Index ny = random.between(4, 12);
  AnalyticCase c = randomCase(needleSheet(nx, ny, aspect, 0.0, random), random);
  setPlanarTruth(c);
  return c;
}

/// A regular grid, where everything ties.
AnalyticCase regularGridCase(Random& random)
{
  AnalyticCase c = randomCase(regularGrid(random.between(4, 20), random.between(4, 20)), random);
  setPlanarTruth(c);
  return c;
}

AnalyticCase cylinderCase(Random& random)
{
  const Index sides = random.between(3, 16);
  AnalyticCase c = randomCase(
    openCylinder(sides, random.between(2, 12), random.uniform(0.5, 2.0) * sides), random);
  const auto place = [&](const MeshPoint& p) -> Vec2
  {
    const Index column = (p.face / 2) % sides;
    const Vec3& a = c.mesh.points[column];
    const Vec3& b = c.mesh.points[(column + 1) % sides];
    const Vec3 x = position(c.mesh, p);
    // The sides of the polygon are of length 1.
    return { column + (x[0] - a[0]) * (b[0] - a[0]) + (x[1] - a[1]) * (b[1] - a[1]), x[2] };
  };
  setTruth(c, place,
    [sides](const Vec2& p, const Vec2& a, const Vec2& b) { return prismDistance(sides, p, a, b); });
  return c;
}

/// A cone whose random total angle is under 2 pi.
AnalyticCase coneCase(Random& random)
{
  const Index sectors = random.between(4, 12);
  return fanCase(sectors, random.uniform(0.2, 0.99) * 2.0 * Pi, random);
}

/// Around one saddle vertex whose random total angle is over 2 pi.
AnalyticCase saddleFanCase(Random& random)
{
  const Index sectors = 2 * random.between(4, 8);
  return fanCase(sectors, random.uniform(1.01, 1.8) * 2.0 * Pi, random);
}

AnalyticCase tetrahedronCase(Random& random)
{
  const Index n = random.between(3, 14);
  AnalyticCase c = randomCase(tetrahedron(n), random);
  setTruth(
    c,
    [&](const MeshPoint& p)
    { return tetrahedronCoordinates(p.face / (n * n), position(c.mesh, p)); },
    tetrahedronDistance);
  return c;
}

/// A planar domain with holes: visibility graph.
AnalyticCase holesCase(Random& random)
{
  const Index nx = random.between(8, 16);
  const Index ny = random.between(8, 16);
  AnalyticCase c = randomCase(planarWithHoles(nx, ny, random.between(1, 5), random), random);
  setVisibilityTruth(c);
  return c;
}

AnalyticCase lShapeCase(Random& random)
{
  AnalyticCase c = randomCase(lShape(2 * random.between(2, 8), 2 * random.between(2, 8)), random);
  setVisibilityTruth(c);
  return c;
}

/// Flat pages on one spine: any two pages unfold into a rectangle.
AnalyticCase bookCase(Random& random)
{
  const Index pages = random.between(3, 6);
  const Index n = random.between(3, 10);
  const Index m = random.between(2, 6);
  AnalyticCase c = randomCase(book(pages, n, m, 0.0, random), random);
  struct Place
  {
    Index page;
    double fromSpine;
    double along;
  };
  const auto place = [&](const MeshPoint& p) -> Place
  {
    const Vec3 x = position(c.mesh, p);
    return { p.face / (2 * n * m), std::hypot(x[0], x[1]), x[2] };
  };
  setTruth(c, place,
    [](const Place& p, const Place& a, const Place& b)
    {
      const double side = p.page == a.page ? 1.0 : -1.0;
      return distanceToSegment(
        { side * p.fromSpine, p.along }, { a.fromSpine, a.along }, { b.fromSpine, b.along });
    });
  return c;
}

/// Two rectangles with one common vertex.
AnalyticCase bowTieCase(Random& random)
{
  const PlainMesh a = randomPlanar(random.between(3, 8), random.between(3, 8), random);
  const PlainMesh b = randomPlanar(random.between(3, 8), random.between(3, 8), random);
  const Index knot = random.below(a.points.size());
  AnalyticCase c = randomCase(joinedAtVertex(a, knot, b, random.below(b.points.size())), random);
  struct Place
  {
    bool onB;
    Vec2 x;
  };
  const auto place = [&](const MeshPoint& p) -> Place {
    return { p.face >= a.triangles.size(), planarPlace(c.mesh, p) };
  };
  const Vec2 joint = { c.mesh.points[knot][0], c.mesh.points[knot][1] };
  setTruth(c, place,
    [&joint](const Place& p, const Place& s, const Place& t)
    {
      return p.onB == s.onB
        ? distanceToSegment(p.x, s.x, t.x)
        : distanceToSegment(p.x, joint, joint) + distanceToSegment(joint, s.x, t.x);
    });
  return c;
}

}

AnalyticCase boxCase(Random& random)
{
  Vec3 size = { 1.0, 1.0, 1.0 };
  std::array<Index, 3> n = { 4, 4, 4 };
  // A cube with equal cells at times, for the ties.
  if (random.chance(0.7))
  {
    for (Index k = 0; k < 3; ++k)
    {
      size[k] = random.uniform(0.3, 2.0);
      n[k] = random.between(2, 8);
    }
  }
  AnalyticCase c = randomCase(box(size, n), random);
  const auto place = [&](const MeshPoint& p)
  {
    // Rounding must not take a point off the face of the box that it is on.
    Vec3 x = position(c.mesh, p);
    const Triangle& t = c.mesh.triangles[p.face];
    for (Index k = 0; k < 3; ++k)
    {
      const double first = c.mesh.points[t[0]][k];
      if (c.mesh.points[t[1]][k] == first && c.mesh.points[t[2]][k] == first)
      {
        x[k] = first;
      }
      x[k] = std::clamp(x[k], 0.0, size[k]);
    }
    return x;
  };
  setTruth(c, place,
    [&size](const Vec3& p, const Vec3& a, const Vec3& b) { return boxDistance(size, p, a, b); });
  return c;
}

const std::vector<AnalyticConfiguration>& analyticConfigurations()
{
  static const std::vector<AnalyticConfiguration> table = { { "Plane", planeCase },
    { "NeedlesInAPlane", stretchedPlaneCase }, { "RegularGrid", regularGridCase },
    { "Box", boxCase }, { "Cylinder", cylinderCase }, { "Cone", coneCase },
    { "SaddleFan", saddleFanCase }, { "Tetrahedron", tetrahedronCase }, { "Holes", holesCase },
    { "LShape", lShapeCase }, { "FlatBook", bookCase }, { "BowTie", bowTieCase } };
  return table;
}

}
