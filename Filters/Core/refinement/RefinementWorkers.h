// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RefinementWorkers_h
#define geodesic_RefinementWorkers_h

#include "Tasks.h"
#include "refinement/DistancesInFaces.h"
#include "refinement/TriangleError.h"

#include <memory>
#include <vector>

namespace geodesic
{

/// What one task of a refinement works with.
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

/// The workers of a refinement. A loop is cut into tasks by its number of items alone, each with a
/// worker of its own.
class RefinementWorkers
{
public:
  /// All must outlive this.
  ///
  /// \param parallelFor absent: one task.
  RefinementWorkers(
    const DistanceField& field, const RedGreenMesh& triangles, const ParallelFor& parallelFor)
    : field_(field)
    , triangles_(triangles)
    , parallelFor_(parallelFor)
  {
    this->resize(1);
  }

  /// For what is done between loops.
  RefinementWorker& first() { return *this->workers_.front(); }

  /// Runs item(worker, i) for i below `items`.
  template <typename Item>
  void run(std::size_t items, const Item& item)
  {
    constexpr std::size_t itemsPerTask = 2;
    constexpr std::size_t mostTasks = 64;
    const std::size_t tasks =
      this->parallelFor_ ? std::clamp<std::size_t>(items / itemsPerTask, 1, mostTasks) : 1;
    this->resize(tasks);
    forAll(this->parallelFor_, tasks,
      [&](std::size_t task)
      {
        const std::size_t end = (task + 1) * items / tasks;
        for (std::size_t i = task * items / tasks; i < end; ++i)
        {
          item(*this->workers_[task], i);
        }
      });
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
  std::vector<std::unique_ptr<RefinementWorker>> workers_;
};

}

#endif
