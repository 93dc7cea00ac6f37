// SPDX-License-Identifier: BSD-3-Clause
//
// Let d be the distance in a face, phi_i the candidates to it (d is the least of them), l a
// linear function on a triangle T of the face and g its gradient.
//
// Below (l over d): l - d is the largest of l - phi_i, and each of these is concave. Inside T its
// gradient cannot vanish unless |g| = 1, since that of phi_i is a unit vector, save at a source in
// T; and where |g| = 1 it is constant along rays. So the largest is on the edges of T or at the
// ends of a source in T.
//
// For T the whole face there is no need of the envelopes of its edges: a path through a window
// enters at some x of a halfedge, and l(p) - |p - x| <= l(x) when |g| <= 1, so that l - d is largest on
// the halfedges, where each window tells by itself, and at the ends of sources. With |g| > 1 it is more
// by (|g| - 1) |p - x| at most.
//
// Above (d over l): d changes by no more than the way. Going from p against g one leaves T at some
// x of an edge where l enters, and d(p) - l(p) <= d(x) - l(x) + (1 - |g|) |p - x|. Where the front
// is smooth, |g| is nearly 1, and what is above on the edges bounds what is above inside.
//
// Near the medial axis |g| is smaller. There the phi_i help: a convex combination of them is over d
// and convex, so that its difference to l is largest at a corner. T is cut into smaller ones until
// a combination is good enough for each.
#include "refinement/InterpolationError.h"

#include "Tolerance.h"

#include <algorithm>

namespace geodesic
{

namespace
{

struct Gradient
{
  double length;
  /// The longest way through the triangle in its direction.
  double chord;
};

// From lengths and dot products: e1 and e2 are the edges from corner 0 with their rises a1 and a2.
Gradient gradientOf(
  double e1e1, double e1e2, double e2e2, double area2, double a1, double a2, double longest)
{
  const double scale = 1.0 / (area2 * area2);
  const double alpha = (a1 * e2e2 - a2 * e1e2) * scale; // g = alpha e1 + beta e2
  const double beta = (a2 * e1e1 - a1 * e1e2) * scale;
  Gradient g;
  g.length = std::sqrt(std::max(0.0, alpha * a1 + beta * a2));
  const double across1 = -beta * area2; // g x e1
  const double across2 = alpha * area2; // g x e2
  const auto [least, most] = std::minmax({ 0.0, across1, across2 });
  const double extent = most - least;
  g.chord = extent > 0.0 ? std::min(longest, area2 * g.length / extent) : longest;
  return g;
}

// How far the interpolant along a halfedge is over the windows of that halfedge: section 6.2 for each.
bool belowOfHalfedge(double length, const WindowRuns& windows, double atOrigin, double atDestination,
  double limit, double& below)
{
  if (!(length > 0.0))
  {
    return true;
  }
  const double a = (atDestination - atOrigin) / length;
  const double slope = (1.0 - a) * (1.0 + a);
  const double shift = slope > 0.0 ? a / std::sqrt(slope) : 0.0;
  for (const Window& w : windows)
  {
    double x = 0.0;
    if (w.isLinear())
    {
      x = w.sourceX > a ? w.begin : w.end;
    }
    else
    {
      // with a steep interpolant the lowest is at an end
      x = slope > 0.0 ? std::clamp(w.sourceX + shift * w.sourceDepth, w.begin, w.end)
                      : (a > 0.0 ? w.end : w.begin);
    }
    below = std::max(below, atOrigin + a * x - w.distance(x));
  }
  return below <= limit;
}

// How far the distance along a halfedge can be over its interpolant, from the windows of that halfedge: a
// window's difference is convex, so largest at an end; between windows that do not meet the
// distance changes by no more than the way. Windows that are over the limit do not help: they have
// been overtaken by later ones, or fill a gap of rounding.
double aboveOfHalfedge(
  double length, const WindowRuns& windows, double atOrigin, double atDestination, double limit)
{
  if (!(length > 0.0))
  {
    return 0.0;
  }
  const double a = (atDestination - atOrigin) / length;
  const auto acrossGap = [a](double from, double to, double gap)
  {
    const double meet = 0.5 * (to - from + (1.0 + a) * gap);
    return meet > 0.0 && meet < gap ? from + (1.0 - a) * meet : std::max(from, to);
  };
  double covered = 0.0;
  double atCovered = 0.0;
  double above = 0.0;
  for (const Window& w : windows)
  {
    if (w.end <= covered)
    {
      continue;
    }
    const double atBegin = w.distance(w.begin) - (atOrigin + a * w.begin);
    const double atEnd = w.distance(w.end) - (atOrigin + a * w.end);
    if (std::max(atBegin, atEnd) > limit)
    {
      continue;
    }
    const double between =
      w.begin > covered ? acrossGap(atCovered, atBegin, w.begin - covered) : atBegin;
    above = std::max({ above, between, atEnd });
    covered = w.end;
    atCovered = atEnd;
  }
  if (covered < length)
  {
    above = std::max(above, acrossGap(atCovered, 0.0, length - covered));
  }
  return above;
}

// What a gradient other than 1 adds: below, and above.
struct Slack
{
  double steep;
  double flat;
};

Slack slackOf(const FaceShape& shape, const std::array<double, 3>& d)
{
  const double longest = shape.longest();
  const Gradient g = gradientOf(shape.length[0] * shape.length[0], shape.cornerDot[0],
    shape.length[2] * shape.length[2], shape.area2, d[1] - d[0], d[2] - d[0], longest);
  return { std::max(0.0, g.length - 1.0) * longest, std::max(0.0, 1.0 - g.length) * g.chord };
}

// Along the normal into the face, l rises from the line of halfedge k to the opposite corner: paths
// against the gradient leave through such a halfedge.
bool risesFrom(std::size_t k, const FaceShape& shape, const std::array<double, 3>& d)
{
  const std::size_t next = (k + 1) % 3;
  const double length2 = shape.length[k] * shape.length[k];
  const double onLine = d[k] * length2 + (d[next] - d[k]) * shape.cornerDot[k];
  return d[(k + 2) % 3] * length2 >= onLine;
}

/// A line along a halfedge, and how far from it is near.
struct Band
{
  double atOrigin;
  double slope;
  /// Of the rays whose distance rises like the line: the sine of their angle with the halfedge.
  double depth;
  double limit;

  double high(double x) const { return this->atOrigin + this->limit + this->slope * x; }
  double low(double x) const { return this->atOrigin - this->limit + this->slope * x; }
};

// A window is convex, so highest over the line at an end.
bool isUnder(const Window& w, const Band& band)
{
  const double overBegin = band.high(w.begin) - w.sigma;
  const double overEnd = band.high(w.end) - w.sigma;
  if (w.isLinear())
  {
    return w.sourceX * w.begin <= overBegin && w.sourceX * w.end <= overEnd;
  }
  const double b = w.begin - w.sourceX;
  const double e = w.end - w.sourceX;
  const double h2 = w.sourceDepth * w.sourceDepth;
  return std::min(overBegin, overEnd) >= 0.0 && b * b + h2 <= overBegin * overBegin &&
    e * e + h2 <= overEnd * overEnd;
}

// A circular window is over its tangent with the line's slope, which is all that most need.
bool isOver(const Window& w, const Band& band)
{
  if (w.isLinear())
  {
    return w.distance(w.begin) >= band.low(w.begin) && w.distance(w.end) >= band.low(w.end);
  }
  if (w.sigma + w.sourceDepth * band.depth >= band.low(w.sourceX))
  {
    return true;
  }
  const double steepest = band.slope > 0.0 ? w.end : w.begin;
  const double x = band.depth > 0.0
    ? std::clamp(w.sourceX + w.sourceDepth * band.slope / band.depth, w.begin, w.end)
    : steepest;
  return w.distance(x) >= band.low(x);
}

} // anonymous namespace

NearLine nearLine(
  const WindowRange& windows, double length, double atOrigin, double atDestination, double limit)
{
  const double slope = (atDestination - atOrigin) / length;
  const double squared = (1.0 - slope) * (1.0 + slope);
  if (!(squared >= -tolerance::Tie)) // along a ray it is 0
  {
    return {};
  }
  const Band band = { atOrigin, slope, std::sqrt(std::max(0.0, squared)), limit };
  const double gap = tolerance::NearLineGap * limit;
  NearLine near = { true, true };
  double covered = 0.0;
  for (const Window& w : windows)
  {
    if (!isOver(w, band))
    {
      return {};
    }
    near.above = near.above && w.begin <= covered + gap && isUnder(w, band);
    covered = w.end;
  }
  near.above = near.above && covered + gap >= length;
  return near;
}

// In a gap the distance changes by no more than the way from its ends, and the line not more.
FaceBounds boundsNearLines(const TriangleMesh& mesh, Id face, const std::array<double, 3>& d,
  const std::array<bool, 3>& above, double limit)
{
  const FaceShape& shape = mesh.shape(face);
  if (!(shape.area2 > 0.0))
  {
    return {};
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (!above[k] && risesFrom(k, shape, d))
    {
      return {};
    }
  }
  const Slack slack = slackOf(shape, d);
  return { (1.0 + tolerance::NearLineGap) * limit + slack.flat, limit + slack.steep };
}

double belowThroughHalfedge(
  const TriangleMesh& mesh, Id halfedge, const std::array<double, 3>& d, const WindowRuns& windows)
{
  const FaceShape& shape = mesh.shape(TriangleMesh::faceOf(halfedge));
  double below = 0.0;
  belowOfHalfedge(mesh.length(halfedge), windows, d[halfedge % 3], d[(halfedge % 3 + 1) % 3], Infinity, below);
  return below + slackOf(shape, d).steep;
}

FaceBounds boundsOfFace(const TriangleMesh& mesh, Id face, const std::array<double, 3>& d,
  const std::array<WindowRuns, 3>& windows, double limit)
{
  const FaceShape& shape = mesh.shape(face);
  if (!(shape.area2 > 0.0))
  {
    return {};
  }
  const Slack slack = slackOf(shape, d);
  if (!(std::max(slack.steep, slack.flat) <= limit))
  {
    return {};
  }
  double below = 0.0;
  double above = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const std::size_t next = (k + 1) % 3;
    if (!belowOfHalfedge(shape.length[k], windows[k], d[k], d[next], limit - slack.steep, below))
    {
      return {};
    }
    if (risesFrom(k, shape, d))
    {
      above = std::max(
        above, aboveOfHalfedge(shape.length[k], windows[k], d[k], d[next], limit - slack.flat));
    }
  }
  return { above + slack.flat, below + slack.steep };
}

InterpolationError::InterpolationError(const DistanceField& field)
  : field_(field)
  , mesh_(field.mesh())
{
}

double InterpolationError::ofFace(Id face, double limit, double known) const
{
  const Triangle& corners = this->mesh_.triangle(face);
  const FaceShape& shape = this->mesh_.shape(face);
  std::array<double, 3> d;
  for (std::size_t k = 0; k < 3; ++k)
  {
    d[k] = this->field_.vertexDistances()[corners[k]];
  }
  const double longest = shape.longest();
  const double bySize = longest <= limit ? longest : Infinity; // d changes by no more than the way
  if (bySize <= known || !(shape.area2 > 0.0))
  {
    return bySize;
  }
  const Id halfedge = 3 * face;
  const FaceBounds bounds = boundsOfFace(this->mesh_, face, d,
    { this->field_.windowsOn(halfedge), this->field_.windowsOn(halfedge + 1),
      this->field_.windowsOn(halfedge + 2) },
    limit);
  double bound = std::max(bounds.above, bounds.below);
  for (const SourceInFace& source : this->field_.sourcesIn(face))
  {
    const double atA = source.a[0] * d[0] + source.a[1] * d[1] + source.a[2] * d[2];
    const double atB = source.b[0] * d[0] + source.b[1] * d[1] + source.b[2] * d[2];
    bound = std::max(bound, std::max(atA, atB) + slackOf(shape, d).steep);
  }
  return bound <= limit ? std::min(bound, bySize) : bySize;
}

InterpolationError::Inside InterpolationError::ofTriangle(const FaceEnvelope& envelope,
  const LinearPiece& piece, const Deviation& onEdges, double limit, bool tight)
{
  const Vec2 e1 = piece.corners[1] - piece.corners[0];
  const Vec2 e2 = piece.corners[2] - piece.corners[0];
  const Vec2 e3 = e2 - e1;
  const double longest = std::sqrt(std::max({ dot(e1, e1), dot(e2, e2), dot(e3, e3) }));
  const double area2 = cross(e1, e2);
  const double below = std::max(onEdges.below, this->belowAtSources(envelope, piece));
  if (below > limit && !tight)
  {
    return { Infinity, below };
  }
  Inside above = { longest, onEdges.above }; // d changes by no more than the way to a corner
  // In a triangle without area each point inside is a point of an edge, too.
  if (!(area2 > 0.0))
  {
    return { std::max(onEdges.above, below), std::max(onEdges.above, below) };
  }
  const Gradient g = gradientOf(dot(e1, e1), dot(e1, e2), dot(e2, e2), area2,
    piece.values[1] - piece.values[0], piece.values[2] - piece.values[0], longest);
  above.bound = std::min(above.bound, onEdges.above + std::max(0.0, 1.0 - g.length) * g.chord);
  if (!(above.bound <= limit))
  {
    const Inside searched = this->search(envelope, piece, limit, tight);
    above.bound = std::min(above.bound, searched.bound);
    above.sample = std::max(above.sample, searched.sample);
  }
  return { std::max(above.bound, below), std::max(above.sample, below) };
}

double InterpolationError::belowAtSources(
  const FaceEnvelope& envelope, const LinearPiece& piece) const
{
  double below = 0.0;
  const Vec2 origin = piece.corners[0];
  const Vec2 e1 = piece.corners[1] - origin;
  const Vec2 e2 = piece.corners[2] - origin;
  const double area2 = cross(e1, e2);
  const auto look = [&](Vec2 p)
  {
    const double u = cross(p - origin, e2);
    const double v = cross(e1, p - origin);
    if (u >= 0.0 && v >= 0.0 && u + v <= area2 && area2 > 0.0)
    {
      below = std::max(below,
        ((area2 - u - v) * piece.values[0] + u * piece.values[1] + v * piece.values[2]) / area2);
    }
  };
  for (const SourceInFace& source : this->field_.sourcesIn(envelope.face()))
  {
    look(envelope.inPlane(source.a));
    look(envelope.inPlane(source.b));
  }
  return below;
}

// Contributions that may be the least somewhere in the triangle.
void InterpolationError::chooseNear(const FaceEnvelope& envelope, const LinearPiece& piece)
{
  const std::array<Vec2, 3>& c = piece.corners;
  const Vec2 middle = (1.0 / 3.0) * (c[0] + c[1] + c[2]);
  const double radius = std::max({ norm(c[0] - middle), norm(c[1] - middle), norm(c[2] - middle) });
  const double bound = envelope.distance(middle) + 2.0 * radius;
  this->near_.clear();
  for (const DistanceCandidate& candidate : envelope.candidates())
  {
    if (candidate.distance(middle) <= bound)
    {
      this->near_.push_back(&candidate);
    }
  }
}

std::size_t InterpolationError::addRow(Vec2 p, double value)
{
  const std::size_t row = this->excess_.size();
  for (const DistanceCandidate* candidate : this->near_)
  {
    this->excess_.push_back(candidate->distance(p) - value);
  }
  return row;
}

double InterpolationError::leastInRow(std::size_t row) const
{
  const auto first = this->excess_.begin() + static_cast<std::ptrdiff_t>(row);
  return *std::min_element(first, first + static_cast<std::ptrdiff_t>(this->near_.size()));
}

InterpolationError::Inside InterpolationError::search(
  const FaceEnvelope& envelope, const LinearPiece& whole, double limit, bool tight)
{
  this->chooseNear(envelope, whole);
  this->excess_.clear();
  Inside result = { 0.0, 0.0 };
  Node root{ whole, 0, {} };
  for (std::size_t k = 0; k < 3; ++k)
  {
    root.row[k] = this->addRow(whole.corners[k], whole.values[k]);
    result.sample = std::max(result.sample, this->leastInRow(root.row[k]));
  }
  this->nodes_.assign(1, root);
  for (std::size_t pieces = 0; !this->nodes_.empty(); ++pieces)
  {
    const Node node = this->nodes_.back();
    this->nodes_.pop_back();
    const double enough =
      tight ? std::max(limit, (1.0 + tolerance::TightFraction) * result.sample) : limit;
    const double bound = this->boundOf(node, enough);
    if (bound <= enough || node.depth == tolerance::MostHalvings || pieces >= tolerance::MostPieces)
    {
      result.bound = std::max(result.bound, bound);
      if (result.bound > limit && !tight)
      {
        return result;
      }
      continue;
    }
    // halved at the longest edge
    const std::array<Vec2, 3>& c = node.piece.corners;
    std::size_t k = 0;
    for (std::size_t j = 1; j < 3; ++j)
    {
      const Vec2 edge = c[(j + 1) % 3] - c[j];
      const Vec2 longest = c[(k + 1) % 3] - c[k];
      k = dot(edge, edge) > dot(longest, longest) ? j : k;
    }
    const std::size_t next = (k + 1) % 3;
    const Vec2 middle = 0.5 * (c[k] + c[next]);
    const double value = 0.5 * (node.piece.values[k] + node.piece.values[next]);
    const std::size_t row = this->addRow(middle, value);
    result.sample = std::max(result.sample, this->leastInRow(row));
    if (result.sample > limit && !tight)
    {
      return { Infinity, result.sample };
    }
    for (const std::size_t replaced : { k, next })
    {
      Node half = node;
      half.depth = node.depth + 1;
      half.piece.corners[replaced] = middle;
      half.piece.values[replaced] = value;
      half.row[replaced] = row;
      this->nodes_.push_back(half);
    }
  }
  return result;
}

namespace
{

using AtCorners = std::array<double, 3>;

double largest(const AtCorners& excess)
{
  return std::max({ excess[0], excess[1], excess[2] });
}

AtCorners mixed(const AtCorners& a, const AtCorners& b, double weight)
{
  AtCorners result;
  for (std::size_t k = 0; k < 3; ++k)
  {
    result[k] = a[k] + weight * (b[k] - a[k]);
  }
  return result;
}

// The convex combination of two with the smallest largest excess: it is at an end or where two
// corners have the same.
AtCorners bestMix(const AtCorners& a, const AtCorners& b)
{
  AtCorners best = largest(a) <= largest(b) ? a : b;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const std::size_t j = (k + 1) % 3;
    const double difference = (b[j] - a[j]) - (b[k] - a[k]);
    const double weight = difference != 0.0 ? (a[k] - a[j]) / difference : -1.0;
    if (weight > 0.0 && weight < 1.0)
    {
      const AtCorners mix = mixed(a, b, weight);
      best = largest(mix) < largest(best) ? mix : best;
    }
  }
  return best;
}

} // anonymous namespace

double InterpolationError::boundOf(const Node& node, double limit)
{
  // the candidates that are least at each corner, the best of all, and from each corner on
  std::array<AtCorners, 7> candidates;
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
        candidates[k] = excess;
      }
    }
    if (largest(excess) < bound)
    {
      bound = largest(excess);
      candidates[3] = excess;
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
      candidates[4 + k][j] = least[k] + way - (node.piece.values[j] - node.piece.values[k]);
    }
  }
  AtCorners best = candidates[3];
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      const AtCorners mix = bestMix(candidates[i], candidates[j]);
      best = largest(mix) < largest(best) ? mix : best;
    }
  }
  for (const AtCorners& candidate : candidates)
  {
    const AtCorners mix = bestMix(best, candidate);
    best = largest(mix) < largest(best) ? mix : best;
  }
  return std::max(largest(best), 0.0);
}

}
