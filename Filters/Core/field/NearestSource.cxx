// SPDX-License-Identifier: BSD-3-Clause
#include "field/NearestSource.h"

#include "Errors.h"
#include "Tolerance.h"
#include "field/NearestSourceOnRanks.h"

#include <algorithm>

namespace geodesic
{

NearestSource::NearestSource(const DistanceField& field, const ReplicatedPatch& patch,
  const std::vector<SourceCurve>& curves, const Job& job)
  : field_(field)
  , mesh_(field.mesh())
  , curves_(patch, curves)
  , origins_(field.mesh().numberOfVertices())
{
  const MeshPartition& part = field.surface();
  for (const VertexOnCurve& on : this->curves_.vertices())
  {
    const Id vertex = part.countedVertex(patch.globalId(on.vertex));
    if (vertex != NoId)
    {
      this->origins_[vertex] = this->atPoint({ on.curve, false, on.parameter });
    }
  }
  for (Id vertex = 0; vertex < part.numberOfOwnVertices(); ++vertex)
  {
    job.reachItem(vertex, part.numberOfOwnVertices());
    if (part.isCountedHere(vertex) && field.vertexDistances()[vertex] < Infinity)
    {
      this->follow(vertex);
    }
  }
  this->elsewhere_ = originsElsewhere(this->field_, this->origins_);
}

// The last piece of the path to a vertex. If it comes through a window and cannot bend at a corner,
// its direction is left out, so that no face need be looked at. The window's ray is its direction,
// unless the source is so near to the halfedge that rounding of the crossing turns the ray.
IncomingSegment NearestSource::originTo(Id vertex) const
{
  const Arrival& arrival = this->field_.arrivals()[vertex];
  const auto isNear = [&]
  { return norm(arrival.direction) < tolerance::NearEdge * this->mesh_.length(arrival.halfedge); };
  if (!arrival.isThroughWindow() || isNear() || cornerCrossed(this->mesh_, arrival) != NoId)
  {
    return incomingSegmentTo(this->field_, SurfacePoint::atVertex(vertex));
  }
  IncomingSegment piece;
  piece.kind = IncomingSegment::Kind::Window;
  piece.origin = arrival.origin;
  piece.start = arrival.start;
  piece.rayOfWindow = arrival.direction;
  return piece;
}

// Follows the path back from pseudo-source to pseudo-source; all vertices on the way get the origin
// that is found. The way ends at a vertex that another rank counts, and where vertices at one place
// name each other.
void NearestSource::follow(Id vertex)
{
  std::vector<Id> way;
  PathOrigin found = this->origins_[vertex];
  while (!found.origin.isKnown())
  {
    const IncomingSegment piece = this->originTo(vertex);
    way.push_back(vertex);
    if (this->isFromCurve(piece))
    {
      found = this->originOf(piece);
      break;
    }
    vertex = this->field_.surface().countedVertex(piece.origin.vertex());
    if (vertex == NoId)
    {
      found = { piece.origin };
      break;
    }
    found = this->origins_[vertex];
    if (std::find(way.begin(), way.end(), vertex) != way.end())
    {
      break;
    }
  }
  for (const Id passed : way)
  {
    this->origins_[passed] = found;
  }
}

// Whether the piece begins on a curve, not at a pseudo-source.
bool NearestSource::isFromCurve(const IncomingSegment& piece) const
{
  return piece.kind == IncomingSegment::Kind::Corner
    ? this->onCurveAt(piece.origin.vertex()) != nullptr
    : piece.kind != IncomingSegment::Kind::Window || piece.origin.isOnCurve();
}

PathOrigin NearestSource::originOf(const IncomingSegment& piece)
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
    return this->inFanAt(on->curve, on->parameter, piece);
  }
  return this->ofVertex(origin.vertex());
}

// Beside a segment the segment's line separates the sides, at its ends the segments that meet there
// do.
PathOrigin NearestSource::atSource(const IncomingSegment& piece)
{
  const SourceInFace& source = piece.source;
  if (piece.along > 0.0 && piece.along < 1.0)
  {
    const double parameter =
      source.parameterOfA + piece.along * (source.parameterOfB - source.parameterOfA);
    const Vec2 along = inHalfedgeFrame(this->mesh_, piece.ray.halfedge, source.b) -
      inHalfedgeFrame(this->mesh_, piece.ray.halfedge, source.a);
    const bool isRight = cross(along, piece.ray.direction) < 0.0;
    return { RayOrigin::curveSide(source.curve, isRight), false, RayStart::atParameter(parameter) };
  }
  return this->inFanAt(
    source.curve, piece.along > 0.0 ? source.parameterOfB : source.parameterOfA, piece);
}

// The piece's direction in the fan of a chain's point: the side that it belongs to, and its angle.
PathOrigin NearestSource::inFanAt(Id chain, double parameter, const IncomingSegment& piece)
{
  const Id face = this->curves_.patch().faceAt(
    this->field_.surface().addressOf(TriangleMesh::faceOf(piece.ray.halfedge)));
  const Id halfedge = TriangleMesh::inCopy(piece.ray.halfedge, face);
  const Vec2 direction = piece.ray.direction;
  const FanAround& fan = this->fanAt(chain, parameter);
  PathOrigin path = this->atPoint(fan.sideOf(halfedge, direction));
  if (this->field_.hasAngles() && dot(direction, direction) > 0.0 && fan.hasFace(face))
  {
    path.hasAngle = true;
    path.start = RayStart::atAngle(fan.angleOf(halfedge, direction));
  }
  return path;
}

PathOrigin NearestSource::atPoint(const SideOfCurve& side) const
{
  const Id point = this->curves_.chains().pointAt(side.curve, side.parameter);
  return { RayOrigin::pointSide(point, side.isRight) };
}

// All curves at a vertex have the same fan there.
const FanAround& NearestSource::fanAt(Id chain, double parameter)
{
  const CurveChains& chains = this->curves_.chains();
  Id number = chains.pointAt(chain, parameter);
  if (const VertexOnCurve* on = this->curves_.vertexAtPlaceOf(chains.pointWith(number)))
  {
    number = chains.pointAt(on->curve, on->parameter);
  }
  if (number != this->fanPoint_)
  {
    this->fan_.emplace(this->meshOfCurves(), this->curves_.placeOf(chains.pointWith(number)));
    this->fanPoint_ = number;
  }
  return *this->fan_;
}

PathOrigin NearestSource::ofVertex(Id globalId) const
{
  const Id vertex = this->field_.surface().countedVertex(globalId);
  if (vertex != NoId)
  {
    return this->origins_[vertex];
  }
  const auto found = this->elsewhere_.find(globalId);
  return found != this->elsewhere_.end() ? found->second : PathOrigin();
}

const VertexOnCurve* NearestSource::onCurveAt(Id globalId) const
{
  return this->curves_.find(this->curves_.patch().vertexAt(globalId));
}

Foot NearestSource::footOf(const PathOrigin& path) const
{
  Foot foot;
  if (!path.origin.isKnown())
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

SurfacePoint NearestSource::pointOf(const Foot& foot) const
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

std::vector<double> NearestSource::arcLengthsOf(Id curve) const
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

double NearestSource::angleOf(const Foot& foot)
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
  return this->curves_.chains().angleFrom(
    foot.curve, this->fanAt(foot.chain, foot.parameter).angleFromCurve(foot.angleInFan));
}

}
