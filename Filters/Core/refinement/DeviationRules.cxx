// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/DeviationRules.h"

#include <algorithm>

namespace geodesic
{

RedGreenMesh::Placement DeviationRules::place(Id edge)
{
  const double weight = this->weightOf(edge);
  return { weight, this->distances_.onEdge(edge, weight) };
}

double DeviationRules::weightOf(Id edge)
{
  constexpr double middle = 0.5;
  const Deviation deviation = this->distances_.deviation(edge);
  if (!(deviation.largest() > this->tolerance_))
  {
    return middle;
  }
  const double aimed = splitPosition(deviation.at());
  for (const double weight : { aimed, 0.5 * (aimed + middle) })
  {
    if (this->shapes_.maySplit(edge, weight, deviation.largest()))
    {
      return weight;
    }
  }
  return middle;
}

bool DeviationRules::mayClose(Id triangle)
{
  return this->shapes_.mayClose(triangle, this->largestAround(triangle));
}

double DeviationRules::largestAround(Id triangle)
{
  double largest = 0.0;
  for (Id k = 0; k < 3; ++k)
  {
    const Id edge = this->triangles_.ensureEdge(triangle, k);
    largest = std::max(largest, this->distances_.deviation(edge).largest());
  }
  return largest;
}

}
