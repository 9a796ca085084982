// SPDX-License-Identifier: BSD-3-Clause
// A part of the campaign of reports/verdicts.md, which scripts/verdicts makes: deliberately wrong
// solvers of which none whose fault can be seen is confirmed, and right ones that are not denied.
#include <gtest/gtest.h>

#include "accuracy/campaign.hpp"

namespace odeum::tests::wrong_solvers_test {
namespace {

class Wrong : public testing::TestWithParam<std::size_t> {};

TEST_P(Wrong, IsNotConfirmedWhereItCanBeSeen) {
  const Case& c = campaign_cases()[GetParam()];
  const std::vector<WrongSolver> solvers = all_wrong();
  ASSERT_GE(solvers.size(), 200U);
  std::size_t seen = 0, tried_ones = 0;
  // Others on each case.
  for (std::size_t i = GetParam(); i < solvers.size(); i += 16) {
    if (!solvers[i].fits(c)) continue;
    ++tried_ones;
    const Trial trial = tried(solvers[i], c);
    if (!trial.visible) continue;
    ++seen;
    EXPECT_TRUE(denies(trial.fit.verdict))
        << solvers[i].name << " is " << to_string(trial.fit.verdict) << ", order "
        << trial.fit.order;
  }
  EXPECT_GE(seen, tried_ones / 4);  // the campaign has faults to find
}

TEST_P(Wrong, WithoutAFaultIsNotDenied) {
  const Case& c = campaign_cases()[GetParam()];
  std::size_t confirmed = 0, tried_ones = 0;
  for (const WrongSolver& solver : all_right()) {
    if (!solver.fits(c)) continue;
    ++tried_ones;
    const judge::OrderFit fit = tried(solver, c).fit;
    EXPECT_NE(fit.verdict, judge::Verdict::lower) << solver.name << ' ' << fit.order;
    EXPECT_NE(fit.verdict, judge::Verdict::floors) << solver.name << ' ' << fit.reason;
    if (fit.verdict == judge::Verdict::confirmed) ++confirmed;
  }
  EXPECT_GE(confirmed, tried_ones / 2);
}

INSTANTIATE_TEST_SUITE_P(Campaign, Wrong, testing::Range(std::size_t{0}, std::size_t{8}),
                         [](const auto& of) { return campaign_cases()[of.param].id; });

}  // namespace
}  // namespace odeum::tests::wrong_solvers_test
