// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_UnfoldedFace_h
#define geodesic_UnfoldedFace_h

#include "Tolerance.h"
#include "Trigonometry.h"
#include "mesh/TriangleMesh.h"
#include "window/Window.h"

namespace geodesic
{

/// The window in another frame, one face farther, on an interval there. Unfolding is a rigid
/// motion: it moves the source, without computing it again from distances.
inline Window moved(const Window& window, Id face, Vec2 origin, Vec2 axis, double begin, double end)
{
  Window w = window;
  w.begin = begin;
  w.end = end;
  if (window.isLinear())
  {
    w.sigma = window.straightDistance(origin);
    w.start = window.startOf(origin);
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
  w.cross(face);
  return w;
}

/// The face of a halfedge, laid into the plane above the halfedge, with what windows need to pass
/// through it (paper, section 3.2, "window propagation"). The apex is the face's third vertex. The
/// left edge runs from the halfedge's origin to the apex, the right edge from the apex to the
/// halfedge's destination.
struct UnfoldedFace
{
  /// By which windows know the face again (Window::crossed); NoId if they need not.
  Id number = NoId;
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
    this->leftTurn = polarAngle(this->apex);
    this->rightTurn = -polarAngle({ this->apexFromEnd, this->apex.y });
  }

  /// Where the ray of a window through x on the halfedge meets the left edge, as a distance from
  /// the halfedge's origin.
  double meetLeft(const Window& window, double x) const
  {
    const Vec2 d = window.direction(x);
    const double denominator = d.y * this->apex.x - d.x * this->apex.y;
    const double t = denominator > 0.0 ? x * d.y / denominator : 0.0;
    return std::clamp(t, 0.0, 1.0) * this->leftLength;
  }
  /// Where it meets the right edge, as a distance from the apex.
  double meetRight(const Window& window, double x) const
  {
    const Vec2 d = window.direction(x);
    const double denominator = d.y * this->apexFromEnd + d.x * this->apex.y;
    const double t = denominator > 0.0 ? (this->length - x) * d.y / denominator : 0.0;
    return (1.0 - std::clamp(t, 0.0, 1.0)) * this->rightLength;
  }

  /// The window behind the left edge, on an interval of that edge. The x axis runs from the
  /// halfedge's origin to the apex, with the face below it.
  Window throughLeft(const Window& window, double begin, double end) const
  {
    return moved(window, this->number, { 0.0, 0.0 }, this->leftAxis, begin, end);
  }
  /// The window behind the right edge. The x axis runs from the apex to the halfedge's destination.
  Window throughRight(const Window& window, double begin, double end) const
  {
    return moved(window, this->number, this->apex, this->rightAxis, begin, end);
  }
};

/// Lays out the face of a halfedge, whose length must not be 0.
inline UnfoldedFace unfold(const TriangleMesh& mesh, Id halfedge)
{
  const FaceShape& shape = mesh.shape(TriangleMesh::faceOf(halfedge));
  const std::size_t k = TriangleMesh::indexInFace(halfedge);
  const std::size_t next = TriangleMesh::nextIndex(halfedge);
  UnfoldedFace face;
  face.length = shape.length[k];
  face.rightLength = shape.length[next];
  face.leftLength = shape.length[TriangleMesh::previousIndex(halfedge)];
  face.apex = Vec2{ shape.cornerDot[k] / face.length, shape.area2 / face.length };
  face.apexFromEnd = shape.cornerDot[next] / face.length;
  if (face.rightLength < tolerance::ShortEdge * face.length)
  {
    face.apex.x = face.length - face.apexFromEnd;
    face.apex.restOfX = face.length - face.apex.x - face.apexFromEnd;
  }
  // An edge without length carries no window, so any axis will do.
  face.leftAxis = face.leftLength > 0.0 ? (1.0 / face.leftLength) * face.apex : Vec2{ 1.0, 0.0 };
  face.rightAxis = face.rightLength > 0.0
    ? (1.0 / face.rightLength) * Vec2{ face.apexFromEnd, -face.apex.y }
    : Vec2{ 1.0, 0.0 };
  return face;
}

}

#endif
