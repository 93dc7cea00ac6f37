// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SolveForRefinement_h
#define geodesic_SolveForRefinement_h

#include "Job.h"
#include "field/SolveDropping.h"
#include "mesh/MeshPartition.h"
#include "mesh/TriangleMesh.h"
#include "refinement/FaceBounds.h"

#include <functional>
#include <memory_resource>
#include <queue>
#include <utility>
#include <vector>

namespace geodesic
{

/// Keeps the windows of faces that may have to be refined, and drops those of other faces as the
/// front passes.
///
/// A face is tested once the front has passed it (testLinear()). If the distance in it is linear
/// within the tolerance, it needs no windows, unless a neighbour is refined and splits its edges.
/// Bounds.md says what is done about later windows.
///
/// If ranks share the surface, each looks after the faces that it owns. It knows nothing of the
/// others, so faces beside them keep their windows.
class RefinementRetention : public DroppingRetention
{
public:
  /// \param job of the front, for tests of faces between batches. The kept windows do not depend on
  ///        its threads.
  RefinementRetention(
    const MeshPartition& surface, double tolerance, const PinnedFaces& pinned, const Job& job = {});

  void start(std::size_t districts, const std::vector<SourceInFace>& sources) override;
  void pass(std::size_t district, const PassedList& list, Id batch, WindowPool& pool) override;
  void shortenDistance(Id vertex) override;
  void advance(const FrontState& front) override;
  void finish(const FrontState& front) override;

private:
  enum class State : std::uint8_t
  {
    Open,
    /// The front has not passed it yet.
    Awaited,
    /// Its windows are never dropped, or another rank owns it.
    Kept,
    Linear,
    /// Linear, with its windows dropped.
    Dropped
  };

  bool isOpen(Id face) const
  {
    return this->state_[face] == State::Open || this->state_[face] == State::Awaited;
  }
  bool isLinear(Id face) const
  {
    return this->state_[face] == State::Linear || this->state_[face] == State::Dropped;
  }
  void takePassed();
  void keep(Id face);
  void test(const std::vector<Id>& due, const FrontState& front);
  void take(Id face, const LinearFaceTest& result, const FrontState& front);
  void dropIfUnneeded(Id face, const FrontState& front);

  MeshPartition surface_;
  const TriangleMesh& mesh_;
  Job job_;
  double tolerance_;
  std::vector<State> state_;
  /// The number of neighbours that may need a linear face's windows.
  std::vector<Id> neededBy_;
  /// The lists of each face that are still kept. Their memory serves faces that come later.
  std::pmr::unsynchronized_pool_resource memory_;
  std::pmr::vector<MeasuredLists> lists_;
  using Awaited = std::pair<double, Id>;
  std::priority_queue<Awaited, std::vector<Awaited>, std::greater<Awaited>> awaited_;
  /// The lists that each district has handed over in this batch.
  std::vector<std::vector<MeasuredList>> passed_;
};

/// Computes a field that refine() can refine to this or a larger tolerance. It keeps windows only
/// where faces are pinned or the distance is not linear within the tolerance (solveDropping()). An
/// approximate solve keeps all windows, and merges those of one halfedge by at most
/// maximumMergedFor(tolerance), whatever the relative error.
///
/// \param surface, sources, options, pinned as for solveDropping().
/// \param tolerance in the surface's units, positive.
/// \throws as solve().
DistanceField solveForRefinement(const MeshPartition& surface, const SourceWindows& sources,
  double tolerance, const FrontOptions& options, PinnedFaces& pinned);

/// How much merging may change the distance on one halfedge of an approximate field that will be
/// refined to a tolerance: a tenth of the tolerance (window/Merging.md).
double maximumMergedFor(double tolerance);

}

#endif
