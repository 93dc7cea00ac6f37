// SPDX-License-Identifier: BSD-3-Clause
// The schedule of vertices against a plain list of what waits.
#include "front/VertexSchedule.h"

#include "EngineSupport.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <future>
#include <iostream>
#include <thread>
#include <utility>
#include <vector>

using geodesic::Id;
using geodesic::Infinity;
using geodesic::VertexSchedule;
using geodesic::VertexStates;
using namespace geodesictest;

namespace
{

/// A schedule and what waits in it, as its owner knows it. Vertices wait at a key, or at their
/// distance because their lists have passed, or for both.
class ScheduleAndModel
{
public:
  explicit ScheduleAndModel(const std::vector<double>& batchWidths)
    : mesh_(engineMesh(regularGrid(2, static_cast<Index>(batchWidths.size()))))
    , states_(this->mesh_, false, false, geodesic::Job())
    , keys_(batchWidths.size(), Infinity)
  {
    for (Id v = 0; v < batchWidths.size(); ++v)
    {
      this->states_[v].batchWidth = static_cast<float>(batchWidths[v]);
    }
  }

  /// Where the last batch began.
  double front() const { return this->front_; }
  bool isAnyWaiting() const { return this->leastWaiting() < Infinity; }

  void add(Id vertex, double distance)
  {
    this->schedule_.add(vertex, distance);
    if (!this->hasPassed(vertex) || distance < this->states_[vertex].distance)
    {
      this->keys_[vertex] = std::min(this->keys_[vertex], std::max(distance, this->front_));
    }
  }

  /// Lets a vertex wait at its distance, or makes the distance smaller at which it waits.
  void pass(Id vertex, double distance)
  {
    geodesic::VertexState& state = this->states_[vertex];
    if (!state.hasPassed)
    {
      state.distance = distance;
      state.hasPassed = true;
      this->schedule_.addPassed(vertex);
    }
    else if (distance < state.distance)
    {
      state.distance = distance;
      this->schedule_.add(vertex, distance); // the same once more
    }
  }

  /// What must hold of any batch: all that wait up to its end are taken, each once, and no others.
  void expectBatch(double mostLast)
  {
    const VertexSchedule::Outlook outlook = this->schedule_.outlook();
    EXPECT_EQ(outlook.least, this->leastWaiting());
    double shortest = Infinity;
    for (Id v = 0; v < this->keys_.size(); ++v)
    {
      shortest =
        std::min(shortest, this->keys_[v] + static_cast<double>(this->states_[v].batchWidth));
    }
    EXPECT_EQ(outlook.last, shortest) << "of all that wait at a key, also far away";
    const double last = std::min(outlook.last, mostLast);
    if (outlook.least < Infinity)
    {
      this->front_ = std::max(this->front_, std::min(outlook.least, last));
    }
    this->schedule_.moveOn(this->front_);
    EXPECT_EQ(this->schedule_.key(), this->front_);
    std::vector<Id> taken = { 0 };
    this->schedule_.takeBatch(last, taken);
    EXPECT_EQ(this->schedule_.last(), last);
    std::sort(taken.begin(), taken.end());
    EXPECT_EQ(taken, this->removeUpTo(last));
    std::vector<bool> waits(this->keys_.size(), false);
    EXPECT_FALSE(this->schedule_.isAnyWaiting(
      [&waits](Id vertex)
      {
        waits[vertex] = true;
        return false; // go on
      }));
    EXPECT_EQ(this->schedule_.isAnyWaiting([](Id) { return true; }), this->isAnyWaiting());
    for (Id v = 0; v < this->keys_.size(); ++v)
    {
      EXPECT_EQ(waits[v], this->keys_[v] < Infinity || this->hasPassed(v));
    }
  }

private:
  bool hasPassed(Id vertex) const { return this->states_[vertex].hasPassed; }

  double leastWaiting() const
  {
    double least = *std::min_element(this->keys_.begin(), this->keys_.end());
    for (Id v = 0; v < this->keys_.size(); ++v)
    {
      least = this->hasPassed(v)
        ? std::min(least, std::max(this->front_, this->states_[v].distance))
        : least;
    }
    return least;
  }

  std::vector<Id> removeUpTo(double last)
  {
    std::vector<Id> removed;
    for (Id v = 0; v < this->keys_.size(); ++v)
    {
      const bool passes = this->hasPassed(v) && this->states_[v].distance <= last;
      const bool isTaken = this->keys_[v] <= last && this->keys_[v] < Infinity;
      if (passes || isTaken)
      {
        removed.push_back(v);
      }
      this->states_[v].hasPassed = this->hasPassed(v) && !passes;
      this->keys_[v] = isTaken ? Infinity : this->keys_[v];
    }
    return removed;
  }

  geodesic::TriangleMesh mesh_;
  VertexStates states_;
  VertexSchedule schedule_{ this->states_ };
  std::vector<double> keys_;
  double front_ = 0.0;
};

}

TEST(VertexSchedule, RandomAdditionsAndBatchesAreThoseOfAList)
{
  for (Random& random : EachSeed(200))
  {
    const Id count = random.chance(0.5) ? random.between(1, 10) : random.between(10, 300);
    // Edges of one length, of two that differ much, or with some of no length.
    const double largeWidth = std::vector<double>{ 1.0, 1e4, 1e-4, 0.0 }[random.below(4)];
    std::vector<double> batchWidths(count);
    for (double& width : batchWidths)
    {
      width = random.chance(0.3) ? largeWidth : random.uniform(0.5, 1.5);
    }
    ScheduleAndModel schedule(batchWidths);
    const auto someDistance = [&]()
    {
      return schedule.front() +
        (random.chance(0.3)      ? 1.0
            : random.chance(0.2) ? random.uniform(-2.0, 0.0)
                                 : random.uniform(1e-3, 60.0));
    };
    schedule.expectBatch(Infinity); // of none
    for (int step = 0; step < 300; ++step)
    {
      for (Index left = random.below(20); left > 0; --left)
      {
        schedule.add(random.below(count), someDistance());
      }
      for (Index left = random.below(3); left > 0; --left)
      {
        schedule.pass(random.below(count), someDistance());
      }
      schedule.expectBatch(random.chance(0.3) ? schedule.front() + random.uniform(0.0, 2.0) : 1e6);
    }
    for (Id batch = 0; batch < 2 * count && schedule.isAnyWaiting(); ++batch)
    {
      schedule.expectBatch(Infinity);
    }
    EXPECT_FALSE(schedule.isAnyWaiting()) << "each batch takes one at least";
  }
}

namespace
{

/// Runs a function and ends the program where it takes longer than a minute.
template <typename Run>
auto withinAMinute(Run run)
{
  std::packaged_task<decltype(run())()> task(std::move(run));
  auto result = task.get_future();
  std::thread thread(std::move(task));
  if (result.wait_for(std::chrono::minutes(1)) != std::future_status::ready)
  {
    std::cout << "[  FAILED  ] no end within a minute" << std::endl;
    std::_Exit(EXIT_FAILURE); // nothing else stops the thread
  }
  thread.join();
  return result.get();
}

}

// Every second column lies where the last one does, so that edges across have no length, and from
// many vertices nothing is within the batch width but what is equally far. The surface is a flat
// strip still.
TEST(VertexSchedule, TheFrontEndsWhereEdgesHaveNoLength)
{
  for (Random& random : EachSeed(20))
  {
    PlainMesh mesh = renumbered(regularGrid(40, 40), random).mesh;
    for (Vec3& p : mesh.points)
    {
      p[0] = 2.0 * std::floor(0.5 * p[0]);
    }
    Sources sources;
    sources.points = { vertexPoint(mesh, 0) };
    const EngineResult result = withinAMinute([&]() { return engineDistances(mesh, sources); });
    for (Index v = 0; v < mesh.points.size(); ++v)
    {
      EXPECT_NEAR(result.vertices[v], spaceDistance(mesh.points[v], mesh.points[0]), 1e-12)
        << "vertex " << v;
    }
  }
}
