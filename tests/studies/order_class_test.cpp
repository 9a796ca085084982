// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include <set>

#include "odeum/studies/convergence/convergence.hpp"
#include "odeum/studies/convergence/order_reason.hpp"

namespace odeum::study::order_class_test {
namespace {

const OrderClass* class_of(const judge::OrderFit& fit) {
  const auto classes = order_classes();
  const auto found = std::ranges::find(classes, fit.why, &OrderClass::why);
  return found == classes.end() ? nullptr : &*found;
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
                               row.fit.verdict == judge::Verdict::undetermined ||
                               row.fit.verdict == judge::Verdict::over_budget;
    ASSERT_EQ(known != nullptr, without_order) << row.fit.reason;
    if (!known) continue;
    found.insert(known->name);
    // Each of its steps is far beyond 2.78 / 2400, and the quadratic terms let it blow up.
    if (row.case_id == "robertson_40" && row.solver == "rk4" && row.mode == Mode::fixed) {
      EXPECT_EQ(known->name, "unstable at every step tried") << row.fit.reason;
    }
  }
  EXPECT_GE(found.size(), 3U) << "too few classes to tell anything of their texts";
}

TEST(OrderClass, EveryCauseIsOneClassWithWords) {
  for (int k = 1;; ++k) {  // after `none`
    judge::OrderFit fit;
    fit.why = static_cast<judge::NoOrder>(k);
    if (to_string(fit.why) == std::string()) break;
    const OrderClass* const known = class_of(fit);
    ASSERT_NE(known, nullptr) << to_string(fit.why);
    EXPECT_EQ(known->why, fit.why) << "two classes of one cause";
    EXPECT_FALSE(known->name.empty() || known->settles.empty()) << to_string(fit.why);
  }
  EXPECT_EQ(class_of(judge::OrderFit()), nullptr);
}

}  // namespace
}  // namespace odeum::study::order_class_test
