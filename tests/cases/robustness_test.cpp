// SPDX-License-Identifier: BSD-3-Clause
// Problems without a solution on the interval, or very stiff: every own adaptive solver reports a
// correct status.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "odeum/cases/set_problem.hpp"
#include "support/catalogue.hpp"

namespace odeum::tests::robustness_test {
namespace {

/// y' = y^2 from 1: a pole at t = 1.
struct Pole {
  static constexpr std::size_t dimension = 1;
  void rhs(double, const double* y, double* f) const { f[0] = y[0] * y[0]; }
  void jacobian(double, const double* y, double* j) const { j[0] = 2 * y[0]; }
};

/// y' = 1000 y from 1: beyond the range of doubles at t = 0.7.
struct Growth {
  static constexpr std::size_t dimension = 1;
  void rhs(double, const double* y, double* f) const { f[0] = 1000 * y[0]; }
  void jacobian(double, const double*, double* j) const { j[0] = 1000; }
};

/// Not a number from t = 0.5 on.
struct Broken {
  static constexpr std::size_t dimension = 1;
  void rhs(double t, const double* y, double* f) const {
    f[0] = t < 0.5 ? -y[0] : std::numeric_limits<double>::quiet_NaN();
  }
  void jacobian(double, const double*, double* j) const { j[0] = -1; }
  void time_derivative(double, const double*, double* d) const { d[0] = 0; }
};

/// y' = -1e8 (y - cos t) - sin t from its smooth solution cos t.
struct ExtremelyStiff {
  static constexpr std::size_t dimension = 1;
  void rhs(double t, const double* y, double* f) const {
    f[0] = -1e8 * (y[0] - std::cos(t)) - std::sin(t);
  }
  void jacobian(double, const double*, double* j) const { j[0] = -1e8; }
  void time_derivative(double t, const double*, double* d) const {
    d[0] = -1e8 * std::sin(t) - std::cos(t);
  }
};

/// Calls look(entrant) for every own adaptive solver, enrolled on P from y = 1 at t = 0.
template <class P, class Look>
void for_each_solver(Look&& look) {
  Contest<P> contest;
  contest.problem = std::make_shared<const P>();
  contest.y0 = std::make_shared<const std::vector<double>>(1, 1.0);
  int seen = 0;
  for (const Entrant& entrant : cases::enroll(erase(contest))) {
    if (entrant.info.library != "odeum" || !entrant.info.adaptive || !entrant.unfit.empty())
      continue;
    SCOPED_TRACE(entrant.info.method);
    look(entrant);
    ++seen;
  }
  EXPECT_GT(seen, 40);
}

Request request_to(double horizon, double tolerance = 1e-6) {
  Request request = adaptive_request(tolerance, {horizon});
  request.budget.evaluations = 200'000;
  return request;
}

TEST(Robustness, PastAPoleIsNoSuccess) {
  for (const double tolerance : {1e-3, 1e-6, 1e-9})
    for_each_solver<Pole>([&](const Entrant& entrant) {
      const Outcome outcome = entrant.solve(request_to(2, tolerance));
      EXPECT_NE(outcome.status, Status::ok) << tolerance;
      EXPECT_NE(outcome.status, Status::refused) << outcome.detail;
      EXPECT_NE(outcome.detail, "");
    });
}

TEST(Robustness, OverflowIsNoSuccess) {
  for_each_solver<Growth>([](const Entrant& entrant) {
    const Outcome outcome = entrant.solve(request_to(10));
    EXPECT_NE(outcome.status, Status::ok);
    EXPECT_NE(outcome.status, Status::refused) << outcome.detail;
    EXPECT_NE(outcome.detail, "");
  });
}

TEST(Robustness, NotANumberIsSaidToBeOne) {
  for_each_solver<Broken>([](const Entrant& entrant) {
    const Outcome outcome = entrant.solve(request_to(2, 1e-4));
    EXPECT_NE(outcome.status, Status::ok);
    EXPECT_NE(outcome.detail.find("nan at t = "), std::string::npos) << outcome.detail;
  });
}

// Only implicit methods reach the end within the budget; the others must report that they did not.
TEST(Robustness, ExtremeStiffnessIsSolvedOrReported) {
  int met = 0;
  for_each_solver<ExtremelyStiff>([&](const Entrant& entrant) {
    const Outcome outcome = entrant.solve(request_to(10, 1e-5));
    if (outcome.status == Status::ok) {
      ++met;
      EXPECT_NEAR(outcome.states[0], std::cos(10.0), 100 * 1e-5);
      return;
    }
    EXPECT_NE(outcome.status, Status::refused) << outcome.detail;
    EXPECT_NE(outcome.detail, "");
  });
  EXPECT_GE(met, 15);
}

TEST(Robustness, AHorizonOfNoLengthIsRefused) {
  for_each_solver<Pole>([](const Entrant& entrant) {
    EXPECT_THROW(entrant.solve(request_to(0)), std::invalid_argument);
    EXPECT_THROW(entrant.solve(request_to(-1)), std::invalid_argument);
    EXPECT_THROW(entrant.solve(request_to(std::nan(""))), std::invalid_argument);
  });
}

// The shortest possible horizons: y is 1 there to rounding.
TEST(Robustness, ATinyHorizonIsReachedOrReported) {
  for (const double horizon : {1e-15, 1e-300})
    for_each_solver<Pole>([&](const Entrant& entrant) {
      const Outcome outcome = entrant.solve(request_to(horizon));
      if (outcome.status == Status::ok)
        EXPECT_NEAR(outcome.states[0], 1, 3e-15) << horizon;
      else
        EXPECT_NE(outcome.detail, "") << horizon;
    });
}

}  // namespace
}  // namespace odeum::tests::robustness_test
