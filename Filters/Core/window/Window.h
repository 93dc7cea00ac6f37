// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Window_h
#define geodesic_Window_h

#include "Types.h"

#include <algorithm>

namespace geodesic
{

/// The most faces that a window can have crossed.
constexpr Id MaximumDepth = 0x7fffffffU;

/// A window: an interval of a halfedge together with the pencil of rays that enters the halfedge's
/// face through it (paper, sections 3.2 and 4.2.1).
///
/// Coordinates are those of the halfedge: its edge is the x axis from its origin, its face lies
/// above it, the unfolded source below or on it. A window keeps the source itself instead of the
/// distances at its ends: recomputing the source from them, as in section 3.2, loses most digits
/// where the interval is narrow. The pseudo-source's distance sigma of a linear window is folded
/// into its distance function.
struct Window
{
  // Not a class, as GCC 12 cannot initialise bit-fields of those by braces.
  enum Kind : std::uint32_t
  {
    /// Rays leave the point (sourceX, -sourceDepth) whose own distance is sigma.
    Circular,
    /// Rays are parallel to the unit vector (sourceX, sourceDepth); the distance at the halfedge's
    /// origin is sigma.
    Linear
  };

  double begin;
  double end;
  double sourceX;
  double sourceDepth;
  double sigma;
  /// How much longer than this window tells the path behind it can be: 0 in the exact field.
  double error;
  Kind kind : 1;
  /// Number of faces crossed since the source: a shortest path crosses no face twice, which bounds
  /// it, and with it every propagation.
  Id depth : 31;
  /// The vertex that its rays leave from; NoId where they come straight from a source that is not a
  /// vertex. Distances do not depend on it.
  Id origin = NoId;

  bool isLinear() const { return this->kind == Kind::Linear; }
  double width() const { return this->end - this->begin; }

  /// Distance at x on the halfedge (paper, equation 1 and section 4.2.2).
  double distance(double x) const
  {
    if (this->isLinear())
    {
      return this->sigma + this->sourceX * x;
    }
    const double dx = x - this->sourceX;
    return this->sigma + std::sqrt(dx * dx + this->sourceDepth * this->sourceDepth);
  }

  /// Length of the straight unfolded ray to a point of the face's plane.
  double straightDistance(Vec2 p) const
  {
    if (this->isLinear())
    {
      return this->sigma + this->sourceX * p.x + this->sourceDepth * p.y;
    }
    const double dx = p.x - this->sourceX;
    const double dy = p.y + this->sourceDepth;
    return this->sigma + std::sqrt(dx * dx + dy * dy);
  }

  /// Direction of the ray through x, not normalised.
  Vec2 direction(double x) const
  {
    return { this->isLinear() ? this->sourceX : x - this->sourceX, this->sourceDepth };
  }

  /// Whether the ray through x leaves the point p (above the halfedge) on its left.
  bool passesRightOf(double x, Vec2 p) const
  {
    const Vec2 d = this->direction(x);
    return d.x * p.y > d.y * (p.x - x);
  }

  /// Where the ray to p crosses the halfedge, moved to the nearest end of the interval when
  /// outside.
  double crossing(Vec2 p) const;

  /// Length of the shortest path to p through the interval: straight where the pencil holds p, bent
  /// at the nearer end elsewhere. Always the length of a real path.
  double bentDistance(Vec2 p) const
  {
    const double x = this->crossing(p);
    return this->distance(x) + norm(p - Vec2{ x, 0.0 });
  }

  /// Least distance on the interval.
  double minimum() const
  {
    if (this->isLinear())
    {
      return this->distance(this->sourceX > 0.0 ? this->begin : this->end);
    }
    return this->distance(std::clamp(this->sourceX, this->begin, this->end));
  }
};

static_assert(sizeof(Window) == 56, "there are hundreds of millions of them");

/// Windows that stand together in memory.
struct WindowRange
{
  const Window* first = nullptr;
  const Window* last = nullptr;
  const Window* begin() const { return this->first; }
  const Window* end() const { return this->last; }
  std::size_t size() const { return static_cast<std::size_t>(this->last - this->first); }
};

/// The window as seen along the reversed edge of the given length.
Window reversed(const Window& window, double length);

/// A halfedge's face unfolded above the halfedge, ready for windows to go through.
struct UnfoldedFace
{
  /// Length of the entered halfedge and of the two that are left through: from its origin to the
  /// apex, from the apex to its destination.
  double length;
  double leftLength;
  double rightLength;
  /// The apex, and its distance along the halfedge from the destination.
  Vec2 apex;
  double apexFromEnd;
  /// Unit vectors along the left and the right edge.
  Vec2 leftAxis;
  Vec2 rightAxis;

  /// Where the ray of a window through x meets the left edge, as a distance from the halfedge's
  /// origin.
  double meetLeft(const Window& window, double x) const;
  /// Where it meets the right edge, as a distance from the apex.
  double meetRight(const Window& window, double x) const;
  /// The window with its source in the frame of the left edge (x axis from the halfedge's origin to
  /// the apex, the face below), on the given interval.
  Window throughLeft(const Window& window, double begin, double end) const;
  /// The same for the right edge (x axis from the apex to the halfedge's destination).
  Window throughRight(const Window& window, double begin, double end) const;
};

inline double UnfoldedFace::meetLeft(const Window& window, double x) const
{
  const Vec2 d = window.direction(x);
  const double denominator = d.y * this->apex.x - d.x * this->apex.y;
  const double t = denominator > 0.0 ? x * d.y / denominator : 0.0;
  return std::clamp(t, 0.0, 1.0) * this->leftLength;
}

inline double UnfoldedFace::meetRight(const Window& window, double x) const
{
  const Vec2 d = window.direction(x);
  const double denominator = d.y * this->apexFromEnd + d.x * this->apex.y;
  const double t = denominator > 0.0 ? (this->length - x) * d.y / denominator : 0.0;
  return (1.0 - std::clamp(t, 0.0, 1.0)) * this->rightLength;
}

/// The window with its source in another frame. Unfolding is a rigid motion: the source is carried
/// along, not computed anew.
inline Window moved(const Window& window, Vec2 origin, Vec2 axis)
{
  Window w = window;
  if (window.isLinear())
  {
    w.sigma = window.straightDistance(origin);
    w.sourceX = window.sourceX * axis.x + window.sourceDepth * axis.y;
    w.sourceDepth = window.sourceDepth * axis.x - window.sourceX * axis.y;
  }
  else
  {
    const double dx = window.sourceX - origin.x;
    const double dy = window.sourceDepth + origin.y;
    w.sourceX = dx * axis.x - dy * axis.y;
    w.sourceDepth = dx * axis.y + dy * axis.x;
  }
  w.sourceDepth = std::max(w.sourceDepth, 0.0);
  w.depth = (window.depth + 1) & MaximumDepth;
  return w;
}

inline Window UnfoldedFace::throughLeft(const Window& window, double begin, double end) const
{
  Window w = moved(window, { 0.0, 0.0 }, this->leftAxis);
  w.begin = begin;
  w.end = end;
  return w;
}

inline Window UnfoldedFace::throughRight(const Window& window, double begin, double end) const
{
  Window w = moved(window, this->apex, this->rightAxis);
  w.begin = begin;
  w.end = end;
  return w;
}

/// The points of (lo, hi) where the distances of two windows are equal: none, one or two,
/// ascending. May hold points where they are not (from squaring); the caller compares between them.
struct Crossings
{
  int count = 0;
  std::array<double, 2> at{};
};
Crossings crossings(const Window& a, const Window& b, double lo, double hi);

}

#endif
