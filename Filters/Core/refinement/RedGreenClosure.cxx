// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/RedGreenClosure.h"

namespace geodesic
{

bool RedGreenClosure::split(Id edge, int round)
{
  if (!this->seams_.isDecidedHere(edge))
  {
    this->seams_.ask(edge, round);
    return false;
  }
  this->mesh_.split(edge, this->rules_.place(edge));
  this->seams_.tell(edge, round);
  return true;
}

void RedGreenClosure::splitIntoFour(Id triangle, int round)
{
  bool areSplit = true;
  for (Id k = 0; k < 3; ++k)
  {
    const Id edge = this->mesh_.ensureEdge(triangle, k);
    if (!this->mesh_.isSplit(edge))
    {
      areSplit = this->split(edge, round) && areSplit;
    }
  }
  if (areSplit)
  {
    this->waiting_.erase(triangle);
    this->mesh_.splitIntoFour(triangle);
  }
  else
  {
    this->waiting_.insert(triangle);
  }
}

std::vector<Id> RedGreenClosure::close(int round)
{
  constexpr int rounds = 2;
  std::vector<Id> changed;
  this->closeTouched(round, changed);
  while (round < rounds)
  {
    ++round;
    const std::vector<Id> bisected = changed;
    for (const Id triangle : bisected)
    {
      if (this->mesh_.isLeaf(triangle) && this->mesh_.splitEdges(triangle) == 1 &&
        !this->isWaiting(triangle) && !this->rules_.mayClose(triangle))
      {
        this->splitIntoFour(triangle, round);
      }
    }
    this->closeTouched(round, changed);
  }
  return changed;
}

// The loop ends: it splits edges only of triangles that already have a split edge, so it adds no
// level of parts to the existing ones.
void RedGreenClosure::closeTouched(int round, std::vector<Id>& changed)
{
  for (Id triangle = this->mesh_.takeTouched(); triangle != NoId;
       triangle = this->mesh_.takeTouched())
  {
    if (!this->mesh_.isLeaf(triangle))
    {
      continue;
    }
    if (this->isWaiting(triangle) || this->mesh_.isSplitTwice(triangle) ||
      (this->mesh_.splitEdges(triangle) > 1 && !this->rules_.mayClose(triangle)))
    {
      this->splitIntoFour(triangle, round);
    }
    else
    {
      changed.push_back(triangle);
    }
  }
  this->mesh_.keepLeaves(changed);
}

}
