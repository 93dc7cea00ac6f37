// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/EdgeSplitter.h"

#include "Tolerance.h"
#include "refinement/SolveForRefinement.h"

#include <algorithm>
#include <cmath>

namespace geodesic
{

namespace
{

// No part of a piece is shorter than this fraction of it: so lengths fall from split to split.
constexpr double LeastWeight = 0.03;

// An edge that needs more cuts is halved again and again: there may be no room for so many.
constexpr std::size_t MostCuts = 300;

double valueAt(const std::vector<Window>& envelope, double x)
{
  const auto window = std::partition_point(
    envelope.begin(), envelope.end() - 1, [x](const Window& w) { return w.end < x; });
  return window->distance(x);
}

} // anonymous namespace

template <typename Visit>
void EdgeSplitter::forEachFaceToMeasure(Id edge, const Visit& visit)
{
  bool isDone = false;
  forEachFace(this->faces_.field.mesh(), SurfacePoint::onEdge(this->edges_[edge].halfedge, 0.5),
    [&](Id face)
    {
      if (!isDone && !this->faces_.isFrozen(face))
      {
        this->face_.enter(face);
        visit(std::as_const(this->face_));
        isDone = this->face_.isExact();
      }
    });
}

void EdgeSplitter::enter(Id edge)
{
  if (this->edge_ != edge)
  {
    this->edge_ = edge;
    this->along_.clear();
    const TriangleMesh& mesh = this->faces_.field.mesh();
    const Id halfedge = this->edges_[edge].halfedge;
    this->length_ = mesh.length(halfedge);
    this->forEachFaceToMeasure(edge,
      [&](const FaceDistance& face)
      {
        const auto place = [&](double at) {
          return face.inPlane(barycentric(mesh, SurfacePoint::onEdge(halfedge, at), face.face()));
        };
        this->along_.push_back(this->envelope_.along(face, place(0.0), place(1.0)));
      });
  }
}

double EdgeSplitter::distanceAtEnd(Id edge, Id end) const
{
  return this->edges_.distanceOf(
    this->edges_.endOfPiece(edge, end), this->faces_.field.vertexDistances());
}

double EdgeSplitter::distanceAt(Id edge, double at)
{
  double least = Infinity;
  const SurfacePoint place = SurfacePoint::onEdge(this->edges_[edge].halfedge, at);
  this->forEachFaceToMeasure(edge,
    [&](const FaceDistance& face)
    {
      least = std::min(least,
        face.distance(face.inPlane(barycentric(this->faces_.field.mesh(), place, face.face()))));
    });
  return least;
}

// The largest deviations of any face from the line between two places, with their places as
// fractions of the way. Each face has its own values at the ends if these are not given.
Deviation EdgeSplitter::deviation(double from, double to, const std::array<double, 2>* ends) const
{
  Deviation largest;
  for (const std::vector<Window>& envelope : this->along_)
  {
    if (!envelope.empty()) // an edge without length
    {
      largest.widen(largestDeviation(envelope, from, to,
        ends ? (*ends)[0] : valueAt(envelope, from), ends ? (*ends)[1] : valueAt(envelope, to)));
    }
  }
  return largest;
}

// How far a piece within the limit can go from one place towards another, in either direction.
// Deviations grow about with the square of the length; where they do not, bisection goes on.
double EdgeSplitter::furthest(double from, double to, double guess, double limit) const
{
  constexpr int steps = 20;
  constexpr double near = 0.97;
  constexpr double aim = 0.985;
  double within = from;
  double beyond = to;
  bool isBeyond = false; // until then, all of the way may be within the limit
  double x = std::abs(guess) < std::abs(to - from) ? from + guess : to;
  for (int i = 0; i < steps; ++i)
  {
    const double deviation =
      this->deviation(std::min(from, x), std::max(from, x), nullptr).largest();
    if (deviation <= limit)
    {
      within = x;
      if (x == to || deviation >= near * limit)
      {
        break;
      }
    }
    else
    {
      beyond = x;
      isBeyond = true;
    }
    const double growth = std::sqrt(aim * limit / std::max(deviation, 0.1 * limit));
    const double aimed = from + growth * (x - from);
    if (aimed > std::min(within, beyond) && aimed < std::max(within, beyond))
    {
      x = aimed;
    }
    else
    {
      x = isBeyond ? 0.5 * (within + beyond) : to;
    }
  }
  return within;
}

// Stops when there are more than the most.
std::vector<double> EdgeSplitter::stepsWithin(
  double from, double to, double limit, std::size_t most) const
{
  std::vector<double> places;
  double guess = to - from;
  for (double last = from;;)
  {
    const double next = this->furthest(last, to, guess, limit);
    if (next == to || next == last || places.size() > most)
    {
      return places;
    }
    places.push_back(next);
    guess = next - last;
    last = next;
  }
}

// If the k-th of n cuts is put between the furthest from the one end and the furthest from the
// other, at k / (n + 1) of the way, pieces are equal where the curvature is. The furthest from the
// one end if that does not suffice.
std::vector<double> EdgeSplitter::evenCuts(double limit, const std::vector<double>& forward) const
{
  const std::vector<double> backward = this->stepsWithin(this->length_, 0.0, limit, forward.size());
  const std::size_t count = forward.size();
  if (backward.size() != count)
  {
    return forward;
  }
  std::vector<double> even;
  double last = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double weight = static_cast<double>(i + 1) / static_cast<double>(count + 1);
    even.push_back(forward[i] + weight * (backward[count - 1 - i] - forward[i]));
    if (!this->isWithin(last, even.back(), limit))
    {
      return forward;
    }
    last = even.back();
  }
  return this->isWithin(last, this->length_, limit) ? even : forward;
}

// The places that cut the edge; none if there would be hundreds.
std::vector<double> EdgeSplitter::cuts(double limit) const
{
  const double length = this->length_;
  const std::vector<double> forward = this->stepsWithin(0.0, length, limit, MostCuts);
  if (forward.size() > MostCuts)
  {
    return {};
  }
  if (forward.size() == 1)
  {
    const double worst = this->deviation(0.0, length, nullptr).at * length;
    if (this->isWithin(0.0, worst, limit) && this->isWithin(worst, length, limit))
    {
      return { worst };
    }
  }
  return this->evenCuts(limit, forward);
}

// Between two fractions of the way along the edge. In an approximate field each face has its own
// values at the ends.
Deviation EdgeSplitter::ofPiece(double from, double to, const std::array<double, 2>& ends) const
{
  const bool isExact = this->faces_.field.relativeErrorBound() == 0.0;
  return this->deviation(from * this->length_, to * this->length_, isExact ? &ends : nullptr);
}

std::vector<Deviation> EdgeSplitter::measure(Id edge)
{
  const CutEdge& e = this->edges_[edge];
  std::vector<Deviation> pieces = e.pieces;
  for (Id piece = 0; piece < e.numberOfPieces(); ++piece)
  {
    if (!pieces[piece].isKnown())
    {
      this->enter(edge);
      pieces[piece] = this->ofPiece(this->edges_.placeOfEnd(edge, piece),
        this->edges_.placeOfEnd(edge, piece + 1),
        { this->distanceAtEnd(edge, piece), this->distanceAtEnd(edge, piece + 1) });
    }
  }
  return pieces;
}

// The triangles at the pieces have a little less than the tolerance: what rounding takes of it, and
// in an approximate field what merging does.
EdgeCuts EdgeSplitter::fewestCuts(Id edge)
{
  this->enter(edge);
  const std::array<double, 2> ends = { this->distanceAtEnd(edge, 0), this->distanceAtEnd(edge, 1) };
  const double merged =
    this->faces_.field.relativeErrorBound() > 0.0 ? maximumMergedFor(this->tolerance_) : 0.0;
  const double rounding = tolerance::FaceRounding * std::max(ends[0], ends[1]);
  const double limit = std::max(this->tolerance_ - merged - rounding, 0.5 * this->tolerance_);
  if (this->isWithin(0.0, this->length_, limit))
  {
    return {};
  }
  std::vector<double> places = this->cuts(limit);
  for (double& place : places)
  {
    place /= this->length_;
  }
  EdgeCuts cuts;
  std::vector<std::pair<double, double>> points = { { 0.0, ends[0] }, { 1.0, ends[1] } };
  this->addSplits(
    { places.data(), places.data() + places.size() }, 0.0, 1.0, 0, cuts.splits, points);
  if (cuts.splits.empty())
  {
    return {}; // all places are ends
  }
  std::sort(points.begin(), points.end());
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    cuts.pieces.push_back(this->ofPiece(
      points[i - 1].first, points[i].first, { points[i - 1].second, points[i].second }));
  }
  return cuts;
}

// Appends the splits, and each point's place and distance. The cut nearest to the middle of a piece
// comes first, so that both parts are about as long, and the last part's cuts before the first's,
// which change the numbers of the pieces behind.
void EdgeSplitter::addSplits(ArrayRange<double> places, double from, double to, Id piece,
  std::vector<EdgeSplit>& splits, std::vector<std::pair<double, double>>& points)
{
  const auto weightOf = [&](double place) { return (place - from) / (to - from); };
  const auto fromMiddle = [&](double place) { return std::abs(weightOf(place) - 0.5); };
  const double* best = std::min_element(places.begin(), places.end(),
    [&](double a, double b) { return fromMiddle(a) < fromMiddle(b); });
  if (best == places.end() || !(fromMiddle(*best) < 0.5))
  {
    return;
  }
  const double weight = std::clamp(weightOf(*best), LeastWeight, 1.0 - LeastWeight);
  const double at = from + weight * (to - from);
  points.emplace_back(at, this->distanceAt(this->edge_, at));
  splits.push_back({ this->edge_, piece, SplitReason::Error, 0.0, weight, points.back().second });
  this->addSplits({ best + 1, places.end() }, at, to, piece + 1, splits, points);
  this->addSplits({ places.begin(), best }, from, at, piece, splits, points);
}

void EdgeSplitter::complete(EdgeSplit& split)
{
  split.weight = std::clamp(split.weight, LeastWeight, 1.0 - LeastWeight);
  const double from = this->edges_.placeOfEnd(split.edge, split.piece);
  const double to = this->edges_.placeOfEnd(split.edge, split.piece + 1);
  split.distance = this->distanceAt(split.edge, from + split.weight * (to - from));
}

}
