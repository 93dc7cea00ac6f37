// SPDX-License-Identifier: BSD-3-Clause
#include "front/CompleteFaces.h"

#include <algorithm>

namespace geodesic
{

void CompleteFaces::addAround(Id halfedge)
{
  Id around = halfedge;
  do
  {
    this->add(TriangleMesh::faceOf(around));
    around = this->mesh_.nextSibling(around);
  } while (around != halfedge);
}

bool CompleteFaces::isNeededAround(Id halfedge) const
{
  bool isNeeded = true;
  Id around = halfedge;
  do
  {
    isNeeded = isNeeded && this->isNeeded(TriangleMesh::faceOf(around));
    around = this->mesh_.nextSibling(around);
  } while (around != halfedge);
  return isNeeded;
}

void CompleteFaces::addAroundReachedVertices(const VertexStates& vertices)
{
  for (Id face = this->firstFace_; face < this->endOfFaces_; ++face)
  {
    for (const Id vertex : this->mesh_.triangle(face))
    {
      if (vertices.distance(vertex) <= this->limit_)
      {
        this->add(face);
      }
    }
  }
}

double CompleteFaces::neededDistance(const VertexStates& vertices, bool inside) const
{
  double bound = 0.0;
  for (Id face = this->firstFace_; face < this->endOfFaces_; ++face)
  {
    if (this->needed_[face])
    {
      const Triangle& t = this->mesh_.triangle(face);
      const auto [least, most] =
        std::minmax({ vertices.distance(t[0]), vertices.distance(t[1]), vertices.distance(t[2]) });
      const double reach = least + this->mesh_.shape(face).longest();
      bound = std::max(bound, inside ? reach : most);
    }
  }
  return bound;
}

std::vector<std::uint8_t> CompleteFaces::completeVertices() const
{
  std::vector<std::uint8_t> complete(this->mesh_.numberOfVertices(), 0);
  for (Id face = this->firstFace_; face < this->endOfFaces_; ++face)
  {
    for (const Id vertex : this->mesh_.triangle(face))
    {
      complete[vertex] |= this->needed_[face];
    }
  }
  return complete;
}

}
