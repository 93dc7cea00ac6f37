// SPDX-License-Identifier: BSD-3-Clause
// When the front is split into districts, with a clock and speeds that are given.
#include "front/ThreadTrial.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>

using geodesic::Job;
using geodesic::ThreadTrial;
using std::chrono::microseconds;

namespace
{

/// A front whose batches take a time that depends on whether it is split.
struct Front
{
  ThreadTrial trial{ Job::Sharing::WherePaying };
  microseconds joinedBatch{ 50 };
  microseconds splitBatch{ 30 };
  std::uint64_t work = 2000;

  ThreadTrial::Clock::time_point now;
  bool isSplit = false;
  int timesAsked = 0;

  /// Runs for a time. \returns the part of it in which the front was split.
  double run(microseconds time)
  {
    microseconds split{ 0 };
    const auto end = this->now + time;
    while (this->now < end)
    {
      const microseconds batch = this->isSplit ? this->splitBatch : this->joinedBatch;
      this->now += batch;
      split += this->isSplit ? batch : microseconds(0);
      this->isSplit = this->trial.isSplit(this->work,
        [this]()
        {
          ++this->timesAsked;
          return this->now;
        });
    }
    return std::chrono::duration<double>(split) / time;
  }
};

constexpr microseconds OneSecond{ 1000000 };

} // anonymous namespace

TEST(ThreadTrial, SplitsAWideFrontWhereThatIsFaster)
{
  Front front;
  EXPECT_GT(front.run(OneSecond), 0.9);
}

TEST(ThreadTrial, LeavesAWideFrontTogetherWhereThatIsFasterOrNearlyAsFast)
{
  for (const microseconds split : { microseconds(200), microseconds(55), microseconds(46) })
  {
    Front front;
    front.splitBatch = split;
    EXPECT_LT(front.run(OneSecond), 0.02) << split.count();
  }
}

TEST(ThreadTrial, FollowsAMachineThatIsTakenByOthersAndGivenBack)
{
  Front front;
  EXPECT_GT(front.run(OneSecond), 0.9);
  front.splitBatch = microseconds(80);
  front.run(OneSecond);
  EXPECT_LT(front.run(OneSecond), 0.02);
  front.splitBatch = microseconds(30);
  front.run(OneSecond);
  EXPECT_GT(front.run(OneSecond), 0.9);
}

TEST(ThreadTrial, DoesNotTryAFrontThatIsWideForAMoment)
{
  Front front;
  EXPECT_EQ(front.run(microseconds(9000)), 0.0);
  EXPECT_GT(front.run(microseconds(9000)), 0.5);
}

TEST(ThreadTrial, NeverSplitsANarrowFrontNorAsksForTheTime)
{
  Front front;
  front.work = 900;
  EXPECT_EQ(front.run(OneSecond), 0.0);
  EXPECT_EQ(front.timesAsked, 0);
}

TEST(ThreadTrial, JoinsAFrontThatBecomesNarrowAndSplitsItAgainWhenItIsWide)
{
  Front front;
  front.run(OneSecond);
  ASSERT_TRUE(front.isSplit);
  front.work = 100;
  front.run(microseconds(2000));
  EXPECT_EQ(front.run(OneSecond), 0.0);
  front.work = 2000;
  EXPECT_GT(front.run(OneSecond), 0.9);
}

TEST(ThreadTrial, TriesAFrontThatIsWideAndNarrowInTurnNoMoreOften)
{
  for (const microseconds turn : { microseconds(2200), microseconds(5000), microseconds(30000) })
  {
    Front front;
    front.splitBatch = microseconds(200);
    microseconds split{ 0 };
    for (microseconds time{ 0 }; time < OneSecond; time += 2 * turn)
    {
      front.work = 100;
      front.run(turn);
      front.work = 4000;
      split += std::chrono::duration_cast<microseconds>(front.run(turn) * turn);
    }
    EXPECT_LT(split, OneSecond / 50) << turn.count();
  }
}

TEST(ThreadTrial, AlwaysSplitsWhereAllTasksAreShared)
{
  Front front;
  front.trial = ThreadTrial(Job::Sharing::Always);
  front.work = 1;
  front.run(front.joinedBatch); // one batch
  EXPECT_TRUE(front.isSplit);
  EXPECT_EQ(front.timesAsked, 0);
}
