// SPDX-License-Identifier: BSD-3-Clause
#include "source/BoundaryCurves.h"

#include <algorithm>
#include <utility>

namespace geodesic
{

namespace
{

/// Chains the halfedges on the boundary of a surface into curves.
class BoundaryChains
{
public:
  explicit BoundaryChains(const TriangleMesh& mesh)
    : mesh_(mesh)
    , isFree_(mesh.numberOfHalfedges(), 0)
    , boundaryHalfedgesAt_(mesh.numberOfVertices(), 0)
  {
    for (Id halfedge = 0; halfedge < mesh.numberOfHalfedges(); ++halfedge)
    {
      if (mesh.isBoundary(halfedge))
      {
        this->isFree_[halfedge] = 1;
        ++this->boundaryHalfedgesAt_[mesh.origin(halfedge)];
        ++this->boundaryHalfedgesAt_[mesh.destination(halfedge)];
      }
    }
  }

  std::vector<SourceCurve> run()
  {
    // First the curves between vertices where the boundary branches or ends, then the remaining
    // loops.
    for (const bool loops : { false, true })
    {
      for (Id halfedge = 0; halfedge < this->mesh_.numberOfHalfedges(); ++halfedge)
      {
        for (const Id vertex : { this->mesh_.origin(halfedge), this->mesh_.destination(halfedge) })
        {
          if (this->isFree_[halfedge] && (loops || !this->goesOn(vertex)))
          {
            this->follow(halfedge, vertex);
          }
        }
      }
    }
    return std::move(this->curves_);
  }

private:
  /// Whether a curve continues through the boundary vertex.
  bool goesOn(Id vertex) const { return this->boundaryHalfedgesAt_[vertex] == 2; }

  Id freeHalfedgeAt(Id vertex) const
  {
    for (const Id corner : this->mesh_.cornersAt(vertex))
    {
      for (const Id halfedge : { corner, TriangleMesh::previousInFace(corner) })
      {
        if (this->isFree_[halfedge])
        {
          return halfedge;
        }
      }
    }
    return NoId;
  }

  void follow(Id halfedge, Id vertex)
  {
    SourceCurve& curve = this->curves_.emplace_back(pointCurve(SurfacePoint::atVertex(vertex)));
    while (halfedge != NoId)
    {
      this->isFree_[halfedge] = 0;
      const Id origin = this->mesh_.origin(halfedge);
      vertex = origin == vertex ? this->mesh_.destination(halfedge) : origin;
      curve.points.push_back(SurfacePoint::atVertex(vertex));
      curve.isCut.push_back(0);
      curve.faces.push_back(TriangleMesh::faceOf(halfedge));
      halfedge = this->goesOn(vertex) ? this->freeHalfedgeAt(vertex) : NoId;
    }
  }

  const TriangleMesh& mesh_;
  /// Of each halfedge, whether it is on the boundary and in no curve yet.
  std::vector<std::uint8_t> isFree_;
  std::vector<Id> boundaryHalfedgesAt_;
  std::vector<SourceCurve> curves_;
};

bool hasFaceAt(const TriangleMesh& mesh, Id vertex)
{
  return vertex < mesh.numberOfVertices() && mesh.cornersAt(vertex).size() > 0;
}

/// Restricts a boundary curve of a whole surface to the faces of a mesh.
void addPieces(const SourceCurve& curve, const TriangleMesh& mesh, std::vector<SourceCurve>& pieces)
{
  std::vector<SurfacePoint> points = curve.points;
  std::vector<Id> faces; // of the mesh at each segment; NoId if there is none
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
  {
    const Id from = points[i].id;
    const Id to = points[i + 1].id;
    const Id halfedge =
      hasFaceAt(mesh, from) && hasFaceAt(mesh, to) ? mesh.halfedgeBetween(from, to) : NoId;
    faces.push_back(halfedge == NoId ? NoId : TriangleMesh::faceOf(halfedge));
  }
  const auto gap = std::find(faces.begin(), faces.end(), NoId);
  if (gap == faces.end())
  {
    pieces.push_back(curve);
    pieces.back().faces = faces;
    return;
  }
  if (curve.isClosed())
  {
    // A loop begins behind an omitted segment, which then is the last one.
    points.pop_back();
    const auto omitted = gap - faces.begin();
    std::rotate(faces.begin(), gap + 1, faces.end());
    std::rotate(points.begin(), points.begin() + omitted + 1, points.end());
  }
  SourceCurve piece;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    piece.points.push_back(points[i]);
    if (i < faces.size() && faces[i] != NoId)
    {
      piece.faces.push_back(faces[i]);
      continue;
    }
    if (hasFaceAt(mesh, piece.points.front().id))
    {
      piece.isCut.assign(piece.points.size(), 0);
      piece.source = curve.source;
      pieces.push_back(std::move(piece));
    }
    piece = SourceCurve();
  }
}

} // anonymous namespace

std::vector<SourceCurve> boundaryCurves(const TriangleMesh& mesh)
{
  return BoundaryChains(mesh).run();
}

std::vector<SourceCurve> boundaryOutsideBarriers(
  const std::vector<SourceCurve>& boundary, const TriangleMesh& mesh)
{
  std::vector<SourceCurve> pieces;
  for (const SourceCurve& curve : boundary)
  {
    addPieces(curve, mesh, pieces);
  }
  return pieces;
}

}
