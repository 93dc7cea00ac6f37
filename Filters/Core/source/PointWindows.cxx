// SPDX-License-Identifier: BSD-3-Clause
#include "source/PointWindows.h"

#include "Tolerance.h"
#include "Trigonometry.h"
#include "window/UnfoldedFace.h"

#include <algorithm>
#include <array>

namespace geodesic
{

namespace
{

/// The x axis of a window's frame, as seen from the leaving frame of the halfedge through which the
/// window's rays have left the point's face.
struct WindowFrame
{
  Id leftThrough;
  Vec2 axis = { 1.0, 0.0 };
  /// Whether the leaving frame is seen in a mirror, from a face of opposite orientation.
  bool isMirrored = false;

  /// The frame behind another edge, whose axis is given in this frame.
  WindowFrame turnedBy(Vec2 by) const
  {
    return { this->leftThrough,
      { this->axis.x * by.x - this->axis.y * by.y, this->axis.x * by.y + this->axis.y * by.x },
      this->isMirrored };
  }
  /// The frame of a halfedge that runs the other way.
  WindowFrame mirrored() const
  {
    return { this->leftThrough, { this->axis.x, -this->axis.y }, !this->isMirrored };
  }
  /// Transforms a direction from the halfedge's frame into the window's.
  Vec2 fromHalfedge(Vec2 u) const
  {
    const Vec2 v = { this->isMirrored ? u.x : -u.x, -u.y };
    return { dot(v, this->axis), cross(this->axis, v) };
  }
  Vec2 toHalfedge(Vec2 u) const
  {
    const double x = u.x * this->axis.x - u.y * this->axis.y;
    return { this->isMirrored ? x : -x, -(u.x * this->axis.y + u.y * this->axis.x) };
  }
};

/// Whether a point, in the leaving frame of a halfedge, is close to it and not to its ends.
bool isBesideHalfedge(Vec2 point, double length)
{
  return -point.y <= tolerance::NearEdge * length && point.x > 0.0 && point.x < length;
}

bool isOn(const Barycentric& point, Id halfedge)
{
  return point[(TriangleMesh::indexInFace(halfedge) + 2) % 3] == 0.0;
}

/// The total angle of the faces around a vertex, infinite on the boundary.
double totalAngle(const TriangleMesh& mesh, Id vertex)
{
  double total = 0.0;
  for (const Id corner : mesh.cornersAt(vertex))
  {
    const bool isAtBoundary =
      mesh.isBoundary(corner) || mesh.isBoundary(TriangleMesh::previousInFace(corner));
    total += isAtBoundary ? Infinity : mesh.cornerAngle(corner);
  }
  return total;
}

/// Adds the circular windows of a point through the halfedges of one face.
struct PointEmitter
{
  const TriangleMesh& mesh;
  const SourceInFace& source;
  const CurveWedge& wedge;
  const FanAround& fan;
  SourceWindows& result;
  /// The halfedges through which rays from beside an edge have entered faces: none twice, so
  /// recursion ends.
  std::vector<Id> entered;

  void addThrough(Id halfedge)
  {
    const double length = this->mesh.length(halfedge);
    const Vec2 p = inLeavingFrame(this->mesh, halfedge, this->source.a);
    if (isBesideHalfedge(p, length))
    {
      this->entered.clear();
      this->sendFromBeside(halfedge, p, { 0.0, length }, { halfedge });
      if (this->isInFaceBehind(halfedge, p))
      {
        return;
      }
    }
    const bool isNear = -p.y <= tolerance::NearEdge * length;
    Interval interval{ 0.0, length };
    const auto bounds = this->wedge.equal_range(this->source.face);
    for (auto bound = bounds.first; bound != bounds.second && !isNear; ++bound)
    {
      const Vec2 u = turned(this->mesh, bound->second, halfedge);
      interval.clip(std::abs(u.x) * tolerance::Rounding * length - dot(p, u), u.x);
    }
    const double depth = std::max(-p.y, tolerance::SourceDepth * length);
    std::vector<LeavingWindow> leaving;
    addLeavingWindow(this->mesh, halfedge, interval,
      { 0.0, 0.0, p.x, depth, 0.0, 0.0, Window::Kind::Circular, 0 }, leaving);
    for (const LeavingWindow& window : leaving)
    {
      this->addBySector(window, { halfedge });
    }
  }

  /// Sends the rays of a point near a vertex around it, from face to face, beginning across a
  /// halfedge of the point's own face. The vertex is one end of each halfedge that is crossed. As
  /// seen from the vertex, rays turn by the angle between the point and where they go: by at most
  /// pi, and by no more than in the other direction.
  ///
  /// \param turn from the point to the halfedge.
  /// \param kind of the windows, another one in the other direction.
  void sendAround(const NearVertex& near, Id halfedge, double turn, Window::Kind kind)
  {
    const double total = totalAngle(this->mesh, near.vertex);
    const bool hasShadow = !(total < Infinity) ||
      this->mesh.pseudoSource(near.vertex) == TriangleMesh::PseudoSource::Saddle;
    const double mostTurn = hasShadow ? Pi : 0.5 * total;
    WindowFrame frame = { halfedge };
    while (!this->mesh.isBoundary(halfedge) && turn < mostTurn)
    {
      const double length = this->mesh.length(halfedge);
      const Vec2 p = near.distance * unitVector(turn);
      Window w = { 0.0, length, this->mesh.origin(halfedge) == near.vertex ? length - p.x : p.x,
        std::max(p.y, 0.0), 0.0, 0.0, kind, 0 };
      this->endAt(halfedge, w, frame);

      const Id into = this->mesh.nextSibling(halfedge);
      if (this->mesh.origin(into) == this->mesh.origin(halfedge))
      {
        w.sourceX = length - w.sourceX;
        frame = frame.mirrored();
      }
      const EnteredCorner behind(this->mesh, near.vertex, into);
      const double width = this->mesh.cornerAngle(behind.corner);
      this->passFaceAround(near, { into, w }, { width, mostTurn - turn, hasShadow }, frame);
      halfedge = behind.onward;
      turn += width;
    }
  }

  // Windows at an edge of a near vertex, for points of the face behind it: what leaves that face
  // has windows of its own.
  void endAt(Id halfedge, Window w, const WindowFrame& frame)
  {
    w.endHere();
    this->addBySector({ halfedge, w }, frame);
  }

  /// The angle of a face at a near vertex, how much of it rays may go through, and whether the rest
  /// is in the shadow of the vertex.
  struct Turn
  {
    double width;
    double most;
    bool hasShadow;
  };

  // Sends rays through the edge opposite the vertex; where all of them pass, also to that edge's
  // far end. Replaces the frame by the one behind the other edge at the vertex.
  void passFaceAround(
    const NearVertex& near, const LeavingWindow& entering, const Turn& turn, WindowFrame& frame)
  {
    const Id into = entering.halfedge;
    const Window& w = entering.window;
    const UnfoldedFace face = unfold(this->mesh, into);
    const bool isAtOrigin = this->mesh.origin(into) == near.vertex;
    this->reachApex(near, entering, frame, turn);
    double passed = 1.0; // of the opposite edge
    if (turn.most < turn.width)
    {
      const double before = face.length * unitVector(turn.most).y;
      const double behind =
        (isAtOrigin ? face.leftLength : face.rightLength) * unitVector(turn.width - turn.most).y;
      // An overlap of a few roundings, not a gap.
      passed = std::min(1.0, before / (before + behind) + tolerance::LeastWidth);
    }
    const LeavingWindow leaving = isAtOrigin
      ? LeavingWindow{ TriangleMesh::nextInFace(into),
          face.throughRight(w, (1.0 - passed) * face.rightLength, face.rightLength) }
      : LeavingWindow{ TriangleMesh::previousInFace(into),
          face.throughLeft(w, 0.0, passed * face.leftLength) };
    if (!this->mesh.isBoundary(leaving.halfedge))
    {
      this->addBySector(leaving, frame.turnedBy(isAtOrigin ? face.rightAxis : face.leftAxis));
    }
    frame = frame.turnedBy(isAtOrigin ? face.leftAxis : face.rightAxis);
  }

  // In the shadow of the near vertex the way leads by the vertex, which tells so too late.
  void reachApex(const NearVertex& near, const LeavingWindow& entering, const WindowFrame& frame,
    const Turn& turn)
  {
    LeavingWindow to = entering;
    if (turn.width <= turn.most)
    {
      this->setOrigin(to.window, frame,
        apexOf(this->mesh, to.halfedge) - Vec2{ to.window.sourceX, -to.window.sourceDepth });
    }
    else if (turn.hasShadow)
    {
      const bool isAtOrigin = this->mesh.origin(to.halfedge) == near.vertex;
      to.window.sourceX = isAtOrigin ? 0.0 : to.window.end;
      to.window.sourceDepth = 0.0;
      to.window.sigma = near.distance;
      to.window.origin = RayOrigin::vertex(GlobalId{ near.vertex }); // the patch's number, so far
    }
    else
    {
      return; // rays reach it around the other side
    }
    this->result.toVertices.push_back(to);
  }

  /// Sends the rays of a point close to a halfedge through the faces behind it in one step, between
  /// the rays through the ends of the edge, which hide what lies beside them. Rays continue in the
  /// same way while the point is close to the next edge: around a vertex near the point, or along a
  /// needle.
  ///
  /// \param point in the leaving frame of the halfedge, as seen from the window frame.
  /// \param rays where they meet the halfedge.
  void sendFromBeside(Id halfedge, Vec2 point, const Interval& rays, const WindowFrame& frame)
  {
    const double length = this->mesh.length(halfedge);
    for (Id s = this->mesh.nextSibling(halfedge); s != halfedge; s = this->mesh.nextSibling(s))
    {
      if (std::find(this->entered.begin(), this->entered.end(), s) != this->entered.end())
      {
        continue;
      }
      this->entered.push_back(s);
      const bool isTurned = this->mesh.origin(s) == this->mesh.origin(halfedge);
      const double x = isTurned ? length - point.x : point.x;
      const double begin = isTurned ? length - rays.end : rays.begin;
      const double end = isTurned ? length - rays.begin : rays.end;
      if (this->isInFaceBehind(halfedge, point))
      {
        const Barycentric b = fromHalfedgeFrame(this->mesh, s, { x, 0.0 });
        this->result.inFaces.push_back({ TriangleMesh::faceOf(s), b, b, this->source.curve,
          this->source.parameterOfA, this->source.parameterOfB });
      }
      this->sendThrough(s, { begin, end, x, -point.y, 0.0, 0.0, Window::Kind::Circular, 0 },
        isTurned ? frame.mirrored() : frame);
    }
  }

  void sendThrough(Id halfedge, const Window& w, const WindowFrame& frame)
  {
    const UnfoldedFace face = unfold(this->mesh, halfedge);
    if (norm(face.apex - Vec2{ w.sourceX, -w.sourceDepth }) < tolerance::NearVertex * face.length)
    {
      this->result.nearVertices.push_back({ this->mesh.opposite(halfedge) });
    }
    const bool toLeft = !w.passesRightOf(w.begin, face.apex);
    const bool toRight = w.passesRightOf(w.end, face.apex);
    if (toLeft)
    {
      const double begin = face.meetLeft(w, w.begin);
      const double end = toRight ? face.leftLength : face.meetLeft(w, w.end);
      this->leave({ TriangleMesh::previousInFace(halfedge), face.throughLeft(w, begin, end) },
        frame.turnedBy(face.leftAxis));
    }
    if (toRight)
    {
      const double begin = toLeft ? 0.0 : face.meetRight(w, w.begin);
      const double end = face.meetRight(w, w.end);
      this->leave({ TriangleMesh::nextInFace(halfedge), face.throughRight(w, begin, end) },
        frame.turnedBy(face.rightAxis));
    }
  }

  void leave(LeavingWindow leaving, const WindowFrame& frame)
  {
    Window& w = leaving.window;
    const Id halfedge = leaving.halfedge;
    const double length = this->mesh.length(halfedge);
    const Vec2 point = { w.sourceX, -w.sourceDepth };
    const bool isBeside = isBesideHalfedge(point, length);
    const bool isHidden = isBeside && this->isInFaceBehind(halfedge, point);
    if (!isHidden && !this->mesh.isBoundary(halfedge) && w.end > w.begin)
    {
      w.sourceDepth = std::max(w.sourceDepth, tolerance::SourceDepth * w.end);
      this->addBySector(leaving, frame);
    }
    if (isBeside)
    {
      this->sendFromBeside(halfedge, point, { w.begin, w.end }, frame);
    }
  }

  /// Whether a point beside a halfedge lies on it but for rounding, and its sectors are known in
  /// the face behind it. That face then contains the point, as those around it do.
  bool isInFaceBehind(Id halfedge, Vec2 point) const
  {
    const Id behind = this->mesh.acrossOriented(halfedge);
    return -point.y <= tolerance::PlaceRounding * this->mesh.length(halfedge) && behind != NoId &&
      this->fan.hasFace(TriangleMesh::faceOf(behind));
  }

  // Splits a window where its rays begin to belong to another curve, or to the other side of a
  // curve.
  void addBySector(const LeavingWindow& leaving, const WindowFrame& frame)
  {
    const Window& w = leaving.window;
    std::vector<double> cuts = { w.begin };
    for (const Vec2& change : this->fan.sideChangesIn(frame.leftThrough))
    {
      const Vec2 u = frame.fromHalfedge(change);
      const double x = u.y > 0.0 ? w.sourceX + w.sourceDepth * u.x / u.y : w.begin;
      if (x > w.begin && x < w.end)
      {
        cuts.push_back(x);
      }
    }
    std::sort(cuts.begin(), cuts.end());
    cuts.push_back(w.end);
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
    {
      Window& part = this->result.windows.emplace_back(leaving).window;
      part.begin = cuts[i];
      part.end = cuts[i + 1];
      this->setOrigin(part, frame, part.direction(0.5 * (part.begin + part.end)));
    }
  }

  // By one of its rays.
  void setOrigin(Window& window, const WindowFrame& frame, Vec2 ray) const
  {
    const Vec2 direction = frame.toHalfedge(ray);
    const SideOfCurve at = this->fan.sideOf(frame.leftThrough, direction);
    const bool isFaceMirrored = this->fan.isMirrored(TriangleMesh::faceOf(frame.leftThrough));
    window.origin = RayOrigin::pointSide(at.point, at.isRight, isFaceMirrored != frame.isMirrored);
    window.start = RayStart::atAngle(
      this->fan.angleOf(frame.leftThrough, direction) - angleAround(window.origin, {}, ray));
  }
};

} // anonymous namespace

void addPointWindows(const TriangleMesh& mesh, const SourceInFace& source, const CurveWedge& wedge,
  const FanAround& fan, SourceWindows& result)
{
  PointEmitter emitter{ mesh, source, wedge, fan, result, {} };
  std::array<bool, 3> isDone = {};
  for (const Id corner : TriangleMesh::halfedgesOf(source.face))
  {
    const double weight = source.a[TriangleMesh::indexInFace(corner)];
    if (weight == 1.0 || !(1.0 - weight < tolerance::NearVertex))
    {
      continue; // at the vertex, or not near
    }
    const NearVertex near = nearVertexAt(mesh, corner, source.a);
    result.nearVertices.push_back(near);
    if (near.hasFan())
    {
      const Id other = TriangleMesh::previousInFace(corner);
      const double turn = polarAngle(fromCorner(mesh, corner, source.a));
      const bool isMirrored = fan.isMirrored(source.face);
      if (!isOn(source.a, corner))
      {
        emitter.sendAround(
          near, corner, turn, isMirrored ? Window::Kind::Circular : Window::Kind::CircularAround);
      }
      if (!isOn(source.a, other))
      {
        emitter.sendAround(near, other, mesh.cornerAngle(corner) - turn,
          isMirrored ? Window::Kind::CircularAround : Window::Kind::Circular);
      }
      isDone[TriangleMesh::indexInFace(corner)] = isDone[TriangleMesh::indexInFace(other)] = true;
    }
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Id halfedge = TriangleMesh::halfedgeOf(source.face, k);
    if (!isOn(source.a, halfedge) && !isDone[k] && !mesh.isBoundary(halfedge) &&
      mesh.length(halfedge) > 0.0)
    {
      emitter.addThrough(halfedge);
    }
  }
}

}
