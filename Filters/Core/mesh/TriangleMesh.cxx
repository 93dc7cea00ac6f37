// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/TriangleMesh.h"

#include "Errors.h"
#include "Tolerance.h"
#include "Trigonometry.h"
#include "mesh/GroupedItems.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace geodesic
{

namespace
{

void checkSize(std::size_t numberOfPoints, std::size_t numberOfTriangles)
{
  if (numberOfTriangles == 0)
  {
    throw MeshError("The surface has no faces. Give a surface of triangles.");
  }
  if (numberOfTriangles >= NoId / 3 || numberOfPoints > MaximumVertices)
  {
    throw MeshTooLarge("The surface has " + std::to_string(numberOfTriangles) + " faces and " +
      std::to_string(numberOfPoints) + " points; at most " + std::to_string(NoId / 3 - 1) +
      " faces and " + std::to_string(MaximumVertices) +
      " points can be numbered. Split the surface.");
  }
}

// Faces on the same three vertices share an edge and the vertex opposite it.
bool isDuplicate(const TriangleMesh& mesh, Id face)
{
  const Id s = TriangleMesh::halfedgeOf(face, 0);
  for (Id t = mesh.nextSibling(s); t != s; t = mesh.nextSibling(t))
  {
    if (TriangleMesh::faceOf(t) < face && mesh.opposite(t) == mesh.opposite(s))
    {
      return true;
    }
  }
  return false;
}

// A cap conducts along its edges, which lie on one line. A height far below the shorter ones gives
// the face an inside and changes its lengths by less than rounding.
void raiseCap(FaceShape& shape)
{
  const std::size_t longest = shape.longestEdge();
  const std::size_t next = (longest + 1) % 3;
  const std::size_t apex = (longest + 2) % 3;
  const std::array<double, 3>& length = shape.length;
  if (!(shape.cornerDot[apex] < 0.0))
  {
    return;
  }
  shape.area2 = tolerance::RaisedHeight * length[longest] * shape.shortest();
  shape.cornerDot[longest] = length[longest] * length[apex];
  shape.cornerDot[next] = length[longest] * length[next];
  shape.cornerDot[apex] = -length[next] * length[apex];
}

FaceShape measure(const TriangleMesh& mesh, Id face)
{
  const Triangle& t = mesh.triangle(face);
  const std::array<Vec3, 3> corners = { mesh.point(t[0]), mesh.point(t[1]), mesh.point(t[2]) };
  FaceShape shape = shapeOf(corners);
  if (isWithoutArea(shape, corners))
  {
    raiseCap(shape);
  }
  return shape;
}

// Walks from corner to corner across the edges at the vertex; if there is one fan, the walk reaches
// every corner. Requires that these edges have one or two halfedges.
//
// \param first that the walk enters across: on the boundary if one of the edges is, so that it
//        covers the whole fan.
bool isOneFan(const TriangleMesh& mesh, Id vertex, Id first)
{
  const std::size_t corners = mesh.cornersAt(vertex).size();
  Id entered = first;
  std::size_t met = 0;
  do
  {
    ++met;
    const Id across = EnteredCorner(mesh, vertex, entered).onward;
    entered = mesh.nextSibling(across);
    if (entered == across)
    {
      break;
    }
  } while (entered != first && met <= corners);
  return met == corners;
}

TriangleMesh::PseudoSource findPseudoSource(const TriangleMesh& mesh, Id vertex)
{
  const IdRange corners = mesh.cornersAt(vertex);
  if (corners.size() == 0)
  {
    return TriangleMesh::PseudoSource::None;
  }
  double angle = 0.0;
  Id first = *corners.begin();
  std::size_t boundaryEdges = 0;
  bool manifold = true;
  bool isBesideAnother = false;
  for (const Id corner : corners)
  {
    angle += mesh.cornerAngle(corner);
    const double longest = mesh.shape(TriangleMesh::faceOf(corner)).longest();
    for (const Id halfedge : { corner, TriangleMesh::previousInFace(corner) })
    {
      isBesideAnother = isBesideAnother || mesh.length(halfedge) < tolerance::ShortEdge * longest;
      const Id other = mesh.nextSibling(halfedge);
      boundaryEdges += other == halfedge ? 1 : 0;
      first = other == halfedge ? halfedge : first;
      manifold = manifold && mesh.nextSibling(other) == halfedge;
    }
  }
  if (!manifold || boundaryEdges > 2 || isBesideAnother || !isOneFan(mesh, vertex, first))
  {
    return TriangleMesh::PseudoSource::Irregular;
  }
  const double straight = boundaryEdges == 0 ? FullAngle : Pi;
  const bool bends = angle > straight * (1.0 + tolerance::FlatAngle);
  return bends ? TriangleMesh::PseudoSource::Saddle : TriangleMesh::PseudoSource::None;
}

} // anonymous namespace

/// Builds a mesh in stages. In each stage, one task alone writes the results for a face or a
/// vertex, so the result does not depend on which thread runs it.
class TriangleMesh::Builder
{
public:
  Builder(TriangleMesh& mesh, const Job& job)
    : mesh_(mesh)
    , job_(job)
  {
  }

  void run(const std::vector<Triangle>& triangles)
  {
    checkSize(this->mesh_.points_.size(), triangles.size());
    this->checkPoints(this->job_.part(0.0, 0.05));
    this->takeFaces(triangles, this->job_.part(0.05, 0.1));
    this->linkSiblings(this->job_.part(0.1, 0.4));
    this->dropFaces(this->job_.part(0.4, 0.55));
    this->linkCorners(this->job_.part(0.55, 0.6));
    TriangleMesh& mesh = this->mesh_;
    this->job_.part(0.6, 0.7).loop(mesh.numberOfFaces(),
      [&mesh](std::size_t face)
      { mesh.faces_[face].shape = measure(mesh, static_cast<Id>(face)); });
    mesh.pseudoSource_.resize(mesh.points_.size());
    this->job_.part(0.7, 1.0).loop(mesh.numberOfVertices(),
      [&mesh](std::size_t vertex)
      { mesh.pseudoSource_[vertex] = findPseudoSource(mesh, static_cast<Id>(vertex)); });
  }

private:
  /// The higher one of a halfedge's vertices, and the halfedge.
  using ByHigh = std::pair<Id, Id>;

  void checkPoints(const Job& job) const
  {
    const std::vector<Vec3>& points = this->mesh_.points_;
    const std::size_t wrong =
      firstWrong(job, points.size(), [&](std::size_t i) { return !isFinite(points[i]); });
    if (wrong < points.size())
    {
      throw MeshError("Point " + std::to_string(wrong) +
        " of the surface has a coordinate that is not finite. Remove or repair the point.");
    }
  }

  void takeFaces(const std::vector<Triangle>& triangles, const Job& job)
  {
    this->mesh_.faces_.resize(triangles.size());
    const std::size_t wrong = firstWrong(job, triangles.size(),
      [&](std::size_t i)
      {
        const Triangle& t = triangles[i];
        this->mesh_.faces_[i].corners = t;
        return *std::max_element(t.begin(), t.end()) >= this->mesh_.numberOfVertices();
      });
    if (wrong < triangles.size())
    {
      throw MeshError(
        "Face " + std::to_string(wrong) + " of the surface names a point that does not exist.");
    }
  }

  // The halfedges of one edge have the same lower vertex.
  void linkSiblings(const Job& job)
  {
    const TriangleMesh& mesh = this->mesh_;
    const GroupedItems byLow = groupItems(mesh.numberOfHalfedges(), mesh.numberOfVertices(),
      job.part(0.0, 0.5), [&mesh](Id s) { return std::min(mesh.origin(s), mesh.destination(s)); });
    const std::vector<Id> nonManifold = job.part(0.5, 1.0).resultsOfRanges(mesh.numberOfVertices(),
      [&](std::size_t begin, std::size_t end)
      {
        Id count = 0;
        std::vector<ByHigh> byHigh;
        for (std::size_t vertex = begin; vertex < end; ++vertex)
        {
          count += this->linkSiblings(byLow.at(static_cast<Id>(vertex)), byHigh);
        }
        return count;
      });
    this->mesh_.numberOfNonManifoldEdges_ =
      std::accumulate(nonManifold.begin(), nonManifold.end(), Id(0));
  }

  // Among halfedges with the same lower vertex, those with the same higher vertex are siblings.
  //
  // \returns the number of edges of three and more.
  Id linkSiblings(const IdRange& halfedges, std::vector<ByHigh>& byHigh)
  {
    Id nonManifold = 0;
    byHigh.clear();
    for (const Id s : halfedges)
    {
      byHigh.emplace_back(std::max(this->mesh_.origin(s), this->mesh_.destination(s)), s);
    }
    std::sort(byHigh.begin(), byHigh.end());
    const auto next = [&](std::size_t i) -> Id&
    {
      const Id s = byHigh[i].second;
      return this->mesh_.faces_[TriangleMesh::faceOf(s)].nextSibling[TriangleMesh::indexInFace(s)];
    };
    for (std::size_t first = 0; first < byHigh.size();)
    {
      std::size_t end = first + 1;
      while (end < byHigh.size() && byHigh[end].first == byHigh[first].first)
      {
        next(end - 1) = byHigh[end].second;
        ++end;
      }
      next(end - 1) = byHigh[first].second;
      nonManifold += end - first > 2 ? 1 : 0;
      first = end;
    }
    return nonManifold;
  }

  // Drops faces that name a vertex twice, and duplicates. Hardly any mesh has such faces, so that
  // siblings are linked with them first, and then again without them.
  void dropFaces(const Job& job)
  {
    TriangleMesh& mesh = this->mesh_;
    std::vector<std::uint8_t> drop(mesh.faces_.size(), 0);
    job.part(0.0, 0.3).loop(mesh.numberOfFaces(),
      [&](std::size_t i)
      {
        const Id face = static_cast<Id>(i);
        drop[face] = !hasThreeVertices(mesh.triangle(face)) || isDuplicate(mesh, face) ? 1 : 0;
      });
    if (std::find(drop.begin(), drop.end(), 1) == drop.end())
    {
      return;
    }
    for (Id face = 0; face < mesh.numberOfFaces(); ++face)
    {
      if (!drop[face])
      {
        mesh.faces_[mesh.inputFaces_.size()] = mesh.faces_[face];
        mesh.inputFaces_.push_back(face);
      }
    }
    if (mesh.inputFaces_.empty())
    {
      throw MeshError("Every face of the surface names a point twice, so that no face is left.");
    }
    mesh.faces_.resize(mesh.inputFaces_.size());
    mesh.faces_.shrink_to_fit();
    this->linkSiblings(job.part(0.3, 1.0));
  }

  void linkCorners(const Job& job)
  {
    TriangleMesh& mesh = this->mesh_;
    GroupedItems corners = groupItems(mesh.numberOfHalfedges(), mesh.numberOfVertices(), job,
      [&mesh](Id corner) { return mesh.origin(corner); });
    mesh.cornerStart_ = std::move(corners.start);
    mesh.corners_ = std::move(corners.items);
  }

  /// The first of some items for which isWrong(item) holds, after visiting all in parallel; the
  /// count if there is none.
  template <typename IsWrong>
  static std::size_t firstWrong(const Job& job, std::size_t count, const IsWrong& isWrong)
  {
    const std::vector<std::size_t> wrong = job.resultsOfRanges(count,
      [&](std::size_t begin, std::size_t end)
      {
        std::size_t first = count;
        for (std::size_t item = begin; item < end; ++item)
        {
          first = isWrong(item) ? std::min(first, item) : first;
        }
        return first;
      });
    return wrong.empty() ? count : *std::min_element(wrong.begin(), wrong.end());
  }

  TriangleMesh& mesh_;
  const Job& job_;
};

TriangleMesh::TriangleMesh(
  std::vector<Vec3> points, const std::vector<Triangle>& triangles, const Job& job)
  : points_(std::move(points))
{
  Builder(*this, job).run(triangles);
}

Id TriangleMesh::firstFaceFrom(Id input) const
{
  const auto& faces = this->inputFaces_;
  return faces.empty()
    ? std::min(input, this->numberOfFaces())
    : static_cast<Id>(std::lower_bound(faces.begin(), faces.end(), input) - faces.begin());
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
  const FaceShape& shape = this->shape(faceOf(corner));
  return polarAngle({ shape.cornerDot[indexInFace(corner)], shape.area2 });
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
        for (const Id w : this->triangle(faceOf(corner)))
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
