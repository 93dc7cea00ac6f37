// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RedGreenMesh_txx
#define geodesic_RedGreenMesh_txx

#include "refinement/RedGreenMesh.h"

namespace geodesic
{

template <typename Visitor>
void RedGreenMesh::forEachLeafAt(Id edge, Visitor&& visit) const
{
  const Edge e = this->edges_[edge]; // a copy: the visitor may ask for edges, which adds them
  for (Id corner = e.firstCorner; corner != NoId;
       corner = this->parts_[corner / 3].nextCorner[corner % 3])
  {
    if (this->parts_[corner / 3].parts == NoId)
    {
      visit(this->faces_ + corner / 3);
    }
  }
  if (e.halfedge == NoId || e.parent != NoId)
  {
    return;
  }
  Id halfedge = e.halfedge;
  do
  {
    const Id face = TriangleMesh::faceOf(halfedge);
    if (this->isLeaf(face) && !this->isFrozen(face))
    {
      visit(face);
    }
    halfedge = this->mesh_.nextSibling(halfedge);
  } while (halfedge != e.halfedge);
}

template <typename Emit>
void RedGreenMesh::forEachTriangle(Id firstFace, Id endOfFaces, Emit&& emit) const
{
  std::vector<Id> stack;
  for (Id face = firstFace; face < endOfFaces; ++face)
  {
    if (this->isWhole(face))
    {
      emit(face, this->mesh_.triangle(face));
      continue;
    }
    if (this->isFrozen(face))
    {
      this->closeFrozen(face, this->corners(face),
        { this->existingEdge(face, 0), this->existingEdge(face, 1), this->existingEdge(face, 2) },
        emit);
      continue;
    }
    stack.push_back(face);
    while (!stack.empty())
    {
      const Id triangle = stack.back();
      stack.pop_back();
      const Id parts = this->partsOf(triangle);
      if (parts == NoId)
      {
        this->closeLeaf(triangle, emit);
        continue;
      }
      for (Id i = 4; i-- > 0;)
      {
        stack.push_back(this->faces_ + parts + i);
      }
    }
  }
}

template <typename Emit>
void RedGreenMesh::closeLeaf(Id triangle, Emit&& emit) const
{
  const Id face = this->faceOf(triangle);
  const Closing closing = this->closing(triangle, this->wayOf(triangle));
  for (Id i = 0; i < closing.count; ++i)
  {
    const std::array<Id, 3>& t = closing.triangles[i];
    emit(face, Triangle{ closing.points[t[0]], closing.points[t[1]], closing.points[t[2]] });
  }
}

// Bisects at the longest split edge first, for the shapes.
template <typename Emit>
void RedGreenMesh::closeFrozen(
  Id face, const Triangle& c, const std::array<Id, 3>& edges, Emit&& emit) const
{
  std::size_t longest = 3;
  double length = -1.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (this->isSplit(edges[k]) && this->lengthOf(c[k], c[(k + 1) % 3]) > length)
    {
      longest = k;
      length = this->lengthOf(c[k], c[(k + 1) % 3]);
    }
  }
  if (longest == 3)
  {
    emit(face, c);
    return;
  }
  const std::size_t k = longest;
  const std::size_t next = (k + 1) % 3;
  const std::size_t previous = (k + 2) % 3;
  const Id middle = this->edges_[edges[k]].split;
  this->closeFrozen(face, Triangle{ c[k], middle, c[previous] },
    { this->halfAt(edges[k], c[k]), NoId, edges[previous] }, emit);
  this->closeFrozen(face, Triangle{ middle, c[next], c[previous] },
    { this->halfAt(edges[k], c[next]), edges[next], NoId }, emit);
}

}

#endif
