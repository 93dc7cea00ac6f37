// SPDX-License-Identifier: BSD-3-Clause
#include "RandomCurves.h"

#include <algorithm>
#include <cmath>

namespace geodesictest
{

namespace
{

Vec2 plus(const Vec2& a, double s, const Vec2& b)
{
  return { a[0] + s * b[0], a[1] + s * b[1] };
}

double cross(const Vec2& a, const Vec2& b)
{
  return a[0] * b[1] - a[1] * b[0];
}

/// The third corner over the edge a-b: how far along from a and how high, in units of length.
Vec2 thirdCorner(const Vec3& a, const Vec3& b, const Vec3& c)
{
  double ab2 = 0.0;
  double ac2 = 0.0;
  double both = 0.0;
  for (Index k = 0; k < 3; ++k)
  {
    ab2 += (b[k] - a[k]) * (b[k] - a[k]);
    ac2 += (c[k] - a[k]) * (c[k] - a[k]);
    both += (b[k] - a[k]) * (c[k] - a[k]);
  }
  const double along = both / std::sqrt(ab2);
  return { along, std::sqrt(std::max(0.0, ac2 - along * along)) };
}

}

bool Polyline::isPoint() const
{
  return this->segments.size() == 1 && this->segments[0].from == this->segments[0].to;
}

bool Polyline::isCut(std::size_t segment) const
{
  return segment < this->isCutAfter.size() && this->isCutAfter[segment];
}

CurveMaker::CurveMaker(const PlainMesh& mesh, Random& random)
  : mesh_(mesh)
  , random_(random)
  , facesOfVertex_(mesh.points.size())
{
  for (Index f = 0; f < mesh.triangles.size(); ++f)
  {
    for (Index k = 0; k < 3; ++k)
    {
      const Index a = mesh.triangles[f][k];
      this->facesOfEdge_[std::minmax(a, mesh.triangles[f][(k + 1) % 3])].push_back(f);
      this->facesOfVertex_[a].push_back(f);
    }
  }
}

/// All faces that hold the point.
std::vector<Index> CurveMaker::facesWith(Index face, const Barycentric& weights) const
{
  std::vector<Index> support;
  for (Index k = 0; k < 3; ++k)
  {
    if (weights[k] != 0.0)
    {
      support.push_back(this->mesh_.triangles[face][k]);
    }
  }
  if (support.size() == 1)
  {
    return this->facesOfVertex_[support[0]];
  }
  if (support.size() == 2)
  {
    return this->facesOfEdge_.at(std::minmax(support[0], support[1]));
  }
  return { face };
}

/// The weights in another face that holds the point.
Barycentric CurveMaker::inFace(Index face, Index other, const Barycentric& weights) const
{
  Barycentric result = { 0.0, 0.0, 0.0 };
  for (Index k = 0; k < 3; ++k)
  {
    for (Index j = 0; j < 3; ++j)
    {
      if (this->mesh_.triangles[other][j] == this->mesh_.triangles[face][k])
      {
        result[j] = weights[k];
      }
    }
  }
  return result;
}

Polyline CurveMaker::point(const MeshPoint& place) const
{
  Polyline curve;
  curve.segments.push_back({ place.face, place.weights, place.weights });
  return curve;
}

Polyline CurveMaker::point()
{
  return this->point(randomPoint(this->mesh_, this->random_));
}

Polyline CurveMaker::walk(Index segments)
{
  Polyline curve;
  const MeshPoint start = randomPoint(this->mesh_, this->random_);
  Index face = start.face;
  Barycentric here = start.weights;
  for (Index i = 0; i < segments; ++i)
  {
    const std::vector<Index> faces = this->facesWith(face, here);
    const Index next = faces[this->random_.below(faces.size())];
    here = this->inFace(face, next, here);
    face = next;
    Barycentric there = randomWeights(this->random_);
    while (there == here)
    {
      there = randomWeights(this->random_);
    }
    curve.segments.push_back({ face, here, there });
    here = there;
  }
  return curve;
}

Polyline CurveMaker::straight(Index faces)
{
  Polyline curve;
  MeshPoint start = randomFacePoint(this->mesh_, this->random_);
  Index face = start.face;
  Barycentric here = start.weights;
  const Triangle& t = this->mesh_.triangles[face];
  const auto corner = [this](Index v) -> const Vec3& { return this->mesh_.points[v]; };
  const double base = thirdCorner(corner(t[0]), corner(t[1]), corner(t[1]))[0]; // the length
  std::array<Vec2, 3> plane = { { { 0.0, 0.0 }, { base, 0.0 },
    thirdCorner(corner(t[0]), corner(t[1]), corner(t[2])) } };
  const Vec2 origin = { here[1] * plane[1][0] + here[2] * plane[2][0],
    here[1] * plane[1][1] + here[2] * plane[2][1] };
  // Aims at a point of a side, so that needles are crossed both ways.
  const Index aim = this->random_.below(3);
  const Vec2 target = plus(plane[aim], this->random_.uniform(0.1, 0.9),
    { plane[(aim + 1) % 3][0] - plane[aim][0], plane[(aim + 1) % 3][1] - plane[aim][1] });
  const Vec2 ray = { target[0] - origin[0], target[1] - origin[1] };
  Index exit = aim;
  for (Index i = 0; i < faces; ++i)
  {
    const Index a = exit;
    const Index b = (exit + 1) % 3;
    const double sideA = cross(ray, plus(plane[a], -1.0, origin));
    const double sideB = cross(ray, plus(plane[b], -1.0, origin));
    const double fraction = sideA / (sideA - sideB);
    Barycentric there = { 0.0, 0.0, 0.0 };
    there[a] = 1.0 - fraction;
    there[b] = fraction;
    const bool last = i + 1 == faces || !(fraction > 0.01 && fraction < 0.99);
    if (last)
    {
      // Ends on the way to the edge.
      const double part = this->random_.uniform(0.2, 0.8);
      for (Index k = 0; k < 3; ++k)
      {
        there[k] = (1.0 - part) * here[k] + part * there[k];
      }
      there[0] = 1.0 - there[1] - there[2];
      curve.segments.push_back({ face, here, there });
      break;
    }
    curve.segments.push_back({ face, here, there });
    std::vector<Index> around = this->facesOfEdge_.at(
      std::minmax(this->mesh_.triangles[face][a], this->mesh_.triangles[face][b]));
    around.erase(std::find(around.begin(), around.end(), face));
    if (around.empty())
    {
      break;
    }
    // The other pages of a non-manifold edge see the polyline bend or end there.
    curve.isCutAfter.push_back(around.size() == 1);
    // Unfold the next face over the edge, away from this one.
    const Index next = around[this->random_.below(around.size())];
    const Triangle& from = this->mesh_.triangles[face];
    const Triangle& to = this->mesh_.triangles[next];
    std::array<Vec2, 3> nextPlane{};
    Index third = 0;
    for (Index j = 0; j < 3; ++j)
    {
      if (to[j] == from[a])
      {
        nextPlane[j] = plane[a];
      }
      else if (to[j] == from[b])
      {
        nextPlane[j] = plane[b];
      }
      else
      {
        third = j;
      }
    }
    const Vec2 up = thirdCorner(corner(from[a]), corner(from[b]), corner(to[third]));
    const Vec2 edge = { plane[b][0] - plane[a][0], plane[b][1] - plane[a][1] };
    const double length = std::hypot(edge[0], edge[1]);
    const Vec2& inner = plane[3 - a - b];
    const double side = cross(edge, plus(inner, -1.0, plane[a])) > 0.0 ? -1.0 : 1.0;
    nextPlane[third] =
      plus(plus(plane[a], up[0] / length, edge), side * up[1] / length, Vec2{ -edge[1], edge[0] });
    here = this->inFace(face, next, there);
    face = next;
    plane = nextPlane;
    // The ray leaves between the third corner and one end of the edge just crossed.
    const bool thirdIsLeft = cross(ray, plus(plane[third], -1.0, origin)) > 0.0;
    const Index after = (third + 1) % 3;
    const bool afterIsLeft = cross(ray, plus(plane[after], -1.0, origin)) > 0.0;
    exit = thirdIsLeft != afterIsLeft ? third : (third + 2) % 3;
  }
  return curve;
}

Polyline CurveMaker::closed()
{
  Polyline curve;
  const Index face = this->random_.below(this->mesh_.triangles.size());
  std::array<Barycentric, 3> corner = { { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } };
  if (this->random_.chance(0.5))
  {
    corner = { { { 0.6, 0.2, 0.2 }, { 0.1, 0.75, 0.15 }, { 0.3, 0.2, 0.5 } } };
  }
  for (Index k = 0; k < 3; ++k)
  {
    curve.segments.push_back({ face, corner[k], corner[(k + 1) % 3] });
  }
  return curve;
}

Polyline CurveMaker::thereAndBack(Index segments)
{
  Polyline curve = this->walk(segments);
  const Polyline back = reversed(curve);
  curve.segments.insert(curve.segments.end(), back.segments.begin(), back.segments.end());
  return curve;
}

Polyline CurveMaker::any()
{
  switch (this->random_.below(8))
  {
    case 0:
    case 1:
      return this->point();
    case 2:
      return this->walk(1);
    case 3:
    case 4:
      return this->walk(this->random_.between(2, 6));
    case 5:
      return this->straight(this->random_.between(1, 5));
    case 6:
      return this->closed();
    default:
      return this->thereAndBack(this->random_.between(1, 3));
  }
}

std::vector<Polyline> CurveMaker::anySource()
{
  std::vector<Polyline> curves;
  const Index count = this->random_.chance(0.5) ? 1 : this->random_.between(2, 4);
  for (Index i = 0; i < count; ++i)
  {
    curves.push_back(this->any());
  }
  return curves;
}

Sources toSources(const std::vector<Polyline>& curves)
{
  Sources sources;
  for (const Polyline& curve : curves)
  {
    if (curve.isPoint())
    {
      sources.points.push_back({ curve.segments[0].face, curve.segments[0].from });
    }
    else
    {
      sources.segments.insert(sources.segments.end(), curve.segments.begin(), curve.segments.end());
    }
  }
  return sources;
}

Polyline reversed(const Polyline& curve)
{
  Polyline result = curve;
  std::reverse(result.segments.begin(), result.segments.end());
  for (MeshSegment& s : result.segments)
  {
    std::swap(s.from, s.to);
  }
  result.isCutAfter.resize(curve.segments.size(), false);
  std::reverse(result.isCutAfter.begin(), result.isCutAfter.end() - 1);
  return result;
}

}
