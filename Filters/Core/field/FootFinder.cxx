// SPDX-License-Identifier: BSD-3-Clause
#include "field/FootFinder.h"

#include "Errors.h"
#include "Tolerance.h"

#include <algorithm>
#include <cmath>

namespace geodesic
{

FootFinder::FootFinder(
  const DistanceField& field, const ReplicatedPatch& patch, const std::vector<SourceCurve>& curves)
  : field_(field)
  , curves_(patch, curves)
{
}

PathOrigin FootFinder::originOf(const IncomingSegment& piece)
{
  if (piece.kind == IncomingSegment::Kind::None)
  {
    return {};
  }
  if (piece.kind == IncomingSegment::Kind::Source)
  {
    return this->atSource(piece);
  }
  const RayOrigin origin = piece.origin;
  if (origin.isPoint())
  {
    return { origin, true, RayStart::atAngle(angleAround(origin, piece.start, piece.rayOfWindow)) };
  }
  if (origin.isOnCurve())
  {
    return { origin, false, piece.start };
  }
  const VertexOnCurve* on =
    piece.kind == IncomingSegment::Kind::Corner ? this->onCurveAt(origin.vertex()) : nullptr;
  if (on != nullptr)
  {
    return this->inFanAt(on->point, piece);
  }
  return { origin };
}

// Beside a segment the segment's line separates the sides, at its ends the segments that meet there
// do.
PathOrigin FootFinder::atSource(const IncomingSegment& piece)
{
  const SourceInFace& source = piece.source;
  if (source.isWholeFace)
  {
    const RayOrigin side = RayOrigin::curveSide(source.curve, false);
    return { side, false, RayStart::atParameter(source.parameterOfA) };
  }
  if (piece.along > 0.0 && piece.along < 1.0)
  {
    const double parameter =
      source.parameterOfA + piece.along * (source.parameterOfB - source.parameterOfA);
    const Vec2 along = inHalfedgeFrame(this->field_.mesh(), piece.ray.halfedge, source.b) -
      inHalfedgeFrame(this->field_.mesh(), piece.ray.halfedge, source.a);
    const bool isRight = cross(along, piece.ray.vector) < 0.0;
    return { RayOrigin::curveSide(source.curve, isRight), false, RayStart::atParameter(parameter) };
  }
  const double parameter = piece.along > 0.0 ? source.parameterOfB : source.parameterOfA;
  return this->inFanAt(this->curves_.chains().pointAt(source.curve, parameter), piece);
}

// The piece's direction in the fan of a chain's point: the side that it belongs to, and its angle.
PathOrigin FootFinder::inFanAt(Id point, const IncomingSegment& piece)
{
  const Id face = this->faceOfCurves(TriangleMesh::faceOf(piece.ray.halfedge));
  const Id halfedge = TriangleMesh::inCopy(piece.ray.halfedge, face);
  const Vec2 direction = piece.ray.vector;
  const FanAround& fan = this->fanAt(point);
  const SideOfCurve side = fan.sideOf(halfedge, direction);
  PathOrigin path = { RayOrigin::pointSide(side.point, side.isRight) };
  if (this->field_.hasAngles() && dot(direction, direction) > 0.0 && fan.hasFace(face))
  {
    path.hasAngle = true;
    path.start = RayStart::atAngle(fan.angleOf(halfedge, direction));
  }
  return path;
}

// All curves at a vertex have the same fan there.
const FanAround& FootFinder::fanAt(Id point)
{
  if (const VertexOnCurve* on = this->curves_.vertexAtPlaceOf(point))
  {
    point = on->point;
  }
  if (point != this->fanPoint_)
  {
    this->fan_.emplace(this->meshOfCurves(), this->curves_.placeOf(point));
    this->fanPoint_ = point;
  }
  return *this->fan_;
}

const VertexOnCurve* FootFinder::onCurveAt(GlobalId id) const
{
  return this->curves_.find(this->curves_.patch().vertexAt(id));
}

Foot FootFinder::footOf(const PathOrigin& path) const
{
  Foot foot;
  if (!path.origin.isOnCurve())
  {
    return foot;
  }
  const CurveChains& chains = this->curves_.chains();
  if (path.origin.isPoint())
  {
    const CurveChains::Point point = chains.pointWith(path.origin.point());
    foot.chain = point.chain;
    foot.parameter = chains.parameters(point.chain)[point.i];
    foot.direction = path.hasAngle ? Foot::Direction::AroundPoint : Foot::Direction::None;
    foot.angleInFan = path.start.angle();
  }
  else
  {
    foot.chain = path.origin.curve();
    foot.parameter = path.start.parameter();
    foot.direction = Foot::Direction::AcrossSegment;
  }
  foot.curve = chains.curveAt(foot.chain, foot.parameter);
  foot.isRight = path.origin.isRight() != chains.inChain(foot.curve).isReversed;
  return foot;
}

Foot FootFinder::footAt(const SurfacePoint& last, const SurfacePoint& before, Id face,
  const IncomingSegment& ray, double length)
{
  const TriangleMesh& mesh = this->field_.mesh();
  if (ray.origin.isOnCurve())
  {
    const Foot foot = this->footOf(this->originOf(ray));
    const SurfacePoint end = fromBarycentric(
      this->meshOfCurves(), this->faceOfCurves(face), barycentric(mesh, last, face));
    const double rounding =
      tolerance::Tie * length + tolerance::PlaceRounding * mesh.shape(face).longest();
    if (distanceInSpace(this->meshOfCurves(), this->pointOf(foot), end) <= rounding)
    {
      return foot;
    }
  }
  return this->footOf(this->originAt(last, before, face));
}

PathOrigin FootFinder::originAt(const SurfacePoint& last, const SurfacePoint& before, Id face)
{
  const TriangleMesh& mesh = this->field_.mesh();
  const Barycentric end = barycentric(mesh, last, face);
  const Barycentric from = barycentric(mesh, before, face);
  const Id frame = longestHalfedge(mesh, face);
  IncomingSegment piece;
  const VertexOnCurve* on = last.kind == SurfacePoint::Kind::Vertex
    ? this->onCurveAt(this->field_.surface().globalId(last.id))
    : nullptr;
  if (on != nullptr)
  {
    piece.ray = { frame, wayInFrame(mesh, frame, end, from) };
    return this->inFanAt(on->point, piece);
  }
  // Of the sources at the end, the one that is nearest to the point before.
  const double rounding = tolerance::PlaceRounding * mesh.shape(face).longest();
  double nearest = Infinity;
  for (const SourceInFace& source : this->field_.sourcesIn(face))
  {
    const Barycentric begin = nearestOnSource(mesh, source, from);
    const double length = distanceInFace(mesh, face, begin, from);
    if (length <= nearest && distanceInFace(mesh, face, begin, end) <= rounding)
    {
      nearest = length;
      piece.source = source;
      piece.along = nearestAlongSource(mesh, source, from);
      piece.ray = { frame, wayInFrame(mesh, frame, begin, from) };
    }
  }
  return nearest < Infinity ? this->atSource(piece) : PathOrigin();
}

/// A face of the field's mesh on the patch.
Id FootFinder::faceOfCurves(Id face) const
{
  return this->curves_.patch().faceAt(this->field_.surface().addressOf(face));
}

SurfacePoint FootFinder::pointOf(const Foot& foot) const
{
  const SourceCurve& curve = this->curves_.chains().curves()[foot.chain];
  const std::vector<double>& parameters = this->curves_.chains().parameters(foot.chain);
  const auto behind = std::upper_bound(parameters.begin(), parameters.end(), foot.parameter);
  if (behind == parameters.begin())
  {
    return curve.points.front();
  }
  const auto i = static_cast<std::size_t>(behind - parameters.begin()) - 1;
  if (i + 1 == parameters.size() || foot.parameter == parameters[i])
  {
    return curve.points[i];
  }
  const double t = (foot.parameter - parameters[i]) / (parameters[i + 1] - parameters[i]);
  const Id face = curve.faces[i];
  const Barycentric a = barycentric(this->meshOfCurves(), curve.points[i], face);
  const Barycentric b = barycentric(this->meshOfCurves(), curve.points[i + 1], face);
  return fromBarycentric(this->meshOfCurves(), face, between(a, b, t));
}

std::vector<double> FootFinder::arcLengthsOf(Id curve) const
{
  const CurveChains::CurveInChain& part = this->curves_.chains().inChain(curve);
  const std::vector<double>& parameters = this->curves_.chains().parameters(part.chain);
  std::vector<double> lengths;
  for (std::size_t i = part.begin; i <= part.end; ++i)
  {
    lengths.push_back(this->curves_.chains().arcLength(curve, parameters[i]));
  }
  if (part.isReversed)
  {
    std::reverse(lengths.begin(), lengths.end());
  }
  return lengths;
}

double FootFinder::angleOf(const Foot& foot)
{
  if (!this->field_.hasAngles())
  {
    throw Error("The angle of a path was asked for, but the solve did not keep angles.");
  }
  if (foot.direction == Foot::Direction::AcrossSegment)
  {
    return foot.isRight ? -RightAngle : RightAngle;
  }
  if (foot.direction == Foot::Direction::None)
  {
    return 0.0;
  }
  const CurveChains& chains = this->curves_.chains();
  const FanAround& fan = this->fanAt(chains.pointAt(foot.chain, foot.parameter));
  return chains.angleFrom(foot.curve, fan.angleFromCurve(foot.angleInFan));
}

}
