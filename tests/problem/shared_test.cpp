// SPDX-License-Identifier: BSD-3-Clause
// The shared problem types stand for any problem: missing capabilities have fallbacks, whose cost
// is counted.
#include "odeum/problem/shared.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>

#include "odeum/cases/set_problem.hpp"
#include "odeum/core/guarded.hpp"
#include "odeum/problem/difference_jacobian.hpp"

namespace odeum::shared_test {
namespace {

/// Prey and predator without a Jacobian.
struct Plain {
  static constexpr std::size_t dimension = 2;
  void rhs(double, const double* y, double* f) const {
    f[0] = y[0] * (1 - y[1]);
    f[1] = y[1] * (y[0] - 1);
  }
};

/// q'' = -q + sin t.
struct Forced {
  static constexpr std::size_t dimension = 2;
  static constexpr bool velocity_dependent = false;
  void acceleration(double t, const double* q, const double*, double* a) const {
    a[0] = std::sin(t) - q[0];
  }
  void rhs(double t, const double* y, double* f) const { second_order_rhs(*this, 1, t, y, f); }
  void jacobian(double, const double*, double* j) const {
    j[0] = j[3] = 0;
    j[1] = 1;
    j[2] = -1;
  }
  void time_derivative(double t, const double*, double* d) const {
    d[0] = 0;
    d[1] = std::cos(t);
  }
};

template <class P>
SharedOde shared(const P& problem) {
  return {view_of(problem), nullptr};
}

TEST(Shared, DifferencesStandInForAJacobianAndAreCounted) {
  const Plain plain;
  const SharedOde problem = shared(plain);
  Guard guard(2, {});
  const Guarded<SharedOde> guarded(problem, guard);
  const double y[2] = {2, 3};
  double j[4];
  jacobian_or_differences(guarded, 0, y, j);
  const double exact[4] = {-2, -2, 3, 1};
  // Forward differences in steps of 1.5e-8 |y| lose half of the digits.
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(j[i], exact[i], 1e-6) << i;
  EXPECT_EQ(guard.rhs_evaluations(), 3U);
  EXPECT_EQ(guard.jacobian_evaluations(), 1U);
}

TEST(Shared, OffersWhatTheProblemHas) {
  const Forced forced;
  const SharedOde problem = shared(forced);
  Guard guard(2, {});
  const Guarded<SharedOde> guarded(problem, guard);
  const double y[2] = {0.5, 0};
  double j[4], d[2];
  guarded.jacobian(0, y, j);
  EXPECT_EQ(j[2], -1);
  EXPECT_EQ(guard.jacobian_evaluations(), 1U);
  EXPECT_EQ(guard.rhs_evaluations(), 0U);
  guarded.time_derivative(1, y, d);
  EXPECT_EQ(d[1], std::cos(1.0));
  EXPECT_FALSE(is_autonomous(guarded));
  EXPECT_EQ(problem.shifted_solver(), nullptr);
}

TEST(Shared, AnAutonomousProblemHasAZeroTimeDerivative) {
  const Plain plain;
  const SharedOde problem = shared(plain);
  const double y[2] = {2, 3};
  double d[2] = {7, 7};
  problem.time_derivative(0, y, d);
  EXPECT_EQ(d[0], 0);
  EXPECT_EQ(d[1], 0);
  EXPECT_TRUE(is_autonomous(problem));
}

/// Libraries with a C interface get the problem itself, not the fallbacks of the shared type.
TEST(Shared, ItsViewIsTheProblems) {
  const Plain plain;
  const OdeView view = view_of(shared(plain));
  EXPECT_EQ(view.problem, &plain);
  EXPECT_EQ(view.jacobian, nullptr);
  EXPECT_EQ(view.time_derivative, nullptr);
}

// A guarded problem offers what its problem offers, and nothing else.
static_assert(!WithJacobian<Guarded<Plain>> && !NonAutonomous<Guarded<Plain>>);
static_assert(WithJacobian<Guarded<Forced>> && NonAutonomous<Guarded<Forced>>);
static_assert(Separable<Guarded<Forced>> && !WithDamping<Guarded<Forced>>);
static_assert(WithTaylorSeries<Guarded<SharedOde>> && !SecondOrder<Guarded<SharedOde>>);
static_assert(SecondOrder<Guarded<SharedSecondOrder>> && !Separable<Guarded<SharedSecondOrder>>);

TEST(Shared, OffersAreThoseOfTheProblem) {
  const Forced forced;
  const SharedSeparable problem(view_of(forced), nullptr);
  Guard guard(2, {});
  const Guarded<SharedSeparable> guarded(problem, guard);
  EXPECT_TRUE(offers_jacobian(guarded) && offers_time_derivative(guarded));
  EXPECT_TRUE(offers_acceleration(guarded));
  EXPECT_FALSE(offers_taylor(guarded) || offers_damp(guarded) || offers_shifted_solver(guarded));
  EXPECT_FALSE(offers_jacobian_times(guarded) || offers_linear_matrix(guarded));
}

template <class P>
std::string unfit(P problem, const std::string& id) {
  Case c;
  c.y0 = {1, 1};
  c.stops = {1};
  cases::set_problem(c, problem);
  for (const Entrant& entrant : c.entrants)
    if (entrant.info.id() == id) return entrant.unfit;
  return "no such solver";
}

TEST(Shared, ReasonsAreThoseOfTheProblem) {
  EXPECT_EQ(unfit(Forced{}, "odeum/leapfrog"), "");
  EXPECT_EQ(unfit(Forced{}, "odeum/rk4"), "");
  EXPECT_NE(unfit(Plain{}, "odeum/leapfrog"), "");
  EXPECT_EQ(unfit(Plain{}, "odeum/rk4"), "");
}

/// A timed run makes the same steps as a counted one, and counts nothing.
TEST(Shared, ATimedRunIsTheSameRunUnwatched) {
  Case c;
  c.y0 = {1, 0};
  c.stops = {1, 2};
  cases::set_problem(c, Forced{});
  int ran = 0;
  for (const Entrant& entrant : c.entrants) {
    if (!entrant.unfit.empty() || !entrant.info.fixed) continue;
    Request request;
    request.steps = 64;
    request.stops = c.stops;
    const Outcome counted = entrant.solve(request);
    request.budget.watched = false;
    const Outcome timed = entrant.solve(request);
    EXPECT_EQ(counted.status, timed.status) << entrant.info.id();
    EXPECT_EQ(counted.states, timed.states) << entrant.info.id();
    if (entrant.info.library == "bullet") continue;  // it has no right-hand side to count
    if (counted.status == Status::ok) {
      EXPECT_GT(counted.counters.rhs_evaluations, 0U) << entrant.info.id();
    }
    EXPECT_EQ(timed.counters.rhs_evaluations, 0U) << entrant.info.id();
    ++ran;
  }
  EXPECT_GT(ran, 10);
}

}  // namespace
}  // namespace odeum::shared_test
