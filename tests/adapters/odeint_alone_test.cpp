// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/odeint_alone.hpp"
#include "adapters/alone.hpp"

namespace odeum::test::odeint_alone_test {
namespace {

bool rosenbrock4(const Case& c, double tolerance, std::vector<double>& y) {
  return rosenbrock4_alone(c.problem.view, c.t0, c.stops, tolerance, y);
}

TEST(OdeintAlone, Rosenbrock4FailsNowhereElse) {
  expect_no_worse_than_alone("odeint/rosenbrock4", rosenbrock4);
}
TEST(OdeintAlone, Rosenbrock4WithDenseOutputFailsNowhereElse) {
  expect_no_worse_than_alone("odeint/rosenbrock4_dense_output", rosenbrock4);
}
TEST(OdeintAlone, EachHardCaseIsSolved) { expect_each_case_solved("odeint"); }

}  // namespace
}  // namespace odeum::test::odeint_alone_test
