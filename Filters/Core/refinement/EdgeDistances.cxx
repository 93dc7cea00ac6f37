// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/EdgeDistances.h"

namespace geodesic
{

// Calls visit(face) until it returns false.
template <typename Visit>
void EdgeDistances::forEachRefinedFace(const RedGreenMesh::Edge& edge, Visit&& visit) const
{
  if (edge.halfedge == NoId)
  {
    visit(edge.face);
    return;
  }
  Id halfedge = edge.halfedge;
  do
  {
    const Id face = TriangleMesh::faceOf(halfedge);
    if (!this->triangles_.isFrozen(face) && !visit(face))
    {
      return;
    }
    halfedge = this->triangles_.mesh().nextSibling(halfedge);
  } while (halfedge != edge.halfedge);
}

double EdgeDistances::atPoint(Id point) const
{
  const Id inputPoints = this->triangles_.numberOfInputPoints();
  return point < inputPoints ? this->field_.vertexDistances()[point]
                             : this->triangles_.points()[point - inputPoints].distance;
}

double EdgeDistances::atPoint(Id point, const FaceDistance& face, Vec2 place) const
{
  return face.isExact() ? this->atPoint(point) : face.distance(place);
}

Deviation EdgeDistances::deviation(Id edge)
{
  if (edge >= this->ofEdge_.size())
  {
    this->ofEdge_.resize(this->triangles_.numberOfEdges());
  }
  if (!this->ofEdge_[edge].known)
  {
    this->ofEdge_[edge] = { this->measure(this->triangles_.edgeData(edge)), true };
  }
  return this->ofEdge_[edge].deviation;
}

// In the exact field one face tells the whole distance along its edge.
Deviation EdgeDistances::measure(const RedGreenMesh::Edge& edge)
{
  Deviation largest;
  this->forEachRefinedFace(edge,
    [&](Id id)
    {
      const FaceDistance& face = this->faces_.of(id);
      largest.widen(this->deviationBetween(edge.ends[0], edge.ends[1], face));
      return !face.isExact();
    });
  return largest;
}

Deviation EdgeDistances::deviationBetween(Id a, Id b, const FaceDistance& face)
{
  const Vec2 p = this->triangles_.inPlane(a, face.face());
  const Vec2 q = this->triangles_.inPlane(b, face.face());
  return largestDeviation(this->envelope_.along(face, p, q), norm(q - p), this->atPoint(a, face, p),
    this->atPoint(b, face, q));
}

double EdgeDistances::onEdge(Id id, double weight)
{
  const RedGreenMesh::Edge& edge = this->triangles_.edgeData(id);
  double least = Infinity;
  this->forEachRefinedFace(edge,
    [&](Id face)
    {
      const Vec2 p = this->triangles_.inPlane(edge.ends[0], face);
      const Vec2 q = this->triangles_.inPlane(edge.ends[1], face);
      least = std::min(least, this->faces_.of(face).distance(p + weight * (q - p)));
      return true;
    });
  return least;
}

void EdgeDistances::forget(Id firstEdge)
{
  if (firstEdge < this->ofEdge_.size())
  {
    this->ofEdge_.resize(firstEdge);
  }
}

}
