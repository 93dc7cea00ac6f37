// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/Deviation.h"

namespace geodesic
{

void Deviation::widen(const Deviation& other)
{
  if (other.above > this->above)
  {
    this->above = other.above;
    this->aboveAt = other.aboveAt;
  }
  if (other.below > this->below)
  {
    this->below = other.below;
    this->belowAt = other.belowAt;
  }
}

Deviation largestDeviation(
  const std::vector<Window>& envelope, double length, double atBegin, double atEnd)
{
  Deviation deviation;
  if (!(length > 0.0))
  {
    return deviation;
  }
  const LineOnSegment line(length, atBegin, atEnd);
  const auto look = [&](const Window& w, double x)
  {
    const double e = w.distance(x) - line.at(x);
    deviation.widen({ std::max(e, 0.0), x / length, std::max(-e, 0.0), x / length });
  };
  for (const Window& w : envelope)
  {
    look(w, w.begin);
    look(w, w.end);
    const double lowest = line.lowestOf(w);
    if (lowest > w.begin && lowest < w.end)
    {
      look(w, lowest);
    }
  }
  return deviation;
}

double splitPosition(double t)
{
  if (t < 0.25)
  {
    return std::max(0.25, 2.0 * t);
  }
  return t > 0.75 ? std::min(0.75, 2.0 * t - 1.0) : t;
}

}
