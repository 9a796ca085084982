// SPDX-License-Identifier: BSD-3-Clause
// A run that makes no step is asked about without a run of no length.
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "odeum/cases/set_problem.hpp"
#include "odeum/why/why.hpp"

namespace odeum::tests::failing_start_test {
namespace {

/// Finite at the start alone.
struct NowhereElse {
  static constexpr std::size_t dimension = 1;
  void rhs(double t, const double*, double* f) const {
    f[0] = t > 0 ? std::numeric_limits<double>::quiet_NaN() : 1;
  }
};

TEST(FailingStart, IsExplained) {
  Case c;
  c.y0 = {1};
  c.stops = {1};
  c.truth.at = [](double, double*) { return false; };
  cases::set_problem(c, NowhereElse{});
  Request request;
  request.mode = Mode::adaptive;
  request.tolerance = Tolerance(1e-6, std::vector<double>{1e-6});
  request.stops = {1};
  for (const char* solver : {"odeum/rodas4", "odeum/dormand_prince54", "odeum/radau_iia5"}) {
    why::Why why;
    ASSERT_NO_THROW(why = why::why(c, solver, request, 2)) << solver;
    EXPECT_NE(why.outcome.status, Status::ok) << solver;
    EXPECT_EQ(why.reached, 0) << solver;
    for (const why::Finding& finding : why.findings)
      EXPECT_EQ(finding.text.find("step of -nan"), std::string::npos) << solver << finding.text;
  }
}

}  // namespace
}  // namespace odeum::tests::failing_start_test
