// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_VertexStates_h
#define geodesic_VertexStates_h

#include "Job.h"
#include "Tolerance.h"
#include "front/Arrival.h"
#include "front/Retention.h"
#include "mesh/TriangleMesh.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace geodesic
{

/// A path to a vertex, possibly shorter than the known ones.
struct DistanceUpdate
{
  Id vertex;
  double distance;
  /// How much longer than the distance its path can be.
  double error;
  Arrival from;
};

/// The state of a vertex; fields that are used together are stored together.
struct VertexState
{
  double distance = Infinity;
  /// The distance with which it was last processed.
  double processed = Infinity;
  /// Where its path comes from (an Arrival without its padding).
  double arrivalX = 0.0;
  Id arrivalHalfedge = NoId;
  /// The group of the lists on the halfedges opposite it (WaitingLists); NoId if none wait.
  Id facing = NoId;
  /// Its slot in the heap of its district's schedule, if it waits there.
  Id slot = 0;
  /// How much farther the other vertices of its batch may be.
  float batchWidth = 0.0F;
  /// Whether it emits windows: a saddle vertex into its shadow, an irregular one everywhere.
  TriangleMesh::PseudoSource pseudoSource = TriangleMesh::PseudoSource::None;
  /// How often it was processed, up to the largest number.
  std::uint8_t timesProcessed = 0;
  bool hasThinFaces = false;
  /// Whether it waits in its district's schedule: ahead of the front in the heap, or behind it.
  enum class Waits : std::uint8_t
  {
    No,
    InHeap,
    Behind
  };
  Waits waits = Waits::No;
  /// Within an error: whether its lists have passed, so that it settles in its next batch.
  bool hasPassed = false;

  Arrival arrival() const { return { this->arrivalHalfedge, {}, this->arrivalX }; }
  /// Whether windows may come again and again to halfedges opposite it. On scans hardly any vertex
  /// is processed more often.
  bool isBusy() const { return this->hasThinFaces || this->isProcessedOften(); }
  bool isProcessedOften() const { return this->timesProcessed >= 4; }
  void countProcessing()
  {
    if (this->timesProcessed < std::numeric_limits<std::uint8_t>::max())
    {
      ++this->timesProcessed;
    }
  }
  /// Whether its distance is shorter than the processed one by more than a fraction.
  bool isShorter(double tie) const { return this->distance < this->processed * (1.0 - tie); }
};

/// The distances found so far, at all vertices.
class VertexStates
{
public:
  /// \param withErrors whether distances may be of merged windows, whose errors are stored.
  /// \param withArrivals whether arrivals are stored, for tracing paths.
  VertexStates(const TriangleMesh& mesh, bool withErrors, bool withArrivals, const Job& job)
    : mesh_(mesh)
    , tie_(withErrors ? tolerance::Tie : tolerance::SameEmission)
    , errors_(withErrors ? mesh.numberOfVertices() : 0, 0.0)
    , arrivals_(withArrivals ? mesh.numberOfVertices() : 0)
  {
    // Fresh memory takes time, too.
    constexpr Id verticesPerReport = 1U << 16;
    this->states_.reserve(mesh.numberOfVertices());
    while (this->size() < mesh.numberOfVertices())
    {
      job.reachItem(this->size(), mesh.numberOfVertices());
      this->states_.resize(
        std::min<std::size_t>(this->size() + verticesPerReport, mesh.numberOfVertices()));
    }
    job.loop(this->states_.size(),
      [this](std::size_t i)
      {
        const Id vertex = static_cast<Id>(i);
        VertexState& state = this->states_[vertex];
        state.pseudoSource = this->mesh_.pseudoSource(vertex);
        // takeFaces() limits it.
        state.batchWidth =
          this->mesh_.cornersAt(vertex).size() > 0 ? std::numeric_limits<float>::max() : 0.0F;
      });
    this->takeFaces();
  }

  Id size() const { return static_cast<Id>(this->states_.size()); }
  const VertexState& operator[](Id vertex) const { return this->states_[vertex]; }
  VertexState& operator[](Id vertex) { return this->states_[vertex]; }
  double distance(Id vertex) const { return this->states_[vertex].distance; }
  /// Whether a vertex has to be processed, as its distance has become shorter.
  bool isShorter(const VertexState& state) const { return state.isShorter(this->tie_); }
  /// How much longer than the vertex's distance its path can be: 0 in the exact solve.
  double error(Id vertex) const { return this->errors_.empty() ? 0.0 : this->errors_[vertex]; }

  /// Whether a path improves a vertex: it is shorter, or it has the same length and an arrival,
  /// which is to be stored and may be better than the known one.
  bool isImprovedBy(Id vertex, double distance, bool hasArrival = true) const
  {
    return distance < this->distance(vertex) ||
      (hasArrival && !this->arrivals_.empty() && this->isArrivalWanted(vertex, distance));
  }

  /// Accepts a path if it is shorter than the known one. \returns whether it was.
  bool shorten(const DistanceUpdate& update)
  {
    // Rounding may put a linear window's distance below 0 at its source.
    const double distance = std::max(update.distance, 0.0);
    VertexState& state = this->states_[update.vertex];
    const bool isShorter = distance < state.distance;
    if (!isShorter && this->arrivals_.empty())
    {
      return false;
    }
    const auto isTie = [&, isBound = isShorter && this->isBoundOnly(update)](double tie)
    { return distance >= state.distance * (1.0 - tie) || isBound; };
    if (!this->arrivals_.empty() &&
      ((isShorter && !isTie(this->isStraight(update) ? tolerance::Evaluation : tolerance::Tie)) ||
        this->isBetterArrival(update, distance)))
    {
      this->arrivals_[update.vertex] = update.from;
    }
    if (!isShorter)
    {
      return false;
    }
    if (!isTie(this->tie_) || state.arrivalHalfedge == NoId)
    {
      state.arrivalHalfedge = update.from.halfedge;
      state.arrivalX = update.from.x;
    }
    state.distance = distance;
    if (!this->errors_.empty())
    {
      this->errors_[update.vertex] = update.error;
    }
    return true;
  }

  /// Moves the arrivals out.
  std::vector<Arrival> releaseArrivals() { return std::move(this->arrivals_); }

  VertexNumbers distances() const { return this->each(&VertexState::distance); }
  VertexNumbers processed() const { return this->each(&VertexState::processed); }

private:
  VertexNumbers each(double VertexState::*number) const
  {
    static_assert(sizeof(VertexState) % sizeof(double) == 0);
    const double* first = this->states_.empty() ? nullptr : &(this->states_.front().*number);
    return { first, sizeof(VertexState) / sizeof(double) };
  }

  // Vertices belong to one batch if none is farther than another by more than half an edge: windows
  // from one of them then seldom reach another. From 0.25 to 2 edges the number of windows hardly
  // changes. It is the shortest edge at a vertex, which does not depend on the order of the faces:
  // batches are the same however ranks share the surface.
  //
  // In strips of thin faces, the distances of vertices side by side along the long edges differ by
  // the square of the altitude over the length. If one batch held many of these vertices, their
  // windows would pass through the strips side by side, each alone, and none would be merged.
  void takeFaces()
  {
    for (Id face = 0; face < this->mesh_.numberOfFaces(); ++face)
    {
      const FaceShape& shape = this->mesh_.shape(face);
      const Triangle& corners = this->mesh_.triangle(face);
      for (std::size_t k = 0; k < 3; ++k)
      {
        const double shorter = std::min(shape.length[k], shape.length[(k + 2) % 3]);
        this->limitBatchWidth(corners[k], static_cast<float>(0.5 * shorter));
      }
      this->longestEdge_ = std::max(this->longestEdge_, shape.longest());
      if (shape.isThin())
      {
        const double altitude = shape.area2 / shape.longest();
        const float width = static_cast<float>(0.5 * altitude * (altitude / shape.longest()));
        for (const Id vertex : corners)
        {
          this->states_[vertex].hasThinFaces = true;
          this->limitBatchWidth(vertex, width);
        }
      }
    }
  }

  void limitBatchWidth(Id vertex, float width)
  {
    this->states_[vertex].batchWidth = std::min(this->states_[vertex].batchWidth, width);
  }

  // At the end of a curve beside an edge the curve's parallel rays come first to a vertex behind
  // the edge, and bend. The straight path from the end is shorter, but for rounding. Merged
  // windows have no such ties: their paths are longer than their distances.
  bool isArrivalWanted(Id vertex, double distance) const
  {
    const Arrival& known = this->arrivals_[vertex];
    const bool isTie = distance <= this->distance(vertex) * (1.0 + tolerance::Tie);
    return known.isKnown() ? isTie && this->errors_.empty() && isBent(this->mesh_, known)
                           : isTie || this->isTieAround(vertex, distance);
  }
  bool isBetterArrival(const DistanceUpdate& update, double distance) const
  {
    return this->isArrivalWanted(update.vertex, distance) &&
      (!this->arrivals_[update.vertex].isKnown() || this->isStraight(update));
  }
  // Whether an exact path does not bend. Such a path, which is shorter by less than a tie, lies
  // beside the other by the root of the tie: in a needle that may be as much as its altitude.
  bool isStraight(const DistanceUpdate& update) const
  {
    return this->errors_.empty() && update.from.isKnown() && !isBent(this->mesh_, update.from);
  }
  /// A bound along an edge does not determine the arrival: one that is a rounding longer stays.
  bool isBoundOnly(const DistanceUpdate& update) const
  {
    return !update.from.isKnown() && this->distance(update.vertex) < Infinity &&
      this->distance(update.vertex) - update.distance <= this->tieAround(update.vertex);
  }

  // A path across a needle carries the rounding of the needle's long edges.
  double tieWith(Id vertex, double longestEdge) const
  {
    return tolerance::Tie * (this->distance(vertex) + longestEdge);
  }
  double tieAround(Id vertex) const
  {
    double longest = 0.0;
    for (const Id corner : this->mesh_.cornersAt(vertex))
    {
      longest = std::max(longest, this->mesh_.length(corner));
    }
    return this->tieWith(vertex, longest);
  }
  // Most paths are longer than any edge allows, and the edges at the vertex, perhaps very many,
  // need not be searched.
  bool isTieAround(Id vertex, double distance) const
  {
    const double known = this->distance(vertex);
    return distance <= known + this->tieWith(vertex, this->longestEdge_) &&
      distance <= known + this->tieAround(vertex);
  }

  const TriangleMesh& mesh_;
  /// A vertex whose distance becomes shorter by no more than this fraction is not processed again.
  /// Within an error nothing is lost by it.
  double tie_;
  /// The surface's.
  double longestEdge_ = 0.0;
  std::vector<VertexState> states_;
  /// Empty in the exact solve.
  std::vector<double> errors_;
  /// Empty if not requested.
  std::vector<Arrival> arrivals_;
};

}

#endif
