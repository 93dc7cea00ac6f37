// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesictest_MemoryRanks_h
#define geodesictest_MemoryRanks_h

#include "Exchange.h"

#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <vector>

namespace geodesictest
{

/// What the ranks of one run have told each other.
struct ExchangeCounts
{
  std::uint64_t steps = 0;
  std::uint64_t messages = 0;
  std::uint64_t bytes = 0;
  /// The processor's seconds between the steps, of all ranks together, and those of the busiest
  /// rank of each step: what the run would take with a processor a rank and messages in no time.
  double work = 0.0;
  double busiest = 0.0;
  /// The bytes that the rank with most of them sends or gets, of each step.
  std::uint64_t busiestBytes = 0;
};

/// Ranks in one process, a thread each, that exchange messages through memory.
class MemoryRanks
{
public:
  /// \param disorder not 0: a seed; each rank waits for random times before it sends and before it
  ///        reads, so that they come to a step in any order.
  explicit MemoryRanks(int numberOfRanks, std::uint64_t disorder = 0);
  ~MemoryRanks();

  /// Runs the work on each rank and waits for all. A rank that throws fails for all.
  ///
  /// \returns what each rank has thrown, or null.
  std::vector<std::exception_ptr> tryRun(const std::function<void(geodesic::Exchange&)>& work);
  /// The same; throws what the lowest rank has thrown.
  void run(const std::function<void(geodesic::Exchange&)>& work);

  /// Rank 0 may ask between its steps.
  const ExchangeCounts& counts() const;

private:
  class Hub;
  class Rank;
  std::unique_ptr<Hub> hub_;
};

}

#endif
