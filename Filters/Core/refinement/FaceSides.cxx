// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/FaceSides.h"

#include <algorithm>

namespace geodesic
{

void FaceSides::enter(FaceTriangles& face)
{
  this->face_ = &face;
  for (std::size_t k = 0; k < 3; ++k)
  {
    this->edgeOfSide_[k] = this->edges_.find(TriangleMesh::halfedgeOf(face.face(), k));
  }
}

bool FaceSides::isReversed(std::size_t side) const
{
  const Id begin = this->mesh_.origin(this->edges_[this->edgeOfSide_[side]].halfedge);
  return begin != this->face_->points()[side].number;
}

double FaceSides::alongEdge(std::size_t side, Id point) const
{
  const Id number = this->face_->points()[point].number;
  if (!this->edges_.isVertex(number))
  {
    return this->edges_.point(number).at;
  }
  const Id halfedge = this->edges_[this->edgeOfSide_[side]].halfedge;
  return number == this->mesh_.origin(halfedge) ? 0.0 : 1.0;
}

FaceTriangles::Point FaceSides::pointOnEdge(
  std::size_t side, Id number, const FaceDistance& distance) const
{
  const PointOnEdge& on = this->edges_.point(number);
  FaceTriangles::Point point;
  point.weights = barycentric(this->mesh_, this->edges_.placeOf(number), this->face_->face());
  point.place = distance.inPlane(point.weights);
  point.distance = on.distance;
  point.here = distance.isExact() ? on.distance : distance.distance(point.place);
  point.number = number;
  point.sides = static_cast<std::uint8_t>(1U << side);
  point.isForShape = on.isForShape;
  return point;
}

void FaceSides::takePoints(const FaceDistance& distance)
{
  for (std::size_t side = 0; side < 3; ++side)
  {
    this->takePoints(side, distance);
  }
}

// From one corner of the side to the next. A part keeps the half that begins first, so the rest of
// the side is in the part that was added.
void FaceSides::takePoints(std::size_t side, const FaceDistance& distance)
{
  std::vector<Id> numbers = this->edges_[this->edgeOfSide_[side]].points;
  if (this->face_->pointsOn(side) == numbers.size())
  {
    return;
  }
  if (this->isReversed(side))
  {
    std::reverse(numbers.begin(), numbers.end());
  }
  struct Piece
  {
    Id from; // the number of the point where it begins
    Id part;
    std::size_t k;
    bool operator<(const Piece& other) const { return this->from < other.from; }
  };
  std::vector<Piece> pieces;
  for (Id part = 0; part < this->face_->numberOfParts(); ++part)
  {
    const FaceTriangles::Part& p = this->face_->parts()[part];
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (p.across[k] == NoId &&
        this->face_->sideWith(p.corners[k], p.corners[(k + 1) % 3]) == side)
      {
        pieces.push_back({ this->face_->points()[p.corners[k]].number, part, k });
      }
    }
  }
  std::sort(pieces.begin(), pieces.end());
  const auto find = [&pieces](Id number) {
    return std::lower_bound(pieces.begin(), pieces.end(), Piece{ number, 0, 0 });
  };
  Piece last = *find(this->face_->points()[side].number);
  for (const Id number : numbers)
  {
    const auto found = find(number);
    if (found != pieces.end() && found->from == number)
    {
      last = *found;
      continue;
    }
    const Id point = this->face_->addPoint(this->pointOnEdge(side, number, distance));
    last.part = this->face_->split(last.part, last.k, point);
  }
}

PieceOfEdge FaceSides::pieceBetween(Id a, Id b) const
{
  const std::size_t side = this->face_->sideWith(a, b);
  const Id edge = this->edgeOfSide_[side];
  const double fromA = this->alongEdge(side, a);
  const double fromB = this->alongEdge(side, b);
  return { edge, this->edges_.pieceFrom(edge, std::min(fromA, fromB)), fromB < fromA };
}

PieceOfEdge FaceSides::pieceAt(std::size_t side, Vec2 place) const
{
  const Vec2 begin = this->face_->points()[side].place;
  const Vec2 along = this->face_->points()[(side + 1) % 3].place - begin;
  const double way = std::clamp(dot(along, place - begin) / dot(along, along), 0.0, 1.0);
  const Id edge = this->edgeOfSide_[side];
  const bool isReversed = this->isReversed(side);
  const Id piece = this->edges_.pieceFrom(edge, isReversed ? 1.0 - way : way);
  return { edge, std::min(piece, this->edges_[edge].numberOfPieces() - 1), isReversed };
}

}
