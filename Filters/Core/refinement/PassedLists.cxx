// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/PassedLists.h"

namespace geodesic
{

void PassedLists::add(const MeasuredList& measured)
{
  Id index = static_cast<Id>(this->nodes_.size());
  if (this->freeNodes_.empty())
  {
    this->nodes_.emplace_back();
  }
  else
  {
    index = this->freeNodes_.back();
    this->freeNodes_.pop_back();
  }
  this->nodes_[index] = { measured, NoId };
  Id* last = &this->first_[TriangleMesh::faceOf(measured.list.halfedge)];
  while (*last != NoId)
  {
    last = &this->nodes_[*last].next;
  }
  *last = index;
}

void PassedLists::free(Id face, const FrontState& front)
{
  for (Id n = this->first_[face]; n != NoId; n = this->nodes_[n].next)
  {
    front.free(this->nodes_[n].measured.list.windows);
    this->freeNodes_.push_back(n);
  }
  this->first_[face] = NoId;
}

}
