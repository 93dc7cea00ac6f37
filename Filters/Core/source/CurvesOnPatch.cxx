// SPDX-License-Identifier: BSD-3-Clause
#include "source/CurvesOnPatch.h"

#include "Tolerance.h"

#include <algorithm>
#include <tuple>

namespace geodesic
{

namespace
{

constexpr std::size_t None = static_cast<std::size_t>(-1);

/// A step from a point of a curve to the next or the previous one. Segment i runs from point i to
/// point i + 1.
struct Step
{
  std::size_t segment = None;
  std::size_t to = None;
};

/// Its segment is None behind the end of an open curve.
Step stepFrom(const SourceCurve& curve, std::size_t i, bool isForward)
{
  const std::size_t last = curve.points.size() - 1;
  if (isForward)
  {
    return i < last ? Step{ i, i + 1 } : curve.isClosed() ? Step{ 0, 1 } : Step{};
  }
  return i > 0 ? Step{ i - 1, i - 1 } : curve.isClosed() ? Step{ last - 1, last - 1 } : Step{};
}

/// Whether the segment is longer than the rounding of its ends, or than a larger fraction of its
/// face.
bool hasLength(const TriangleMesh& mesh, const SourceCurve& curve, std::size_t segment,
  double fraction = tolerance::PlaceRounding)
{
  return lengthOfSegment(mesh, curve, segment) >
    fraction * mesh.shape(curve.faces[segment]).longest();
}

/// Whether the ends of a segment determine its direction. Where the curve is merely cut, the next
/// segment determines the direction better than a short one.
bool tellsDirection(const TriangleMesh& mesh, const SourceCurve& curve, const Step& step)
{
  return curve.isCut[step.to] ? hasLength(mesh, curve, step.segment, tolerance::NearEdge)
                              : hasLength(mesh, curve, step.segment);
}

/// Point i and those at its place that follow it in one direction.
std::vector<std::size_t> pointsAtOnePlace(
  const TriangleMesh& mesh, const SourceCurve& curve, std::size_t i, bool isForward)
{
  std::vector<std::size_t> points = { i };
  for (Step step = stepFrom(curve, i, isForward); points.size() <= curve.faces.size() &&
       step.segment != None && !hasLength(mesh, curve, step.segment);
       step = stepFrom(curve, step.to, isForward))
  {
    points.push_back(step.to);
  }
  return points;
}

/// The steps from a given one, across edges, to the first that determines a direction. If the curve
/// ends or reaches a vertex before, the given step alone, or nothing if it determines no direction.
std::vector<Step> stepsOnward(
  const TriangleMesh& mesh, const SourceCurve& curve, const Step& first, bool isForward)
{
  std::vector<Step> steps = { first };
  while (!tellsDirection(mesh, curve, steps.back()))
  {
    const SurfacePoint& p = curve.points[steps.back().to];
    const Step next = stepFrom(curve, steps.back().to, isForward);
    if (next.segment == None || p.kind != SurfacePoint::Kind::Edge || !mesh.isInner(p.id) ||
      steps.size() == curve.faces.size())
    {
      return hasLength(mesh, curve, first.segment) ? std::vector<Step>{ first }
                                                   : std::vector<Step>();
    }
    steps.push_back(next);
  }
  return steps;
}

/// The direction of the last of some steps in the face of the first, transformed back from face to
/// face over the edges.
FaceDirection onwardBehind(
  const TriangleMesh& mesh, const SourceCurve& curve, const std::vector<Step>& steps)
{
  const Id frame = longestHalfedge(mesh, curve.faces[steps.back().segment]);
  FaceDirection onward = { frame,
    inHalfedgeFrame(mesh, frame, curve.points[steps.back().to]) -
      inHalfedgeFrame(mesh, frame, curve.points[steps[steps.size() - 2].to]) };
  for (std::size_t n = steps.size() - 1; n-- > 0;)
  {
    const SurfacePoint& p = curve.points[steps[n].to];
    const Id own = mesh.siblingInFace(p.id, curve.faces[steps[n].segment]);
    const Id other = mesh.siblingInFace(p.id, curve.faces[steps[n + 1].segment]);
    onward = { other, turned(mesh, onward, other) };
    onward = own == other ? onward : acrossEdge(mesh, onward, own);
  }
  return onward;
}

/// Adds the end at a point of the segment towards the next or the previous one.
void addEnd(const TriangleMesh& mesh, const CurveChains& chains, const CurveChains::Point& at,
  bool isForward, std::vector<SegmentEnd>& ends)
{
  const SourceCurve& curve = chains.curves()[at.chain];
  const Step step = stepFrom(curve, at.i, isForward);
  const std::vector<Step> steps =
    step.segment != None ? stepsOnward(mesh, curve, step, isForward) : std::vector<Step>();
  if (!steps.empty())
  {
    ends.push_back(
      { curve.points[at.i], curve.points[step.to], curve.faces[step.segment], chains.numberOf(at),
        isForward, steps.size() > 1 ? onwardBehind(mesh, curve, steps) : FaceDirection() });
  }
}

} // anonymous namespace

CurvesOnPatch::CurvesOnPatch(const ReplicatedPatch& patch, const std::vector<SourceCurve>& curves)
  : patch_(patch)
  , chains_(patch.mesh(), curves)
{
  for (Id chain = 0; chain < this->chains_.curves().size(); ++chain)
  {
    const SourceCurve& curve = this->chains_.curves()[chain];
    const std::size_t count = curve.points.size() - (curve.isClosed() ? 1 : 0);
    for (std::size_t i = 0; i < count; ++i)
    {
      if (curve.points[i].kind == SurfacePoint::Kind::Vertex)
      {
        this->vertices_.push_back({ curve.points[i].id, this->chains_.numberOf({ chain, i }) });
      }
    }
  }
  std::stable_sort(this->vertices_.begin(), this->vertices_.end());
}

const VertexOnCurve* CurvesOnPatch::find(Id vertex) const
{
  const Id i = indexIn(this->vertices_, VertexOnCurve{ vertex });
  return i != NoId ? &this->vertices_[i] : nullptr;
}

std::vector<SegmentEnd> CurvesOnPatch::endsAt(Id point) const
{
  std::vector<SegmentEnd> ends;
  const CurveChains::Point at = this->chains_.pointWith(point);
  addEnd(this->mesh(), this->chains_, at, true, ends);
  addEnd(this->mesh(), this->chains_, at, false, ends);
  return ends;
}

std::vector<SegmentEnd> CurvesOnPatch::endsAtVertex(Id vertex) const
{
  return this->ofAllCurvesAt(vertex, &CurvesOnPatch::endsAt);
}

// Those of the last points at the place in both directions.
std::vector<SegmentEnd> CurvesOnPatch::endsAtPlaceOf(Id point) const
{
  std::vector<SegmentEnd> ends;
  const CurveChains::Point at = this->chains_.pointWith(point);
  const SourceCurve& curve = this->chains_.curves()[at.chain];
  for (const bool isForward : { true, false })
  {
    const std::size_t last = pointsAtOnePlace(this->mesh(), curve, at.i, isForward).back();
    addEnd(this->mesh(), this->chains_, { at.chain, last }, isForward, ends);
  }
  return ends;
}

// Several points of a curve may be at one vertex: their ends are the same.
std::vector<SegmentEnd> CurvesOnPatch::ofAllCurvesAt(Id vertex, EndsAtPoint endsOfPoint) const
{
  std::vector<SegmentEnd> ends;
  const auto range =
    std::equal_range(this->vertices_.begin(), this->vertices_.end(), VertexOnCurve{ vertex });
  for (auto on = range.first; on != range.second; ++on)
  {
    const std::vector<SegmentEnd> added = (this->*endsOfPoint)(on->point);
    ends.insert(ends.end(), added.begin(), added.end());
  }
  const auto isLess = [](const SegmentEnd& a, const SegmentEnd& b)
  {
    return std::make_tuple(a.face, a.to.members(), a.point) <
      std::make_tuple(b.face, b.to.members(), b.point);
  };
  std::stable_sort(ends.begin(), ends.end(), isLess);
  const auto isSame = [&](const SegmentEnd& a, const SegmentEnd& b) { return !isLess(a, b); };
  ends.erase(std::unique(ends.begin(), ends.end(), isSame), ends.end());
  return ends;
}

const VertexOnCurve* CurvesOnPatch::vertexAtPlaceOf(Id point) const
{
  const CurveChains::Point at = this->chains_.pointWith(point);
  const SourceCurve& curve = this->chains_.curves()[at.chain];
  const auto vertexOf = [&curve](std::size_t i)
  { return curve.points[i].kind == SurfacePoint::Kind::Vertex ? curve.points[i].id : NoId; };
  Id vertex = vertexOf(at.i);
  for (const bool isForward : { true, false })
  {
    for (const std::size_t i : pointsAtOnePlace(this->mesh(), curve, at.i, isForward))
    {
      vertex = vertexOf(at.i) != NoId ? vertex : std::min(vertex, vertexOf(i));
    }
  }
  return vertex != NoId ? this->find(vertex) : nullptr;
}

PointOfSource CurvesOnPatch::placeOf(Id point) const
{
  if (const VertexOnCurve* on = this->vertexAtPlaceOf(point))
  {
    return { SurfacePoint::atVertex(on->vertex),
      this->ofAllCurvesAt(on->vertex, &CurvesOnPatch::endsAtPlaceOf), on->point };
  }
  const CurveChains::Point at = this->chains_.pointWith(point);
  return { this->chains_.curves()[at.chain].points[at.i], this->endsAtPlaceOf(point), point };
}

SourceFrame CurvesOnPatch::frameOf(Id number) const
{
  const TriangleMesh& mesh = this->mesh();
  const CurveChains::CurveInChain& part = this->chains_.inChain(number);
  const SourceCurve& curve = this->chains_.curves()[part.chain];
  SourceFrame frame;
  if (part.begin == part.end)
  {
    const FanAround::Axis axis =
      FanAround(mesh, this->placeOf(this->chains_.numberOf({ part.chain, part.begin }))).axis();
    frame.x = inSpace(mesh, axis.halfedge, { axis.isAgainst ? -1.0 : 1.0, 0.0 });
    frame.y = inSpace(mesh, axis.halfedge, { 0.0, 1.0 });
  }
  else
  {
    const std::size_t first = part.isReversed ? part.end : part.begin;
    const std::size_t second = part.isReversed ? part.end - 1 : part.begin + 1;
    const Id halfedge = longestHalfedge(mesh, curve.faces[std::min(first, second)]);
    const Vec2 d = inHalfedgeFrame(mesh, halfedge, curve.points[second]) -
      inHalfedgeFrame(mesh, halfedge, curve.points[first]);
    frame.x = inSpace(mesh, halfedge, d);
    frame.y = inSpace(mesh, halfedge, { -d.y, d.x });
  }
  frame.normal = cross(frame.x, frame.y);
  return frame;
}

}
