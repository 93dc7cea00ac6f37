// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/FaceCheck.h"

#include "Tolerance.h"
#include "refinement/FaceBounds.h"
#include "refinement/TriangleShape.h"

#include <algorithm>
#include <cmath>

namespace geodesic
{

namespace
{

// The search ends after this many parts, or halvings: from then on, refining the triangle is
// cheaper.
constexpr unsigned MaximumPieces = 200;
constexpr unsigned MaximumHalvings = 14;

/// The excess of one candidate, or of a convex combination, over the function at the corners of a
/// part.
using AtCorners = std::array<double, 3>;

double largestOf(const AtCorners& excess)
{
  return std::max({ excess[0], excess[1], excess[2] });
}

// The convex combination of two with the smallest maximum: it is at an end, or where two corners
// have equal excess.
AtCorners bestMix(const AtCorners& a, const AtCorners& b)
{
  AtCorners best = largestOf(a) <= largestOf(b) ? a : b;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const std::size_t j = (k + 1) % 3;
    const double difference = (b[j] - a[j]) - (b[k] - a[k]);
    const double weight = difference != 0.0 ? (a[k] - a[j]) / difference : -1.0;
    if (weight > 0.0 && weight < 1.0)
    {
      AtCorners mix;
      for (std::size_t i = 0; i < 3; ++i)
      {
        mix[i] = a[i] + weight * (b[i] - a[i]);
      }
      best = largestOf(mix) < largestOf(best) ? mix : best;
    }
  }
  return best;
}

// The best convex combination found: the best one of pairs, combined with each candidate.
AtCorners bestMixOf(const std::array<AtCorners, 7>& candidates, const AtCorners& known)
{
  AtCorners best = known;
  const auto take = [&best](const AtCorners& mix)
  { best = largestOf(mix) < largestOf(best) ? mix : best; };
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      take(bestMix(candidates[i], candidates[j]));
    }
  }
  for (const AtCorners& candidate : candidates)
  {
    take(bestMix(best, candidate));
  }
  return best;
}

} // anonymous namespace

void FaceCheck::enter(const FaceTriangles& face)
{
  this->face_ = &face;
  this->inside_.clear();
  this->distance_.enter(face.face());
}

Deviation FaceCheck::deviationOf(Id a, Id b)
{
  if (this->face_->sideWith(a, b) < 3)
  {
    const PieceOfEdge piece = this->faces_.pieceBetween(*this->face_, a, b);
    const Deviation& deviation = this->faces_.edges[piece.edge].pieces[piece.piece];
    return piece.isReversed ? deviation.reversed() : deviation;
  }
  // From the lower point to the higher one, to the last digit the same from both sides.
  const Id low = std::min(a, b);
  const Id high = std::max(a, b);
  const auto [found, isNew] =
    this->inside_.emplace((static_cast<std::uint64_t>(low) << 32) | high, Deviation());
  if (isNew)
  {
    const FaceTriangles::Point& begin = this->face_->points()[low];
    const FaceTriangles::Point& end = this->face_->points()[high];
    found->second = largestDeviation(this->envelope_.along(this->distance_, begin.place, end.place),
      0.0, norm(end.place - begin.place), begin.here, end.here);
  }
  return b < a ? found->second.reversed() : found->second;
}

// In an approximate field the faces around a point differ by what merging has changed, which no
// refinement can undo. The triangle gets the rest of the tolerance, but at least half of it.
double FaceCheck::limitFor(const Difference& at) const
{
  return std::max(this->tolerance_ - at.difference - at.rounding, 0.5 * this->tolerance_);
}

double FaceCheck::limitOf(const Triangle& corners) const
{
  return this->limitFor(this->differenceAt(corners));
}

// A triangle as small as the tolerance passes.
FaceCheck::Result FaceCheck::of(const Triangle& corners)
{
  LinearPiece linear;
  Deviation onSides;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const FaceTriangles::Point& point = this->face_->points()[corners[k]];
    linear.corners[k] = point.place;
    linear.values[k] = point.here;
    onSides.widen(this->deviationOf(corners[k], corners[(k + 1) % 3]));
  }
  const Difference atCorners = this->differenceAt(corners);
  const double limit = this->limitFor(atCorners);
  const bool isSmall = longestEdge(linear.corners) <= limit;
  if (onSides.largest() > limit && !isSmall)
  {
    return { Infinity, onSides.largest() };
  }
  const double below = std::max(onSides.below, this->belowAtSources(linear));
  if (below > limit && !isSmall)
  {
    return { Infinity, below };
  }
  Result result = this->above(linear, onSides.above, limit);
  result.sample = std::max(result.sample, below);
  const double own = std::max({ result.bound, below, onSides.above });
  result.bound =
    isSmall || own <= limit ? own + atCorners.rounding + atCorners.difference : Infinity;
  return result;
}

// The distance changes by no more than the length moved from a corner.
double FaceCheck::boundBySize(const Triangle& corners) const
{
  const auto [difference, rounding] = this->differenceAt(corners);
  return longestEdge(this->face_->places(corners)) + difference + rounding;
}

FaceCheck::Difference FaceCheck::differenceAt(const Triangle& corners) const
{
  double largest = 0.0;
  double difference = 0.0;
  for (const Id corner : corners)
  {
    const FaceTriangles::Point& point = this->face_->points()[corner];
    largest = std::max(largest, point.distance);
    difference = std::max(difference, std::abs(point.here - point.distance));
  }
  return { difference, tolerance::FaceRounding * largest };
}

// Each end of a segment is a source of its own.
double FaceCheck::belowAtSources(const LinearPiece& piece) const
{
  double below = 0.0;
  const Vec2 origin = piece.corners[0];
  const Vec2 e1 = piece.corners[1] - origin;
  const Vec2 e2 = piece.corners[2] - origin;
  const double area2 = cross(e1, e2);
  for (const SourceInFace& source : this->faces_.field.sourcesIn(this->face_->face()))
  {
    const Vec2 p = this->distance_.inPlane(source.a);
    const double u = cross(p - origin, e2);
    const double v = cross(e1, p - origin);
    if (u >= 0.0 && v >= 0.0 && u + v <= area2 && area2 > 0.0)
    {
      below = std::max(below,
        ((area2 - u - v) * piece.values[0] + u * piece.values[1] + v * piece.values[2]) / area2);
    }
  }
  return below;
}

FaceCheck::Result FaceCheck::above(const LinearPiece& piece, double onEdges, double limit)
{
  const Vec2 e1 = piece.corners[1] - piece.corners[0];
  const Vec2 e2 = piece.corners[2] - piece.corners[0];
  const double area2 = cross(e1, e2);
  // A triangle whose corners lie on a line consists of its edges.
  if (!(area2 > 0.0))
  {
    return { onEdges, onEdges };
  }
  const double longest = longestEdge(piece.corners);
  const GradientSlack slack = slackOf({ dot(e1, e1), dot(e1, e2), dot(e2, e2), area2, longest },
    piece.values[1] - piece.values[0], piece.values[2] - piece.values[0]);
  // The distance changes by no more than the length moved to a corner, or to an edge.
  const double byWay = std::min(longest, onEdges + slack.above);
  return byWay <= limit ? Result{ byWay, onEdges } : this->search(piece, onEdges, limit);
}

// Branch and bound: halves the triangle repeatedly until, on each part, some convex combination of
// candidates is close enough to the function at the corners.
FaceCheck::Result FaceCheck::search(const LinearPiece& piece, double onEdges, double limit)
{
  const std::array<Vec2, 3>& c = piece.corners;
  const Vec2 middle = (1.0 / 3.0) * (c[0] + c[1] + c[2]);
  const double radius = std::max({ norm(c[0] - middle), norm(c[1] - middle), norm(c[2] - middle) });
  this->near_.choose(this->distance_, middle, radius);
  this->excess_.clear();
  Node root{ piece, 0, {} };
  Result result = { 0.0, onEdges };
  for (std::size_t k = 0; k < 3; ++k)
  {
    root.row[k] = this->addRow(piece.corners[k], piece.values[k]);
    result.sample = std::max(result.sample, this->leastInRow(root.row[k]));
  }
  this->nodes_.assign(1, root);
  for (std::size_t pieces = 0; !this->nodes_.empty(); ++pieces)
  {
    const Node node = this->nodes_.back();
    this->nodes_.pop_back();
    const double bound = this->boundOf(node, limit);
    if (bound <= limit)
    {
      result.bound = std::max(result.bound, bound);
      continue;
    }
    const bool isLast = node.depth == MaximumHalvings || pieces >= MaximumPieces;
    if (!isLast)
    {
      result.sample = std::max(result.sample, this->halve(node));
    }
    if (isLast || result.sample > limit)
    {
      result.bound = Infinity;
      return result;
    }
  }
  return result;
}

// Halves a part at its longest edge. Returns the excess of the distance at the new point.
double FaceCheck::halve(const Node& node)
{
  const std::array<Vec2, 3>& c = node.piece.corners;
  const std::size_t k = longestSide(lengthsOf(c));
  const std::size_t next = (k + 1) % 3;
  const Vec2 middle = 0.5 * (c[k] + c[next]);
  const double value = 0.5 * (node.piece.values[k] + node.piece.values[next]);
  const std::size_t row = this->addRow(middle, value);
  for (const std::size_t replaced : { k, next })
  {
    Node half = node;
    half.depth = node.depth + 1;
    half.piece.corners[replaced] = middle;
    half.piece.values[replaced] = value;
    half.row[replaced] = row;
    this->nodes_.push_back(half);
  }
  return this->leastInRow(row);
}

std::size_t FaceCheck::addRow(Vec2 p, double value)
{
  const std::size_t row = this->excess_.size();
  for (const DistanceCandidate* candidate : this->near_)
  {
    this->excess_.push_back(candidate->distance(p) - value);
  }
  return row;
}

double FaceCheck::leastInRow(std::size_t row) const
{
  const auto first = this->excess_.begin() + static_cast<std::ptrdiff_t>(row);
  return *std::min_element(first, first + static_cast<std::ptrdiff_t>(this->near_.size()));
}

double FaceCheck::boundOf(const Node& node, double limit) const
{
  // the candidates that are least at each corner, the best of all, and the distance functions from
  // each corner
  std::array<AtCorners, 7> chosen;
  std::array<double, 3> least{ Infinity, Infinity, Infinity };
  double bound = Infinity;
  for (std::size_t i = 0; i < this->near_.size(); ++i)
  {
    const AtCorners excess = { this->excess_[node.row[0] + i], this->excess_[node.row[1] + i],
      this->excess_[node.row[2] + i] };
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (excess[k] < least[k])
      {
        least[k] = excess[k];
        chosen[k] = excess;
      }
    }
    if (largestOf(excess) < bound)
    {
      bound = largestOf(excess);
      chosen[3] = excess;
    }
  }
  if (bound <= limit)
  {
    return std::max(bound, 0.0);
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    for (std::size_t j = 0; j < 3; ++j)
    {
      const double way = norm(node.piece.corners[j] - node.piece.corners[k]);
      chosen[4 + k][j] = least[k] + way - (node.piece.values[j] - node.piece.values[k]);
    }
  }
  return std::max(largestOf(bestMixOf(chosen, chosen[3])), 0.0);
}

}
