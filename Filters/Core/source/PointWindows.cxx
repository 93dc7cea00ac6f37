// SPDX-License-Identifier: BSD-3-Clause
#include "source/PointWindows.h"

#include "Tolerance.h"
#include "window/UnfoldedFace.h"

#include <algorithm>

namespace geodesic
{

namespace
{

Vec2 directionInLeavingFrame(const TriangleMesh& mesh, Id halfedge, const WedgeBound& bound)
{
  const Vec2 u = turned(mesh, bound.direction, bound.halfedge, halfedge);
  return { -u.x, -u.y };
}

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

/// The origin and the place of a window, by one of its rays.
CurveOrigin originOf(
  const TriangleMesh& mesh, const EmittingPoint& from, const WindowFrame& frame, Vec2 ray)
{
  const Vec2 direction = frame.toHalfedge(ray);
  const CurveOrigin place = from.sectors.of(frame.leftThrough, direction);
  const CurveSide side = CurveSide::of(place.origin, mesh.numberOfVertices());
  const bool isFaceMirrored = from.directions.isMirrored(TriangleMesh::faceOf(frame.leftThrough));
  const PointSide point = { from.chains.pointAt(side.curve, place.place), side.isRight,
    isFaceMirrored != frame.isMirrored };
  const auto curves = static_cast<Id>(from.chains.curves().size());
  const Id origin = point.origin(PointSide::first(mesh.numberOfVertices(), curves));
  const double around = from.directions.around(frame.leftThrough, direction);
  return { origin, around - angleAround(origin, 0.0, ray) };
}

// Splits the windows of a point where their rays begin to belong to another curve, or to the other
// side of a curve.
void addBySector(const TriangleMesh& mesh, const EmittingPoint& point, const WindowFrame& frame,
  const LeavingWindow& leaving, std::vector<LeavingWindow>& windows)
{
  const Window& w = leaving.window;
  std::vector<double> cuts = { w.begin };
  for (const Vec2& change : point.sectors.changesIn(frame.leftThrough))
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
    Window part = w;
    part.begin = cuts[i];
    part.end = cuts[i + 1];
    const CurveOrigin from =
      originOf(mesh, point, frame, w.direction(0.5 * (part.begin + part.end)));
    part.origin = from.origin;
    part.place = from.place;
    windows.push_back({ leaving.halfedge, part });
  }
}

/// Whether a point, in the leaving frame of a halfedge, is close to it and not to its ends.
bool isBesideHalfedge(Vec2 point, double length)
{
  return -point.y <= tolerance::NearEdge * length && point.x > 0.0 && point.x < length;
}

/// Whether such a point lies on the halfedge but for rounding, and its sectors are known in the
/// face behind it. That face then contains the point, as those around it do.
bool isInFaceBehind(const TriangleMesh& mesh, Id halfedge, Vec2 point, const CurveSectors& sectors)
{
  const Id behind = mesh.acrossOriented(halfedge);
  return -point.y <= tolerance::PlaceRounding * mesh.length(halfedge) && behind != NoId &&
    sectors.haveFace(TriangleMesh::faceOf(behind));
}

/// Sends the rays of a point close to a halfedge through the faces behind it in one step, between
/// the rays through the ends of the edge, which hide what lies beside them. Rays continue in the
/// same way while the point is close to the next edge: around a vertex near the point, along a
/// needle, through a face without area.
class RaysFromBesideEdge
{
public:
  RaysFromBesideEdge(const TriangleMesh& mesh, const SourceInFace& source,
    const EmittingPoint& from, SourceWindows& result)
    : mesh_(mesh)
    , source_(source)
    , from_(from)
    , result_(result)
  {
  }

  /// \param point in the leaving frame of the halfedge, as seen from the window frame.
  /// \param rays where they meet the halfedge.
  void send(Id halfedge, Vec2 point, const Interval& rays, const WindowFrame& frame)
  {
    const double length = this->mesh_.length(halfedge);
    for (Id s = this->mesh_.nextSibling(halfedge); s != halfedge; s = this->mesh_.nextSibling(s))
    {
      if (std::find(this->entered_.begin(), this->entered_.end(), s) == this->entered_.end())
      {
        this->entered_.push_back(s);
        const bool turned = this->mesh_.origin(s) == this->mesh_.origin(halfedge);
        const double x = turned ? length - point.x : point.x;
        const double begin = turned ? length - rays.end : rays.begin;
        const double end = turned ? length - rays.begin : rays.end;
        if (isInFaceBehind(this->mesh_, halfedge, point, this->from_.sectors))
        {
          this->addSource(s, x);
        }
        this->sendThrough(s, { begin, end, x, -point.y, 0.0, 0.0, Window::Kind::Circular, 0 },
          turned ? frame.mirrored() : frame);
      }
    }
  }

private:
  // The face of the halfedge contains the point, which lies at x.
  void addSource(Id halfedge, double x)
  {
    const Barycentric b = fromHalfedgeFrame(this->mesh_, halfedge, { x, 0.0 });
    SourceInFace& source = this->result_.inFaces.emplace_back(this->source_);
    source.face = TriangleMesh::faceOf(halfedge);
    source.a = b;
    source.b = b;
  }

  void sendThrough(Id halfedge, const Window& w, const WindowFrame& frame)
  {
    const UnfoldedFace face = unfold(this->mesh_, halfedge);
    if (norm(face.apex - Vec2{ w.sourceX, -w.sourceDepth }) < tolerance::NearVertex * face.length)
    {
      this->result_.nearVertices.push_back(this->mesh_.opposite(halfedge));
    }
    // In a face without area all rays run along its edges, so they do not determine a direction.
    Window seen = w;
    seen.sourceDepth = face.apex.y > 0.0
      ? w.sourceDepth
      : std::max(w.sourceDepth, tolerance::SourceDepth * face.length);
    const bool toLeft = !seen.passesRightOf(w.begin, face.apex);
    const bool toRight = seen.passesRightOf(w.end, face.apex);
    if (toLeft)
    {
      const double begin = face.meetLeft(seen, w.begin);
      const double end = toRight ? face.leftLength : face.meetLeft(seen, w.end);
      this->leave({ TriangleMesh::previousInFace(halfedge), face.throughLeft(w, begin, end) },
        frame.turnedBy(face.leftAxis));
    }
    if (toRight)
    {
      const double begin = toLeft ? 0.0 : face.meetRight(seen, w.begin);
      const double end = face.meetRight(seen, w.end);
      this->leave({ TriangleMesh::nextInFace(halfedge), face.throughRight(w, begin, end) },
        frame.turnedBy(face.rightAxis));
    }
  }

  void leave(LeavingWindow leaving, const WindowFrame& frame)
  {
    Window& w = leaving.window;
    const Id halfedge = leaving.halfedge;
    const double length = this->mesh_.length(halfedge);
    const Vec2 point = { w.sourceX, -w.sourceDepth };
    const bool isBeside = isBesideHalfedge(point, length);
    const bool isHidden =
      isBeside && isInFaceBehind(this->mesh_, halfedge, point, this->from_.sectors);
    if (!isHidden && !this->mesh_.isBoundary(halfedge) && w.end > w.begin)
    {
      w.sourceDepth = std::max(w.sourceDepth, tolerance::SourceDepth * w.end);
      addBySector(this->mesh_, this->from_, frame, leaving, this->result_.windows);
    }
    if (isBeside)
    {
      // In a face without area rays have no direction that would hold them between bounds.
      const bool isLine = this->mesh_.shape(TriangleMesh::faceOf(halfedge)).hasZeroArea();
      this->send(
        halfedge, point, isLine ? Interval{ 0.0, length } : Interval{ w.begin, w.end }, frame);
    }
  }

  const TriangleMesh& mesh_;
  const SourceInFace& source_;
  const EmittingPoint& from_;
  SourceWindows& result_;
  /// The halfedges through which rays have entered faces: none twice, so recursion ends.
  std::vector<Id> entered_;
};

void addThroughHalfedge(const TriangleMesh& mesh, Id halfedge, const SourceInFace& source,
  const EmittingPoint& from, SourceWindows& result)
{
  const double length = mesh.length(halfedge);
  const Vec2 p = inLeavingFrame(mesh, halfedge, source.a);
  if (isBesideHalfedge(p, length))
  {
    RaysFromBesideEdge(mesh, source, from, result).send(halfedge, p, { 0.0, length }, { halfedge });
    if (isInFaceBehind(mesh, halfedge, p, from.sectors))
    {
      return;
    }
  }
  const bool near = -p.y <= tolerance::NearEdge * length;
  Interval interval{ 0.0, length };
  const auto bounds = from.wedge.equal_range(source.face);
  for (auto bound = bounds.first; bound != bounds.second && !near; ++bound)
  {
    const Vec2 u = directionInLeavingFrame(mesh, halfedge, bound->second);
    interval.clip(dot(p, u) + std::abs(u.x) * tolerance::Rounding * length, -u.x);
  }
  const double depth = std::max(-p.y, tolerance::SourceDepth * length);
  std::vector<LeavingWindow> leaving;
  addLeavingWindow(mesh, halfedge, interval,
    { 0.0, 0.0, p.x, depth, 0.0, 0.0, Window::Kind::Circular, 0 }, leaving);
  for (const LeavingWindow& window : leaving)
  {
    addBySector(mesh, from, { halfedge }, window, result.windows);
  }
}

} // anonymous namespace

void addPointWindows(const TriangleMesh& mesh, const SourceInFace& source,
  const EmittingPoint& from, SourceWindows& result)
{
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Id halfedge = 3 * source.face + static_cast<Id>(k);
    const bool isOnIt = source.a[(k + 2) % 3] == 0.0;
    if (!isOnIt && !mesh.isBoundary(halfedge) && mesh.length(halfedge) > 0.0)
    {
      addThroughHalfedge(mesh, halfedge, source, from, result);
    }
  }
}

}
