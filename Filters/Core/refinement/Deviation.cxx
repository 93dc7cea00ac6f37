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
  const double a = (atEnd - atBegin) / length;
  const double slope = (1.0 - a) * (1.0 + a); // of the ray with distance a x, squared
  const double shift = slope > 0.0 ? a / std::sqrt(slope) : 0.0;
  const auto look = [&](const Window& w, double x)
  {
    const double e = w.distance(x) - (atBegin + a * x);
    deviation.widen({ std::max(e, 0.0), x / length, std::max(-e, 0.0), x / length });
  };
  for (const Window& w : envelope)
  {
    look(w, w.begin);
    look(w, w.end);
    const double x = w.sourceX + shift * w.sourceDepth;
    if (!w.isLinear() && slope > 0.0 && x > w.begin && x < w.end)
    {
      look(w, x);
    }
  }
  return deviation;
}

double splitPosition(double t)
{
  if (t < 0.125)
  {
    return 0.25;
  }
  if (t < 0.25)
  {
    return 2.0 * t;
  }
  if (t <= 0.75)
  {
    return t;
  }
  return t < 0.875 ? 2.0 * t - 1.0 : 0.75;
}

}
