// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RefinementWorkers_h
#define geodesic_RefinementWorkers_h

#include "Progress.h"
#include "refinement/DistancesInFaces.h"
#include "refinement/TriangleError.h"

#include <memory>
#include <vector>

namespace geodesic
{

/// Reports to a callback how far a refinement is; the fraction never decreases.
class RefinementProgress
{
public:
  explicit RefinementProgress(const ProgressCallback& callback)
    : callback_(ascending(callback))
    , paced_(paced(this->callback_))
  {
  }
  RefinementProgress(const RefinementProgress&) = delete;
  RefinementProgress& operator=(const RefinementProgress&) = delete;

  /// Called once per step with the estimated fraction done.
  ///
  /// \throws Aborted
  void at(double fraction)
  {
    constexpr unsigned stepsPerReport = 256;
    if (this->steps_++ % stepsPerReport == 0)
    {
      this->tell(fraction);
    }
  }

  /// Called at the end of a longer step.
  ///
  /// \throws Aborted
  void tell(double fraction) { reportProgress(this->callback_, std::min(fraction, 1.0)); }

  /// Called between the pieces of a step, which may take long if faces have very many windows.
  ///
  /// \throws Aborted
  void look() const { reportProgress(this->paced_, 0.0); }

private:
  ProgressCallback callback_;
  ProgressCallback paced_;
  unsigned steps_ = 0;
};

/// The tools of one task of a refinement.
struct RefinementWorker
{
  RefinementWorker(const DistanceField& field, const RedGreenMesh& triangles)
    : distances(field, triangles)
    , error(field)
  {
  }

  DistancesInFaces distances;
  TriangleError error;
};

/// The workers of a refinement, and the deviations of edges, each of which they measure once. The
/// number of a loop's items alone determines its tasks, each of which has a worker of its own.
class RefinementWorkers
{
public:
  /// All arguments must outlive this.
  ///
  /// \param parallelFor if empty, one task.
  /// \param progress checked every few items.
  RefinementWorkers(const DistanceField& field, const RedGreenMesh& triangles,
    const ParallelFor& parallelFor, const RefinementProgress& progress)
    : field_(field)
    , triangles_(triangles)
    , parallelFor_(parallelFor)
    , progress_(progress)
  {
    this->resize(1);
  }

  /// The worker for work between loops: one edge or leaf after another, which may lead to many
  /// more.
  ///
  /// \throws Aborted
  RefinementWorker& first()
  {
    this->progress_.look();
    return *this->workers_.front();
  }

  /// Runs item(worker, i) for i below `items`.
  ///
  /// \throws Aborted
  template <typename Item>
  void run(std::size_t items, const Item& item)
  {
    forItems(
      this->parallelFor_, items, [this]() { this->progress_.look(); },
      [this](std::size_t tasks) { this->resize(tasks); },
      [&](std::size_t task, std::size_t i) { item(*this->workers_[task], i); });
  }

  /// The largest deviations of an edge; measures it if necessary.
  Deviation deviation(Id edge);
  /// Measures all edges that have not been measured yet, in parallel.
  void measure(const std::vector<Id>& edges);
  /// The largest deviations of a measured edge; may be called from several threads.
  Deviation measured(Id edge) const { return this->edges_[edge].deviation; }
  /// Forgets the edges that no longer exist.
  void forgetNewEdges();

private:
  struct Edge
  {
    Deviation deviation;
    bool isMeasured = false;
  };

  void resize(std::size_t count);

  const DistanceField& field_;
  const RedGreenMesh& triangles_;
  const ParallelFor& parallelFor_;
  const RefinementProgress& progress_;
  std::vector<std::unique_ptr<RefinementWorker>> workers_;
  std::vector<Edge> edges_;
};

}

#endif
