// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesictest_WindowSupport_h
#define geodesictest_WindowSupport_h

#include "truth/TestMeshes.h"

#include "window/Window.h"
#include "window/WindowMerge.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <ostream>
#include <vector>

/// Windows for tests, and their distances in extended precision. This truth is written anew from
/// the definition of a window and calls none of the engine's functions.
namespace geodesictest
{

using geodesic::Window;

/// At least 64 bits of mantissa on the test machines: about a thousand times the precision under
/// test.
using Extended = long double;

constexpr double Epsilon = std::numeric_limits<double>::epsilon();

inline Window circularWindow(double begin, double end, double x, double depth, double sigma = 0.0)
{
  return { begin, end, x, depth, sigma, 0.0, Window::Kind::Circular, 0 };
}

/// \param slope growth of the distance along the halfedge, in [-1, 1].
inline Window linearWindow(double begin, double end, double slope, double sigma = 0.0)
{
  return { begin, end, slope, std::sqrt((1.0 - slope) * (1.0 + slope)), sigma, 0.0,
    Window::Kind::Linear, 0 };
}

/// Merges the windows of a vector, as mergeNeighbours() does those of a block.
inline double mergeNeighbours(std::vector<Window>& windows, double edgeLength, double relativeError,
  double maximumAdded = geodesic::Infinity)
{
  geodesic::WindowBlock list = { windows.data(), static_cast<std::uint32_t>(windows.size()) };
  const double largest = geodesic::mergeNeighbours(list, edgeLength, relativeError, maximumAdded);
  windows.resize(list.size);
  return largest;
}

/// The straight distance of a window to a point above its halfedge.
inline Extended exactDistance(const Window& w, Extended x, Extended y = 0.0L)
{
  if (w.kind == Window::Kind::Linear)
  {
    return w.sigma + w.sourceX * x + w.sourceDepth * y;
  }
  const Extended dx = x - w.sourceX;
  const Extended dy = y + w.sourceDepth;
  return w.sigma + std::sqrt(dx * dx + dy * dy);
}

/// The minimum of a convex function on [lo, hi], by ternary search.
inline Extended leastOf(const std::function<Extended(Extended)>& f, Extended lo, Extended hi)
{
  for (int i = 0; i < 200; ++i)
  {
    const Extended a = lo + (hi - lo) / 3.0L;
    const Extended b = hi - (hi - lo) / 3.0L;
    (f(a) < f(b) ? hi : lo) = f(a) < f(b) ? b : a;
  }
  return f(0.5L * (lo + hi));
}

/// The length of the shortest path through the window to a point above the halfedge.
inline Extended exactBentDistance(const Window& w, Extended x, Extended y)
{
  return leastOf(
    [&](Extended t) { return exactDistance(w, t) + std::hypot(x - t, y); }, w.begin, w.end);
}

/// A window of any kind somewhere on [0, length].
inline Window randomWindow(double length, Random& random)
{
  const double begin = random.uniform(0.0, 0.8) * length;
  const double end = begin + random.uniform(0.1, 1.0) * (length - begin);
  const double sigma = random.chance(0.3) ? 0.0 : random.uniform(0.0, length);
  if (random.chance(0.4))
  {
    return linearWindow(begin, end, random.uniform(-1.0, 1.0), sigma + length);
  }
  const double depth =
    random.chance(0.1) ? 0.0 : std::pow(10.0, random.uniform(-3.0, 2.0)) * length;
  return circularWindow(begin, end, random.uniform(-1.0, 2.0) * length, depth, sigma);
}

}

namespace geodesic
{

/// For failure messages.
inline std::ostream& operator<<(std::ostream& os, const Window& w)
{
  os.precision(17);
  return os << (w.isLinear() ? "linear [" : "circular [") << w.begin << ", " << w.end
            << "] source (" << w.sourceX << ", " << w.sourceDepth << ") sigma " << w.sigma
            << " error " << w.error;
}

}

#endif
