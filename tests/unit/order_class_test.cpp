// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/convergence/order_class.hpp"

#include <gtest/gtest.h>

#include <set>

#include "odeum/studies/convergence/convergence.hpp"

namespace odeum::study {
namespace {

judge::OrderFit fit_of(judge::Verdict verdict, const std::string& reason) {
  judge::OrderFit fit;
  fit.verdict = verdict;
  fit.reason = reason;
  return fit;
}

TEST(OrderClass, EveryReasonOfRealRunsHasAClass) {
  Options options;
  options.cases = {"robertson_40", "kepler_e09", "hires"};
  options.solvers = {"odeum/rk4",
                     "odeum/radau_iia9",
                     "odeum/sdirk2",
                     "odeum/implicit_euler_fixed_*",
                     "odeum/explicit_euler",
                     "gsl/rk4",
                     "odeint/rosenbrock4",
                     "cvode/adams"};
  options.quick = true;
  const ConvergenceResult result = converge(options, Runner());
  std::set<std::string_view> found;
  for (const OrderRow& row : result.orders) {
    const OrderClass* const known = class_of(row.fit);
    const bool without_order = row.fit.verdict == judge::Verdict::failed ||
                               row.fit.verdict == judge::Verdict::undetermined;
    ASSERT_EQ(known != nullptr, without_order) << row.fit.reason;
    if (!known) continue;
    EXPECT_NE(known->name, "other") << row.case_id << " " << row.solver << ": " << row.fit.reason;
    found.insert(known->name);
    // Each of its steps is far beyond 2.78 / 2400, and the quadratic terms let it blow up.
    if (row.case_id == "robertson_40" && row.solver == "rk4" && row.mode == Mode::fixed) {
      EXPECT_EQ(known->name, "unstable at every step tried") << row.fit.reason;
    }
  }
  EXPECT_GE(found.size(), 3U) << "too few classes to tell anything of their texts";
}

TEST(OrderClass, TheFirstMarkDecides) {
  using judge::Verdict;
  const auto name = [](Verdict verdict, const char* reason) {
    const OrderClass* const known = class_of(fit_of(verdict, reason));
    return std::string(known ? known->name : "none");
  };
  EXPECT_EQ(name(Verdict::undetermined,
                 "3 steps give an error that is solved; 4 are needed; 320 steps take about 2e+04 "
                 "evaluations, more than the budget"),
            "the budget ends before the order shows");
  EXPECT_EQ(name(Verdict::undetermined, "3 steps give an error that is solved; 4 are needed"),
            "rounding is reached after too few points");
  EXPECT_EQ(name(Verdict::undetermined,
                 "no step size could be solved within the budget: more than "
                 "30000 evaluations; first non-finite value: component 0"),
            "over budget at every setting");
  EXPECT_EQ(name(Verdict::undetermined,
                 "order 5.12 down to steps of 0.022, but at 0.0078 the error "
                 "is 2.4 times what that predicts"),
            "a finer run denies the order");
  EXPECT_EQ(name(Verdict::failed, "of a new kind"), "other");
  EXPECT_EQ(name(Verdict::lower, "converges with order 3 where 4 is claimed"), "none");
}

}  // namespace
}  // namespace odeum::study
