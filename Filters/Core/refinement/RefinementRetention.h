// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RefinementRetention_h
#define geodesic_RefinementRetention_h

#include "front/Retention.h"
#include "mesh/TriangleMesh.h"
#include "refinement/InterpolationError.h"

#include <queue>
#include <utility>
#include <vector>

namespace geodesic
{

/// Keeps the windows of faces that may have to be refined, and drops those of the others as the
/// front passes.
///
/// Let A and B bound how far the distance is over and under the linear interpolant L of a face's
/// corners. Where the face is closed by triangles between points of its edges, their values are
/// exact, so that the closure l is over L by at most A and under it by at most B: |l - d| <= A + B.
/// Where that is within the tolerance the distance counts as linear in the face. Windows that come
/// later make d only smaller, so that A stays what it is; B is looked at again. Where it is too
/// large then and the windows before are gone, the face was dropped too early: the solve has to be
/// done again with the face pinned.
class RefinementRetention : public Retention
{
public:
  /// \param pinned for each face, whether its windows are never dropped.
  RefinementRetention(
    const TriangleMesh& mesh, double tolerance, const std::vector<std::uint8_t>& pinned);

  bool needsInside() const override { return true; }
  void setNumberOfWorkers(std::size_t count) override { this->passed_.resize(count); }
  void start(const std::vector<SourceInFace>& sources) override;
  void pass(std::size_t worker, const PassedList& list, Id batch, WindowPool& pool) override;
  void shortenDistance(Id vertex) override;
  void advance(const FrontState& front) override;
  void finish(const FrontState& front) override;

  KeptWindows release() { return std::move(this->kept_); }
  /// Faces whose windows were dropped too early.
  const std::vector<Id>& droppedTooEarly() const { return this->droppedTooEarly_; }

private:
  enum class State : std::uint8_t
  {
    Open,
    /// The front is to come past it.
    Awaited,
    Kept,
    Linear,
    /// Linear, and its windows are gone.
    Dropped
  };
  /// A list, and whether it is within tolerance::NearLine of the line between the distances at its
  /// ends.
  struct MeasuredList
  {
    PassedList list;
    NearLine near;
  };
  struct Run
  {
    MeasuredList measured;
    Id next;
  };

  template <typename Visit>
  void forEachNeighbour(Id face, Visit&& visit) const;
  bool isOpen(Id face) const
  {
    return this->state_[face] == State::Open || this->state_[face] == State::Awaited;
  }
  std::array<double, 3> atCorners(Id face, const VertexNumbers& distances) const;
  double rounding(const std::array<double, 3>& d) const;
  void take(
    std::vector<MeasuredList>& lists, const VertexNumbers& distances, WindowPool& pool);
  void add(const MeasuredList& measured);
  void awaitFacesAround(Id vertex, const VertexNumbers& processed);
  void test(Id face, const VertexNumbers& distances, WindowPool& pool);
  FaceBounds quickBounds(Id face, const std::array<double, 3>& d) const;
  FaceBounds bounds(Id face, const std::array<double, 3>& d, double limit) const;
  bool passes(Id face, const FaceBounds& bounds, double rounding, double limit);
  void keep(Id face);
  void release(Id face, WindowPool& pool);
  void drop(Id face, WindowPool& pool);
  // Blocks go back to the workers in turn, so that all of them find some.
  WindowPool& anyPool(const FrontState& front)
  {
    return *front.pools[this->nextPool_++ % front.pools.size()];
  }

  const TriangleMesh& mesh_;
  double tolerance_;
  std::vector<State> state_;
  /// How far the distance can be over the interpolant in a linear face.
  std::vector<float> above_;
  /// How many neighbours may need the face's windows although it is linear.
  std::vector<Id> neededBy_;
  std::vector<Run> runs_;
  std::vector<Id> freeRuns_;
  std::vector<Id> firstRun_;
  using Awaited = std::pair<double, Id>;
  std::priority_queue<Awaited, std::vector<Awaited>, std::greater<Awaited>> awaited_;
  std::vector<Id> droppedTooEarly_;
  /// What each worker has handed over in this batch.
  std::vector<std::vector<MeasuredList>> passed_;
  std::size_t nextPool_ = 0;
  KeptWindows kept_;
};

}

#endif
