// SPDX-License-Identifier: BSD-3-Clause
#include "field/FootFinder.h"

#include "Errors.h"

#include <algorithm>
#include <cmath>

namespace geodesic
{

FootFinder::FootFinder(
  const DistanceField& field, const ReplicatedPatch& patch, const std::vector<SourceCurve>& curves)
  : field_(field)
  , curves_(patch, curves)
  , sectors_(patch.mesh())
  , directions_(patch.mesh())
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
    return { origin, RayStart::atAngle(angleAround(origin, piece.start, piece.rayOfWindow)) };
  }
  if (origin.isOnCurve())
  {
    return { origin, piece.start };
  }
  const VertexOnCurve* on =
    piece.kind == IncomingSegment::Kind::Corner ? this->onCurveAt(origin.vertex()) : nullptr;
  if (on != nullptr)
  {
    this->goToVertex(on->vertex);
    return this->inSector(piece);
  }
  return { origin };
}

// Beside a segment the segment's line separates the sides, at its ends the segments that meet there
// do.
PathOrigin FootFinder::atSource(const IncomingSegment& piece)
{
  const SourceInFace& source = piece.source;
  if (piece.along > 0.0 && piece.along < 1.0)
  {
    const double parameter =
      source.parameterOfA + piece.along * (source.parameterOfB - source.parameterOfA);
    const Vec2 along = inHalfedgeFrame(this->field_.mesh(), piece.ray.halfedge, source.b) -
      inHalfedgeFrame(this->field_.mesh(), piece.ray.halfedge, source.a);
    const bool isRight = cross(along, piece.ray.direction) < 0.0;
    return { RayOrigin::curveSide(source.curve, isRight), RayStart::atParameter(parameter) };
  }
  const double parameter = piece.along > 0.0 ? source.parameterOfB : source.parameterOfA;
  this->goToPoint(this->curves_.chains().pointAt(source.curve, parameter));
  return this->inSector(piece);
}

// The curve and the side to which the piece's direction belongs at the current point.
PathOrigin FootFinder::inSector(const IncomingSegment& piece)
{
  const Id face = this->curves_.patch().faceAt(
    this->field_.surface().addressOf(TriangleMesh::faceOf(piece.ray.halfedge)));
  const Id halfedge = TriangleMesh::inCopy(piece.ray.halfedge, face);
  const SideOfCurve side = this->sectors_.of(halfedge, piece.ray.direction);
  double around = Infinity;
  if (this->field_.hasAngles() && dot(piece.ray.direction, piece.ray.direction) > 0.0)
  {
    this->goAround(this->curves_.chains().pointAt(side.curve, side.parameter));
    around = this->directions_.around(halfedge, piece.ray.direction);
  }
  return this->atPoint(side, around);
}

PathOrigin FootFinder::atPoint(const SideOfCurve& side, double around) const
{
  const Id point = this->curves_.chains().pointAt(side.curve, side.parameter);
  return { RayOrigin::pointSide(point, side.isRight), RayStart::atAngle(around) };
}

void FootFinder::goAround(Id number)
{
  if (number != this->directionsPoint_)
  {
    const PointWithEnds at = this->curves_.around(number);
    this->directions_.assign(at.point, at.ends);
    this->directionsPoint_ = number;
  }
}

const VertexOnCurve* FootFinder::onCurveAt(Id globalId) const
{
  return this->curves_.find(this->curves_.patch().vertexAt(globalId));
}

void FootFinder::goToVertex(Id vertex)
{
  if (vertex != this->sectorsVertex_)
  {
    const VertexOnCurve& on = *this->curves_.find(vertex);
    this->sectors_.assign(
      SurfacePoint::atVertex(vertex), this->curves_.endsAround(vertex), on.curve, on.parameter);
    this->sectorsVertex_ = vertex;
  }
}

void FootFinder::goToPoint(Id number)
{
  const PointWithEnds at = this->curves_.around(number);
  if (at.point.kind == SurfacePoint::Kind::Vertex)
  {
    this->goToVertex(at.point.id);
    return;
  }
  const CurveChains::Point point = this->curves_.chains().pointWith(number);
  const double parameter = this->curves_.chains().parameters(point.chain)[point.i];
  this->sectors_.assign(at.point, at.ends, point.chain, parameter);
  this->sectorsVertex_ = NoId;
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
    foot.around = path.start.angle();
  }
  else
  {
    foot.chain = path.origin.curve();
    foot.parameter = path.start.parameter();
  }
  foot.curve = chains.curveAt(foot.chain, foot.parameter);
  foot.isRight = path.origin.isRight() != chains.inChain(foot.curve).isReversed;
  return foot;
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
  if (std::isnan(foot.around))
  {
    return foot.isRight ? -RightAngle : RightAngle;
  }
  if (!(std::abs(foot.around) < Infinity))
  {
    return 0.0;
  }
  this->goAround(this->curves_.chains().pointAt(foot.chain, foot.parameter));
  return this->curves_.chains().angleFrom(foot.curve, this->directions_.angleOf(foot.around));
}

}
