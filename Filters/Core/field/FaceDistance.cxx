// SPDX-License-Identifier: BSD-3-Clause
#include "field/FaceDistance.h"

#include "Errors.h"
#include "Tolerance.h"

#include <algorithm>

namespace geodesic
{

namespace
{

/// Whether a window's rays run along its halfedge. Such a pencil has no inside: rounding alone
/// would decide on which side of it points of the halfedge lie.
bool isGrazing(const Window& w)
{
  if (w.isLinear())
  {
    return w.sourceDepth <= tolerance::GrazingAngle;
  }
  const double before = std::max(w.begin - w.sourceX, w.sourceX - w.end);
  return before > 0.0 && w.sourceDepth <= tolerance::GrazingAngle * before;
}

/// Whether a circular window reaches the whole face, up to a length of rounding. A path that bends
/// at an end of the window, by the angle between the ray there and the halfedge at most, is then
/// not longer than a straight one: the ray runs along the halfedge, or the source is at this end,
/// where rounding alone gives the ray its direction.
bool reachesAll(const Window& w, double rounding)
{
  const auto isOpen = [&w, rounding](double beside)
  {
    const double toEnd = norm(Vec2{ beside, w.sourceDepth });
    const double detour =
      beside > 0.0 ? w.sourceDepth * w.sourceDepth / (toEnd + beside) : toEnd - beside;
    return detour <= rounding;
  };
  return !w.isLinear() && isOpen(w.sourceX - w.begin) && isOpen(w.end - w.sourceX);
}

Vec2 nearestOnSegment(Vec2 a, Vec2 b, Vec2 p)
{
  const Vec2 ab = b - a;
  const double squared = dot(ab, ab);
  const double t = squared > 0.0 ? std::clamp(dot(p - a, ab) / squared, 0.0, 1.0) : 0.0;
  return a + t * ab;
}

} // anonymous namespace

double DistanceCandidate::distance(Vec2 p) const
{
  if (this->kind == Kind::Cone)
  {
    return this->sigma + norm(p - this->source);
  }
  if (this->kind == Kind::Segment)
  {
    return norm(p - nearestOnSegment(this->begin, this->end, p));
  }
  const Vec2 fromBegin = p - this->begin;
  if (cross(this->rayAtBegin(), fromBegin) > 0.0)
  {
    return this->atBegin + norm(fromBegin);
  }
  const Vec2 fromEnd = p - this->end;
  if (cross(this->rayAtEnd(), fromEnd) < 0.0)
  {
    return this->atEnd + norm(fromEnd);
  }
  return this->sigma + (this->kind == Kind::Linear ? dot(this->source, p) : norm(p - this->source));
}

FaceDistance::FaceDistance(const DistanceField& field)
  : field_(field)
  , mesh_(field.mesh())
{
}

void FaceDistance::enter(Id face)
{
  if (face == this->face_)
  {
    return;
  }
  if (!this->field_.hasWindows())
  {
    throw Error("The distance inside faces was asked for, but the solve kept no windows.");
  }
  this->face_ = face;
  this->frame_ = longestHalfedge(this->mesh_, face);
  this->candidates_.clear();
  const std::vector<SourceInFace> sources = this->field_.sourcesIn(face);
  if (isWholeFaceAmong(sources))
  {
    // A pencil without a direction: 0 everywhere.
    this->candidates_.push_back({ DistanceCandidate::Kind::Linear, 0.0, {}, {}, {}, 0.0, 0.0 });
    this->firstCorner_ = 1;
    return;
  }
  for (Id k = 0; k < 3; ++k)
  {
    this->addHalfedge(TriangleMesh::halfedgeOf(face, k));
  }
  this->firstCorner_ = this->candidates_.size();
  for (std::size_t k = 0; k < 3; ++k)
  {
    this->candidates_.push_back(DistanceCandidate::cone(this->inPlane(cornerWeights(k)),
      this->field_.vertexDistances()[this->mesh_.triangle(face)[k]]));
  }
  for (const SourceInFace& source : sources)
  {
    const Vec2 a = this->inPlane(source.a);
    this->candidates_.push_back(source.a == source.b
        ? DistanceCandidate::cone(a, 0.0)
        : DistanceCandidate{
            DistanceCandidate::Kind::Segment, 0.0, a, a, this->inPlane(source.b), 0.0, 0.0 });
  }
}

void FaceDistance::addHalfedge(Id halfedge)
{
  const WindowRuns windows = this->field_.windowsOn(halfedge);
  const double length = this->mesh_.length(halfedge);
  if (windows.empty() || !(length > 0.0))
  {
    return;
  }
  const std::size_t k = TriangleMesh::indexInFace(halfedge);
  const Vec2 origin = this->inPlane(cornerWeights(k));
  const Vec2 end = this->inPlane(cornerWeights((k + 1) % 3));
  const Vec2 along = (1.0 / length) * (end - origin);
  const Vec2 into = { -along.y, along.x };
  const double rounding = tolerance::PlaceRounding * this->mesh_.shape(this->face_).longest();
  for (const Window& w : windows)
  {
    DistanceCandidate c;
    c.begin = origin + w.begin * along;
    c.end = origin + w.end * along;
    c.atBegin = std::max(w.distance(w.begin), 0.0);
    c.atEnd = std::max(w.distance(w.end), 0.0);
    if (isGrazing(w))
    {
      c.kind = DistanceCandidate::Kind::Cone; // with the same values on the halfedge
      c.source = c.atBegin < c.atEnd ? c.begin : c.end;
      c.sigma = std::min(c.atBegin, c.atEnd);
    }
    else if (w.isLinear())
    {
      c.kind = DistanceCandidate::Kind::Linear;
      c.source = w.sourceX * along + w.sourceDepth * into;
      c.sigma = w.sigma - dot(c.source, origin);
    }
    else
    {
      c.kind =
        reachesAll(w, rounding) ? DistanceCandidate::Kind::Cone : DistanceCandidate::Kind::Circular;
      c.source = origin + w.sourceX * along - w.sourceDepth * into;
      c.sigma = w.sigma;
    }
    this->candidates_.push_back(c);
  }
}

double FaceDistance::distance(Vec2 p) const
{
  double least = Infinity;
  for (const DistanceCandidate& c : this->candidates_)
  {
    least = std::min(least, c.distance(p));
  }
  return std::max(least, 0.0);
}

double NearCandidates::choose(const FaceDistance& face, Vec2 middle, double radius, double value)
{
  const std::vector<DistanceCandidate>& candidates = face.candidates();
  this->inMiddle_.clear();
  double least = Infinity;
  for (const DistanceCandidate& c : candidates)
  {
    this->inMiddle_.push_back(c.distance(middle));
    least = std::min(least, this->inMiddle_.back());
  }
  const double bound = std::min(least + 2.0 * radius, value + radius) * (1.0 + tolerance::Tie);
  this->near_.clear();
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    if (this->inMiddle_[i] <= bound)
    {
      this->near_.push_back(&candidates[i]);
    }
  }
  return least;
}

double NearCandidates::distance(Vec2 p) const
{
  double least = Infinity;
  for (const DistanceCandidate* c : this->near_)
  {
    least = std::min(least, c->distance(p));
  }
  return least;
}

}
