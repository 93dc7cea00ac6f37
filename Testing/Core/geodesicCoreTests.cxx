// SPDX-License-Identifier: BSD-3-Clause
// Runs the engine's tests that the arguments select. CTest has one entry per suite; a suite none of
// whose tests could run counts as skipped.
#include <gtest/gtest.h>

namespace
{
constexpr int Skipped = 77;
}

int main(int argc, char* argv[])
{
  ::testing::InitGoogleTest(&argc, argv);
  const int result = RUN_ALL_TESTS();
  const ::testing::UnitTest& all = *::testing::UnitTest::GetInstance();
  const bool hasRun = all.successful_test_count() + all.failed_test_count() > 0;
  return hasRun || all.skipped_test_count() == 0 ? result : Skipped;
}
