// SPDX-License-Identifier: BSD-3-Clause
// One Jacobian by differences for all that need one, in any unit of the state, and one count of it.
#include "odeum/problem/difference_jacobian.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "odeum/api/integrate.hpp"
#include "odeum/cases/set_problem.hpp"
#include "odeum/core/guarded.hpp"
#include "odeum/linear/sparse_system.hpp"
#include "odeum/methods/bdf_variable.hpp"
#include "odeum/methods/radau_iia5.hpp"
#include "odeum/solvers/dense_jacobian.hpp"
#include "support/catalogue.hpp"
#include "support/implicit_stage.hpp"

namespace odeum::tests::difference_jacobian_test {
namespace {

/// Robertson's reactions for concentrations in other units, the second one's `second` times that of
/// the others.
template <bool WithJ>
struct Reactions {
  static constexpr std::size_t dimension = 3;
  double unit = 1, second = 1;
  double of(std::size_t i) const { return i == 1 ? unit * second : unit; }
  bool autonomous() const { return true; }
  State<Robertson> in_unit(const double* y) const {
    return {y[0] / of(0), y[1] / of(1), y[2] / of(2)};
  }
  void rhs(double t, const double* y, double* f) const {
    Robertson().rhs(t, in_unit(y).data(), f);
    for (std::size_t i = 0; i < 3; ++i) f[i] *= of(i);
  }
  void jacobian(double t, const double* y, double* j) const requires WithJ {
    Robertson().jacobian(t, in_unit(y).data(), j);
    for (std::size_t k = 0; k < 9; ++k) j[k] *= of(k / 3) / of(k % 3);
  }
};
using Matrix = std::array<double, 9>;
const double units[] = {0x1p-27, 1, 0x1p27};  // 7e-9, 1, 1e8

TEST(DifferenceJacobian, IsTheSameInEveryUnit) {
  for (const State<Robertson> y : {State<Robertson>{1, 0, 0}, {0.7, 2e-5, 0.3}}) {
    Matrix exact;
    Robertson().jacobian(0, y.data(), exact.data());
    for (const double unit : units) {
      const State<Robertson> scaled{y[0] * unit, y[1] * unit, y[2] * unit};
      Matrix j;
      difference_jacobian(Reactions<false>{unit}, 0, scaled.data(), j.data());
      // The second component moves by 1.5e-8 times a thousandth: 3e7 of it is 4.5e-4.
      for (std::size_t k = 0; k < 9; ++k) EXPECT_NEAR(j[k], exact[k], 1e-3) << unit << ' ' << k;
    }
  }
}

/// y' = rate - 3 y.
struct Filling {
  static constexpr std::size_t dimension = 1;
  double rate;
  void rhs(double, const double* y, double* f) const { f[0] = rate - 3 * y[0]; }
};

TEST(DifferenceJacobian, OfAStateOfZerosIsMeasuredByItsDerivative) {
  const double zero = 0;
  for (const double rate : {1e-8, 1.0, 1e8, 0.0}) {
    double j = 0;
    difference_jacobian(Filling{rate}, 0, &zero, &j);
    EXPECT_NEAR(j, -3, 1e-4) << rate;  // rounding of 1 by a change of 1.5e-11
  }
}

/// Two components of unlike sizes, the smaller one not linear.
struct Mixed {
  static constexpr std::size_t dimension = 2;
  bool autonomous() const { return true; }
  void rhs(double, const double* y, double* f) const {
    f[0] = -y[0];
    f[1] = -3e7 * y[1] * y[1];
  }
};

TEST(DifferenceJacobian, WeighsComponentsByTheThresholdsOfATolerance) {
  const Mixed problem;
  const State<Mixed> y{1e8, 3.6e-5};
  const auto error = [&](const Tolerance& tolerance) {
    Plain<Mixed> seen(problem);
    seen.weigh_by(tolerance);
    std::array<double, 4> j{};
    seen.jacobian(0, y.data(), j.data());
    return std::abs(j[3] + 2 * 3e7 * y[1]);
  };
  EXPECT_LE(error(Tolerance(1e-6, {1e2, 1e-10})), 1e-2);
  EXPECT_GT(error(Tolerance(1e-6, 1e-10)), 1e3);  // else the weights would be of no use
}

TEST(DifferenceJacobian, IsOneForOwnMethodsPeersSparseProblemsAndTheLibrary) {
  for (const double unit : units) {
    const Reactions<false> problem{unit};
    const State<Robertson> y{0.7 * unit, 2e-5 * unit, 0};
    Matrix expected, j;
    difference_jacobian(problem, 0, y.data(), expected.data());

    const SharedOde shared{view_of(problem), nullptr};
    Guard guard(3, {});
    const Guarded<SharedOde> guarded(shared, guard);
    jacobian_or_differences(guarded, 0, y.data(), j.data());
    EXPECT_EQ(j, expected);
    EXPECT_EQ(guard.rhs_evaluations(), 4U);
    EXPECT_EQ(guard.jacobian_evaluations(), 1U);

    GuardedView view(view_of(problem), {});  // what GSL, odeint and plug-ins get
    ASSERT_EQ(DenseJacobian(view)(0, y.data(), j.data()), 0);
    EXPECT_EQ(j, expected);
    EXPECT_EQ(view.guard().rhs_evaluations(), 4U);
    EXPECT_EQ(view.guard().jacobian_evaluations(), 1U);

    const Sparsity full = banded_sparsity(3, 2, 2);
    differenced_entries(full, [&](double t, const double* at, double* f) {
      problem.rhs(t, at, f);
    })(0, y.data(), j.data());
    EXPECT_EQ(j, expected);

    const Plain<Reactions<false>> plain(problem);
    plain.jacobian(0, y.data(), j.data());
    EXPECT_EQ(j, expected);
  }
}

template <bool WithJ>
Case reactions(double unit, double second = 1) {
  Case c;
  c.y0 = {unit, 0, 0};
  c.stops = {40};
  cases::set_problem(c, Reactions<WithJ>{unit, second});
  return c;
}
const Entrant* entrant_of(const Case& c, const std::string& id) {
  for (const Entrant& entrant : c.entrants)
    if (entrant.info.id() == id && entrant.solve) return &entrant;
  return nullptr;  // the library is not there
}

/// Where the second concentration, 4e-5 at most, has a unit of its own, it is moved by what its
/// tolerance says of its size, not by that of the others.
TEST(DifferenceJacobian, CostsEvaluationsButNoStepsInAnyUnit) {
  using Units = std::pair<double, double>;
  for (const auto& [unit, second] :
       {Units{0x1p-27, 1}, {1, 1}, {0x1p27, 1}, {1, 0x1p-40}, {1, 0x1p20}}) {
    const Case exact = reactions<true>(unit, second), differenced = reactions<false>(unit, second);
    Request request = adaptive_request(1e-6, {40});
    request.tolerance =
        second == 1 ? Tolerance(1e-6, 1e-10 * unit) : Tolerance(1e-6, {1e-8, 1e-12 * second, 1e-8});
    request.budget.evaluations = 100'000;  // a hundred times what a run takes
    for (const char* id : {"odeum/radau_iia5", "odeum/bdf_variable", "odeum/rodas4", "odeum/sdirk4",
                           "gsl/bsimp", "gsl/rk4imp", "gsl/msbdf", "odeint/rosenbrock4"}) {
      if (!entrant_of(exact, id)) continue;
      const Outcome a = entrant_of(exact, id)->solve(request),
                    b = entrant_of(differenced, id)->solve(request);
      ASSERT_EQ(a.status, Status::ok) << id << ' ' << unit << a.detail;
      ASSERT_EQ(b.status, Status::ok) << id << ' ' << unit << b.detail;
      const auto steps = static_cast<double>(a.counters.steps);
      EXPECT_NEAR(static_cast<double>(b.counters.steps), steps, 0.05 * steps) << id << ' ' << unit;
      EXPECT_GE(b.counters.rhs_evaluations, 4 * b.counters.jacobian_evaluations) << id;
      const Reactions<true> in{unit, second};
      for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(b.states[i], a.states[i], 1e-5 * in.of(i)) << id << ' ' << unit << second;
    }
  }
}

TEST(DifferenceJacobian, IsCountedAlikeForEverySolver) {
  const Case exact = reactions<true>(1), differenced = reactions<false>(1);
  const Request request = fixed_request(400, {0.4});
  for (const char* id : {"odeum/rodas4", "odeint/rosenbrock4", "arkode/arkstep_sdirk_5_3_4"}) {
    if (!entrant_of(exact, id)) continue;
    const Outcome a = entrant_of(exact, id)->solve(request),
                  b = entrant_of(differenced, id)->solve(request);
    ASSERT_EQ(b.status, Status::ok) << id << b.detail;
    EXPECT_GT(a.counters.jacobian_evaluations, 0U) << id;
    EXPECT_EQ(b.counters.jacobian_evaluations, a.counters.jacobian_evaluations) << id;
    // ARKODE has f at the state already.
    const std::uint64_t each = entrant_of(exact, id)->info.library == "arkode" ? 3 : 4;
    EXPECT_EQ(b.counters.rhs_evaluations,
              a.counters.rhs_evaluations + each * a.counters.jacobian_evaluations)
        << id;
  }
  if (const Entrant* const cvode = entrant_of(differenced, "cvode/bdf")) {
    const Outcome b = cvode->solve(adaptive_request(1e-6, {40}));
    EXPECT_GT(b.counters.jacobian_evaluations, 0U);
    EXPECT_GT(b.counters.rhs_evaluations, 3 * b.counters.jacobian_evaluations);
  }
}

template <class M>
void expect_equal_steps_by_the_library(M method) {
  for (const double unit : units) {
    State<Robertson> with{unit, 0, 0}, without = with;
    const Tolerance tolerance(1e-6, 1e-10 * unit);
    const RunEnd a = integrate(Reactions<true>{unit}, method, with, 0, 40, tolerance),
                 b = integrate(Reactions<false>{unit}, method, without, 0, 40, tolerance);
    ASSERT_TRUE(a.ok());
    ASSERT_TRUE(b.ok()) << unit << ": ended at t = " << b.t;
    const auto steps = static_cast<double>(a.steps);
    EXPECT_NEAR(static_cast<double>(b.steps), steps, 0.05 * steps) << unit;
  }
}

TEST(DifferenceJacobian, ServesProgramsOfOnesOwnInAnyUnit) {
  expect_equal_steps_by_the_library(methods::radau_iia5{});
  expect_equal_steps_by_the_library(methods::bdf_variable{});
}

}  // namespace
}  // namespace odeum::tests::difference_jacobian_test
