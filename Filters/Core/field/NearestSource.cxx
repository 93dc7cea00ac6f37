// SPDX-License-Identifier: BSD-3-Clause
#include "field/NearestSource.h"

#include <algorithm>

namespace geodesic
{

NearestSource::NearestSource(const DistanceField& field, const std::vector<SourceCurve>& curves,
  const ProgressCallback& callback)
  : field_(field)
  , mesh_(field.mesh())
  , chains_(field.mesh(), curves)
  , onCurves_(field.mesh(), this->chains_)
  , sectors_(field.mesh())
{
  this->origins_.assign(this->mesh_.numberOfVertices(), CurveOrigin());
  LoopProgress progress(callback);
  progress.nextUntil(0.5);
  this->findBesideVertices(progress);
  progress.nextUntil(1.0);
  this->findOthers(progress);
}

// The side of the curve is told from the direction at the vertex: all that come from one vertex
// together.
void NearestSource::findBesideVertices(const LoopProgress& progress)
{
  std::vector<std::pair<Id, Id>> beside; // the vertex on a curve, and the one beside it
  const std::vector<Arrival>& arrivals = this->field_.arrivals();
  for (Id vertex = 0; vertex < arrivals.size(); ++vertex)
  {
    progress.at(vertex, arrivals.size());
    const Arrival& arrival = arrivals[vertex];
    const VertexOnCurve* on = this->onCurves_.find(vertex);
    if (on != nullptr)
    {
      this->origins_[vertex] = CurveOrigin::onLeft(this->mesh_, on->curve, on->place);
    }
    else if (arrival.isKnown() && !arrival.isThroughWindow())
    {
      const LastPiece piece = lastPieceTo(this->field_, SurfacePoint::atVertex(vertex));
      if (piece.kind == LastPiece::Kind::Corner && this->onCurves_.find(piece.origin) != nullptr)
      {
        beside.emplace_back(piece.origin, vertex);
      }
    }
  }
  std::sort(beside.begin(), beside.end());
  for (const auto& [on, vertex] : beside)
  {
    const LastPiece piece = lastPieceTo(this->field_, SurfacePoint::atVertex(vertex));
    this->origins_[vertex] = this->originOf(piece);
  }
}

void NearestSource::findOthers(const LoopProgress& progress)
{
  for (Id vertex = 0; vertex < this->mesh_.numberOfVertices(); ++vertex)
  {
    progress.at(vertex, this->mesh_.numberOfVertices());
    if (this->field_.vertexDistances()[vertex] < Infinity)
    {
      this->follow(vertex);
    }
  }
}

// The last piece to a vertex, through a window without its direction, which takes no face to know.
LastPiece NearestSource::originTo(Id vertex) const
{
  const Arrival& arrival = this->field_.arrivals()[vertex];
  if (!arrival.isThroughWindow())
  {
    return lastPieceTo(this->field_, SurfacePoint::atVertex(vertex));
  }
  LastPiece piece;
  piece.kind = LastPiece::Kind::Window;
  piece.origin = arrival.origin;
  piece.place = arrival.place;
  return piece;
}

// Back from pseudo-source to pseudo-source, and forth again. Vertices at one place may name each
// other: the way back ends there.
void NearestSource::follow(Id vertex)
{
  std::vector<Id> way;
  CurveOrigin found = this->origins_[vertex];
  while (found.origin == NoId)
  {
    const LastPiece piece = this->originTo(vertex);
    way.push_back(vertex);
    if (this->isFromCurve(piece))
    {
      found = this->originOf(piece);
      break;
    }
    vertex = piece.origin;
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

Foot NearestSource::of(const LastPiece& piece)
{
  return this->footOf(this->originOf(piece));
}

// Not from a pseudo-source, whose foot is its own.
bool NearestSource::isFromCurve(const LastPiece& piece) const
{
  switch (piece.kind)
  {
    case LastPiece::Kind::Corner:
      return this->onCurves_.find(piece.origin) != nullptr;
    case LastPiece::Kind::Window:
      return CurveSide::isOne(piece.origin, this->mesh_.numberOfVertices());
    default:
      return true;
  }
}

CurveOrigin NearestSource::originOf(const LastPiece& piece)
{
  switch (piece.kind)
  {
    case LastPiece::Kind::None:
      return {};
    case LastPiece::Kind::Source:
      return this->atSource(piece);
    case LastPiece::Kind::Corner:
    case LastPiece::Kind::Window:
      break;
  }
  if (CurveSide::isOne(piece.origin, this->mesh_.numberOfVertices()))
  {
    return { piece.origin, piece.place };
  }
  if (piece.kind == LastPiece::Kind::Corner && this->onCurves_.find(piece.origin) != nullptr)
  {
    this->goToVertex(piece.origin);
    return this->sectors_.of(piece.frame, piece.direction);
  }
  return this->origins_[piece.origin];
}

// Beside a segment its line tells the side, at its ends the segments that meet there.
CurveOrigin NearestSource::atSource(const LastPiece& piece)
{
  const SourceInFace& source = piece.source;
  if (piece.along > 0.0 && piece.along < 1.0)
  {
    const double place = source.placeOfA + piece.along * (source.placeOfB - source.placeOfA);
    const Vec2 along = inHalfedgeFrame(this->mesh_, piece.frame, source.b) -
      inHalfedgeFrame(this->mesh_, piece.frame, source.a);
    const CurveSide side = { source.curve, cross(along, piece.direction) < 0.0 };
    return { side.origin(this->mesh_.numberOfVertices()), place };
  }
  const double place = piece.along > 0.0 ? source.placeOfB : source.placeOfA;
  const std::vector<double>& places = this->chains_.places(source.curve);
  const auto at = std::lower_bound(places.begin(), places.end(), place);
  const auto i = static_cast<std::size_t>(at - places.begin());
  this->goToPoint(source.curve, std::min(i, places.size() - 1));
  return this->sectors_.of(piece.frame, piece.direction);
}

void NearestSource::goToVertex(Id vertex)
{
  if (vertex == this->sectorsVertex_)
  {
    return;
  }
  const VertexOnCurve& on = *this->onCurves_.find(vertex);
  this->sectors_.assign(SurfacePoint::atVertex(vertex), this->onCurves_.endsAt(vertex),
    CurveOrigin::onLeft(this->mesh_, on.curve, on.place));
  this->sectorsVertex_ = vertex;
}

void NearestSource::goToPoint(Id number, std::size_t i)
{
  const SourceCurve& curve = this->chains_.curves()[number];
  const SurfacePoint& point = curve.points[i];
  if (point.kind == SurfacePoint::Kind::Vertex)
  {
    this->goToVertex(point.id);
    return;
  }
  const std::vector<double>& places = this->chains_.places(number);
  // A closed curve begins and ends in one point.
  const std::size_t first = curve.isClosed() && i + 1 == curve.points.size() ? 0 : i;
  this->sectors_.assign(point, segmentEndsAt(this->mesh_, curve, number, places, first),
    CurveOrigin::onLeft(this->mesh_, number, places[i]));
  this->sectorsVertex_ = NoId;
}

Foot NearestSource::footOf(const CurveOrigin& origin) const
{
  if (origin.origin == NoId)
  {
    return {};
  }
  const CurveSide side = CurveSide::of(origin.origin, this->mesh_.numberOfVertices());
  const CurveChains::Link& link = this->chains_.linkAt(side.curve, origin.place);
  return { link.curve, side.isRight != link.isReversed, side.curve, origin.place };
}

SurfacePoint NearestSource::pointOf(const Foot& foot) const
{
  const SourceCurve& curve = this->chains_.curves()[foot.chain];
  const std::vector<double>& places = this->chains_.places(foot.chain);
  const auto behind = std::upper_bound(places.begin(), places.end(), foot.place);
  if (behind == places.begin())
  {
    return curve.points.front();
  }
  const auto i = static_cast<std::size_t>(behind - places.begin()) - 1;
  if (i + 1 == places.size() || foot.place == places[i])
  {
    return curve.points[i];
  }
  const double t = (foot.place - places[i]) / (places[i + 1] - places[i]);
  const Id face = curve.faces[i];
  const Barycentric a = barycentric(this->mesh_, curve.points[i], face);
  const Barycentric b = barycentric(this->mesh_, curve.points[i + 1], face);
  return fromBarycentric(this->mesh_, face, between(a, b, t));
}

}
