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
#include <map>
#include <set>
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

/// A schedule and what waits in it, as its owner knows it: a key and a batch width of each vertex.
class ScheduleAndModel
{
public:
  explicit ScheduleAndModel(std::vector<double> batchWidths)
    : mesh_(engineMesh(regularGrid(2, static_cast<Index>(batchWidths.size()))))
    , states_(this->mesh_, false, false, geodesic::Job())
    , keys_(batchWidths.size(), Infinity)
  {
    for (Id v = 0; v < batchWidths.size(); ++v)
    {
      this->states_[v].batchWidth = static_cast<float>(batchWidths[v]);
    }
  }

  /// Lets a vertex wait, or wait with a smaller key.
  void add(double key, Id vertex)
  {
    if (key < this->keys_[vertex])
    {
      this->waiting_.erase({ this->keys_[vertex], vertex });
      this->keys_[vertex] = key;
      this->waiting_.insert({ key, vertex });
    }
    this->schedule_.add(vertex, key);
  }

  double least() const { return this->schedule_.outlook().least; }

  std::vector<Id> takeBatch(double last)
  {
    std::vector<Id> taken;
    this->schedule_.takeBatch(std::min(last, this->schedule_.outlook().last), taken);
    for (const Id vertex : taken)
    {
      this->takenKeys_[vertex] = this->keys_[vertex];
      this->waiting_.erase({ this->keys_[vertex], vertex });
      this->keys_[vertex] = Infinity;
    }
    return taken;
  }

  double batchWidth(Id vertex) const
  {
    return static_cast<double>(this->states_[vertex].batchWidth);
  }
  /// The key with which a vertex was last taken.
  double takenKey(Id vertex) const { return this->takenKeys_.at(vertex); }
  /// Sorted.
  const std::set<std::pair<double, Id>>& waiting() const { return this->waiting_; }
  double leastWaiting() const
  {
    return this->waiting_.empty() ? Infinity : this->waiting_.begin()->first;
  }
  VertexSchedule& schedule() { return this->schedule_; }

  /// Lets a vertex whose lists have passed wait at its distance.
  void addPassed(double distance, Id vertex)
  {
    this->states_[vertex].distance = distance;
    this->states_[vertex].hasPassed = true;
    this->schedule_.addPassed(vertex);
  }
  void settle(Id vertex) { this->states_[vertex].hasPassed = false; }
  /// Lets a vertex wait whose distance has become smaller.
  void shorten(double distance, Id vertex)
  {
    this->states_[vertex].distance = distance;
    this->schedule_.add(vertex, distance);
  }

private:
  geodesic::TriangleMesh mesh_;
  VertexStates states_;
  VertexSchedule schedule_{ this->states_ };
  std::vector<double> keys_;
  std::map<Id, double> takenKeys_;
  std::set<std::pair<double, Id>> waiting_;
};

/// What must hold of any batch: all that is taken waited, up to the least sum of key and batch
/// width; what is left lies behind it; and the least one is in the batch.
void expectBatch(ScheduleAndModel& schedule, double last)
{
  const std::set<std::pair<double, Id>> before = schedule.waiting();
  const double least = schedule.leastWaiting();
  EXPECT_EQ(schedule.least(), least);
  double end = last;
  for (const auto& [key, vertex] : before)
  {
    end = std::min(end, key + schedule.batchWidth(vertex));
  }
  const auto expected = std::count_if(
    before.begin(), before.end(), [end](const auto& waiting) { return waiting.first <= end; });
  const std::vector<Id> taken = schedule.takeBatch(last);
  EXPECT_EQ(taken.size(), static_cast<std::size_t>(expected))
    << "the width of what waits far away ends the batch, too";
  EXPECT_EQ(before.size(), schedule.waiting().size() + taken.size()) << "lost, or taken twice";
  double most = 0.0;
  double shortest = last;
  for (const Id vertex : taken)
  {
    most = std::max(most, schedule.takenKey(vertex));
    shortest = std::min(shortest, schedule.takenKey(vertex) + schedule.batchWidth(vertex));
  }
  EXPECT_LE(most, shortest) << "farther than the width of another in its batch";
  EXPECT_GT(schedule.leastWaiting(), most) << "something nearer was left";
  EXPECT_EQ(!taken.empty(), least <= last && least < Infinity) << "the least one is in the batch";
}

}

TEST(VertexSchedule, IsEmptyAtFirst)
{
  ScheduleAndModel schedule({ 1.0 });
  EXPECT_EQ(schedule.least(), Infinity);
  EXPECT_TRUE(schedule.takeBatch(Infinity).empty());
}

TEST(VertexSchedule, RandomAdditionsAndBatchesAreThoseOfASortedList)
{
  for (std::uint64_t seed = 0; seed < 200; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Id count = random.between(1, 300);
    // Edges of one length, of two that differ much, or with some of no length.
    const double largeWidth = std::vector<double>{ 1.0, 1e4, 1e-4, 0.0 }[seed % 4];
    std::vector<double> batchWidths;
    for (Id v = 0; v < count; ++v)
    {
      batchWidths.push_back(random.chance(0.3) ? largeWidth : random.uniform(0.5, 1.5));
    }
    ScheduleAndModel schedule(batchWidths);
    double front = 0.0;
    for (int step = 0; step < 300; ++step)
    {
      // As in the front: nothing is added before it, and keys only fall.
      for (Index left = random.below(20); left > 0; --left)
      {
        const Id vertex = random.below(count);
        schedule.add(front + (random.chance(0.3) ? 1.0 : random.uniform(1e-3, 60.0)), vertex);
      }
      const double last = random.chance(0.3) ? front + random.uniform(0.0, 2.0) : 1e6;
      if (schedule.leastWaiting() < Infinity)
      {
        front = std::max(front, std::min(schedule.leastWaiting(), last));
      }
      expectBatch(schedule, last);
    }
    for (Id batch = 0; batch < count && schedule.least() < Infinity; ++batch)
    {
      expectBatch(schedule, Infinity);
    }
    EXPECT_TRUE(schedule.waiting().empty()) << "each batch takes one at least";
  }
}

TEST(VertexSchedule, ABatchHoldsAllWithinEachBatchWidth)
{
  ScheduleAndModel schedule({ 0.5, 0.25, 0.125, 2.0, 2.0 });
  schedule.add(1.0, 0);
  schedule.add(1.125, 1);
  schedule.add(1.375, 2); // ends at 1.5, after what vertices 0 and 1 reach
  schedule.add(1.3750001, 3);
  schedule.add(9.0, 4);
  EXPECT_EQ(schedule.least(), 1.0);
  EXPECT_EQ(schedule.takeBatch(Infinity), (std::vector<Id>{ 0, 1, 2 }));
  EXPECT_EQ(schedule.least(), 1.3750001);
  EXPECT_EQ(schedule.takeBatch(1.3750001), (std::vector<Id>{ 3 })) << "up to the last, included";
  EXPECT_TRUE(schedule.takeBatch(8.0).empty());
  EXPECT_EQ(schedule.least(), 9.0);
}

TEST(VertexSchedule, AVertexAddedAgainIsTakenOnceAndWithItsSmallerKey)
{
  ScheduleAndModel schedule({ 1.0, 1.0 });
  schedule.add(100.0, 0); // far
  schedule.add(2.0, 1);
  EXPECT_EQ(schedule.least(), 2.0);
  schedule.add(1.5, 0); // near
  EXPECT_EQ(schedule.least(), 1.5);
  EXPECT_EQ(schedule.takeBatch(1.75), std::vector<Id>{ 0 });
  EXPECT_EQ(schedule.takeBatch(Infinity), std::vector<Id>{ 1 });
  EXPECT_EQ(schedule.least(), Infinity);
}

TEST(VertexSchedule, AVertexBehindTheFrontWaitsForTheNextBatch)
{
  ScheduleAndModel schedule({ 0.5, 0.5, 2.0 });
  schedule.schedule().moveOn(4.0);
  schedule.schedule().add(0, 3.0);
  schedule.schedule().add(1, 4.25);
  schedule.schedule().add(2, 4.625);
  EXPECT_EQ(schedule.least(), 4.0);
  EXPECT_EQ(schedule.schedule().outlook().last, 4.5);
  EXPECT_EQ(schedule.takeBatch(4.5), (std::vector<Id>{ 0, 1 }));
}

TEST(VertexSchedule, AVertexWhoseListsHavePassedWaitsAtItsDistanceAndLimitsNoBatch)
{
  ScheduleAndModel schedule({ 0.5, 0.5, 0.25 });
  schedule.addPassed(1.25, 2);
  schedule.add(1.125, 0);
  schedule.add(2.0, 1);
  EXPECT_EQ(schedule.least(), 1.125);
  schedule.shorten(1.0, 2);
  EXPECT_EQ(schedule.least(), 1.0);
  EXPECT_EQ(schedule.schedule().outlook().last, 1.625) << "the width of the first alone";
  EXPECT_TRUE(schedule.schedule().isAnyWaiting([](Id vertex) { return vertex == 2; }));
  EXPECT_TRUE(schedule.takeBatch(0.875).empty());
  EXPECT_EQ(schedule.takeBatch(1.0), std::vector<Id>{ 2 });
  EXPECT_EQ(schedule.takeBatch(Infinity), std::vector<Id>{ 0 });
  EXPECT_EQ(schedule.takeBatch(Infinity), std::vector<Id>{ 1 });
  EXPECT_EQ(schedule.least(), Infinity);
}

TEST(VertexSchedule, AVertexWhoseListsHavePassedMayAlsoWaitForANearerList)
{
  for (const double last : { 0.875, 1.0 })
  {
    ScheduleAndModel schedule({ 0.5 });
    schedule.addPassed(1.0, 0);
    schedule.schedule().add(0, 0.75);
    EXPECT_EQ(schedule.least(), 0.75);
    EXPECT_EQ(schedule.takeBatch(last), std::vector<Id>{ 0 });
    EXPECT_EQ(schedule.least(), last < 1.0 ? 1.0 : Infinity);
    EXPECT_EQ(schedule.takeBatch(1.0).size(), last < 1.0 ? 1U : 0U) << "once a batch";
  }
}

TEST(VertexSchedule, AVertexWhoseListsHavePassedMayAlsoWaitForAFartherList)
{
  ScheduleAndModel schedule({ 0.5 });
  schedule.schedule().add(0, 4.0);
  schedule.addPassed(1.0, 0);
  EXPECT_EQ(schedule.takeBatch(1.0), std::vector<Id>{ 0 });
  schedule.settle(0);
  EXPECT_EQ(schedule.least(), 4.0);
  schedule.schedule().add(0, 2.0);
  EXPECT_EQ(schedule.takeBatch(2.0), std::vector<Id>{ 0 });
  EXPECT_EQ(schedule.least(), Infinity) << "it waited once";
}

TEST(VertexSchedule, VerticesWithoutBatchWidthAreTaken)
{
  // Edges of no length, and keys so large that a width is rounded away.
  for (const double key : { 1.0, 1e20 })
  {
    ScheduleAndModel schedule({ 0.0, 0.0, key * 1e-17, 0.0 });
    schedule.add(key, 0);
    schedule.add(key, 1);
    schedule.add(key, 2);
    schedule.add(2.0 * key, 3);
    ASSERT_EQ(schedule.least(), key);
    EXPECT_EQ(schedule.takeBatch(Infinity).size(), 3U) << "equal keys are in one batch";
    ASSERT_EQ(schedule.least(), 2.0 * key);
    EXPECT_EQ(schedule.takeBatch(Infinity), std::vector<Id>{ 3 });
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
  for (std::uint64_t seed = 0; seed < 20; ++seed)
  {
    Random random(seed);
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
        << "seed " << seed << ", vertex " << v;
    }
  }
}
