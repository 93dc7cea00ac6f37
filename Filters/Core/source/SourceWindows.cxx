// SPDX-License-Identifier: BSD-3-Clause
#include "source/SourceWindows.h"

#include "window/FacePropagation.h"
#include "Tolerance.h"

#include <algorithm>
#include <tuple>

namespace geodesic
{

namespace
{

constexpr double RightAngle = 1.57079632679489661923;

std::size_t next(std::size_t k)
{
  return (k + 1) % 3;
}
std::size_t previous(std::size_t k)
{
  return (k + 2) % 3;
}

Vec2 rotated(Vec2 v, Vec2 axis)
{
  return { v.x * axis.x - v.y * axis.y, v.x * axis.y + v.y * axis.x };
}

// The unit vector along halfedge `of` of a face in the frame of its halfedge `in`.
Vec2 halfedgeAxis(const FaceShape& shape, std::size_t of, std::size_t in)
{
  if (of == in)
  {
    return { 1.0, 0.0 };
  }
  const double scale = shape.length[in] * shape.length[of];
  if (of == next(in))
  {
    return { -shape.cornerDot[of] / scale, shape.area2 / scale };
  }
  return { -shape.cornerDot[in] / scale, -shape.area2 / scale };
}

// A point in the frame of a window that leaves through the halfedge: the halfedge frame turned by a half
// turn about the middle of the halfedge.
Vec2 inLeavingFrame(const TriangleMesh& mesh, Id halfedge, const Barycentric& b)
{
  const Vec2 p = inHalfedgeFrame(mesh, halfedge, b);
  return { mesh.length(halfedge) - p.x, -p.y };
}

// The direction from a point along a segment that ends there, in one face around the point: rays at
// less than a right angle to it are shorter from inside the segment. `u` is in the frame of a halfedge.
struct Constraint
{
  Id face;
  std::size_t halfedge;
  Vec2 u;
};

Vec2 inLeavingFrame(const TriangleMesh& mesh, std::size_t halfedge, const Constraint& constraint)
{
  const Vec2 u =
    rotated(constraint.u, halfedgeAxis(mesh.shape(constraint.face), constraint.halfedge, halfedge));
  return { -u.x, -u.y };
}

struct Interval
{
  double begin;
  double end;

  // Keeps where a * x <= b.
  void clip(double a, double b)
  {
    if (a > 0.0)
    {
      this->end = std::min(this->end, b / a);
    }
    else if (a < 0.0)
    {
      this->begin = std::max(this->begin, b / a);
    }
    else if (b < 0.0)
    {
      this->end = this->begin;
    }
  }
};

// A source's end that another segment of the same point continues or not.
struct Spoke
{
  SurfacePoint from;
  SurfacePoint to;
  Id face;
};

class Maker
{
public:
  explicit Maker(const TriangleMesh& mesh)
    : mesh_(mesh)
  {
  }

  SourceWindows make(const std::vector<SourceCurve>& curves)
  {
    for (SourceCurve curve : curves)
    {
      for (SurfacePoint& point : curve.points)
      {
        point = normalized(this->mesh_, point);
      }
      this->addSegments(curve);
      this->addPoints(curve);
    }
    this->emitFromVertices();
    const auto byFace = [](const SourceInFace& a, const SourceInFace& b)
    { return a.face < b.face; };
    std::stable_sort(this->result_.inFaces.begin(), this->result_.inFaces.end(), byFace);
    return std::move(this->result_);
  }

private:
  // The halfedge of a face that is on the edge of the given one.
  Id halfedgeInFace(Id halfedge, Id face) const
  {
    Id s = halfedge;
    while (TriangleMesh::faceOf(s) != face)
    {
      s = this->mesh_.nextSibling(s);
    }
    return s;
  }

  void addSegments(const SourceCurve& curve)
  {
    for (std::size_t i = 0; i + 1 < curve.points.size(); ++i)
    {
      const SurfacePoint& p = curve.points[i];
      const SurfacePoint& q = curve.points[i + 1];
      const Id face = curve.faces[i];
      const Barycentric a = barycentric(this->mesh_, p, face);
      const Barycentric b = barycentric(this->mesh_, q, face);
      this->emitSegment(face, a, b);
      for (std::size_t k = 0; k < 3; ++k)
      {
        if (a[previous(k)] == 0.0 && b[previous(k)] == 0.0) // along halfedge k
        {
          const Id halfedge = 3 * face + static_cast<Id>(k);
          for (Id s = this->mesh_.nextSibling(halfedge); s != halfedge; s = this->mesh_.nextSibling(s))
          {
            const Id other = TriangleMesh::faceOf(s);
            this->emitSegment(
              other, barycentric(this->mesh_, p, other), barycentric(this->mesh_, q, other));
          }
        }
      }
    }
  }

  // Paper, section 4.2 and figure 6: rays leave at right angles, the strip's ends are cut by
  // orthogonal rays at the segment's ends.
  void emitSegment(Id face, const Barycentric& a, const Barycentric& b)
  {
    this->result_.inFaces.push_back({ face, a, b });
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Id halfedge = 3 * face + static_cast<Id>(k);
      const bool along = a[previous(k)] == 0.0 && b[previous(k)] == 0.0;
      if (along || this->mesh_.isBoundary(halfedge) || this->mesh_.length(halfedge) == 0.0)
      {
        continue;
      }
      Vec2 from = inLeavingFrame(this->mesh_, halfedge, a);
      Vec2 to = inLeavingFrame(this->mesh_, halfedge, b);
      if (from.x > to.x)
      {
        std::swap(from, to);
      }
      const double length = norm(to - from);
      if (!(length > 0.0))
      {
        continue;
      }
      const Vec2 t = (1.0 / length) * (to - from);
      Interval interval{ 0.0, this->mesh_.length(halfedge) };
      const double origin = dot(from, t); // position along the segment of x = 0, negated
      interval.clip(-t.x, -origin);
      interval.clip(t.x, origin + length);
      // Where the segment touches the halfedge, rays leave the face up to there only.
      const double sigma = -cross(t, from);
      interval.clip(t.y, sigma + tolerance::SourceDepth * this->mesh_.length(halfedge));
      this->addWindow(halfedge, interval, -t.y, t.x, sigma, Window::Kind::Linear);
    }
  }

  void addPoints(const SourceCurve& curve)
  {
    const std::size_t count = curve.points.size();
    const bool closed = curve.isClosed();
    for (std::size_t i = 0; i < count; ++i)
    {
      const bool last = i + 1 == count;
      const SurfacePoint& p = curve.points[i];
      // Around an edge of three and more faces the others see the curve bend.
      const bool straight =
        curve.isCut[i] && p.kind == SurfacePoint::Kind::Edge && this->mesh_.isInner(p.id);
      if (straight || (closed && last))
      {
        continue;
      }
      std::vector<Spoke> spokes;
      const auto addSpoke = [&](std::size_t to, std::size_t segment)
      {
        if (!samePlace(this->mesh_, p, curve.points[to]))
        {
          spokes.push_back({ p, curve.points[to], curve.faces[segment] });
        }
      };
      if (!last)
      {
        addSpoke(i + 1, i);
      }
      if (i > 0 || closed)
      {
        addSpoke(i > 0 ? i - 1 : count - 2, i > 0 ? i - 1 : count - 2);
      }
      if (p.kind == SurfacePoint::Kind::Vertex)
      {
        this->result_.vertices.push_back(p.id);
        this->vertexSpokes_.insert(this->vertexSpokes_.end(), spokes.begin(), spokes.end());
        continue;
      }
      this->emitFromPoint(p, spokes);
    }
  }

  void emitFromPoint(const SurfacePoint& p, const std::vector<Spoke>& spokes)
  {
    std::vector<Constraint> constraints;
    for (const Spoke& spoke : spokes)
    {
      this->constrain(spoke, constraints);
    }
    forEachFace(this->mesh_, p,
      [&](Id face)
      {
        const Barycentric b = barycentric(this->mesh_, p, face);
        if (p.kind != SurfacePoint::Kind::Vertex)
        {
          this->result_.inFaces.push_back({ face, b, b });
          this->findNearVertices(face, b);
        }
        this->emitPoint(face, b, constraints);
      });
  }

  void findNearVertices(Id face, const Barycentric& b)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (1.0 - b[k] < tolerance::NearVertex)
      {
        this->result_.nearVertices.push_back(this->mesh_.triangle(face)[k]);
      }
    }
  }

  // Several curves may meet in one vertex: all their segments bound its wedges together.
  void emitFromVertices()
  {
    std::vector<Id>& vertices = this->result_.vertices;
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    const auto key = [](const Spoke& s)
    { return std::make_tuple(s.from.id, s.face, s.to.kind, s.to.id, s.to.u, s.to.v); };
    const auto less = [&](const Spoke& a, const Spoke& b) { return key(a) < key(b); };
    std::vector<Spoke>& spokes = this->vertexSpokes_;
    std::sort(spokes.begin(), spokes.end(), less);

    auto first = spokes.cbegin();
    for (const Id vertex : vertices)
    {
      auto last = first;
      while (last != spokes.cend() && last->from.id == vertex)
      {
        ++last;
      }
      this->emitFromPoint(SurfacePoint::atVertex(vertex), { first, last });
      first = last;
    }
  }

  void emitPoint(Id face, const Barycentric& b, const std::vector<Constraint>& constraints)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Id halfedge = 3 * face + static_cast<Id>(k);
      const double length = this->mesh_.length(halfedge);
      if (b[previous(k)] == 0.0 || this->mesh_.isBoundary(halfedge) || length == 0.0)
      {
        continue;
      }
      const Vec2 p = inLeavingFrame(this->mesh_, halfedge, b);
      const bool near = -p.y <= tolerance::NearEdge * length;
      Interval interval{ 0.0, length };
      for (const Constraint& constraint : constraints)
      {
        if (constraint.face == face && !near)
        {
          const Vec2 u = inLeavingFrame(this->mesh_, k, constraint);
          interval.clip(u.x, dot(p, u) + std::abs(u.x) * tolerance::Rounding * length);
        }
      }
      const double depth = std::max(-p.y, tolerance::SourceDepth * length);
      this->addWindow(halfedge, interval, p.x, depth, 0.0, Window::Kind::Circular);
      if (near && p.x > 0.0 && p.x < length)
      {
        this->emitBeyond(halfedge, p);
      }
    }
  }

  // Where on a halfedge a ray passes says little of its direction when the point is close to the halfedge.
  // Its rays are then also sent through the faces behind, from its place, in one step: between the
  // rays through the ends of the edge, which hide what is beside them.
  void emitBeyond(Id halfedge, Vec2 p)
  {
    const double length = this->mesh_.length(halfedge);
    for (Id s = this->mesh_.nextSibling(halfedge); s != halfedge; s = this->mesh_.nextSibling(s))
    {
      const bool turned = this->mesh_.origin(s) == this->mesh_.origin(halfedge);
      const Window w = { 0.0, length, turned ? length - p.x : p.x, -p.y, 0.0, 0.0,
        Window::Kind::Circular, 0 };
      const UnfoldedFace face = unfold(this->mesh_, s);
      const bool toLeft = !w.passesRightOf(0.0, face.apex);
      const bool toRight = w.passesRightOf(length, face.apex);
      if (toLeft)
      {
        const double end = toRight ? face.leftLength : face.meetLeft(w, length);
        this->addBeyond(TriangleMesh::previousInFace(s), face.throughLeft(w, 0.0, end));
      }
      if (toRight)
      {
        const double begin = toLeft ? 0.0 : face.meetRight(w, 0.0);
        this->addBeyond(TriangleMesh::nextInFace(s), face.throughRight(w, begin, face.rightLength));
      }
    }
  }

  void addBeyond(Id halfedge, Window window)
  {
    if (this->mesh_.isBoundary(halfedge) || !(window.end > window.begin))
    {
      return;
    }
    window.sourceDepth = std::max(window.sourceDepth, tolerance::SourceDepth * window.end);
    this->result_.windows.push_back({ halfedge, window });
  }

  void addWindow(
    Id halfedge, const Interval& interval, double x, double depth, double sigma, Window::Kind kind)
  {
    const double length = this->mesh_.length(halfedge);
    const double begin = std::max(interval.begin, 0.0);
    const double end = std::min(interval.end, length);
    if (end - begin > tolerance::LeastWidth * length && depth > 0.0)
    {
      this->result_.windows.push_back({ halfedge, { begin, end, x, depth, sigma, 0.0, kind, 0 } });
    }
  }

  void constrain(const Spoke& spoke, std::vector<Constraint>& constraints) const
  {
    switch (spoke.from.kind)
    {
      case SurfacePoint::Kind::Face:
        constraints.push_back(this->inOwnFace(spoke, 0));
        break;
      case SurfacePoint::Kind::Edge:
        this->constrainAroundEdge(spoke, constraints);
        break;
      case SurfacePoint::Kind::Vertex:
        this->constrainAroundVertex(spoke, constraints);
        break;
    }
  }

  // The spoke's direction in the frame of a halfedge of its own face (the first with a length from k
  // on).
  Constraint inOwnFace(const Spoke& spoke, std::size_t k) const
  {
    while (this->mesh_.shape(spoke.face).length[k] == 0.0)
    {
      k = next(k);
    }
    const Id halfedge = 3 * spoke.face + static_cast<Id>(k);
    const Vec2 from =
      inHalfedgeFrame(this->mesh_, halfedge, barycentric(this->mesh_, spoke.from, spoke.face));
    const Vec2 to = inHalfedgeFrame(this->mesh_, halfedge, barycentric(this->mesh_, spoke.to, spoke.face));
    const Vec2 d = to - from;
    const double length = norm(d);
    return { spoke.face, k, length > 0.0 ? (1.0 / length) * d : d };
  }

  // Faces across the edge unfold into the spoke's plane: the same vector, seen from the other side.
  void constrainAroundEdge(const Spoke& spoke, std::vector<Constraint>& constraints) const
  {
    const Id halfedge = this->halfedgeInFace(spoke.from.id, spoke.face);
    const Constraint own = this->inOwnFace(spoke, halfedge % 3);
    constraints.push_back(own);
    for (Id s = this->mesh_.nextSibling(halfedge); s != halfedge; s = this->mesh_.nextSibling(s))
    {
      const bool opposed = this->mesh_.origin(s) == this->mesh_.destination(halfedge);
      const Vec2 u = { opposed ? -own.u.x : own.u.x, -own.u.y };
      constraints.push_back({ TriangleMesh::faceOf(s), s % 3, u });
    }
  }

  // Walks the faces around the vertex from the spoke to both sides, as far as a right angle.
  void constrainAroundVertex(const Spoke& spoke, std::vector<Constraint>& constraints) const
  {
    const Id vertex = spoke.from.id;
    std::size_t corner = 0;
    while (this->mesh_.triangle(spoke.face)[corner] != vertex)
    {
      ++corner;
    }
    const Constraint own = this->inOwnFace(spoke, corner);
    constraints.push_back(own);
    if (own.halfedge != corner)
    {
      return; // a halfedge without length: its neighbours emit too, which costs time only
    }
    const Id halfedge = 3 * spoke.face + static_cast<Id>(corner);
    const double angle = std::max(0.0, std::atan2(own.u.y, own.u.x)); // from halfedge `corner`
    this->walk(vertex, halfedge, angle, constraints);
    this->walk(vertex, TriangleMesh::previousInFace(halfedge),
      std::max(0.0, this->mesh_.cornerAngle(halfedge) - angle), constraints);
  }

  // Crosses a spoke halfedge that is `angle` away from the segment; goes on through every face there.
  void walk(
    Id vertex, Id crossed, double angle, std::vector<Constraint>& constraints, Id steps = 0) const
  {
    if (angle >= RightAngle || steps > this->mesh_.cornersAt(vertex).size())
    {
      return;
    }
    for (Id s = this->mesh_.nextSibling(crossed); s != crossed; s = this->mesh_.nextSibling(s))
    {
      // In the frame of s the vertex is at the origin or at the end of the x axis.
      const bool atOrigin = this->mesh_.origin(s) == vertex;
      const double x = atOrigin ? std::cos(angle) : -std::cos(angle);
      constraints.push_back({ TriangleMesh::faceOf(s), s % 3, { x, -std::sin(angle) } });
      const Id corner = atOrigin ? s : TriangleMesh::nextInFace(s);
      const Id across = atOrigin ? TriangleMesh::previousInFace(s) : TriangleMesh::nextInFace(s);
      this->walk(vertex, across, angle + this->mesh_.cornerAngle(corner), constraints, steps + 1);
    }
  }

  const TriangleMesh& mesh_;
  SourceWindows result_;
  std::vector<Spoke> vertexSpokes_;
};

} // anonymous namespace

SourceWindows makeSourceWindows(const TriangleMesh& mesh, const std::vector<SourceCurve>& curves)
{
  return Maker(mesh).make(curves);
}

LeavingWindow vertexWindow(const TriangleMesh& mesh, Id corner, double sigma)
{
  const Id halfedge = TriangleMesh::nextInFace(corner);
  const double length = mesh.length(halfedge);
  std::array<double, 3> b{};
  b[corner % 3] = 1.0;
  const Vec2 p = inLeavingFrame(mesh, halfedge, b);
  const double depth = std::max(-p.y, tolerance::SourceDepth * length);
  return { halfedge, { 0.0, length, p.x, depth, sigma, 0.0, Window::Kind::Circular, 0 } };
}

}
