// SPDX-License-Identifier: BSD-3-Clause
// The queue of vertices against a plain list of what waits.
#include "front/VertexQueue.h"

#include "EngineSupport.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <future>
#include <iostream>
#include <map>
#include <set>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

using geodesic::Id;
using geodesic::Infinity;
using geodesic::VertexQueue;
using namespace geodesictest;

namespace
{

/// A queue and what waits in it, as its owner knows it: a key and a reach of each vertex.
class QueueAndModel
{
public:
  explicit QueueAndModel(std::vector<double> reaches)
    : reaches_(std::move(reaches))
    , keys_(this->reaches_.size(), Infinity)
  {
  }

  /// Lets a vertex wait, or wait with a smaller key.
  void push(double key, Id vertex)
  {
    ASSERT_LT(key, this->keys_[vertex]);
    this->waiting_.erase({ this->keys_[vertex], vertex });
    this->keys_[vertex] = key;
    this->waiting_.insert({ key, vertex });
    this->queue_.push(key, vertex);
  }

  double least() { return this->queue_.outlook(this->isCurrent(), this->reachOf()).least; }

  std::vector<Id> takeBatch(double last)
  {
    std::vector<Id> taken;
    this->queue_.takeBatch(
      std::min(last, this->queue_.outlook(this->isCurrent(), this->reachOf()).last),
      this->isCurrent(),
      [&](Id vertex)
      {
        taken.push_back(vertex);
        this->takenKeys_[vertex] = this->keys_[vertex];
        this->waiting_.erase({ this->keys_[vertex], vertex });
        this->keys_[vertex] = Infinity;
      });
    return taken;
  }

  double reach(Id vertex) const { return this->reaches_[vertex]; }
  double key(Id vertex) const { return this->keys_[vertex]; }
  /// The key with which a vertex was last taken.
  double takenKey(Id vertex) const { return this->takenKeys_.at(vertex); }
  /// Sorted.
  const std::set<std::pair<double, Id>>& waiting() const { return this->waiting_; }
  double leastWaiting() const
  {
    return this->waiting_.empty() ? Infinity : this->waiting_.begin()->first;
  }

private:
  std::function<bool(const VertexQueue::Entry&)> isCurrent() const
  {
    return [this](const VertexQueue::Entry& entry)
    { return entry.key == this->keys_[entry.vertex]; };
  }
  /// A queue that goes in a circle asks for ever: this is the time limit.
  std::function<double(Id)> reachOf()
  {
    return [this, asked = std::size_t(0)](Id vertex) mutable
    {
      if (++asked > 100 * this->reaches_.size() + 100)
      {
        throw std::runtime_error("The queue does not come to an end.");
      }
      return this->reaches_[vertex];
    };
  }

  VertexQueue queue_;
  std::vector<double> reaches_;
  std::vector<double> keys_;
  std::map<Id, double> takenKeys_;
  std::set<std::pair<double, Id>> waiting_;
};

/// What must hold of any batch: all that is taken waited, up to the end of the shortest reach; what
/// is left lies behind it; and once the least one was asked for, it is in the batch.
void expectBatch(QueueAndModel& queue, double last, bool leastWasAskedFor)
{
  const std::set<std::pair<double, Id>> before = queue.waiting();
  const double least = queue.leastWaiting();
  double end = last;
  for (const auto& [key, vertex] : before)
  {
    end = std::min(end, key + queue.reach(vertex));
  }
  const auto expected = std::count_if(
    before.begin(), before.end(), [end](const auto& waiting) { return waiting.first <= end; });
  const std::vector<Id> taken = queue.takeBatch(last);
  EXPECT_EQ(taken.size(), static_cast<std::size_t>(expected))
    << "the reach of what waits far away ends the batch, too";
  EXPECT_EQ(before.size(), queue.waiting().size() + taken.size()) << "lost, or taken twice";
  double most = 0.0;
  double shortest = last;
  for (const Id vertex : taken)
  {
    most = std::max(most, queue.takenKey(vertex));
    shortest = std::min(shortest, queue.takenKey(vertex) + queue.reach(vertex));
  }
  EXPECT_LE(most, shortest) << "farther than the reach of another in its batch";
  EXPECT_GT(queue.leastWaiting(), most) << "something nearer was left";
  if (leastWasAskedFor)
  {
    EXPECT_EQ(!taken.empty(), least <= last && least < Infinity) << "the least one is in the batch";
  }
}

}

TEST(VertexQueue, IsEmptyAtFirst)
{
  QueueAndModel queue({ 1.0 });
  EXPECT_EQ(queue.least(), Infinity);
  EXPECT_TRUE(queue.takeBatch(Infinity).empty());
}

TEST(VertexQueue, RandomPushesAndBatchesAreThoseOfASortedList)
{
  for (std::uint64_t seed = 0; seed < 200; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Id count = random.between(1, 300);
    // Edges of one length, of two that differ much, or with some of no length.
    const double farReach = std::vector<double>{ 1.0, 1e4, 1e-4, 0.0 }[seed % 4];
    std::vector<double> reaches;
    for (Id v = 0; v < count; ++v)
    {
      reaches.push_back(random.chance(0.3) ? farReach : random.uniform(0.5, 1.5));
    }
    QueueAndModel queue(reaches);
    double front = 0.0;
    for (int step = 0; step < 300; ++step)
    {
      // As in the front: nothing is pushed before it, and keys only fall.
      for (Index pushes = random.below(20); pushes > 0; --pushes)
      {
        const Id vertex = random.below(count);
        const double key = front + (random.chance(0.3) ? 1.0 : random.uniform(1e-3, 60.0));
        if (key < queue.key(vertex))
        {
          queue.push(key, vertex);
        }
      }
      // Where vertices wait behind the front, the front does not ask.
      const bool asks = random.chance(0.7);
      if (asks)
      {
        ASSERT_EQ(queue.least(), queue.leastWaiting());
      }
      const double last = random.chance(0.3) ? front + random.uniform(0.0, 2.0) : 1e6;
      if (queue.leastWaiting() < Infinity)
      {
        front = std::max(front, std::min(queue.leastWaiting(), last));
      }
      expectBatch(queue, last, asks);
    }
    for (Id batch = 0; batch < count && queue.least() < Infinity; ++batch)
    {
      expectBatch(queue, Infinity, true);
    }
    EXPECT_TRUE(queue.waiting().empty()) << "each batch takes one at least";
  }
}

TEST(VertexQueue, ABatchHoldsAllWithinTheShortestReach)
{
  QueueAndModel queue({ 0.5, 0.25, 0.125, 2.0, 2.0 });
  queue.push(1.0, 0);
  queue.push(1.125, 1);
  queue.push(1.375, 2); // ends at 1.5, after what vertices 0 and 1 reach
  queue.push(1.3750001, 3);
  queue.push(9.0, 4);
  EXPECT_EQ(queue.least(), 1.0);
  EXPECT_EQ(queue.takeBatch(Infinity), (std::vector<Id>{ 0, 1, 2 }));
  EXPECT_EQ(queue.least(), 1.3750001);
  EXPECT_EQ(queue.takeBatch(1.3750001), (std::vector<Id>{ 3 })) << "up to the last, included";
  EXPECT_TRUE(queue.takeBatch(8.0).empty());
  EXPECT_EQ(queue.least(), 9.0);
}

TEST(VertexQueue, AVertexPushedAgainIsTakenOnceAndWithItsSmallerKey)
{
  QueueAndModel queue({ 1.0, 1.0 });
  queue.push(100.0, 0); // far
  queue.push(2.0, 1);
  EXPECT_EQ(queue.least(), 2.0);
  queue.push(1.5, 0); // near
  EXPECT_EQ(queue.least(), 1.5);
  EXPECT_EQ(queue.takeBatch(1.75), std::vector<Id>{ 0 });
  EXPECT_EQ(queue.takeBatch(Infinity), std::vector<Id>{ 1 });
  EXPECT_EQ(queue.least(), Infinity) << "the old entry of vertex 0 is not current";
}

TEST(VertexQueue, WhatHasNoReachStillComesNear)
{
  // Edges of no length, and keys so large that a reach is rounded away.
  for (const double key : { 1.0, 1e20 })
  {
    QueueAndModel queue({ 0.0, 0.0, key * 1e-17, 0.0 });
    queue.push(key, 0);
    queue.push(key, 1);
    queue.push(key, 2);
    queue.push(2.0 * key, 3);
    ASSERT_EQ(queue.least(), key);
    EXPECT_EQ(queue.takeBatch(Infinity).size(), 3U) << "equal keys are in one batch";
    ASSERT_EQ(queue.least(), 2.0 * key);
    EXPECT_EQ(queue.takeBatch(Infinity), std::vector<Id>{ 3 });
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
// many vertices nothing is within reach but what is equally far. The surface is a flat strip still.
TEST(VertexQueue, TheFrontEndsWhereEdgesHaveNoLength)
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
