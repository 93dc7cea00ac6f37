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

/// Statistics of the communication in one run.
struct ExchangeCounts
{
  std::uint64_t steps = 0;
  std::uint64_t messages = 0;
  std::uint64_t bytes = 0;
  /// Processor seconds between the steps: the total of all ranks, and the sum over all steps of the
  /// busiest rank's, which is the time of the run with a processor per rank and free communication.
  double work = 0.0;
  double busiest = 0.0;
  /// The sum over all steps of the largest number of bytes that one rank sends or receives.
  std::uint64_t busiestBytes = 0;
};

/// Ranks as threads of one process, which exchange messages through memory.
class MemoryRanks
{
public:
  /// \param disorder a seed, or 0. With a seed each rank waits for random times before it sends and
  ///        before it reads, so that ranks arrive at a step in any order.
  explicit MemoryRanks(int numberOfRanks, std::uint64_t disorder = 0);
  ~MemoryRanks();

  /// Runs the work on each rank and waits for all. A rank that throws makes all ranks fail.
  ///
  /// \returns for each rank, what it has thrown, or null.
  std::vector<std::exception_ptr> tryRun(const std::function<void(geodesic::Exchange&)>& work);
  /// tryRun() that rethrows what the lowest rank has thrown.
  void run(const std::function<void(geodesic::Exchange&)>& work);

  /// Rank 0 may call this between its steps.
  const ExchangeCounts& counts() const;

private:
  class Hub;
  class Rank;
  std::unique_ptr<Hub> hub_;
};

}

#endif
