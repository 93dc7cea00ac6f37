// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/TriangleMesh.h"

#include "Errors.h"
#include "Tolerance.h"

#include <algorithm>
#include <numeric>

namespace geodesic
{

namespace
{

constexpr double Pi = 3.14159265358979323846;

void checkPoints(const std::vector<Vec3>& points)
{
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Vec3& p = points[i];
    if (!isFinite(p))
    {
      throw MeshError("Point " + std::to_string(i) +
        " of the surface has a coordinate that is not finite. Remove or repair the point.");
    }
  }
}

void checkSize(std::size_t numberOfPoints, std::size_t numberOfTriangles)
{
  if (numberOfTriangles == 0)
  {
    throw MeshError("The surface has no faces. Give a surface of triangles.");
  }
  if (numberOfTriangles >= NoId / 3 || numberOfPoints >= NoId)
  {
    throw MeshTooLarge("The surface has " + std::to_string(numberOfTriangles) + " faces and " +
      std::to_string(numberOfPoints) + " points; at most " + std::to_string(NoId / 3 - 1) +
      " faces and " + std::to_string(NoId - 1) + " points can be numbered. Split the surface.");
  }
}

} // anonymous namespace

bool FaceShape::hasZeroArea() const
{
  const double longest = this->longest();
  return this->area2 <= tolerance::ZeroArea * longest * longest;
}

TriangleMesh::TriangleMesh(std::vector<Vec3> points, const std::vector<Triangle>& triangles,
  const ProgressCallback& callback)
  : points_(std::move(points))
{
  checkSize(this->points_.size(), triangles.size());
  checkPoints(this->points_);
  LoopProgress progress(callback);
  progress.nextUntil(0.1);
  this->takeFaces(triangles, progress);
  progress.nextUntil(0.4);
  this->linkSiblings(progress);
  this->dropDuplicateFaces(progress);
  progress.nextUntil(0.6);
  this->linkCorners(progress);
  progress.nextUntil(0.7);
  this->measureFaces(progress);
  progress.nextUntil(1.0);
  this->findPseudoSources(progress);
}

void TriangleMesh::takeFaces(const std::vector<Triangle>& triangles, const LoopProgress& progress)
{
  this->faces_.reserve(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    progress.at(i, triangles.size());
    const Triangle& t = triangles[i];
    if (*std::max_element(t.begin(), t.end()) >= this->numberOfVertices())
    {
      throw MeshError(
        "Face " + std::to_string(i) + " of the surface names a point that does not exist.");
    }
    const bool repeats = t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
    if (repeats && this->inputFaces_.empty())
    {
      this->inputFaces_.resize(this->faces_.size());
      std::iota(this->inputFaces_.begin(), this->inputFaces_.end(), Id(0));
    }
    if (repeats)
    {
      ++this->report_.facesWithRepeatedVertex;
      continue;
    }
    if (this->report_.facesWithRepeatedVertex > 0)
    {
      this->inputFaces_.push_back(static_cast<Id>(i));
    }
    this->faces_.push_back({ t, {}, {} });
  }
  if (this->faces_.empty())
  {
    throw MeshError("Every face of the surface names a point twice, so that no face is left.");
  }
}

// Halfedges are bucketed by their lower vertex, and a bucket sorted by the higher one, so that the
// halfedges of one edge stand together.
void TriangleMesh::linkSiblings(const LoopProgress& progress)
{
  const Id halfedges = this->numberOfHalfedges();
  const auto low = [this](Id s) { return std::min(this->origin(s), this->destination(s)); };
  std::vector<Id> start(this->points_.size() + 1, 0);
  for (Id s = 0; s < halfedges; ++s)
  {
    ++start[low(s) + 1];
  }
  std::partial_sum(start.begin(), start.end(), start.begin());

  struct Entry
  {
    Id high;
    Id halfedge;
    bool operator<(const Entry& other) const
    {
      return this->high != other.high ? this->high < other.high : this->halfedge < other.halfedge;
    }
  };
  std::vector<Entry> entries(halfedges);
  for (Id s = 0; s < halfedges; ++s)
  {
    const Id a = this->origin(s);
    const Id b = this->destination(s);
    entries[start[std::min(a, b)]++] = { std::max(a, b), s };
  }

  const auto next = [this](Id halfedge) -> Id&
  { return this->faces_[halfedge / 3].nextSibling[halfedge % 3]; };
  this->numberOfEdges_ = 0;
  this->report_.nonManifoldEdges = 0;
  std::size_t first = 0;
  for (Id v = 0; v < this->numberOfVertices(); ++v)
  {
    progress.at(v, this->points_.size());
    const std::size_t last = start[v]; // the fill has moved start[v] to the end of v's bucket
    std::sort(entries.begin() + static_cast<std::ptrdiff_t>(first),
      entries.begin() + static_cast<std::ptrdiff_t>(last));
    while (first < last)
    {
      std::size_t end = first + 1;
      while (end < last && entries[end].high == entries[first].high)
      {
        next(entries[end - 1].halfedge) = entries[end].halfedge;
        ++end;
      }
      next(entries[end - 1].halfedge) = entries[first].halfedge;
      ++this->numberOfEdges_;
      this->report_.nonManifoldEdges += end - first > 2 ? 1 : 0;
      first = end;
    }
  }
}

// Faces on the same three vertices share an edge and the vertex opposite it.
void TriangleMesh::dropDuplicateFaces(LoopProgress& progress)
{
  progress.nextUntil(0.45);
  std::vector<std::uint8_t> drop(this->faces_.size(), 0);
  Id dropped = 0;
  for (Id f = 0; f < this->numberOfFaces(); ++f)
  {
    progress.at(f, this->faces_.size());
    const Id s = 3 * f;
    for (Id t = this->nextSibling(s); t != s && !drop[f]; t = this->nextSibling(t))
    {
      const bool duplicate = faceOf(t) < f && this->opposite(t) == this->opposite(s);
      drop[f] = duplicate ? 1 : 0;
    }
    dropped += drop[f];
  }
  if (dropped == 0)
  {
    return;
  }
  std::vector<Face> kept;
  std::vector<Id> inputFaces;
  for (Id f = 0; f < this->numberOfFaces(); ++f)
  {
    if (!drop[f])
    {
      kept.push_back(this->faces_[f]);
      inputFaces.push_back(this->inputFace(f));
    }
  }
  this->faces_ = std::move(kept);
  this->inputFaces_ = std::move(inputFaces);
  this->report_.duplicateFaces = dropped;
  progress.nextUntil(0.55);
  this->linkSiblings(progress);
}

void TriangleMesh::linkCorners(const LoopProgress& progress)
{
  this->cornerStart_.assign(this->points_.size() + 1, 0);
  for (const Face& face : this->faces_)
  {
    for (const Id v : face.corners)
    {
      ++this->cornerStart_[v + 1];
    }
  }
  for (Id v = 0; v < this->numberOfVertices(); ++v)
  {
    this->report_.isolatedVertices += this->cornerStart_[v + 1] == 0 ? 1 : 0;
    this->cornerStart_[v + 1] += this->cornerStart_[v];
  }
  this->corners_.resize(this->numberOfHalfedges());
  std::vector<Id> next(this->cornerStart_.begin(), this->cornerStart_.end() - 1);
  for (Id corner = 0; corner < this->numberOfHalfedges(); ++corner)
  {
    progress.at(corner, this->numberOfHalfedges());
    this->corners_[next[this->origin(corner)]++] = corner;
  }
}

void TriangleMesh::measureFaces(const LoopProgress& progress)
{
  for (Id f = 0; f < this->numberOfFaces(); ++f)
  {
    progress.at(f, this->faces_.size());
    const Triangle& t = this->faces_[f].corners;
    std::array<Vec3, 3> edge;
    FaceShape& shape = this->faces_[f].shape;
    for (std::size_t k = 0; k < 3; ++k)
    {
      edge[k] = this->points_[t[(k + 1) % 3]] - this->points_[t[k]];
      shape.length[k] = norm(edge[k]);
    }
    for (std::size_t k = 0; k < 3; ++k)
    {
      shape.cornerDot[k] = -dot(edge[k], edge[(k + 2) % 3]);
    }
    // Of the three equal cross products the one of the two shorter edges has the least rounding.
    const std::size_t longest = shape.longestEdge();
    shape.area2 = norm(cross(edge[(longest + 1) % 3], edge[(longest + 2) % 3]));
    this->report_.zeroAreaFaces += shape.hasZeroArea() ? 1 : 0;
  }
}

Id TriangleMesh::edgeOf(Id halfedge) const
{
  Id lowest = halfedge;
  for (Id s = this->nextSibling(halfedge); s != halfedge; s = this->nextSibling(s))
  {
    lowest = std::min(lowest, s);
  }
  return lowest;
}

Id TriangleMesh::halfedgeBetween(Id a, Id b) const
{
  for (const Id corner : this->cornersAt(a))
  {
    const Id incoming = previousInFace(corner);
    if (this->destination(corner) == b || this->origin(incoming) == b)
    {
      return this->destination(corner) == b ? corner : incoming;
    }
  }
  return NoId;
}

double TriangleMesh::cornerAngle(Id corner) const
{
  const FaceShape& shape = this->shape(corner / 3);
  return std::atan2(shape.area2, shape.cornerDot[corner % 3]);
}

void TriangleMesh::findPseudoSources(const LoopProgress& progress)
{
  this->pseudoSource_.assign(this->points_.size(), PseudoSource::None);
  for (Id v = 0; v < this->numberOfVertices(); ++v)
  {
    progress.at(v, this->points_.size());
    const IdRange corners = this->cornersAt(v);
    double angle = 0.0;
    std::size_t boundaryEdges = 0;
    bool manifold = true;
    for (const Id corner : corners)
    {
      angle += this->cornerAngle(corner);
      for (const Id halfedge : { corner, previousInFace(corner) })
      {
        const Id other = this->nextSibling(halfedge);
        boundaryEdges += other == halfedge ? 1 : 0;
        manifold = manifold && this->nextSibling(other) == halfedge;
      }
    }
    const double straight = boundaryEdges == 0 ? 2.0 * Pi : Pi;
    const bool bends = angle > straight * (1.0 + tolerance::FlatAngle);
    const bool several = !manifold || boundaryEdges > 2 || !this->isOneFan(v);
    this->pseudoSource_[v] = corners.size() == 0 ? PseudoSource::None
      : several                                  ? PseudoSource::Irregular
      : bends                                    ? PseudoSource::Saddle
                                                 : PseudoSource::None;
  }
}

// Walks from corner to corner across the edges at the vertex; every corner is met where there is
// one fan. Only called where these edges have one or two halfedges.
bool TriangleMesh::isOneFan(Id vertex) const
{
  const IdRange corners = this->cornersAt(vertex);
  if (corners.size() == 0)
  {
    return true;
  }
  // Begin at a boundary edge where there is one, so that one walk meets the whole fan.
  Id entered = *corners.begin();
  for (const Id corner : corners)
  {
    for (const Id s : { corner, previousInFace(corner) })
    {
      entered = this->isBoundary(s) ? s : entered;
    }
  }
  const Id first = entered;
  std::size_t met = 0;
  do
  {
    ++met;
    const Id across =
      this->origin(entered) == vertex ? previousInFace(entered) : nextInFace(entered);
    entered = this->nextSibling(across);
    if (entered == across)
    {
      break;
    }
  } while (entered != first && met <= corners.size());
  return met == corners.size();
}

std::vector<Id> TriangleMesh::components() const
{
  std::vector<Id> component(this->points_.size(), NoId);
  std::vector<Id> stack;
  Id count = 0;
  for (Id seed = 0; seed < this->numberOfVertices(); ++seed)
  {
    if (component[seed] != NoId)
    {
      continue;
    }
    component[seed] = count;
    stack.push_back(seed);
    while (!stack.empty())
    {
      const Id v = stack.back();
      stack.pop_back();
      for (const Id corner : this->cornersAt(v))
      {
        for (const Id w : this->triangle(corner / 3))
        {
          if (component[w] == NoId)
          {
            component[w] = count;
            stack.push_back(w);
          }
        }
      }
    }
    ++count;
  }
  return component;
}

}
