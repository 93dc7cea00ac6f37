// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_UnfoldedFace_h
#define geodesic_UnfoldedFace_h

#include "mesh/TriangleMesh.h"
#include "window/Window.h"

namespace geodesic
{

/// The face of a halfedge, laid into the plane above the halfedge, with what windows need to pass
/// through it (paper, section 3.2, "window propagation"). The apex is the face's third vertex. The
/// left edge runs from the halfedge's origin to the apex, the right edge from the apex to the
/// halfedge's destination.
struct UnfoldedFace
{
  double length;
  double leftLength;
  double rightLength;
  /// The apex, and its distance along the halfedge from the halfedge's destination. If the right
  /// edge is short, the apex also has a restOfX: the destination must see the apex at its exact
  /// distance, or rays would pass that edge from its far side.
  PointOverHalfedge apex = Vec2{};
  double apexFromEnd;
  /// Unit vectors along the left and the right edge.
  Vec2 leftAxis;
  Vec2 rightAxis;
  /// The angles from the halfedge to these, which windows that carry angles need: findTurns().
  double leftTurn = 0.0;
  double rightTurn = 0.0;

  void findTurns()
  {
    this->leftTurn = std::atan2(this->apex.y, this->apex.x);
    this->rightTurn = -std::atan2(this->apex.y, this->apexFromEnd);
  }

  /// Where the ray of a window through x on the halfedge meets the left edge, as a distance from
  /// the halfedge's origin.
  double meetLeft(const Window& window, double x) const;
  /// Where it meets the right edge, as a distance from the apex.
  double meetRight(const Window& window, double x) const;
  /// The window behind the left edge, on an interval of that edge. The x axis runs from the
  /// halfedge's origin to the apex, with the face below it.
  Window throughLeft(const Window& window, double begin, double end) const;
  /// The window behind the right edge. The x axis runs from the apex to the halfedge's destination.
  Window throughRight(const Window& window, double begin, double end) const;
};

/// Lays out the face of a halfedge, whose length must not be 0.
UnfoldedFace unfold(const TriangleMesh& mesh, Id halfedge);

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

/// The window in another frame, one face farther. Unfolding is a rigid motion: it moves the source,
/// without computing it again from distances.
inline Window moved(const Window& window, Vec2 origin, Vec2 axis)
{
  Window w = window;
  if (window.isLinear())
  {
    w.sigma = window.straightDistance(origin);
    w.place = window.placeOf(origin);
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
  w.facesCrossed = (window.facesCrossed + 1) & MaximumFacesCrossed;
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

}

#endif
