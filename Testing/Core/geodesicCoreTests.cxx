// SPDX-License-Identifier: BSD-3-Clause
// Runs the engine's tests that the arguments choose. CTest has one entry a suite: it counts as
// skipped where a test of it could not run and none failed.
#include <gtest/gtest.h>

namespace
{
constexpr int Skipped = 77;
}

int main(int argc, char* argv[])
{
  ::testing::InitGoogleTest(&argc, argv);
  const int result = RUN_ALL_TESTS();
  const bool hasSkipped = ::testing::UnitTest::GetInstance()->skipped_test_count() > 0;
  return result == 0 && hasSkipped ? Skipped : result;
}
