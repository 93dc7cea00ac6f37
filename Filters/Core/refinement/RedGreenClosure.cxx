// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/RedGreenClosure.h"

#include <algorithm>

namespace geodesic
{

void RedGreenClosure::split(Id edge)
{
  this->mesh_.split(edge, this->rules_.place(edge));
}

void RedGreenClosure::splitIntoFour(Id triangle)
{
  for (Id k = 0; k < 3; ++k)
  {
    const Id edge = this->mesh_.edge(triangle, k);
    if (!this->mesh_.isSplit(edge))
    {
      this->split(edge);
    }
  }
  this->mesh_.splitIntoFour(triangle);
}

std::vector<Id> RedGreenClosure::close()
{
  constexpr int rounds = 2;
  std::vector<Id> changed;
  this->closeTouched(changed);
  for (int round = 0; round < rounds; ++round)
  {
    const std::vector<Id> bisected = changed;
    for (const Id triangle : bisected)
    {
      if (this->mesh_.isLeaf(triangle) && this->mesh_.splitEdges(triangle) == 1 &&
        !this->rules_.mayClose(triangle))
      {
        this->splitIntoFour(triangle);
      }
    }
    this->closeTouched(changed);
  }
  return changed;
}

void RedGreenClosure::closeTouched(std::vector<Id>& changed)
{
  for (Id triangle = this->mesh_.takeTouched(); triangle != NoId;
       triangle = this->mesh_.takeTouched())
  {
    if (!this->mesh_.isLeaf(triangle))
    {
      continue;
    }
    if (this->mesh_.isSplitTwice(triangle) ||
      (this->mesh_.splitEdges(triangle) > 1 && !this->rules_.mayClose(triangle)))
    {
      this->splitIntoFour(triangle);
    }
    else
    {
      changed.push_back(triangle);
    }
  }
  std::sort(changed.begin(), changed.end());
  changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
  changed.erase(std::remove_if(changed.begin(), changed.end(),
                  [this](Id triangle) { return !this->mesh_.isLeaf(triangle); }),
    changed.end());
}

}
