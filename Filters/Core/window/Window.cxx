// SPDX-License-Identifier: BSD-3-Clause
#include "window/Window.h"

namespace geodesic
{

double Window::crossing(Vec2 p) const
{
  double x = p.x;
  if (this->isLinear())
  {
    x -= this->sourceDepth > 0.0 ? p.y * this->sourceX / this->sourceDepth : 0.0;
  }
  else if (p.y > 0.0)
  {
    x = this->sourceX + (p.x - this->sourceX) * this->sourceDepth / (this->sourceDepth + p.y);
  }
  return std::clamp(x, this->begin, this->end);
}

Window reversed(const Window& window, double length, Id numberOfVertices)
{
  Window w = window;
  w.begin = length - window.end;
  w.end = length - window.begin;
  if (window.isLinear())
  {
    w.sigma = window.distance(length);
    w.sourceX = -window.sourceX;
    w.place = window.placeOf({ length, 0.0 });
    w.origin ^= 3U; // in the mirrored frame the rays are on the other side: see CurveSide
  }
  else
  {
    w.sourceX = length - window.sourceX;
    if (CurveSide::isOne(window.origin, numberOfVertices))
    {
      w.place = angleAround(window.origin, window.place, { -1.0, 0.0 });
      w.origin ^= 1U; // angles around the point grow the other way
    }
  }
  return w;
}

}
