// SPDX-License-Identifier: BSD-3-Clause
#include "window/WindowCrossings.h"

#include <cmath>
#include <utility>

namespace geodesic
{

namespace
{

// Roots of a t^2 + 2 b t + c. The caller gives the discriminant b^2 - a c in a form without
// cancellation; the textbook formula for the roots would introduce cancellation again.
Crossings quadraticRoots(double a, double b, double c, double discriminant)
{
  Crossings roots;
  if (!(discriminant >= 0.0))
  {
    return roots;
  }
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  if (q != 0.0)
  {
    roots.at[static_cast<std::size_t>(roots.count++)] = c / q;
  }
  if (a != 0.0)
  {
    roots.at[static_cast<std::size_t>(roots.count++)] = q / a;
  }
  return roots;
}

// Both sides are sqrt((t - s)^2 + h^2) + sigma. The points of equal distance form one branch of a
// hyperbola, which a line meets up to twice. (Section 3.3 has one crossing, which is true only for
// equal sigma, where the two roots here coincide.) With l(t) = alpha t + gamma, the difference of
// the squares, l^2 = beta2 ((t - s1)^2 + h1^2).
Crossings circularCircular(const Window& a, const Window& b, double origin)
{
  const double s0 = a.sourceX - origin;
  const double s1 = b.sourceX - origin;
  const double h1 = b.sourceDepth;
  const double beta = b.sigma - a.sigma;
  const double alpha = 2.0 * (s1 - s0);
  const double gamma =
    (s0 - s1) * (s0 + s1) + (a.sourceDepth - h1) * (a.sourceDepth + h1) - beta * beta;
  const double beta2 = 4.0 * beta * beta;
  const double quadratic = (alpha - 2.0 * beta) * (alpha + 2.0 * beta);
  const double atSource = gamma + alpha * s1;
  return quadraticRoots(quadratic, alpha * gamma + beta2 * s1,
    gamma * gamma - beta2 * (s1 * s1 + h1 * h1),
    beta2 * (atSource * atSource + quadratic * h1 * h1));
}

// Section 4.2.2, but with both sigmas: of the circular window, and of the linear window, whose
// function includes it.
Crossings circularLinear(const Window& circular, const Window& linear, double origin)
{
  const double s = circular.sourceX - origin;
  const double h = circular.sourceDepth;
  const double m = linear.sourceX;
  const double n = linear.distance(origin) - circular.sigma;
  const double atSource = n + m * s;
  const double height = h * linear.sourceDepth;
  return quadraticRoots(linear.sourceDepth * linear.sourceDepth, -(s + m * n),
    s * s + h * h - n * n, (atSource - height) * (atSource + height));
}

Crossings linearLinear(const Window& a, const Window& b, double origin)
{
  Crossings root;
  const double slope = a.sourceX - b.sourceX;
  root.count = slope != 0.0 ? 1 : 0;
  root.at[0] = slope != 0.0 ? (b.distance(origin) - a.distance(origin)) / slope : 0.0;
  return root;
}

} // anonymous namespace

Crossings crossings(const Window& a, const Window& b, double lo, double hi)
{
  const double origin = 0.5 * (lo + hi); // the interval's middle, so that roots are accurate there
  Crossings roots;
  if (a.isLinear() && b.isLinear())
  {
    roots = linearLinear(a, b, origin);
  }
  else if (a.isLinear() || b.isLinear())
  {
    roots = a.isLinear() ? circularLinear(b, a, origin) : circularLinear(a, b, origin);
  }
  else
  {
    roots = circularCircular(a, b, origin);
  }
  Crossings inside;
  for (int i = 0; i < roots.count; ++i)
  {
    const double x = origin + roots.at[static_cast<std::size_t>(i)];
    if (x > lo && x < hi)
    {
      inside.at[static_cast<std::size_t>(inside.count++)] = x;
    }
  }
  if (inside.count == 2 && inside.at[0] > inside.at[1])
  {
    std::swap(inside.at[0], inside.at[1]);
  }
  return inside;
}

}
