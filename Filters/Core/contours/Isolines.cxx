// SPDX-License-Identifier: BSD-3-Clause
#include "contours/Isolines.h"

#include "Errors.h"
#include "Tolerance.h"
#include "contours/FaceIsolines.h"
#include "contours/IsolineJoin.h"
#include "contours/IsolinesOnRanks.h"
#include "field/DistanceRange.h"
#include "field/SegmentEnvelope.h"

#include <algorithm>

namespace geodesic
{

namespace
{

constexpr std::size_t FacesPerTask = 32;
// The share of the job that the points on edges take.
constexpr double EdgesDone = 0.3;

void checkOptions(const IsolineOptions& options)
{
  const std::vector<double>& values = options.values;
  const bool ascending = std::adjacent_find(values.begin(), values.end(),
                           [](double a, double b) { return !(a < b); }) == values.end();
  if (values.empty() || !(values.front() > 0.0) || !(values.back() < Infinity) || !ascending)
  {
    throw Error("The values of isolines must be positive, finite and ascending, at least one.");
  }
  if (!(options.chordTolerance > 0.0))
  {
    throw Error("The chord tolerance of isolines must be positive.");
  }
}

// Corrects the x on an edge that was found on an envelope: windows of an envelope may differ where
// they meet, by tolerance::JointFraction. Then the distance in the face decides.
//
// \param line of the edge, from its begin.
double crossingByDistance(
  const FaceDistance& face, const PlaneLine& line, double length, double level, double found)
{
  constexpr int doublings = 8;
  constexpr int halvings = 60;
  const auto above = [&](double x) { return face.distance(line.point + x * line.along) - level; };
  const double off = above(found);
  const auto isBeyond = [&](double x) { return (above(x) < 0.0) != (off < 0.0); };
  if (std::abs(off) <= tolerance::IsolineValue * (level + length))
  {
    return found;
  }
  double step = std::abs(off);
  for (int i = 0; i < doublings; ++i, step *= 2.0)
  {
    for (double beyond : { std::max(0.0, found - step), std::min(length, found + step) })
    {
      if (isBeyond(beyond))
      {
        double before = found;
        for (int k = 0; k < halvings; ++k)
        {
          const double middle = 0.5 * (before + beyond);
          (isBeyond(middle) ? beyond : before) = middle;
        }
        return beyond;
      }
    }
  }
  return found;
}

class IsolineDrawing
{
public:
  IsolineDrawing(const DistanceField& field, const IsolineOptions& options)
    : field_(field)
    , mesh_(field.mesh())
    , options_(options)
  {
    for (const double value : options.values)
    {
      this->levels_.push_back(value * (1.0 - tolerance::BelowValue));
    }
    this->certain_ = this->levels_.back() * (1.0 + tolerance::BoundMargin);
  }

  Isolines run()
  {
    this->findFaces();
    this->findEdgePoints();
    std::vector<IsolinePieces> drawn =
      this->forTasks(this->options_.job.part(EdgesDone, 1.0), &IsolineDrawing::drawFaces);
    // A point is the vertex if it lies so near that rounding cannot separate them.
    std::vector<SurfacePoint> onEdges;
    onEdges.reserve(this->edgePoints_.size());
    for (const auto& [halfedge, value, fraction, rises] : this->edgePoints_)
    {
      const double size = this->levels_[value] + this->mesh_.length(halfedge);
      onEdges.push_back(
        placeOnHalfedge(this->mesh_, halfedge, fraction, tolerance::IsolineAtVertex * size));
    }
    Isolines result = joinPieces(this->mesh_, this->levels_, std::move(onEdges),
      pointsAtSeams(this->field_.surface(), this->edgePoints_), std::move(drawn));
    countTurnsAtSeams(this->mesh_, result);
    return result;
  }

private:
  void findFaces()
  {
    const MeshPartition& part = this->field_.surface();
    for (Id face = part.firstOwnFace(); face < part.endOfOwnFaces(); ++face)
    {
      if (!this->rangeOf(face).holdsOneOf(this->levels_))
      {
        continue;
      }
      if (!this->field_.knowsInside(face))
      {
        throw Error("Isolines were asked for in face " + std::to_string(face) +
          ", whose windows the solve did not keep.");
      }
      if (this->isReached(face) && !this->field_.isCovered(face))
      {
        this->faces_.push_back(face);
      }
    }
  }

  /// Whether a path comes to the face. The range of a face beyond the front holds the largest
  /// value, as far as its corners tell.
  bool isReached(Id face) const
  {
    const auto halfedges = TriangleMesh::halfedgesOf(face);
    return !this->field_.sourcesIn(face).empty() ||
      std::any_of(halfedges.begin(), halfedges.end(),
        [this](Id halfedge)
        {
          return this->field_.vertexDistances()[this->mesh_.origin(halfedge)] < Infinity ||
            !this->field_.windowsOn(halfedge).empty();
        });
  }

  bool isBelow(Id vertex, std::size_t value) const
  {
    return this->field_.vertexDistances()[vertex] < this->levels_[value];
  }

  /// Runs a task for ranges of the faces. A single face may have very many windows.
  template <typename Result>
  std::vector<Result> forTasks(const Job& job,
    Result (IsolineDrawing::*task)(std::size_t, std::size_t, const Job&) const) const
  {
    const std::size_t count = this->faces_.size();
    std::vector<Result> results((count + FacesPerTask - 1) / FacesPerTask);
    job.longTasks(results.size(),
      [&](std::size_t i, const Job& part)
      {
        const std::size_t at = i * FacesPerTask;
        results[i] = (this->*task)(at, std::min(at + FacesPerTask, count), part);
      });
    return results;
  }

  void findEdgePoints()
  {
    const auto found =
      this->forTasks(this->options_.job.part(0.0, EdgesDone), &IsolineDrawing::edgePointsOf);
    for (const std::vector<EdgePoint>& points : found)
    {
      this->edgePoints_.insert(this->edgePoints_.end(), points.begin(), points.end());
    }
    exchangeEdgePoints(this->field_.surface(), this->edgePoints_);
  }

  std::vector<EdgePoint> edgePointsOf(std::size_t first, std::size_t last, const Job& job) const
  {
    std::vector<EdgePoint> points;
    SegmentEnvelope envelope;
    FaceDistance distance(this->field_);
    for (std::size_t i = first; i < last; ++i)
    {
      job.look();
      this->addEdgePoints(this->faces_[i], envelope, distance, points);
    }
    return points;
  }

  /// Computes the points of those edges that are named by a halfedge of the face. Where the
  /// distance has a value on an edge, the ranges of all faces at the edge hold it.
  void addEdgePoints(Id face, SegmentEnvelope& envelope, FaceDistance& distance,
    std::vector<EdgePoint>& points) const
  {
    const bool hasSource = !this->field_.sourcesIn(face).empty();
    std::vector<SegmentCrossing> crossings;
    for (const Id halfedge : TriangleMesh::halfedgesOf(face))
    {
      const std::array<Id, 2> ends = { this->mesh_.origin(halfedge),
        this->mesh_.destination(halfedge) };
      const double length = this->mesh_.length(halfedge);
      DistanceRange range = rangeOnEdge(length, this->field_.vertexDistances()[ends[0]],
        this->field_.vertexDistances()[ends[1]], this->certain_);
      range.least = hasSource ? 0.0 : range.least;
      const auto [first, last] = range.indicesIn(this->levels_);
      if (first == last || this->mesh_.edgeOf(halfedge) != halfedge)
      {
        continue;
      }
      distance.enter(face);
      const std::size_t k = TriangleMesh::indexInFace(halfedge);
      const Vec2 p = distance.inPlane(cornerWeights(k));
      const Vec2 q = distance.inPlane(cornerWeights((k + 1) % 3));
      const PlaneLine line = { p, length > 0.0 ? (1.0 / length) * (q - p) : Vec2{} };
      for (std::size_t value = first; value < last; ++value)
      {
        crossings.clear();
        envelope.findCrossings(distance, p, q, this->levels_[value], this->isBelow(ends[0], value),
          this->isBelow(ends[1], value), crossings);
        for (const SegmentCrossing& crossing : crossings)
        {
          const double at =
            crossingByDistance(distance, line, length, this->levels_[value], crossing.at);
          const double fraction = length > 0.0 ? std::min(1.0, at / length) : 0.5;
          points.push_back({ halfedge, static_cast<Id>(value), fraction, crossing.rises });
        }
      }
    }
  }

  IsolinePieces drawFaces(std::size_t first, std::size_t last, const Job& job) const
  {
    IsolineTask task = { this->mesh_, static_cast<Id>(this->edgePoints_.size()),
      this->options_.chordTolerance, job, LevelArrangement(job), {} };
    std::vector<OutlinePoint> outline;
    FaceDistance distance(this->field_);
    for (std::size_t i = first; i < last; ++i)
    {
      const Id face = this->faces_[i];
      const bool hasSource = !this->field_.sourcesIn(face).empty();
      const auto [from, to] = this->rangeOf(face).indicesIn(this->levels_);
      for (std::size_t value = from; value < to; ++value)
      {
        job.look();
        const bool below = this->isBelow(this->mesh_.triangle(face)[0], value);
        this->findOutline(face, value, outline);
        if (outline.empty() && !below && !hasSource)
        {
          continue;
        }
        distance.enter(face);
        drawInFace(distance, this->levels_[value], static_cast<Id>(value), outline, below, task);
      }
    }
    return std::move(task.result);
  }

  void findOutline(Id face, std::size_t value, std::vector<OutlinePoint>& outline) const
  {
    outline.clear();
    const Id frame = longestHalfedge(this->mesh_, face);
    for (const Id halfedge : TriangleMesh::halfedgesOf(face))
    {
      const Id k = TriangleMesh::indexInFace(halfedge);
      const Vec2 begin = inHalfedgeFrame(this->mesh_, frame, cornerWeights(k));
      const Vec2 edge = inHalfedgeFrame(this->mesh_, frame, cornerWeights((k + 1) % 3)) - begin;
      const Id named = this->mesh_.edgeOf(halfedge);
      const bool isReversed = this->mesh_.origin(named) != this->mesh_.origin(halfedge);
      const std::size_t firstOfEdge = outline.size();
      auto p = std::partition_point(this->edgePoints_.begin(), this->edgePoints_.end(),
        [&](const EdgePoint& e)
        { return e.halfedge != named ? e.halfedge < named : e.value < value; });
      for (; p != this->edgePoints_.end() && p->halfedge == named && p->value == value; ++p)
      {
        const double t = isReversed ? 1.0 - p->fraction : p->fraction;
        outline.push_back({ begin + t * edge, static_cast<Id>(p - this->edgePoints_.begin()),
          p->rises != isReversed });
      }
      if (isReversed)
      {
        std::reverse(outline.begin() + static_cast<std::ptrdiff_t>(firstOfEdge), outline.end());
      }
    }
  }

  DistanceRange rangeOf(Id face) const
  {
    const std::vector<double>& d = this->field_.vertexDistances();
    const auto& [a, b, c] = this->mesh_.triangle(face);
    return rangeInFace(this->mesh_.shape(face), { d[a], d[b], d[c] }, this->certain_,
      !this->field_.sourcesIn(face).empty());
  }

  const DistanceField& field_;
  const TriangleMesh& mesh_;
  const IsolineOptions& options_;
  /// See tolerance::BelowValue.
  std::vector<double> levels_;
  /// Distances beyond this, which is over the largest value, need not be exact.
  double certain_;
  /// The faces of this rank that may contain a value, ascending.
  std::vector<Id> faces_;
  /// The points on the edges of these faces, ascending by halfedge and value.
  std::vector<EdgePoint> edgePoints_;
};

} // anonymous namespace

Isolines drawIsolines(const DistanceField& field, const IsolineOptions& options)
{
  checkOptions(options);
  return IsolineDrawing(field, options).run();
}

}
