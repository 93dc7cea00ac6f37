// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/RedGreenMesh.h"

#include "Tolerance.h"
#include "mesh/HalfedgeFrame.h"

#include <algorithm>
#include <map>
#include <utility>

namespace geodesic
{

RedGreenMesh::RedGreenMesh(
  const MeshPartition& surface, std::vector<std::uint8_t> frozen, std::unordered_map<Id, Id> beside)
  : mesh_(surface.mesh())
  , faces_(mesh_.numberOfFaces())
  , firstFace_(surface.firstOwnFace())
  , endOfFaces_(surface.endOfOwnFaces())
  , frozen_(std::move(frozen))
  , beside_(std::move(beside))
  , redOfFace_(mesh_.numberOfFaces(), NoId)
  , numberOfTriangles_(endOfFaces_ - firstFace_)
{
}

SurfacePoint RedGreenMesh::place(Id point) const
{
  const Id inputPoints = this->numberOfInputPoints();
  return point < inputPoints ? SurfacePoint::atVertex(point)
                             : this->points_[point - inputPoints].place;
}

Vec2 RedGreenMesh::inPlane(Id point, Id face) const
{
  return inHalfedgeFrame(this->mesh_, longestHalfedge(this->mesh_, face),
    barycentric(this->mesh_, this->place(point), face));
}

std::array<Vec2, 3> RedGreenMesh::inPlane(const Triangle& corners, Id face) const
{
  return { this->inPlane(corners[0], face), this->inPlane(corners[1], face),
    this->inPlane(corners[2], face) };
}

std::vector<Vec2> RedGreenMesh::inPlane(const Closing& closing, Id face) const
{
  std::vector<Vec2> places;
  places.reserve(closing.points.size());
  for (const Id point : closing.points)
  {
    places.push_back(this->inPlane(point, face));
  }
  return places;
}

namespace
{

double squaredNorm(Vec2 v)
{
  return dot(v, v);
}

std::array<double, 3> squaredSides(const std::array<Vec2, 3>& corners)
{
  return { squaredNorm(corners[1] - corners[0]), squaredNorm(corners[2] - corners[1]),
    squaredNorm(corners[0] - corners[2]) };
}

Id longestSide(const std::array<Vec2, 3>& corners)
{
  const std::array<double, 3> sides = squaredSides(corners);
  return static_cast<Id>(std::max_element(sides.begin(), sides.end()) - sides.begin());
}

Id shortestSide(const std::array<Vec2, 3>& corners)
{
  const std::array<double, 3> sides = squaredSides(corners);
  return static_cast<Id>(std::min_element(sides.begin(), sides.end()) - sides.begin());
}

// The height over the longest side, as a fraction of that side.
double heightOfLength(const std::array<Vec2, 3>& corners)
{
  const Id k = longestSide(corners);
  const Vec2 side = corners[(k + 1) % 3] - corners[k];
  return cross(side, corners[(k + 2) % 3] - corners[k]) / squaredNorm(side);
}

// A triangle is thin if its height over the longest side is under this fraction of that side.
constexpr double ThinHeight = 0.25;

// Triangles without area, with which CAD exports close T-vertices, are not: on one line the sides
// of a strip's triangles may be as long as theirs, so that splitting would not end.
bool areThin(const std::array<Vec2, 3>& corners)
{
  const double height = heightOfLength(corners);
  return height < ThinHeight && height > tolerance::PlaceRounding;
}

} // anonymous namespace

Id RedGreenMesh::ensureEdge(Id triangle, Id k)
{
  const Id existing = this->existingEdge(triangle, k);
  if (existing != NoId)
  {
    return existing;
  }
  const Id halfedge = this->mesh_.edgeOf(TriangleMesh::halfedgeOf(triangle, k));
  const Id edge = this->addEdge(this->mesh_.origin(halfedge), this->mesh_.destination(halfedge),
    NoId, halfedge, TriangleMesh::faceOf(halfedge));
  Id around = halfedge;
  do
  {
    const Id face = TriangleMesh::faceOf(around);
    if (this->isWhole(face))
    {
      this->redOfFace_[face] = static_cast<Id>(this->redFaces_.size());
      const Triangle& corners = this->mesh_.triangle(face);
      this->redFaces_.push_back({ face, corners });
      this->redFaces_.back().isThin = areThin(this->inPlane(corners, face));
    }
    this->red(face).edges[TriangleMesh::indexInFace(around)] = edge;
    around = this->mesh_.nextSibling(around);
  } while (around != halfedge);
  return edge;
}

Id RedGreenMesh::addEdge(Id a, Id b, Id parent, Id halfedge, Id face)
{
  this->edges_.push_back({ { a, b }, NoId, NoId, parent, halfedge, face });
  return static_cast<Id>(this->edges_.size() - 1);
}

bool RedGreenMesh::isThin(Id triangle) const
{
  const Red* red = this->find(triangle);
  return red ? red->isThin : areThin(this->inPlane(this->corners(triangle), triangle));
}

bool RedGreenMesh::hasArea(Id triangle) const
{
  return heightOfLength(this->inPlane(this->corners(triangle), this->faceOf(triangle))) >
    tolerance::PlaceRounding;
}

bool RedGreenMesh::isAnyAsShortAsWide(Id triangle, const std::vector<Id>& edges) const
{
  const Closing closing = this->closing(triangle, this->wayOf(triangle));
  const std::vector<Vec2> places = this->inPlane(closing, this->faceOf(triangle));
  return std::any_of(closing.triangles.begin(), closing.triangles.end(),
    [&](const std::array<Id, 3>& t)
    {
      const std::array<Vec2, 3> corners = { places[t[0]], places[t[1]], places[t[2]] };
      const Id shortest = shortestSide(corners);
      for (Id k = 0; k < 3; ++k)
      {
        const Id edge = closing.edgeBetween(t[k], t[(k + 1) % 3]);
        if (edge != NoId && std::find(edges.begin(), edges.end(), edge) != edges.end() &&
          (k == shortest || !areThin(corners)))
        {
          return true;
        }
      }
      return false;
    });
}

Id RedGreenMesh::longestEdge(Id triangle) const
{
  return longestSide(this->inPlane(this->corners(triangle), this->faceOf(triangle)));
}

double RedGreenMesh::height(Id triangle) const
{
  const std::array<Vec2, 3> p = this->inPlane(this->corners(triangle), this->faceOf(triangle));
  const Id k = longestSide(p);
  const Vec2 side = p[(k + 1) % 3] - p[k];
  return cross(side, p[(k + 2) % 3] - p[k]) / norm(side);
}

double RedGreenMesh::lengthOf(Id edge) const
{
  const Edge& e = this->edges_[edge];
  return norm(this->inPlane(e.ends[1], e.face) - this->inPlane(e.ends[0], e.face));
}

Id RedGreenMesh::pointsOnEdges(Id triangle) const
{
  Id count = 0;
  for (Id k = 0; k < 3; ++k)
  {
    this->forEachPartOf(
      this->existingEdge(triangle, k), [&](Id edge) { count += this->isSplit(edge) ? 1 : 0; });
  }
  return count;
}

Id RedGreenMesh::splitEdges(Id triangle) const
{
  Id count = 0;
  for (Id k = 0; k < 3; ++k)
  {
    count += this->isSplit(this->existingEdge(triangle, k)) ? 1 : 0;
  }
  return count;
}

namespace
{

/// The triangles of a polygon that begins at the corner before the split edges: with no split edge,
/// with one, with two in either way, and with three in the first way and in the other ways, which
/// differ by the polygon's first corner.
constexpr std::array<std::array<std::array<Id, 3>, 4>, 6> TrianglesOfPolygon = { {
  { { { 0, 1, 2 } } },
  { { { 0, 1, 3 }, { 1, 2, 3 } } },
  { { { 1, 2, 3 }, { 0, 1, 3 }, { 0, 3, 4 } } },
  { { { 1, 2, 3 }, { 0, 1, 4 }, { 1, 3, 4 } } },
  { { { 0, 1, 5 }, { 1, 2, 3 }, { 5, 3, 4 }, { 1, 3, 5 } } },
  { { { 0, 1, 3 }, { 0, 3, 5 }, { 1, 2, 3 }, { 5, 3, 4 } } },
} };

} // anonymous namespace

Id RedGreenMesh::waysToClose(Id triangle) const
{
  const Id splits = this->splitEdges(triangle);
  return splits < 2 || this->isSplitTwice(triangle) ? 1 : 2 * splits - 2;
}

RedGreenMesh::Closing RedGreenMesh::closing(Id triangle, Id way) const
{
  const Triangle c = this->corners(triangle);
  const Id face = this->faceOf(triangle);
  const Id splits = this->splitEdges(triangle);
  const bool isStrip = this->isSplitTwice(triangle);
  Id begin = splits == 3 ? (way + 2) % 3 : 0;
  if (isStrip)
  {
    begin = this->longestEdge(triangle);
  }
  while (splits > 0 && splits < 3 && !isStrip &&
    !(this->isSplit(this->existingEdge(triangle, begin)) &&
      (splits == 1 || this->isSplit(this->existingEdge(triangle, (begin + 1) % 3)))))
  {
    ++begin;
  }
  Closing closing;
  const Id corners = 3 + this->pointsOnEdges(triangle);
  closing.points.reserve(corners);
  closing.edges.reserve(corners);
  closing.triangles.reserve(corners - 2);
  for (Id i = 0; i < 3; ++i)
  {
    const Id k = (begin + i) % 3;
    this->addAlong(closing, c[k], this->existingEdge(triangle, k));
  }
  if (isStrip)
  {
    this->closeStrip(closing, face, { c[begin], c[(begin + 1) % 3], c[(begin + 2) % 3] });
    return closing;
  }
  const auto& triangles = TrianglesOfPolygon[splits < 2 ? splits : 2 * splits - (way == 0 ? 2 : 1)];
  closing.triangles.assign(triangles.begin(), triangles.begin() + 1 + splits);
  return closing;
}

// Appends the points from one end of an edge to before the other end.
void RedGreenMesh::addAlong(Closing& closing, Id begin, Id edge) const
{
  if (!this->isSplit(edge))
  {
    closing.points.push_back(begin);
    closing.edges.push_back(edge);
    return;
  }
  const Edge& e = this->edges_[edge];
  const Id end = e.ends[0] == begin ? e.ends[1] : e.ends[0];
  this->addAlong(closing, begin, this->halfAt(edge, begin));
  this->addAlong(closing, e.split, this->halfAt(edge, end));
}

SurfacePoint RedGreenMesh::between(const Edge& edge, double weight) const
{
  const auto mean = [weight](double a, double b) { return a + weight * (b - a); };
  const SurfacePoint a = this->place(edge.ends[0]);
  const SurfacePoint b = this->place(edge.ends[1]);
  if (edge.halfedge != NoId)
  {
    const double from = a.kind == SurfacePoint::Kind::Edge ? a.u : 0.0;
    const double to = b.kind == SurfacePoint::Kind::Edge ? b.u : 1.0;
    return SurfacePoint::onEdge(edge.halfedge, mean(from, to));
  }
  const std::array<double, 3> from = barycentric(this->mesh_, a, edge.face);
  const std::array<double, 3> to = barycentric(this->mesh_, b, edge.face);
  return SurfacePoint::inFace(edge.face, mean(from[1], to[1]), mean(from[2], to[2]));
}

namespace
{

/// The strip of triangles between the two chains of points from one end of a polygon's longest side
/// to the other.
class Strip
{
public:
  /// \param places of the polygon's points, which begin with the longest side.
  /// \param sideEnd the number of the point where the longest side ends.
  /// \param apex the number of the third corner.
  Strip(const std::vector<Vec2>& places, Id sideEnd, Id apex)
    : places_(places)
    , size_(static_cast<Id>(places.size()))
    , sideEnd_(sideEnd)
    , apex_(apex)
    , longest_(norm(places[sideEnd] - places[0]))
  {
  }

  /// Calls emit(triangle) with numbers of the polygon's points.
  template <typename Emit>
  void close(const Emit& emit)
  {
    Id a = 0;               // along the longest side
    Id b = this->size_ - 1; // along the other sides, backwards
    while (b > a + 1)
    {
      if (this->takesA(a, b))
      {
        emit({ a, a + 1, b });
        ++a;
      }
      else
      {
        emit({ a, b - 1, b });
        --b;
      }
    }
  }

private:
  // Three points of one straight side are no triangle.
  bool takesA(Id a, Id b) const
  {
    if (b - 1 == this->sideEnd_)
    {
      return true;
    }
    if (a == this->sideEnd_)
    {
      return false;
    }
    if (a == 0 && b > this->apex_)
    {
      return true;
    }
    if (a + 1 == this->sideEnd_ && this->apex_ != this->sideEnd_ + 1)
    {
      return false;
    }
    return this->isBetter(a + 1, b - 1, a, b);
  }

  // Whether a triangle on the last side, from a to b, has a better third point than another one.
  // The larger angle there gives Delaunay's triangles, whose smallest angle is the largest. In a
  // face without area rounding makes the angles: there the shorter diagonal is better.
  bool isBetter(Id point, Id other, Id a, Id b) const
  {
    const Corner corner = this->cornerAt(point, a, b);
    const Corner otherCorner = this->cornerAt(other, a, b);
    if (corner.isFlat || otherCorner.isFlat)
    {
      return squaredNorm(this->places_[point] - this->places_[b]) <=
        squaredNorm(this->places_[other] - this->places_[a]);
    }
    return corner.cotangent <= otherCorner.cotangent;
  }

  struct Corner
  {
    double cotangent;
    bool isFlat;
  };
  Corner cornerAt(Id point, Id a, Id b) const
  {
    const Vec2 toA = this->places_[a] - this->places_[point];
    const Vec2 toB = this->places_[b] - this->places_[point];
    const double sine = std::abs(cross(toA, toB));
    const double rounding = tolerance::PlaceRounding * this->longest_;
    return { dot(toA, toB) / sine, sine <= rounding * (norm(toA) + norm(toB)) };
  }

  const std::vector<Vec2>& places_;
  Id size_;
  Id sideEnd_;
  Id apex_;
  double longest_;
};

} // anonymous namespace

void RedGreenMesh::closeStrip(Closing& closing, Id face, const Triangle& corners) const
{
  const auto numberOf = [&closing](Id point)
  {
    return static_cast<Id>(
      std::find(closing.points.begin(), closing.points.end(), point) - closing.points.begin());
  };
  const std::vector<Vec2> places = this->inPlane(closing, face);
  Strip(places, numberOf(corners[1]), numberOf(corners[2]))
    .close([&closing](const std::array<Id, 3>& t) { closing.triangles.push_back(t); });
}

void RedGreenMesh::split(Id id, const Placement& placement)
{
  const Edge edge = this->edges_[id];
  const Id middle = this->numberOfInputPoints() + static_cast<Id>(this->points_.size());
  this->points_.push_back(
    { edge.ends, placement.weight, this->between(edge, placement.weight), placement.distance });
  const Id first = this->addEdge(edge.ends[0], middle, id, edge.halfedge, edge.face);
  this->addEdge(middle, edge.ends[1], id, edge.halfedge, edge.face);
  this->edges_[id].split = middle;
  this->edges_[id].halves = first;

  const auto beside = this->beside_.find(edge.halfedge); // NoId has no entry
  this->numberOfTriangles_ += beside == this->beside_.end() ? 0 : beside->second;
  this->forEachFaceAt(edge,
    [this](Id face)
    {
      const bool isOutput = face >= this->firstFace_ && face < this->endOfFaces_;
      this->numberOfTriangles_ += isOutput && this->isFrozen(face) ? 1 : 0;
    });
  this->forEachLeafAround(id,
    [this](Id triangle)
    {
      ++this->numberOfTriangles_;
      this->touched_.push_back(triangle);
    });
}

Id RedGreenMesh::halfAt(Id edge, Id end) const
{
  const Edge& e = this->edges_[edge];
  return e.ends[0] == end ? e.halves : e.halves + 1;
}

Id RedGreenMesh::addPart(Id face, const Triangle& corners, const std::array<Id, 3>& edges)
{
  const Id index = static_cast<Id>(this->parts_.size());
  Red part{ face, corners, edges };
  for (Id k = 0; k < 3; ++k)
  {
    Edge& edge = this->edges_[edges[k]];
    part.nextCorner[k] = edge.firstCorner;
    edge.firstCorner = 3 * index + k;
  }
  this->parts_.push_back(part);
  const Id triangle = this->faces_ + index;
  this->touched_.push_back(triangle);
  this->numberOfTriangles_ += 1 + this->pointsOnEdges(triangle);
  return index;
}

void RedGreenMesh::splitIntoFour(Id triangle)
{
  const Triangle c = this->corners(triangle);
  const Id face = this->faceOf(triangle);
  std::array<Id, 3> e;
  std::array<Id, 3> m;
  for (Id k = 0; k < 3; ++k)
  {
    e[k] = this->existingEdge(triangle, k);
    m[k] = this->edges_[e[k]].split;
  }
  std::array<Id, 3> inner; // opposite the part at corner k
  for (std::size_t k = 0; k < 3; ++k)
  {
    inner[k] = this->addEdge(m[(k + 2) % 3], m[k], NoId, NoId, face);
  }
  this->numberOfTriangles_ -= 1 + this->pointsOnEdges(triangle);
  const Id first = this->addPart(
    face, { c[0], m[0], m[2] }, { this->halfAt(e[0], c[0]), inner[0], this->halfAt(e[2], c[0]) });
  this->addPart(
    face, { m[0], c[1], m[1] }, { this->halfAt(e[0], c[1]), this->halfAt(e[1], c[1]), inner[1] });
  this->addPart(
    face, { m[2], m[1], c[2] }, { inner[2], this->halfAt(e[1], c[2]), this->halfAt(e[2], c[2]) });
  this->addPart(face, { m[0], m[1], m[2] }, { inner[1], inner[2], inner[0] });
  this->red(triangle).parts = first;
  this->red(triangle).numberOfParts = 4;
}

void RedGreenMesh::divide(Id triangle)
{
  const Id face = this->faceOf(triangle);
  const Closing closing = this->closing(triangle, this->wayOf(triangle));
  const Id first = static_cast<Id>(this->parts_.size());
  this->numberOfTriangles_ -= 1 + this->pointsOnEdges(triangle);
  std::map<std::pair<Id, Id>, Id> across;
  for (const std::array<Id, 3>& t : closing.triangles)
  {
    std::array<Id, 3> edges;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Id end = t[(k + 1) % 3];
      edges[k] = closing.edgeBetween(t[k], end);
      if (edges[k] == NoId)
      {
        const auto [found, isNew] = across.emplace(std::minmax(t[k], end), this->numberOfEdges());
        edges[k] = found->second;
        if (isNew)
        {
          this->addEdge(closing.points[t[k]], closing.points[end], NoId, NoId, face);
        }
      }
    }
    const Triangle corners = { closing.points[t[0]], closing.points[t[1]], closing.points[t[2]] };
    const Id part = this->addPart(face, corners, edges);
    this->parts_[part].isThin = areThin(this->inPlane(corners, face));
  }
  this->red(triangle).parts = first;
  this->red(triangle).numberOfParts = static_cast<Id>(closing.triangles.size());
}

bool RedGreenMesh::isSplitTwice(Id triangle) const
{
  for (Id k = 0; k < 3; ++k)
  {
    const Id edge = this->existingEdge(triangle, k);
    const Id halves = edge == NoId ? NoId : this->edges_[edge].halves;
    if (halves != NoId && (this->isSplit(halves) || this->isSplit(halves + 1)))
    {
      return true;
    }
  }
  return false;
}

Id RedGreenMesh::takeTouched()
{
  if (this->touched_.empty())
  {
    return NoId;
  }
  const Id triangle = this->touched_.back();
  this->touched_.pop_back();
  return triangle;
}

void RedGreenMesh::begin()
{
  this->pointsBefore_ = this->points_.size();
  this->edgesBefore_ = this->numberOfEdges();
  this->partsBefore_ = static_cast<Id>(this->parts_.size());
  this->trianglesBefore_ = this->numberOfTriangles_;
}

void RedGreenMesh::rollBack()
{
  this->edges_.resize(this->edgesBefore_);
  for (Edge& edge : this->edges_)
  {
    if (edge.halves >= this->edgesBefore_)
    {
      edge.split = NoId;
      edge.halves = NoId;
    }
    while (edge.firstCorner != NoId && edge.firstCorner / 3 >= this->partsBefore_)
    {
      edge.firstCorner = this->parts_[edge.firstCorner / 3].nextCorner[edge.firstCorner % 3];
    }
  }
  this->points_.resize(this->pointsBefore_);
  this->parts_.resize(this->partsBefore_);
  for (std::vector<Red>* triangles : { &this->parts_, &this->redFaces_ })
  {
    for (Red& red : *triangles)
    {
      const auto forget = [](Id& id, Id before) { id = id < before ? id : NoId; };
      forget(red.parts, this->partsBefore_);
      std::for_each(
        red.edges.begin(), red.edges.end(), [&](Id& edge) { forget(edge, this->edgesBefore_); });
    }
  }
  this->numberOfTriangles_ = this->trianglesBefore_;
  this->touched_.clear();
}

}
