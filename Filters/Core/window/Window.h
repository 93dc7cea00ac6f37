// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Window_h
#define geodesic_Window_h

#include "Tolerance.h"
#include "Trigonometry.h"
#include "Types.h"
#include "window/ErrorBound.h"
#include "window/RayOrigin.h"
#include "window/TwoDoubles.h"

#include <algorithm>

namespace geodesic
{

constexpr Id MaximumFacesCrossed = 0x3fffffffU;

/// The angle around a point of a curve at which the ray of a window leaves it.
///
/// \param origin Window::origin, a point of a curve.
/// \param axis Window::start.
/// \param direction of the ray, in the frame of the window's halfedge.
inline double angleAround(RayOrigin origin, RayStart axis, Vec2 direction)
{
  return axis.angle() + origin.aroundPoint(polarAngle(direction));
}

/// A point over a halfedge, with the rounding error of its x.
struct PointOverHalfedge : Vec2
{
  double restOfX = 0.0;

  PointOverHalfedge(Vec2 p, double rest = 0.0)
    : Vec2(p)
    , restOfX(rest)
  {
  }
};

/// A window: an interval of a halfedge and the pencil of rays that enters the halfedge's face
/// through it (paper, sections 3.2 and 4.2.1).
///
/// Coordinates refer to the halfedge: the x axis runs along the halfedge from its origin, the face
/// lies above, and the unfolded source below or on the axis. A window keeps the source itself
/// instead of the distances at the interval's ends: recomputing the source from these distances, as
/// in section 3.2, loses most digits if the interval is narrow. The distance function of a linear
/// window includes the pseudo-source's distance sigma.
struct Window
{
  // Not a class: GCC 12 cannot initialise bit-fields of enumeration classes by braces.
  enum Kind : std::uint32_t
  {
    /// Rays leave the point (sourceX, -sourceDepth), whose own distance is sigma.
    Circular,
    /// Rays are parallel to the unit vector (sourceX, sourceDepth); the distance at the halfedge's
    /// origin is sigma.
    Linear,
    /// Circular, too. Rays of a source beside a vertex turn around the vertex to the left and to
    /// the right. Windows of the two directions never become one, although around a cone both may
    /// have the same source in the plane: those of one direction are CircularAround, the others
    /// Circular.
    CircularAround
  };

  double begin;
  double end;
  double sourceX;
  double sourceDepth;
  double sigma;
  /// The path behind this window is longer than the window's distance by at most this; 0 in the
  /// exact field.
  ErrorBound error;
  Kind kind : 2;
  /// Number of faces crossed since the source. A shortest path crosses no face twice, so this
  /// number is bounded, and propagation ends.
  Id facesCrossed : 30;
  /// Where its rays start: on a side of a curve if it is linear, else at a vertex as a
  /// pseudo-source or at a point of a curve. Distances do not depend on it.
  RayOrigin origin = {};
  /// One of the last eight faces that it has crossed (MeshPartition::globalFace()); NoId if none is
  /// known. A window that comes to this face again ends: rays would wind around the thin tube that
  /// caps are, back to back, up to the limit of faces crossed.
  Id crossed = NoId;
  /// Linear: the curve's parameter where the ray through the halfedge's origin starts. Circular
  /// from a curve's point: the angle of the x axis around the point, if the front keeps angles;
  /// else unused.
  RayStart start = {};

  /// Crosses one face more. Each eighth is kept in mind: thin tubes have fewer.
  void cross(Id face)
  {
    this->crossed = this->facesCrossed % 8 == 0 ? face : this->crossed;
    this->facesCrossed = (this->facesCrossed + 1) & MaximumFacesCrossed; // is below it
  }
  /// Of two windows that become this one: a face that only one of them has crossed is not known.
  void forgetUnlessCrossedBy(const Window& other)
  {
    this->crossed = this->crossed == other.crossed ? this->crossed : NoId;
  }
  /// Lets no ray go on behind the halfedge's face: the window only tells distances in this face.
  void endHere() { this->facesCrossed = MaximumFacesCrossed; }

  bool isLinear() const { return (this->kind & Kind::Linear) != 0; } // one bit: asked very often
  double width() const { return this->end - this->begin; }
  TwoDoubles ends() const { return { this->begin, this->end }; }

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

  TwoDoubles distances(TwoDoubles x) const
  {
    if (this->isLinear())
    {
      return TwoDoubles(this->sigma) + TwoDoubles(this->sourceX) * x;
    }
    const TwoDoubles dx = x - TwoDoubles(this->sourceX);
    const TwoDoubles depth(this->sourceDepth);
    return TwoDoubles(this->sigma) + TwoDoubles::roots(dx * dx + depth * depth);
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

  /// Where the ray of a linear window through a point of the face's plane starts. All rays of a
  /// circular window have the start of the window. On the left side of the curve, the rays'
  /// direction is the curve's direction turned to the left.
  RayStart startOf(Vec2 p) const
  {
    const double along = this->sourceDepth * p.x - this->sourceX * p.y;
    return this->isLinear()
      ? RayStart::atParameter(this->start.parameter() + this->origin.alongCurve(along))
      : this->start;
  }

  /// Direction of the ray through x, not normalised.
  Vec2 direction(double x) const
  {
    return { this->isLinear() ? this->sourceX : x - this->sourceX, this->sourceDepth };
  }

  /// The direction of the path that crosses the halfedge at crossing() of a point p above it, not
  /// normalised. Rays from one point have it from there to p: where the point is close to the
  /// halfedge, rounding of the crossing would turn the ray.
  Vec2 directionTo(Vec2 p, double crossing) const
  {
    const double size = std::abs(p.x) + p.y + this->end;
    if (this->isLinear())
    {
      // About as long as the way from there to p, so that lengths can be compared on surfaces of
      // all sizes; by a power of two, which rounds nothing.
      return std::scalbn(1.0, std::ilogb(size)) * this->direction(crossing);
    }
    const double outside = p.y > 0.0 ? std::abs(this->straightCrossing(p) - crossing) : Infinity;
    const bool isStraight = outside <= tolerance::PlaceRounding * size;
    return isStraight ? p - Vec2{ this->sourceX, -this->sourceDepth } : this->direction(crossing);
  }

  /// The x of the directions of the rays through the two ends; their y is sourceDepth.
  TwoDoubles endDirections() const
  {
    const TwoDoubles source(this->sourceX);
    return this->isLinear() ? source : this->ends() - source;
  }

  /// Whether the ray through x passes the point p, which lies above the halfedge, on p's right.
  bool passesRightOf(double x, const PointOverHalfedge& p) const
  {
    const Vec2 d = this->direction(x);
    return d.x * p.y > d.y * (p.x - x + p.restOfX);
  }

  /// Where the ray to p crosses the halfedge, clamped to the interval.
  double crossing(Vec2 p) const
  {
    double x = p.x;
    if (this->isLinear())
    {
      x -= this->sourceDepth > 0.0 ? p.y * this->sourceX / this->sourceDepth : 0.0;
    }
    else if (p.y > 0.0)
    {
      x = this->straightCrossing(p);
    }
    return std::clamp(x, this->begin, this->end);
  }
  /// The same of a circular window, not clamped, for a point that is not on the halfedge.
  double straightCrossing(Vec2 p) const
  {
    return this->sourceX + (p.x - this->sourceX) * this->sourceDepth / (this->sourceDepth + p.y);
  }

  /// Length of the shortest path to p through the interval: straight if the pencil contains p, else
  /// bent at the nearer end. It is always the length of a real path.
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

static_assert(sizeof(Window) == 64, "there are hundreds of millions of them");

/// Consecutive windows in memory.
using WindowRange = ArrayRange<Window>;

/// The least distance of any window.
inline double leastDistance(const WindowRange& windows)
{
  double least = Infinity;
  for (const Window& w : windows)
  {
    least = std::min(least, w.minimum());
  }
  return least;
}

/// The same window in the reversed frame: from the end of a halfedge of this length back to its
/// origin.
inline Window reversed(const Window& window, double length)
{
  Window w = window;
  w.begin = length - window.end;
  w.end = length - window.begin;
  w.origin = window.origin.mirrored();
  if (window.isLinear())
  {
    w.sigma = window.distance(length);
    w.sourceX = -window.sourceX;
    w.start = window.startOf({ length, 0.0 });
  }
  else
  {
    w.sourceX = length - window.sourceX;
    if (window.origin.isPoint())
    {
      w.start = RayStart::atAngle(angleAround(window.origin, window.start, { -1.0, 0.0 }));
    }
  }
  return w;
}

/// Changes the windows of a halfedge, in their order, into those of the reversed one.
inline void reverseAll(Window* begin, Window* end, double length)
{
  std::reverse(begin, end);
  std::transform(begin, end, begin, [length](const Window& w) { return reversed(w, length); });
}

}

#endif
