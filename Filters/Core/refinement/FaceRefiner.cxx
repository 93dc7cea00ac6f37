// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/FaceRefiner.h"

#include "Tolerance.h"
#include "Trigonometry.h"
#include "refinement/TriangleShape.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace geodesic
{

namespace
{

// A triangle's smallest angle (in radians) is too small if it is under this (14 degrees) and under
// this fraction of the face's.
constexpr double LeastAngle = 0.25;
constexpr double LeastAngleFraction = 0.5;
// A new piece of an edge makes an angle that is larger by this factor, so that rounding does not
// make it too small again.
constexpr double AngleMargin = 1.05;

// A triangle is not split for its shape unless its sides differ by more than this factor: so no
// side gets much shorter than the shortest one. Of a cap, both other sides may be half as long as
// the longest.
constexpr double UnequalSides = 1.9;

// A face may be split this often for its shapes, and this often more for each point that errors
// need. On sides of thin faces a split may leave sides as unequal as before, again and again.
constexpr Id SplitsForShape = 16;
constexpr Id SplitsForShapePerPoint = 4;

// A new point inside keeps this fraction of half the side that it splits away from the sides of the
// face. Else its triangles there would be thin unless the face's side gets a point, too.
constexpr double DistanceFromSides = 0.2;

// A face has at most so many triangles, and so many more for each square of the tolerance. Where
// the distance is uneven by rounding, or by merging, thin ones might be split for ever. What is
// left then is over the tolerance.
constexpr double MostParts = 1000.0;
constexpr double MostPartsOfSize = 100.0;

// A large face takes several rounds, between which triangles are counted and the watcher can stop.
constexpr int StepsInRound = 2048;

// The longest of a triangle's sides that lie on sides of the face; 3 if none does.
std::size_t longestOnSide(const FaceTriangles::Part& part, const std::array<double, 3>& lengths)
{
  std::size_t longest = 3;
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (part.across[k] == NoId && (longest == 3 || lengths[k] > lengths[longest]))
    {
      longest = k;
    }
  }
  return longest;
}

} // anonymous namespace

bool FaceRefiner::OpenPart::operator<(const OpenPart& other) const
{
  return std::tuple(other.reason, this->urgency, other.part) <
    std::tuple(this->reason, other.urgency, this->part);
}

bool FaceRefiner::refine(
  FaceTriangles& face, SourceRegions* regions, std::vector<EdgeSplit>& requests)
{
  this->regions_ = regions;
  this->requests_ = &requests;
  this->open_ = {};
  this->face_ = &face;
  this->check_.enter(face);
  this->leastAngle_ =
    std::min(LeastAngle, LeastAngleFraction * smallestAngle(face.places({ 0, 1, 2 })));
  for (std::size_t side = 0; side < 3; ++side)
  {
    this->faces_.takePoints(face, side, this->check_.distance());
  }
  face.flipChanged();
  face.takeChanged();
  for (Id part = 0; part < face.numberOfParts(); ++part)
  {
    if (face.part(part).hasPassed())
    {
      this->assessAtBorder(part);
    }
    else
    {
      this->assess(part);
    }
  }
  const double across = longestEdge(face.places({ 0, 1, 2 })) / this->tolerance_;
  const double mostParts = MostParts + MostPartsOfSize * across * across;
  for (int step = 0; !this->open_.empty() && face.numberOfParts() <= mostParts; ++step)
  {
    if (step == StepsInRound)
    {
      return false;
    }
    const OpenPart open = this->open_.top();
    this->open_.pop();
    if (face.part(open.part).version == open.version)
    {
      const Id parts = face.numberOfParts();
      this->improve(open);
      for (const Id part : face.takeChanged())
      {
        this->assess(part);
      }
      if (face.part(open.part).version == open.version && face.numberOfParts() > parts)
      {
        this->open_.push(open); // another triangle on the way to the longest side was split
      }
    }
  }
  for (Id part = 0; !this->open_.empty() && part < face.numberOfParts(); ++part)
  {
    FaceTriangles::Part& p = face.part(part);
    p.bound = p.hasPassed() ? p.bound : this->check_.boundBySize(p.corners);
  }
  return true;
}

void FaceRefiner::assess(Id part)
{
  FaceTriangles::Part& p = this->face_->part(part);
  const FaceCheck::Result check = this->check_.of(p.corners);
  p.bound = check.bound;
  if (!p.hasPassed())
  {
    this->open_.push({ SplitReason::Error, check.sample, part, p.version });
    return;
  }
  const double shape = this->urgencyOfShape(part);
  if (shape > 0.0)
  {
    this->open_.push({ SplitReason::Shape, shape, part, p.version });
    return;
  }
  this->assessAtBorder(part);
}

void FaceRefiner::assessAtBorder(Id part)
{
  const FaceTriangles::Part& p = this->face_->parts()[part];
  const double length = p.hasPassed() && this->regions_
    ? this->faces_.lengthAtBorder(this->face_->face(), p.corners, *this->regions_, this->tolerance_)
    : 0.0;
  if (length > 0.0)
  {
    this->open_.push({ SplitReason::Border, length, part, p.version });
  }
}

double FaceRefiner::urgencyOfShape(Id part) const
{
  if (this->face_->numberOfParts() == 1)
  {
    return 0.0;
  }
  const std::array<Vec2, 3> places = this->face_->places(this->face_->parts()[part].corners);
  const auto lengths = lengthsOf(places);
  const auto [shortest, longest] = std::minmax_element(lengths.begin(), lengths.end());
  const double angle = smallestAngle(places);
  const bool isBad = angle < this->leastAngle_ && (*longest) > UnequalSides * (*shortest);
  return isBad ? this->leastAngle_ / std::max(angle, tolerance::Rounding) : 0.0;
}

void FaceRefiner::improve(const OpenPart& open)
{
  switch (open.reason)
  {
    case SplitReason::Error:
      this->mendError(open);
      break;
    case SplitReason::Shape:
      this->mendShape(open);
      break;
    case SplitReason::Border:
      this->halveLongest(open);
      break;
  }
}

// A side's deviation counts as no larger than its length, as distances change by no more than the
// length moved: so refinement ends, whatever rounding does.
void FaceRefiner::mendError(const OpenPart& open)
{
  const FaceTriangles::Part& part = this->face_->parts()[open.part];
  const auto lengths = lengthsOf(this->face_->places(part.corners));
  std::size_t worst = 3;
  double largest = this->check_.limitOf(part.corners);
  double at = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Deviation side = this->check_.deviationOf(part.corners[k], part.corners[(k + 1) % 3]);
    const double deviation = std::min(side.largest(), lengths[k]);
    if (deviation > largest)
    {
      worst = k;
      largest = deviation;
      at = side.at;
    }
  }
  if (worst == 3)
  {
    this->halveLongest(open);
  }
  else if (part.across[worst] == NoId)
  {
    const PieceOfEdge piece =
      this->faces_.pieceBetween(*this->face_, part.corners[worst], part.corners[(worst + 1) % 3]);
    this->request(open, piece, splitPosition(piece.isReversed ? 1.0 - at : at));
  }
  else if (!this->flipIfBoth(open.part, worst))
  {
    this->splitInside(open, open.part, worst, splitPosition(at));
  }
}

// A triangle whose piece of the face's side is too long gets a point there, where the angle is just
// large enough. At a sharp corner pieces then grow with the way from the corner.
void FaceRefiner::mendShape(const OpenPart& open)
{
  const FaceTriangles::Part& part = this->face_->parts()[open.part];
  if (!this->mayImproveShape())
  {
    return;
  }
  const std::array<Vec2, 3> places = this->face_->places(part.corners);
  const auto lengths = lengthsOf(places);
  const std::size_t k = longestOnSide(part, lengths);
  const double least = *std::min_element(lengths.begin(), lengths.end());
  if (k == 3 || !(lengths[k] > UnequalSides * least))
  {
    this->halveLongest(open);
    return;
  }
  const std::size_t next = (k + 1) % 3;
  const std::size_t apex = (k + 2) % 3;
  const bool isNearBegin = lengths[apex] < lengths[next];
  const Vec2 near = places[isNearBegin ? k : next];
  const Vec2 along = (1.0 / lengths[k]) * (places[isNearBegin ? next : k] - near);
  const double height = std::abs(cross(along, places[apex] - near));
  // No piece may be shorter than the shortest side, or, of a cap, than half of the piece.
  const double half = 0.5 * lengths[k];
  const double way =
    std::clamp(dot(along, places[apex] - near) + height / tangent(AngleMargin * this->leastAngle_),
      std::min(least, half), half);
  const PieceOfEdge piece =
    this->faces_.pieceBetween(*this->face_, part.corners[k], part.corners[next]);
  const double weight = way / lengths[k];
  this->request(open, piece, isNearBegin != piece.isReversed ? weight : 1.0 - weight);
}

// Errors need all points but those that shapes alone have asked for.
bool FaceRefiner::mayImproveShape() const
{
  const Id forShapes = this->face_->pointsForShapes();
  const Id forErrors = static_cast<Id>(this->face_->points().size()) - forShapes;
  return forShapes < SplitsForShape + SplitsForShapePerPoint * forErrors;
}

bool FaceRefiner::flipIfBoth(Id part, std::size_t k)
{
  for (const Triangle& corners : this->face_->flipped(part, k))
  {
    if (!this->face_->isTriangle(corners) ||
      smallestAngle(this->face_->places(corners)) < this->leastAngle_ ||
      !(this->check_.of(corners).bound < Infinity))
    {
      return false;
    }
  }
  this->face_->flip(part, k);
  return true;
}

// Walks across the longest side as long as the next triangle's is longer. What is halved is then
// the longest side of both triangles there.
void FaceRefiner::halveLongest(const OpenPart& open)
{
  Id part = open.part;
  for (;;)
  {
    const FaceTriangles::Part& p = this->face_->parts()[part];
    const auto lengths = lengthsOf(this->face_->places(p.corners));
    const std::size_t k = longestSide(lengths);
    const Id other = p.across[k];
    if (other == NoId)
    {
      this->request(
        open, this->faces_.pieceBetween(*this->face_, p.corners[k], p.corners[(k + 1) % 3]), 0.5);
      return;
    }
    if (!(longestEdge(this->face_->places(this->face_->parts()[other].corners)) > lengths[k]))
    {
      this->splitInside(open, part, k, 0.5);
      return;
    }
    part = other;
  }
}

void FaceRefiner::splitInside(const OpenPart& open, Id part, std::size_t k, double weight)
{
  const Triangle& c = this->face_->parts()[part].corners;
  const Id a = c[k];
  const Id b = c[(k + 1) % 3];
  const FaceTriangles::Point& begin = this->face_->points()[a];
  const FaceTriangles::Point& end = this->face_->points()[b];
  FaceTriangles::Point point;
  point.weights = between(begin.weights, end.weights, weight);
  point.place = this->check_.distance().inPlane(point.weights);
  if (this->asksBeside(open, point, norm(end.place - begin.place)))
  {
    return;
  }
  point.distance = this->check_.distance().distance(point.place);
  point.here = point.distance;
  point.parents = { a, b };
  point.weight = weight;
  point.isForShape = open.reason == SplitReason::Shape;
  this->face_->split(part, k, this->face_->addPoint(point));
  this->face_->flipChanged();
}

// Whether a point that splits a side of this length would lie too close to a side of the face. Then
// the longest piece beside it is to be halved instead.
bool FaceRefiner::asksBeside(const OpenPart& open, const FaceTriangles::Point& point, double length)
{
  const FaceShape& shape = this->faces_.field.mesh().shape(this->face_->face());
  const double away = DistanceFromSides * 0.5 * length;
  PieceOfEdge beside;
  double longest = 2.0 * away; // shorter ones do no harm
  for (std::size_t side = 0; side < 3; ++side)
  {
    if (point.weights[(side + 2) % 3] * shape.area2 / shape.length[side] < away)
    {
      const Vec2 begin = this->face_->points()[side].place;
      const Vec2 along = this->face_->points()[(side + 1) % 3].place - begin;
      const double way = dot(along, point.place - begin) / dot(along, along);
      const PieceOfEdge piece = this->faces_.pieceAt(*this->face_, side, way);
      const double lengthOfPiece = this->faces_.edges.lengthOfPiece(piece.edge, piece.piece);
      if (lengthOfPiece > longest)
      {
        beside = piece;
        longest = lengthOfPiece;
      }
    }
  }
  if (beside.edge == NoId)
  {
    return false;
  }
  this->request(open, beside, 0.5);
  return true;
}

void FaceRefiner::request(const OpenPart& open, const PieceOfEdge& piece, double weight)
{
  this->requests_->push_back({ piece.edge, piece.piece, open.reason, open.urgency, weight });
  this->face_->part(open.part).bound = Infinity; // assessed anew with the point
}

}
