// SPDX-License-Identifier: BSD-3-Clause
// Runs of a chaotic problem far beyond the time up to which its solution can be known: each row is
// held against the solution from the row before.
#include "odeum/brought/row_to_row.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "odeum/brought/judgement.hpp"
#include "odeum/cases/catalogue.hpp"
#include "odeum/cases/parameters.hpp"
#include "odeum/cases/text_case.hpp"

namespace odeum::tests::row_to_row_test {
namespace {

using State = std::array<double, 3>;

State lorenz(const State& y) {
  return {10 * (y[1] - y[0]), y[0] * (28 - y[2]) - y[1], y[0] * y[1] - 8.0 / 3 * y[2]};
}
State moved(const State& y, double h, const State& k) {
  return {y[0] + h * k[0], y[1] + h * k[1], y[2] + h * k[2]};
}

/// A step of RK4, or with `wrong` of one that takes the slope of the last stage from the start.
State step(const State& y, double h, bool wrong) {
  const State a = lorenz(y), b = lorenz(moved(y, h / 2, a)), c = lorenz(moved(y, h / 2, b)),
              d = wrong ? a : lorenz(moved(y, h, c));
  State next = y;
  for (std::size_t i = 0; i < 3; ++i) next[i] += h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
  return next;
}

/// Rows of 0.1 up to t = 100: errors of one part in 1e16 are as large as the attractor there.
brought::Trajectory stepped(double h, bool wrong) {
  brought::Trajectory run;
  run.file = fmt::format("lorenz_h{}.csv", h);
  run.series = "lorenz";
  run.components = {0, 1, 2};
  run.step = h;
  run.apart = 0.1;
  run.steps_a_row = static_cast<std::size_t>(std::lround(run.apart / h));
  State y{1, 1, 1};
  for (int row = 0; row <= 1000; ++row) {
    run.times.push_back(row * run.apart);
    run.states.insert(run.states.end(), y.begin(), y.end());
    for (std::size_t k = 0; k < run.steps_a_row; ++k) y = step(y, h, wrong);
  }
  run.half_places.assign(run.states.size(), 0);
  return run;
}

brought::SeriesRow judged(bool wrong, const std::string& rate = "10*(y - x)") {
  Case c = case_of(cases::text_statements("my.yaml",
                                          "states: {x: 1, y: 1, z: 1}\nequations: {x: " + rate +
                                              ", y: x*(28 - z) - y, z: x*y - 8/3*z}\n"
                                              "time: {end: 100}\n",
                                          "lorenz", {})
                       .front());
  c.truth = cases::unknown_truth("it is chaotic");
  std::vector<brought::Trajectory> runs;
  for (const double h : {0.01, 0.005, 0.0025}) runs.push_back(stepped(h, wrong));
  const brought::Judgement judgement = brought::judge_runs(c, runs, {.method = "", .order = 4});
  EXPECT_EQ(judgement.files.front().status, "unknown");
  return judgement.series.front();
}

TEST(RowToRow, ShowsTheOrderWhereNoTruthIsKnown) {
  const brought::SeriesRow row = judged(false);
  EXPECT_EQ(row.verdict, judge::Verdict::confirmed) << row.reason;
  // Three steps, of which the coarsest has errors of h^5 of some per cent.
  EXPECT_NEAR(row.measured_order, 4, 0.2) << row.reason;
  EXPECT_NE(row.reason.find("not whether the end is right"), std::string::npos) << row.reason;
}

TEST(RowToRow, ShowsAMistakeThere) {
  const brought::SeriesRow row = judged(true);
  EXPECT_EQ(row.verdict, judge::Verdict::lower) << row.reason;
  EXPECT_EQ(row.claim, brought::Claimed::denied);
  EXPECT_NEAR(row.measured_order, 1, 0.2) << row.reason;
}

TEST(RowToRow, ShowsAnotherProblemThere) {
  // The error of other equations does not fall with the step.
  const brought::SeriesRow row = judged(false, "10.01*(y - x)");
  EXPECT_EQ(row.verdict, judge::Verdict::floors) << row.reason;
  EXPECT_EQ(row.claim, brought::Claimed::denied);
}

}  // namespace
}  // namespace odeum::tests::row_to_row_test
