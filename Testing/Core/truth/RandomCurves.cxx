// SPDX-License-Identifier: BSD-3-Clause
#include "truth/RandomCurves.h"

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

/// A ray from a point of a face through faces that are unfolded one after another.
class StraightWalk
{
public:
  StraightWalk(const PlainMesh& mesh, const MeshPoint& start)
    : mesh_(mesh)
    , face_(start.face)
  {
    const double base = thirdCorner(this->corner(0), this->corner(1), this->corner(1))[0]; // length
    this->plane_[1] = { base, 0.0 };
    this->plane_[2] = thirdCorner(this->corner(0), this->corner(1), this->corner(2));
    this->origin_ = plus(this->origin_, start.weights[1], this->plane_[1]);
    this->origin_ = plus(this->origin_, start.weights[2], this->plane_[2]);
  }

  Index face() const { return this->face_; }

  /// Sends the ray to the point this fraction of the way along side k.
  void aimAt(Index k, double fraction)
  {
    const Vec2 side = plus(this->plane_[(k + 1) % 3], -1.0, this->plane_[k]);
    this->ray_ = plus(plus(this->plane_[k], fraction, side), -1.0, this->origin_);
    this->exit_ = k;
  }

  /// Where on its side the ray leaves the face.
  double exitFraction() const
  {
    const double a = this->sideOf(this->exit_);
    const double b = this->sideOf((this->exit_ + 1) % 3);
    return a / (a - b);
  }

  Barycentric exitWeights() const
  {
    Barycentric weights = { 0.0, 0.0, 0.0 };
    weights[this->exit_] = 1.0 - this->exitFraction();
    weights[(this->exit_ + 1) % 3] = this->exitFraction();
    return weights;
  }

  bool leavesAwayFromCorners() const
  {
    return this->exitFraction() > 0.01 && this->exitFraction() < 0.99;
  }

  /// Goes on into the face behind the side.
  void enter(Index next)
  {
    const Triangle& from = this->mesh_.triangles[this->face_];
    const Triangle& to = this->mesh_.triangles[next];
    const Index a = this->exit_;
    const Index b = (a + 1) % 3;
    const Index third = cornerBesides(to, from[a], from[b]);
    const bool sameWay = to[(third + 1) % 3] == from[a];
    std::array<Vec2, 3> plane{};
    plane[(third + 1) % 3] = this->plane_[sameWay ? a : b];
    plane[(third + 2) % 3] = this->plane_[sameWay ? b : a];
    const Vec2 up = thirdCorner(this->corner(a), this->corner(b), this->mesh_.points[to[third]]);
    const Vec2 edge = plus(this->plane_[b], -1.0, this->plane_[a]);
    const double length = std::hypot(edge[0], edge[1]);
    const Vec2 inward = plus(this->plane_[3 - a - b], -1.0, this->plane_[a]);
    const double away = cross(edge, inward) > 0.0 ? -1.0 : 1.0;
    plane[third] = plus(plus(this->plane_[a], up[0] / length, edge), away * up[1] / length,
      Vec2{ -edge[1], edge[0] });
    this->face_ = next;
    this->plane_ = plane;
    // The ray leaves between the third corner and one end of the edge just crossed.
    const Index after = (third + 1) % 3;
    const bool between = (this->sideOf(third) > 0.0) != (this->sideOf(after) > 0.0);
    this->exit_ = between ? third : (third + 2) % 3;
  }

private:
  const Vec3& corner(Index k) const
  {
    return this->mesh_.points[this->mesh_.triangles[this->face_][k]];
  }

  /// Positive where corner k is to the left of the ray.
  double sideOf(Index k) const
  {
    return cross(this->ray_, plus(this->plane_[k], -1.0, this->origin_));
  }

  static Index cornerBesides(const Triangle& t, Index a, Index b)
  {
    Index k = 0;
    while (t[k] == a || t[k] == b)
    {
      ++k;
    }
    return k;
  }

  const PlainMesh& mesh_;
  Index face_;
  /// The face's corners, unfolded into the plane of the first one.
  std::array<Vec2, 3> plane_{};
  Vec2 origin_ = { 0.0, 0.0 };
  Vec2 ray_ = { 0.0, 0.0 };
  /// The side (from this corner to the next) that the ray leaves through.
  Index exit_ = 0;
};

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
  const MeshPoint start = randomFacePoint(this->mesh_, this->random_);
  Barycentric here = start.weights;
  StraightWalk walk(this->mesh_, start);
  // Aims at a point of a side, so that needles are crossed both ways.
  const Index aim = this->random_.below(3);
  walk.aimAt(aim, this->random_.uniform(0.1, 0.9));
  for (Index i = 0; i < faces; ++i)
  {
    Barycentric there = walk.exitWeights();
    const Index face = walk.face();
    if (i + 1 == faces || !walk.leavesAwayFromCorners())
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
    std::vector<Index> around = this->facesWith(face, there);
    around.erase(std::find(around.begin(), around.end(), face));
    if (around.empty())
    {
      break;
    }
    // The other pages of a non-manifold edge see the polyline bend or end there.
    curve.isCutAfter.push_back(around.size() == 1);
    walk.enter(around[this->random_.below(around.size())]);
    here = this->inFace(face, walk.face(), there);
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
