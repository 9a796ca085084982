// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/hard_cases/hard_cases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/temporary_folder.hpp"

namespace odeum::study {
namespace {

using record::OutputFolder;
using tests::text_of;

constexpr const char* files[] = {"drift.csv", "horizons.csv", "largest_steps.csv",
                                 "order_reduction.csv"};

/// Results of the real studies for a few solvers, not synthetic rows.
HardCaseResults some_results() {
  HardCaseResults results;
  const std::vector<std::string> solvers{"odeum/rk4", "odeum/radau_iia5"};
  results.drift = measure_drift({.cases = {"osc_undamped", horizon_case}, .solvers = solvers});
  results.largest_steps = measure_limits({.cases = {"stiff_chain2_k1e4"}, .solvers = solvers});
  results.reduction = measure_reduction({.solvers = solvers}).rows;
  return results;
}

TEST(HardCases, AreReadBackAsTheyWereWritten) {
  const tests::TemporaryFolder root;
  const OutputFolder folder(root.path() / "out");
  const HardCaseResults written = some_results();
  write_csv(written, folder);
  const HardCaseResults read = read_hard_cases(folder.path());
  EXPECT_EQ(read.problem, "");
  EXPECT_FALSE(read.measured);
  EXPECT_EQ(read.drift.rows.size(), written.drift.rows.size());
  std::vector<std::string> before;
  for (const char* file : files) before.push_back(text_of(folder.path() / file));
  write_csv(read, folder);
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_EQ(text_of(folder.path() / files[i]), before[i]) << files[i];
}

TEST(HardCases, AFolderWithoutFilesIsNoProblem) {
  const tests::TemporaryFolder root;
  const HardCaseResults read = read_hard_cases(root.path());
  EXPECT_TRUE(read.empty());
  EXPECT_EQ(read.problem, "");
}

TEST(HardCases, BrokenFilesAreNotBelieved) {
  const tests::TemporaryFolder root;
  const OutputFolder folder(root.path() / "out");
  write_csv(some_results(), folder);
  const std::string whole = text_of(folder.path() / "order_reduction.csv");
  folder.write("horizons.csv", "schema,case\n1,a\n");
  folder.write("order_reduction.csv", whole.substr(0, whole.size() - 7));
  const HardCaseResults read = read_hard_cases(folder.path());
  EXPECT_TRUE(read.drift.horizons.empty());
  EXPECT_TRUE(read.reduction.empty());
  EXPECT_FALSE(read.largest_steps.empty()) << "the others are used";
  EXPECT_EQ(read.problem,
            "the earlier horizons.csv has other columns (another version?); the earlier "
            "order_reduction.csv is truncated");
  std::string spoilt = whole;
  spoilt.replace(spoilt.find(",confirmed,"), 11, ",excellent,");
  folder.write("order_reduction.csv", spoilt);
  EXPECT_TRUE(read_hard_cases(folder.path()).reduction.empty()) << "no such verdict";
}

TEST(HardCases, WhatIsMeasuredNowReplacesWhatWas) {
  const HardCaseResults earlier = some_results();
  HardCaseResults now;
  now.measured = true;
  for (const LargestStep& row : earlier.largest_steps)
    if (row.solver == "rk4") now.largest_steps.push_back(row);
  ASSERT_EQ(now.largest_steps.size(), 1U);
  now.largest_steps[0].largest_stable_step = 1;
  HardCaseResults with_stranger = earlier;
  with_stranger.largest_steps.push_back(earlier.largest_steps[0]);
  with_stranger.largest_steps.back().solver = "a_method_that_went";
  add_earlier(now, with_stranger, all_cases());
  ASSERT_EQ(now.largest_steps.size(), 2U) << "each once, and not the solver that went";
  EXPECT_EQ(now.largest_steps[0].largest_stable_step, 1);
  EXPECT_EQ(now.largest_steps[1].solver, "radau_iia5");
  EXPECT_EQ(now.reduction.size(), earlier.reduction.size());
  EXPECT_TRUE(now.measured);
}

TEST(HardCases, TheSelectionNamesCasesThatThereAre) {
  std::vector<std::string> ids(std::begin(drift_cases_of_peers), std::end(drift_cases_of_peers));
  ids.insert(ids.end(), std::begin(limit_cases_of_peers), std::end(limit_cases_of_peers));
  ids.emplace_back(horizon_case);
  for (const std::string& id : ids)
    EXPECT_TRUE(std::any_of(all_cases().begin(), all_cases().end(), [&](const Case& c) {
      return c.id == id;
    })) << id;
  for (const Case& c : all_cases()) {
    if (c.id == horizon_case) {
      EXPECT_TRUE(c.has_tag("chaotic"));
    }
    if (std::count(std::begin(limit_cases_of_peers), std::end(limit_cases_of_peers), c.id) > 0) {
      EXPECT_TRUE(c.has_tag("stiff")) << c.id;
    }
  }
}

}  // namespace
}  // namespace odeum::study
