// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/core/parallel.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace odeum::tests::parallel_test {
namespace {

/// `interrupted` is the program's own flag: cleared again whatever the test does.
struct InterruptedFlag : testing::Test {
  ~InterruptedFlag() override { interrupted = false; }
};
using Parallel = InterruptedFlag;

TEST_F(Parallel, DoesEachPieceOnceWhateverTheJobs) {
  for (const unsigned jobs : {0U, 1U, 2U, 8U, 200U}) {
    std::vector<std::atomic<int>> done(100);
    parallel_for(done.size(), jobs, [&](std::size_t i) { ++done[i]; });
    for (const auto& times : done) EXPECT_EQ(times, 1) << jobs << " jobs";
  }
  parallel_for(0, 4, [](std::size_t) { FAIL() << "there is nothing to do"; });
}

TEST_F(Parallel, RunsAsManyAtATimeAsAsked) {
  std::atomic<int> at_once{0}, most{0};
  parallel_for(200, 3, [&](std::size_t) {
    const int now = ++at_once;
    for (int seen = most; now > seen && !most.compare_exchange_weak(seen, now);) {
    }
    std::this_thread::sleep_for(std::chrono::microseconds(100));
    --at_once;
  });
  EXPECT_LE(most, 3);
  EXPECT_GE(most, 2) << "sleeping threads overlap on any machine";
}

TEST_F(Parallel, RethrowsAndStartsNothingMore) {
  for (const unsigned jobs : {1U, 4U}) {
    std::atomic<int> begun{0};
    const auto run = [&] {
      parallel_for(10'000, jobs, [&](std::size_t i) {
        ++begun;
        if (i == 5) throw std::domain_error("piece " + std::to_string(i));
        std::this_thread::sleep_for(std::chrono::microseconds(50));
      });
    };
    try {
      run();
      FAIL() << "the exception was lost";
    } catch (const std::domain_error& error) {
      EXPECT_STREQ(error.what(), "piece 5");
    }
    EXPECT_LT(begun, 5'000);
  }
}

TEST_F(Parallel, StopsWhenInterruptedAndSaysSo) {
  for (const unsigned jobs : {1U, 4U}) {
    interrupted = false;
    std::atomic<int> begun{0};
    EXPECT_THROW(parallel_for(10'000, jobs,
                              [&](std::size_t i) {
                                ++begun;
                                if (i == 5) interrupted = true;
                                std::this_thread::sleep_for(std::chrono::microseconds(50));
                              }),
                 Interrupted);
    EXPECT_GE(begun, 6);
    EXPECT_LT(begun, 5'000);
  }
  EXPECT_THROW(parallel_for(3, 1, [](std::size_t) { FAIL() << "interrupted before it began"; }),
               Interrupted);
}

}  // namespace
}  // namespace odeum::tests::parallel_test
