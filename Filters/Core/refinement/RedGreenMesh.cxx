// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/RedGreenMesh.h"

#include "mesh/HalfedgeFrame.h"

#include <algorithm>

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
      this->redFaces_.push_back({ face, this->mesh_.triangle(face) });
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

RedGreenMesh::Closing RedGreenMesh::closing(Id triangle, Id way) const
{
  const Id splits = this->splitEdges(triangle);
  Id begin = splits == 3 ? (way + 2) % 3 : 0;
  while (splits > 0 && splits < 3 &&
    !(this->isSplit(this->existingEdge(triangle, begin)) &&
      (splits == 1 || this->isSplit(this->existingEdge(triangle, (begin + 1) % 3)))))
  {
    ++begin;
  }
  Closing closing;
  closing.count = 1 + splits;
  closing.triangles = TrianglesOfPolygon[splits < 2 ? splits : 2 * splits - (way == 0 ? 2 : 1)];
  const auto add = [&closing](Id point, Id edge)
  {
    closing.points[closing.size] = point;
    closing.edges[closing.size] = edge;
    ++closing.size;
  };
  const Triangle c = this->corners(triangle);
  for (Id i = 0; i < 3; ++i)
  {
    const Id k = (begin + i) % 3;
    const Id edge = this->existingEdge(triangle, k);
    add(c[k], this->isSplit(edge) ? this->halfAt(edge, c[k]) : edge);
    if (this->isSplit(edge))
    {
      add(this->edges_[edge].split, this->halfAt(edge, c[(k + 1) % 3]));
    }
  }
  return closing;
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
  this->forEachLeafAt(id,
    [this](Id triangle)
    {
      ++this->numberOfTriangles_;
      this->touched_.push_back(triangle);
    });
  if (edge.parent != NoId)
  {
    this->forEachLeafAt(edge.parent, [this](Id triangle) { this->touched_.push_back(triangle); });
  }
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
  this->numberOfTriangles_ += 1 + this->splitEdges(triangle);
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
  this->numberOfTriangles_ -= 4;
  const Id first = this->addPart(
    face, { c[0], m[0], m[2] }, { this->halfAt(e[0], c[0]), inner[0], this->halfAt(e[2], c[0]) });
  this->addPart(
    face, { m[0], c[1], m[1] }, { this->halfAt(e[0], c[1]), this->halfAt(e[1], c[1]), inner[1] });
  this->addPart(
    face, { m[2], m[1], c[2] }, { inner[2], this->halfAt(e[1], c[2]), this->halfAt(e[2], c[2]) });
  this->addPart(face, { m[0], m[1], m[2] }, { inner[1], inner[2], inner[0] });
  this->red(triangle).parts = first;
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
