// SPDX-License-Identifier: BSD-3-Clause
// One test for each own method on each smooth case that it fits: the running code has the order
// that the method claims, neither less nor more.
#include <gtest/gtest.h>

#include "odeum/study/convergence.hpp"

namespace odeum {
namespace {

struct Pair {
  std::string case_id, method;
  Mode mode;
  double claimed;
};

std::vector<Pair> own_pairs() {
  std::vector<Pair> pairs;
  for (const Case& c : all_cases()) {
    if (!c.has_tag("smooth")) continue;
    for (const Entrant& entrant : c.entrants) {
      if (entrant.info.library != "odeum" || !entrant.unfit.empty()) continue;
      if (std::isnan(entrant.info.order)) continue;  // none is claimed
      if (entrant.info.fixed)
        pairs.push_back({c.id, entrant.info.method, Mode::fixed, entrant.info.order});
      // Choosing steps knows nothing of the number of unknowns: the small cases show it. On a cloth
      // low orders meet too few tolerances within the budget.
      if (entrant.info.adaptive && !entrant.info.adaptive_order && !c.has_tag("cloth"))
        pairs.push_back({c.id, entrant.info.method, Mode::adaptive, entrant.info.order});
    }
  }
  return pairs;
}

std::string name_of(const testing::TestParamInfo<Pair>& info) {
  return info.param.case_id + "_" + info.param.method + "_" + to_string(info.param.mode);
}

class Order : public testing::TestWithParam<Pair> {};

TEST_P(Order, IsAsClaimed) {
  const Pair& pair = GetParam();
  const study::ConvergenceResult result = study::converge(
      {.cases = {pair.case_id}, .solvers = {"odeum/" + pair.method}, .modes = {pair.mode}});
  ASSERT_EQ(result.orders.size(), 1U);
  const study::OrderFit& fit = result.orders.front().fit;
  if (fit.verdict == study::Verdict::higher && std::isnan(fit.order)) {
    // Exact but for rounding: a polynomial solution of low degree, which free fall alone has.
    EXPECT_EQ(pair.case_id, "free_fall");
    EXPECT_GE(pair.claimed, 2);
    return;
  }
  // Fixed steps: a fit over at least four steps whose local slopes agree to 0.1 is off by less than
  // 0.15, the next order of a step's error expansion included; a wrong coefficient costs a whole
  // order. Adaptive runs: their mean step is a looser yardstick, see order_fit.hpp.
  const double band =
      pair.mode == Mode::fixed ? 0.15 : study::adaptive_tolerance(pair.claimed).order;
  EXPECT_NEAR(fit.order, pair.claimed, band) << to_string(fit.verdict) << ": " << fit.reason;
  EXPECT_EQ(fit.verdict, study::Verdict::confirmed) << fit.reason;
  EXPECT_GE(fit.points, 4U);
}

INSTANTIATE_TEST_SUITE_P(Own, Order, testing::ValuesIn(own_pairs()), name_of);

}  // namespace
}  // namespace odeum
