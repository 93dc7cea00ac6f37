// SPDX-License-Identifier: BSD-3-Clause
#include "truth/BruteForce.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>

namespace geodesictest
{

namespace
{

constexpr double Infinite = std::numeric_limits<double>::infinity();
constexpr double Pi = 3.14159265358979323846;
constexpr Index None = ~Index(0);

// A pencil that is beaten by less than this (relative) is followed all the same: rounding must not
// end the only pencil along a ray that grazes a flat vertex.
constexpr double BeatenSlack = 1e-10;
// A point this far outside a pencil (as an angle, or relative to the strip) is still reached by it:
// the detour through the vertex that bounds the pencil is longer by the square of it only.
constexpr double PencilSlack = 1e-12;
// Rounding of the cross products that tell where a border ray meets an edge.
constexpr double BorderSlack = 1e-14;
// A point this close to a pencil's apex (relative to the edge between them) lies in no direction
// that rounding leaves alone.
constexpr double ApexSlack = 1e-14;
// A vertex whose total angle is short of 2 pi by this still emits. Emitting is always right.
constexpr double AngleSlack = 1e-7;
// A face whose height is this small against its edge counts as flat: its vertices emit.
constexpr double FlatFace = 1e-7;

struct Plane
{
  double x = 0.0;
  double y = 0.0;
};
Plane operator+(Plane a, Plane b)
{
  return { a.x + b.x, a.y + b.y };
}
Plane operator-(Plane a, Plane b)
{
  return { a.x - b.x, a.y - b.y };
}
Plane operator*(double s, Plane a)
{
  return { s * a.x, s * a.y };
}
double dot(Plane a, Plane b)
{
  return a.x * b.x + a.y * b.y;
}
double cross(Plane a, Plane b)
{
  return a.x * b.y - a.y * b.x;
}
double size(Plane a)
{
  // std::hypot is for squares that overflow or underflow. It took a quarter of the solver's time.
  const double square = a.x * a.x + a.y * a.y;
  return square > 1e-280 && square < 1e280 ? std::sqrt(square) : std::hypot(a.x, a.y);
}
/// A quarter turn to the left.
Plane turned(Plane a)
{
  return { -a.y, a.x };
}
/// The vector a as seen from axes whose x axis is the unit vector e.
Plane seenFrom(Plane e, Plane a)
{
  return { dot(e, a), cross(e, a) };
}

struct FlatTriangle
{
  Triangle vertices;
  /// Of edge k, from corner k to corner k + 1.
  std::array<double, 3> length;
  /// The third corner over edge k: how far along from corner k, from corner k + 1, and how high.
  std::array<double, 3> along;
  std::array<double, 3> alongBack;
  std::array<double, 3> height;
};

/// A face laid into the plane counterclockwise: corners relative to some origin, and the unit
/// vector along each edge.
struct Layout
{
  std::array<Plane, 3> corner;
  std::array<Plane, 3> direction;
};

struct EdgeOfFace
{
  Index face;
  Index k;
};

/// Rays from a point (or, in a strip, parallel rays) that cross one edge. Seen along the rays,
/// `left` is the edge's left end. The plane's origin is the point; in a strip the rays run along +y
/// from the source, which lies on y = 0.
struct Pencil
{
  double nearest;
  double offset;
  Plane left, right;
  Plane direction;
  Plane leftRay, rightRay;
  Index leftVertex, rightVertex;
  Index face;
  bool strip;
};

struct LaterPencil
{
  bool operator()(const Pencil& a, const Pencil& b) const { return a.nearest > b.nearest; }
};

/// A source as it lies in one face.
struct DirectSource
{
  Index face;
  Barycentric from;
  Barycentric to;
  bool segment;
};

class Solver
{
public:
  Solver(const PlainMesh& mesh, const BruteForceOptions& options)
    : mesh_(mesh)
    , options_(options)
  {
    this->takeFaces();
    this->findEmitters();
    this->bound_.assign(mesh.points.size(), Infinite);
    this->queriesIn_.resize(this->faces_.size());
  }

  BruteForceResult solve(const Sources& sources, const std::vector<MeshPoint>& queries);

private:
  void takeFaces();
  void findEmitters();
  bool isSurroundedOnce(Index vertex) const;
  Barycentric inKeptFace(Index keptFace, Index inputFace, const Barycentric& weights) const;
  const std::vector<EdgeOfFace>& facesAround(Index a, Index b) const;

  Layout layout(Index face, Index base) const;
  static Layout movedTo(const Layout& layout, const Barycentric& origin);

  void emitPoint(Index face, const Barycentric& weights, double offset);
  void emitInto(Index face, const Barycentric& weights, double offset);
  void emitSegment(Index face, const Barycentric& from, const Barycentric& to);
  void emitStrip(Index face, const Layout& layout, double segmentLength, bool mirrored);
  void emitVertex(Index vertex);

  void lower(Index vertex, double distance);
  void relaxEdges();
  void propagate();
  void follow(const Pencil& pencil, const EdgeOfFace& entry);
  void push(Pencil pencil);
  bool isBeaten(const Pencil& pencil, Plane leftmost, Plane rightmost) const;
  void reachQueries(const Pencil& pencil, Index face, Index third, Plane thirdPoint);
  void finishQueries();
  void reachDirectly(Index query);
  double inFaceDistance(Index face, const Barycentric& a, const Barycentric& b) const;

  const PlainMesh& mesh_;
  BruteForceOptions options_;
  std::vector<FlatTriangle> faces_;
  std::vector<Index> keptFace_;
  std::map<std::pair<Index, Index>, std::vector<EdgeOfFace>> around_;
  std::vector<std::vector<EdgeOfFace>> cornersAt_;
  std::vector<bool> emits_;
  /// Length of the shortest path known so far; a real path always.
  std::vector<double> bound_;
  std::priority_queue<Pencil, std::vector<Pencil>, LaterPencil> pencils_;
  using Arrival = std::pair<double, Index>;
  std::priority_queue<Arrival, std::vector<Arrival>, std::greater<Arrival>> arrivals_;
  std::vector<DirectSource> directSources_;
  std::vector<std::vector<Index>> queriesIn_;
  std::vector<Index> queryFace_;
  std::vector<Barycentric> queryWeights_;
  BruteForceResult result_;
};

//----------------------------------------------------------------------------
Vec3 minus(const Vec3& a, const Vec3& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}
double dot(const Vec3& a, const Vec3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
double size(const Vec3& a)
{
  return std::sqrt(dot(a, a));
}
double parallelogram(const Vec3& a, const Vec3& b)
{
  return size(
    Vec3{ a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] });
}

void Solver::takeFaces()
{
  std::map<Triangle, Index> seen;
  this->cornersAt_.resize(this->mesh_.points.size());
  for (const Triangle& t : this->mesh_.triangles)
  {
    Triangle sorted = t;
    std::sort(sorted.begin(), sorted.end());
    if (sorted[0] == sorted[1] || sorted[1] == sorted[2])
    {
      this->keptFace_.push_back(None);
      continue;
    }
    const Index id = static_cast<Index>(this->faces_.size());
    const auto [found, isNew] = seen.emplace(sorted, id);
    this->keptFace_.push_back(found->second);
    if (!isNew)
    {
      continue;
    }
    FlatTriangle face;
    face.vertices = t;
    for (Index k = 0; k < 3; ++k)
    {
      const Vec3& p = this->mesh_.points[t[k]];
      const Vec3& q = this->mesh_.points[t[(k + 1) % 3]];
      const Vec3& r = this->mesh_.points[t[(k + 2) % 3]];
      const Vec3 pq = minus(q, p);
      const double length = size(pq);
      const double inverse = length > 0.0 ? 1.0 / length : 0.0;
      face.length[k] = length;
      face.along[k] = inverse * dot(minus(r, p), pq);
      face.alongBack[k] = inverse * dot(minus(q, r), pq);
      face.height[k] = inverse * parallelogram(pq, minus(r, p));
      this->around_[std::minmax(t[k], t[(k + 1) % 3])].push_back({ id, k });
      this->cornersAt_[t[k]].push_back({ id, k });
    }
    this->faces_.push_back(face);
  }
}

const std::vector<EdgeOfFace>& Solver::facesAround(Index a, Index b) const
{
  return this->around_.at(std::minmax(a, b));
}

/// Whether the faces at the vertex form one closed fan without forks.
bool Solver::isSurroundedOnce(Index vertex) const
{
  const std::vector<EdgeOfFace>& corners = this->cornersAt_[vertex];
  std::vector<Index> reached = { corners.front().face };
  for (std::size_t i = 0; i < reached.size(); ++i)
  {
    for (Index v : this->faces_[reached[i]].vertices)
    {
      if (v == vertex)
      {
        continue;
      }
      const std::vector<EdgeOfFace>& around = this->facesAround(vertex, v);
      if (around.size() != 2)
      {
        return false;
      }
      for (const EdgeOfFace& e : around)
      {
        if (std::find(reached.begin(), reached.end(), e.face) == reached.end())
        {
          reached.push_back(e.face);
        }
      }
    }
  }
  return reached.size() == corners.size();
}

void Solver::findEmitters()
{
  this->emits_.assign(this->mesh_.points.size(), this->options_.everyVertexEmits);
  for (Index v = 0; v < this->mesh_.points.size(); ++v)
  {
    double angle = 0.0;
    bool flatFace = false;
    for (const EdgeOfFace& corner : this->cornersAt_[v])
    {
      const FlatTriangle& face = this->faces_[corner.face];
      const Index k = corner.k;
      angle += std::atan2(face.height[k], face.along[k]);
      for (Index j = 0; j < 3; ++j)
      {
        flatFace = flatFace || !(face.height[j] > FlatFace * face.length[j]);
      }
    }
    if (!this->cornersAt_[v].empty() &&
      (flatFace || angle > 2.0 * Pi - AngleSlack || !this->isSurroundedOnce(v)))
    {
      this->emits_[v] = true;
    }
  }
}

/// Weights by corner of the kept face: the input face may be a duplicate with other corners first.
Barycentric Solver::inKeptFace(Index keptFace, Index inputFace, const Barycentric& weights) const
{
  Barycentric result{};
  const Triangle& from = this->mesh_.triangles[inputFace];
  const Triangle& to = this->faces_[keptFace].vertices;
  for (Index k = 0; k < 3; ++k)
  {
    for (Index j = 0; j < 3; ++j)
    {
      if (from[k] == to[j])
      {
        result[j] = weights[k];
      }
    }
  }
  return result;
}

//----------------------------------------------------------------------------
/// The face with corner `base` at the origin and edge `base` along +x.
Layout Solver::layout(Index face, Index base) const
{
  const FlatTriangle& t = this->faces_[face];
  const Index second = (base + 1) % 3;
  const Index third = (base + 2) % 3;
  Layout result;
  result.corner[base] = { 0.0, 0.0 };
  result.corner[second] = { t.length[base], 0.0 };
  result.corner[third] = { t.along[base], t.height[base] };
  const auto unit = [](Plane a, double length) {
    return length > 0.0 ? (1.0 / length) * a : Plane{ 0.0, 0.0 };
  };
  result.direction[base] = { 1.0, 0.0 };
  result.direction[second] = unit({ -t.alongBack[base], t.height[base] }, t.length[second]);
  result.direction[third] = unit({ -t.along[base], -t.height[base] }, t.length[third]);
  return result;
}

/// The same with the origin at a point of the face, accurate where the point is close to a corner.
Layout Solver::movedTo(const Layout& layout, const Barycentric& origin)
{
  Layout result = layout;
  for (Index k = 0; k < 3; ++k)
  {
    result.corner[k] = { 0.0, 0.0 };
    for (Index j = 1; j < 3; ++j)
    {
      const Index other = (k + j) % 3;
      result.corner[k] =
        result.corner[k] + origin[other] * (layout.corner[k] - layout.corner[other]);
    }
  }
  return result;
}

/// The edge whose layout keeps most digits: the shortest that has a length.
Index shortestEdge(const FlatTriangle& face)
{
  Index best = 0;
  for (Index k = 1; k < 3; ++k)
  {
    if (face.length[k] > 0.0 && (face.length[k] < face.length[best] || face.length[best] <= 0.0))
    {
      best = k;
    }
  }
  return best;
}

double Solver::inFaceDistance(Index face, const Barycentric& a, const Barycentric& b) const
{
  const Layout corners = movedTo(this->layout(face, shortestEdge(this->faces_[face])), a);
  Plane p;
  for (Index k = 0; k < 3; ++k)
  {
    p = p + b[k] * corners.corner[k];
  }
  return size(p);
}

/// Emits from the point into every face that holds it.
void Solver::emitPoint(Index face, const Barycentric& weights, double offset)
{
  const Triangle& t = this->faces_[face].vertices;
  std::vector<Index> support;
  for (Index k = 0; k < 3; ++k)
  {
    if (weights[k] != 0.0)
    {
      support.push_back(k);
    }
  }
  std::vector<EdgeOfFace> holders = { { face, 0 } };
  if (support.size() == 2)
  {
    holders = this->facesAround(t[support[0]], t[support[1]]);
  }
  else if (support.size() == 1)
  {
    holders = this->cornersAt_[t[support[0]]];
  }
  for (const EdgeOfFace& holder : holders)
  {
    Barycentric here = { 0.0, 0.0, 0.0 };
    for (Index k : support)
    {
      for (Index j = 0; j < 3; ++j)
      {
        if (this->faces_[holder.face].vertices[j] == t[k])
        {
          here[j] = weights[k];
        }
      }
    }
    this->emitInto(holder.face, here, offset);
  }
}

void Solver::emitInto(Index face, const Barycentric& weights, double offset)
{
  const FlatTriangle& t = this->faces_[face];
  const Layout here = movedTo(this->layout(face, shortestEdge(t)), weights);
  if (offset <= 0.0)
  {
    this->directSources_.push_back({ face, weights, weights, false });
  }
  for (Index k = 0; k < 3; ++k)
  {
    this->lower(t.vertices[k], offset + size(here.corner[k]));
    const Index next = (k + 1) % 3;
    // Nothing leaves through an edge that the point lies on: the faces behind it hold it, too.
    if (weights[(k + 2) % 3] == 0.0)
    {
      continue;
    }
    Pencil pencil;
    pencil.offset = offset;
    pencil.left = pencil.leftRay = here.corner[next];
    pencil.right = pencil.rightRay = here.corner[k];
    pencil.direction = -1.0 * here.direction[k];
    pencil.leftVertex = t.vertices[next];
    pencil.rightVertex = t.vertices[k];
    pencil.face = face;
    pencil.strip = false;
    this->push(pencil);
  }
}

void Solver::emitSegment(Index face, const Barycentric& from, const Barycentric& to)
{
  this->emitPoint(face, from, 0.0);
  this->emitPoint(face, to, 0.0);
  // A segment along an edge must lie on it exactly: lay out that edge first.
  Index base = shortestEdge(this->faces_[face]);
  for (Index k = 0; k < 3; ++k)
  {
    if (from[k] == 0.0 && to[k] == 0.0)
    {
      base = (k + 1) % 3;
    }
  }
  Layout here = movedTo(this->layout(face, base), from);
  const Index second = (base + 1) % 3;
  const Index third = (base + 2) % 3;
  const Layout plain = this->layout(face, base);
  const Plane span = (to[second] - from[second]) * plain.corner[second] +
    (to[third] - from[third]) * plain.corner[third];
  const double length = size(span);
  if (!(length > 0.0))
  {
    return;
  }
  this->directSources_.push_back({ face, from, to, true });
  const Plane axis = (1.0 / length) * span;
  for (Index k = 0; k < 3; ++k)
  {
    here.corner[k] = seenFrom(axis, here.corner[k]);
    here.direction[k] = seenFrom(axis, here.direction[k]);
  }
  this->emitStrip(face, here, length, false);
  for (Index k = 0; k < 3; ++k)
  {
    here.corner[k].y = -here.corner[k].y;
    here.direction[k].y = -here.direction[k].y;
  }
  this->emitStrip(face, here, length, true);
}

/// Parallel rays along +y from the segment on the x axis through the edges above it.
void Solver::emitStrip(Index face, const Layout& here, double segmentLength, bool mirrored)
{
  const FlatTriangle& t = this->faces_[face];
  for (Index k = 0; k < 3; ++k)
  {
    const Plane corner = here.corner[k];
    if (corner.x >= 0.0 && corner.x <= segmentLength && corner.y >= 0.0)
    {
      this->lower(t.vertices[k], corner.y);
    }
    // Counterclockwise, edges above run to the left.
    const Index next = (k + 1) % 3;
    const bool leftward = here.corner[next].x < corner.x;
    const bool rightward = here.corner[next].x > corner.x;
    if (mirrored ? !rightward : !leftward)
    {
      continue;
    }
    const Index l = mirrored ? k : next;
    const Index r = mirrored ? next : k;
    Pencil pencil;
    pencil.offset = 0.0;
    pencil.left = here.corner[l];
    pencil.right = here.corner[r];
    pencil.direction = (mirrored ? 1.0 : -1.0) * here.direction[k];
    pencil.leftRay = { std::max(0.0, pencil.left.x), 0.0 };
    pencil.rightRay = { std::min(segmentLength, pencil.right.x), 0.0 };
    pencil.leftVertex = t.vertices[l];
    pencil.rightVertex = t.vertices[r];
    pencil.face = face;
    pencil.strip = true;
    this->push(pencil);
  }
}

void Solver::emitVertex(Index vertex)
{
  for (const EdgeOfFace& corner : this->cornersAt_[vertex])
  {
    Barycentric weights = { 0.0, 0.0, 0.0 };
    weights[corner.k] = 1.0;
    this->emitInto(corner.face, weights, this->bound_[vertex]);
  }
}

//----------------------------------------------------------------------------
void Solver::lower(Index vertex, double distance)
{
  if (distance < this->bound_[vertex])
  {
    this->bound_[vertex] = distance;
    this->arrivals_.push({ distance, vertex });
  }
}

/// Dijkstra along the edges: bounds for the start.
void Solver::relaxEdges()
{
  while (!this->arrivals_.empty())
  {
    const auto [distance, vertex] = this->arrivals_.top();
    this->arrivals_.pop();
    if (distance > this->bound_[vertex])
    {
      continue;
    }
    for (const EdgeOfFace& corner : this->cornersAt_[vertex])
    {
      const FlatTriangle& face = this->faces_[corner.face];
      const Index k = corner.k;
      this->lower(face.vertices[(k + 1) % 3], distance + face.length[k]);
      this->lower(face.vertices[(k + 2) % 3], distance + face.length[(k + 2) % 3]);
    }
  }
  for (Index v = 0; v < this->bound_.size(); ++v)
  {
    if (this->bound_[v] < Infinite)
    {
      this->arrivals_.push({ this->bound_[v], v });
    }
  }
}

/// The nearest first, pencils and vertices alike; a vertex that is lowered once more emits once
/// more.
void Solver::propagate()
{
  while (!this->pencils_.empty() || !this->arrivals_.empty())
  {
    const double vertexKey = this->arrivals_.empty() ? Infinite : this->arrivals_.top().first;
    if (!this->pencils_.empty() && this->pencils_.top().nearest < vertexKey)
    {
      const Pencil pencil = this->pencils_.top();
      this->pencils_.pop();
      for (const EdgeOfFace& e : this->facesAround(pencil.leftVertex, pencil.rightVertex))
      {
        if (e.face != pencil.face)
        {
          this->follow(pencil, e);
        }
      }
      continue;
    }
    const auto [distance, vertex] = this->arrivals_.top();
    this->arrivals_.pop();
    if (distance <= this->bound_[vertex] && this->emits_[vertex] &&
      distance <= this->options_.maximumDistance)
    {
      this->emitVertex(vertex);
    }
  }
}

/// Where the pencil's border ray meets its edge, moved outwards by what rounding may have done: by
/// much where the ray nearly runs along the edge. A pencil taken for wider is dropped less often.
Plane borderPoint(const Pencil& pencil, bool left)
{
  const Plane span = pencil.right - pencil.left;
  const Plane ray = left ? pencil.leftRay : pencil.rightRay;
  const double above = pencil.strip ? ray.x - pencil.left.x : cross(ray, pencil.left);
  const double below = pencil.strip ? span.x : -cross(ray, span);
  const double reach = size(pencil.left) + size(pencil.right);
  const double rounding = BorderSlack * (pencil.strip ? reach : size(ray) * reach);
  double fraction = left ? 0.0 : 1.0;
  if (below > rounding)
  {
    fraction = std::clamp((above + (left ? -rounding : rounding)) / below, 0.0, 1.0);
  }
  return pencil.left + fraction * span;
}

double pencilDistance(const Pencil& pencil, Plane p)
{
  return pencil.strip ? p.y : pencil.offset + size(p);
}

/// How far a point is to the left of the pencil's left ray (or to the right of its right one).
double outside(const Pencil& pencil, Plane p, bool left)
{
  const Plane ray = left ? pencil.leftRay : pencil.rightRay;
  const double beyond = pencil.strip ? ray.x - p.x : cross(ray, p);
  return left ? beyond : -beyond;
}

/// Whether apex, edge and point are within rounding of each other, so that any angle is one.
bool isAtApex(const Pencil& pencil, Plane p)
{
  const double rounding = ApexSlack * (size(pencil.left) + size(pencil.right));
  return !pencil.strip && size(p) <= rounding && pencil.nearest - pencil.offset <= rounding;
}

bool reaches(const Pencil& pencil, Plane p)
{
  if (isAtApex(pencil, p))
  {
    return true;
  }
  const double leftSlack =
    PencilSlack * (pencil.strip ? std::abs(p.x) + std::abs(p.y) : size(pencil.leftRay) * size(p));
  const double rightSlack =
    PencilSlack * (pencil.strip ? std::abs(p.x) + std::abs(p.y) : size(pencil.rightRay) * size(p));
  return outside(pencil, p, true) <= leftSlack && outside(pencil, p, false) <= rightSlack;
}

/// Whether the way through an end of the edge is shorter for every ray. Distance along the edge has
/// slope at most 1, so the ray farthest from that end decides.
bool Solver::isBeaten(const Pencil& pencil, Plane leftmost, Plane rightmost) const
{
  const double atRight = pencilDistance(pencil, rightmost);
  const double atLeft = pencilDistance(pencil, leftmost);
  return atRight * (1.0 - BeatenSlack) >
    this->bound_[pencil.leftVertex] + size(rightmost - pencil.left) ||
    atLeft * (1.0 - BeatenSlack) > this->bound_[pencil.rightVertex] + size(leftmost - pencil.right);
}

void Solver::push(Pencil pencil)
{
  // A point within rounding of the edge sees all of it, under an angle that rounds to pi.
  const bool empty = pencil.strip
    ? !(pencil.leftRay.x < pencil.rightRay.x)
    : !(cross(pencil.rightRay, pencil.leftRay) > 0.0) && dot(pencil.rightRay, pencil.leftRay) > 0.0;
  if (empty || !(size(pencil.right - pencil.left) > 0.0))
  {
    return;
  }
  const Plane leftmost = borderPoint(pencil, true);
  const Plane rightmost = borderPoint(pencil, false);
  // An edge that stands on an end of the segment at a right angle leans over it by rounding. Below
  // the segment that is no ray.
  const auto [lowest, highest] = std::minmax({ leftmost.y, rightmost.y });
  const double slack = PencilSlack * (size(pencil.left) + size(pencil.right));
  if (pencil.strip && lowest < -slack && highest <= slack)
  {
    return;
  }
  if (this->isBeaten(pencil, leftmost, rightmost))
  {
    return;
  }
  pencil.nearest = std::min(pencilDistance(pencil, leftmost), pencilDistance(pencil, rightmost));
  if (!pencil.strip)
  {
    const Plane span = rightmost - leftmost;
    const double foot = -dot(leftmost, span);
    if (foot > 0.0 && foot < dot(span, span))
    {
      pencil.nearest = pencil.offset + std::abs(cross(leftmost, span)) / size(span);
    }
  }
  if (pencil.nearest <= this->options_.maximumDistance)
  {
    this->pencils_.push(pencil);
  }
}

/// Unfolds the face behind the edge and sends the pencil on through its two other edges.
void Solver::follow(const Pencil& pencil, const EdgeOfFace& entry)
{
  if (this->isBeaten(pencil, borderPoint(pencil, true), borderPoint(pencil, false)))
  {
    return;
  }
  ++this->result_.pencils;
  const FlatTriangle& face = this->faces_[entry.face];
  const Index k = entry.k;
  const bool forward = face.vertices[k] == pencil.leftVertex;
  const double along = forward ? face.along[k] : face.alongBack[k];
  const double alongBack = forward ? face.alongBack[k] : face.along[k];
  const double leftLength = face.length[forward ? (k + 2) % 3 : (k + 1) % 3];
  const double rightLength = face.length[forward ? (k + 1) % 3 : (k + 2) % 3];
  const Index thirdVertex = face.vertices[(k + 2) % 3];
  const Plane up = face.height[k] * turned(pencil.direction);
  const Plane fromLeft = along * pencil.direction + up;
  const Plane toRight = alongBack * pencil.direction - up;
  const Plane third = pencil.left + fromLeft;

  if (reaches(pencil, third))
  {
    this->lower(thirdVertex, pencilDistance(pencil, third));
  }
  this->reachQueries(pencil, entry.face, (k + 2) % 3, third);

  const Plane thirdRay = pencil.strip ? Plane{ third.x, 0.0 } : third;
  Pencil child = pencil;
  child.face = entry.face;
  if (outside(pencil, third, true) < 0.0 && leftLength > 0.0)
  {
    child.right = third;
    child.rightVertex = thirdVertex;
    child.direction = (1.0 / leftLength) * fromLeft;
    child.rightRay = outside(pencil, third, false) > 0.0 ? pencil.rightRay : thirdRay;
    this->push(child);
  }
  if (outside(pencil, third, false) < 0.0 && rightLength > 0.0)
  {
    child.right = pencil.right;
    child.rightVertex = pencil.rightVertex;
    child.rightRay = pencil.rightRay;
    child.left = third;
    child.leftVertex = thirdVertex;
    child.direction = (1.0 / rightLength) * toRight;
    child.leftRay = outside(pencil, third, true) > 0.0 ? pencil.leftRay : thirdRay;
    this->push(child);
  }
}

//----------------------------------------------------------------------------
void Solver::reachQueries(const Pencil& pencil, Index face, Index third, Plane thirdPoint)
{
  const Triangle& t = this->faces_[face].vertices;
  const Index leftCorner =
    t[(third + 1) % 3] == pencil.leftVertex ? (third + 1) % 3 : (third + 2) % 3;
  const Index rightCorner = 3 - third - leftCorner;
  for (Index query : this->queriesIn_[face])
  {
    const Barycentric& w = this->queryWeights_[query];
    const Plane p = pencil.left + w[rightCorner] * (pencil.right - pencil.left) +
      w[third] * (thirdPoint - pencil.left);
    if (reaches(pencil, p))
    {
      double& best = this->result_.queries[query];
      best = std::min(best, pencilDistance(pencil, p));
    }
  }
}

/// From a source in the face that the query was given in.
void Solver::reachDirectly(Index query)
{
  double& best = this->result_.queries[query];
  for (const DirectSource& source : this->directSources_)
  {
    if (source.face != this->queryFace_[query])
    {
      continue;
    }
    const Barycentric& here = this->queryWeights_[query];
    if (!source.segment)
    {
      best = std::min(best, this->inFaceDistance(source.face, source.from, here));
      continue;
    }
    const Layout corners =
      movedTo(this->layout(source.face, shortestEdge(this->faces_[source.face])), source.from);
    Plane p;
    Plane end;
    for (Index k = 0; k < 3; ++k)
    {
      p = p + here[k] * corners.corner[k];
      end = end + source.to[k] * corners.corner[k];
    }
    if (dot(p, end) >= 0.0 && dot(p, end) <= dot(end, end))
    {
      best = std::min(best, std::abs(cross(p, end)) / size(end));
    }
  }
}

void Solver::finishQueries()
{
  for (Index query = 0; query < this->queryFace_.size(); ++query)
  {
    this->reachDirectly(query);
    const Index face = this->queryFace_[query];
    for (Index k = 0; k < 3; ++k)
    {
      Barycentric corner = { 0.0, 0.0, 0.0 };
      corner[k] = 1.0;
      double& best = this->result_.queries[query];
      best = std::min(best,
        this->bound_[this->faces_[face].vertices[k]] +
          this->inFaceDistance(face, corner, this->queryWeights_[query]));
    }
  }
}

BruteForceResult Solver::solve(const Sources& sources, const std::vector<MeshPoint>& queries)
{
  for (const MeshPoint& query : queries)
  {
    const Index face = this->keptFace_[query.face];
    this->queriesIn_[face].push_back(static_cast<Index>(this->queryFace_.size()));
    this->queryFace_.push_back(face);
    this->queryWeights_.push_back(this->inKeptFace(face, query.face, query.weights));
  }
  this->result_.queries.assign(queries.size(), Infinite);
  for (const MeshPoint& point : sources.points)
  {
    const Index face = this->keptFace_[point.face];
    this->emitPoint(face, this->inKeptFace(face, point.face, point.weights), 0.0);
  }
  for (const MeshSegment& segment : sources.segments)
  {
    const Index face = this->keptFace_[segment.face];
    this->emitSegment(face, this->inKeptFace(face, segment.face, segment.from),
      this->inKeptFace(face, segment.face, segment.to));
  }
  this->relaxEdges();
  this->propagate();
  this->finishQueries();
  this->result_.vertices = this->bound_;
  return this->result_;
}

}

//----------------------------------------------------------------------------
BruteForceResult bruteForceDistances(const PlainMesh& mesh, const Sources& sources,
  const std::vector<MeshPoint>& queries, const BruteForceOptions& options)
{
  return Solver(mesh, options).solve(sources, queries);
}

}
