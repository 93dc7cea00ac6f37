// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RefinementWorkers_h
#define geodesic_RefinementWorkers_h

#include "Tasks.h"
#include "refinement/DistancesInFaces.h"
#include "refinement/RefinementProgress.h"
#include "refinement/TriangleError.h"

#include <memory>
#include <vector>

namespace geodesic
{

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

/// The workers of a refinement. The number of a loop's items alone determines its tasks, each of
/// which has a worker of its own.
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

private:
  void resize(std::size_t count)
  {
    while (this->workers_.size() < count)
    {
      this->workers_.push_back(std::make_unique<RefinementWorker>(this->field_, this->triangles_));
    }
  }

  const DistanceField& field_;
  const RedGreenMesh& triangles_;
  const ParallelFor& parallelFor_;
  const RefinementProgress& progress_;
  std::vector<std::unique_ptr<RefinementWorker>> workers_;
};

}

#endif
