// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/EdgeSplitter.h"

#include "Tolerance.h"
#include "refinement/SolveForRefinement.h"

#include <algorithm>

namespace geodesic
{

namespace
{

// No part of a piece is shorter than this fraction of it: so lengths fall from split to split.
constexpr double LeastWeight = 0.03;

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

const DistanceAlongEdge& EdgeSplitter::along(Id edge)
{
  if (this->edge_ != edge)
  {
    this->edge_ = edge;
    this->along_ = {};
    const TriangleMesh& mesh = this->faces_.field.mesh();
    const Id halfedge = this->edges_[edge].halfedge;
    this->forEachFaceToMeasure(edge,
      [&](const FaceDistance& face)
      {
        const auto place = [&](double at) {
          return face.inPlane(barycentric(mesh, SurfacePoint::onEdge(halfedge, at), face.face()));
        };
        const Vec2 begin = place(0.0);
        this->along_.add(this->envelope_.along(face, begin, place(1.0)), face.distance(begin));
      });
  }
  return this->along_;
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

Deviation EdgeSplitter::deviation(
  Id edge, double from, double to, const std::array<double, 2>& ends)
{
  const double length = this->edges_[edge].length;
  const bool isExact = this->faces_.field.relativeErrorBound() == 0.0;
  return this->along(edge).deviation(from * length, to * length, isExact ? &ends : nullptr);
}

std::vector<Deviation> EdgeSplitter::measure(Id edge)
{
  const CutEdge& e = this->edges_[edge];
  std::vector<Deviation> pieces = e.pieces;
  for (Id piece = 0; piece < e.numberOfPieces(); ++piece)
  {
    if (!pieces[piece].isKnown())
    {
      pieces[piece] = this->deviation(edge, this->edges_.placeOfEnd(edge, piece),
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
  const CutEdge& e = this->edges_[edge];
  const std::array<double, 2> ends = { this->distanceAtEnd(edge, 0), this->distanceAtEnd(edge, 1) };
  const double merged =
    this->faces_.field.relativeErrorBound() > 0.0 ? maximumMergedFor(this->tolerance_) : 0.0;
  const double rounding = tolerance::FaceRounding * std::max(ends[0], ends[1]);
  const double limit = std::max(this->tolerance_ - merged - rounding, 0.5 * this->tolerance_);
  if (!(this->along(edge).deviation(0.0, e.length, nullptr).largest() > limit))
  {
    return {};
  }
  std::vector<double> places = this->along(edge).cuts(0.0, e.length, limit);
  for (double& place : places)
  {
    place /= e.length;
  }
  EdgeCuts cuts;
  std::vector<std::pair<double, double>> points = { { 0.0, ends[0] }, { 1.0, ends[1] } };
  this->addSplits(
    edge, { places.data(), places.data() + places.size() }, 0.0, 1.0, 0, cuts.splits, points);
  if (cuts.splits.empty())
  {
    return {}; // all places are ends
  }
  std::sort(points.begin(), points.end());
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    cuts.pieces.push_back(this->deviation(
      edge, points[i - 1].first, points[i].first, { points[i - 1].second, points[i].second }));
  }
  return cuts;
}

// Appends the splits, and each point's place and distance. The cut nearest to the middle of a piece
// comes first, so that both parts are about as long, and the last part's cuts before the first's,
// which change the numbers of the pieces behind.
void EdgeSplitter::addSplits(Id edge, ArrayRange<double> places, double from, double to, Id piece,
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
  points.emplace_back(at, this->distanceAt(edge, at));
  splits.push_back({ piece, false, weight, points.back().second });
  this->addSplits(edge, { best + 1, places.end() }, at, to, piece + 1, splits, points);
  this->addSplits(edge, { places.begin(), best }, from, at, piece, splits, points);
}

EdgeSplit EdgeSplitter::split(Id edge, Id piece, double weight, bool isForShape)
{
  weight = std::clamp(weight, LeastWeight, 1.0 - LeastWeight);
  const double from = this->edges_.placeOfEnd(edge, piece);
  const double to = this->edges_.placeOfEnd(edge, piece + 1);
  return { piece, isForShape, weight, this->distanceAt(edge, from + weight * (to - from)) };
}

}
