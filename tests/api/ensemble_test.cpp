// SPDX-License-Identifier: BSD-3-Clause
// Members in lanes are those of runs alone. No product and sum are joined here (odeum_options), so
// that they have the same bits.
#include "odeum/api/ensemble.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "odeum/linear/dense_lu.hpp"
#include "odeum/methods/dormand_prince54.hpp"
#include "odeum/methods/dormand_prince54_dead_band.hpp"
#include "odeum/methods/dormand_prince54_pi.hpp"
#include "odeum/methods/dormand_prince853.hpp"
#include "odeum/methods/rk4.hpp"
#include "odeum/methods/rodas4.hpp"
#include "odeum/methods/tsitouras54.hpp"
#include "odeum/methods/verner65.hpp"

namespace odeum::tests::ensemble_test {
namespace {

constexpr std::size_t many = 10'000;

template <class Real>
struct Lorenz {
  using real = Real;
  static constexpr std::size_t dimension = 3;
  Real s{10}, r{28}, b{8. / 3};
  void rhs(Real, const Real* y, Real* f) const {
    f[0] = s * (y[1] - y[0]);
    f[1] = y[0] * (r - y[2]) - y[1];
    f[2] = y[0] * y[1] - b * y[2];
  }
};
/// Depends on t, and calls functions.
template <class Real>
struct Driven {
  using real = Real;
  static constexpr std::size_t dimension = 2;
  Real force{1}, friction{0.1};
  void rhs(Real t, const Real* y, Real* f) const {
    using std::sin, std::abs, std::sqrt;
    f[0] = y[1];
    f[1] = force * sin(2 * t) - sin(y[0]) - friction * select(y[1] < 0, -y[1], y[1]) * y[1] -
           0.1 * sqrt(abs(y[0]));
  }
};
template <class Real>
struct Robertson {
  using real = Real;
  static constexpr std::size_t dimension = 3;
  Real slow{0.04}, fast{3e7}, back{1e4};
  static constexpr bool autonomous() { return true; }
  void rhs(Real, const Real* y, Real* f) const {
    const Real u = slow * y[0], v = back * y[1] * y[2], w = fast * y[1] * y[1];
    f[0] = v - u;
    f[1] = u - v - w;
    f[2] = w;
  }
  void jacobian(Real, const Real* y, Real* j) const {
    const Real rows[] = {
        -slow,        back * y[2], back * y[1],     slow, -back * y[2] - 2 * fast * y[1],
        -back * y[1], 0,           2 * fast * y[1], 0};
    std::copy(std::begin(rows), std::end(rows), j);
  }
};
/// Five rates of very different size in a ring, driven: more unknowns than have a closed inverse.
template <class Real>
struct Ring {
  using real = Real;
  static constexpr std::size_t dimension = 5;
  Real fast{1e4};
  Real rate(std::size_t i) const { return i % 2 == 0 ? fast : Real(1. + static_cast<double>(i)); }
  void rhs(Real t, const Real* y, Real* f) const {
    using std::cos;
    for (std::size_t i = 0; i < 5; ++i) {
      const std::size_t before = (i + 4) % 5;
      f[i] = rate(before) * y[before] * y[before] - rate(i) * y[i] * y[i] + cos(t);
    }
  }
  void jacobian(Real, const Real* y, Real* j) const {
    std::fill(j, j + 25, Real(0));
    for (std::size_t i = 0; i < 5; ++i) {
      j[i * 5 + i] = -2 * rate(i) * y[i];
      j[(i + 1) % 5 * 5 + i] = 2 * rate(i) * y[i];
    }
  }
  void time_derivative(Real t, const Real*, Real* f) const {
    using std::sin;
    for (std::size_t i = 0; i < 5; ++i) f[i] = -sin(t);
  }
};

template <class P, std::size_t N>
P scaled(const P& problem, const std::array<double, N>& factors) {
  auto numbers = std::bit_cast<std::array<double, N>>(problem);
  for (std::size_t i = 0; i < N; ++i) numbers[i] *= factors[i];
  return std::bit_cast<P>(numbers);
}

template <template <class> class P>
struct Ensemble {
  std::vector<P<double>> members;
  std::vector<State<P<double>>> states;
};
/// Each number of each member within a factor of 1 to 1.5 of the usual one.
template <template <class> class P>
Ensemble<P> around(const State<P<double>>& start, std::size_t count) {
  Ensemble<P> all{std::vector<P<double>>(count), std::vector<State<P<double>>>(count, start)};
  std::mt19937 draw(7);
  std::uniform_real_distribution<double> factor(1, 1.5);
  for (std::size_t k = 0; k < count; ++k) {
    std::array<double, sizeof(P<double>) / sizeof(double)> numbers{};
    for (double& each : numbers) each = factor(draw);
    all.members[k] = scaled(all.members[k], numbers);
    for (double& each : all.states[k]) each *= factor(draw);
  }
  return all;
}

template <class S>
bool same(const S& a, const S& b) {
  return std::equal(a.begin(), a.end(), b.begin(),
                    [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

/// Functions of libmvec have some units in the last place more than those of a run alone: steps of
/// equal length add up some hundred of them. A step to a tolerance that is nearly rejected may be
/// rejected in one of the two: then the runs have steps of their own, and as much of an error each
/// as their tolerances leave over all steps, some ten times one step's.
template <template <class> class P>
constexpr bool calls_functions = std::is_same_v<P<double>, Driven<double>>;
double apart(const Step&) { return 1e-11; }
double apart(const Tolerance& tolerance) { return 20 * tolerance.relative; }

template <class S>
bool near(const RunEnd& a, const RunEnd& b, const S& y, const S& z, double apart) {
  const double steps = static_cast<double>(a.steps) - static_cast<double>(b.steps);
  bool all = a.status == b.status && a.t == b.t &&
             std::abs(steps) <= 1 + 0.15 * static_cast<double>(b.steps);
  for (std::size_t i = 0; i < y.size(); ++i)
    all = all && std::abs(y[i] - z[i]) <= apart * (1 + std::abs(z[i]));
  return all;
}

/// Each member to the last bit as alone, and all that is told of its run.
template <template <class> class P, class M, class How>
void expect_as_alone(M method, const How& how, double end, const State<P<double>>& start,
                     std::size_t count = many) {
  Ensemble<P> together = around<P>(start, count), alone = together;
  const auto ends = integrate_ensemble(together.members, method, together.states, 0.5, end, how);
  ASSERT_EQ(ends.size(), count);
  std::size_t others = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const RunEnd run = integrate(alone.members[k], method, alone.states[k], 0.5, end, how);
    bool as_alone = ends[k].status == run.status && ends[k].t == run.t &&
                    ends[k].steps == run.steps && ends[k].rejected_steps == run.rejected_steps &&
                    ends[k].rhs_evaluations == run.rhs_evaluations &&
                    same(together.states[k], alone.states[k]);
    if (calls_functions<P>)
      as_alone = near(ends[k], run, together.states[k], alone.states[k], apart(how));
    if (!as_alone && others++ == 0)
      ADD_FAILURE() << M::info.id << ", member " << k << ": " << ends[k].steps << " steps, "
                    << ends[k].rhs_evaluations << " evaluations, alone " << run.steps << ", "
                    << run.rhs_evaluations << "; " << together.states[k][0] << ", alone "
                    << alone.states[k][0];
  }
  EXPECT_EQ(others, 0U);
}

TEST(Ensemble, FixedStepsHaveTheBitsOfRunsAlone) {
  expect_as_alone<Lorenz>(methods::rk4{}, Step{0.01}, 1.5, {1, 2, 20});
  expect_as_alone<Driven>(methods::rk4{}, Step{0.05}, 2.5, {1, 0.5});
  expect_as_alone<Lorenz>(methods::dormand_prince54{}, Step{0.02}, 1.5, {1, 2, 20});
  expect_as_alone<Driven>(methods::verner65{}, Step{0.1}, 2.5, {1, 0.5});
  expect_as_alone<Robertson>(methods::rodas4{}, Step{1}, 20, {1, 0, 0}, 1000);
}

TEST(Ensemble, AdaptiveStepsHaveTheBitsOfRunsAlone) {
  expect_as_alone<Lorenz>(methods::dormand_prince54{}, Tolerance{1e-6}, 2, {1, 2, 20});
  expect_as_alone<Driven>(methods::dormand_prince54_pi{}, Tolerance{1e-5, {1e-5, 1e-7}}, 4,
                          {1, 0.5});
  expect_as_alone<Driven>(methods::dormand_prince54_dead_band{}, Tolerance{1e-6}, 4, {1, 0.5}, 999);
  expect_as_alone<Lorenz>(methods::dormand_prince853{}, Tolerance{1e-9}, 2, {1, 2, 20}, 1001);
  expect_as_alone<Driven>(methods::verner65{}, Tolerance{1e-7}, 4, {1, 0.5}, 1000);
  expect_as_alone<Driven>(methods::tsitouras54{}, Tolerance{1e-7}, 4, {1, 0.5}, 3);
  expect_as_alone<Robertson>(methods::rodas4{}, Tolerance{1e-6, 1e-10}, 400, {1, 0, 0});
}

// Elimination in lanes has another order of operations than that of a single matrix.
TEST(Ensemble, StiffMembersKeepTheToleranceOfRunsAlone) {
  Ensemble<Ring> together = around<Ring>({1, 1, 1, 1, 1}, many), alone = together, truth = together;
  const Tolerance tolerance(1e-6);
  const auto ends =
      integrate_ensemble(together.members, methods::rodas4{}, together.states, 0, 2, tolerance);
  double worst = 0, worst_alone = 0;
  for (std::size_t k = 0; k < many; k += 10) {
    const RunEnd run =
        integrate(alone.members[k], methods::rodas4{}, alone.states[k], 0, 2, tolerance);
    ASSERT_TRUE(ends[k].ok() && run.ok());
    EXPECT_NEAR(static_cast<double>(ends[k].steps), static_cast<double>(run.steps), 2);
    integrate(truth.members[k], methods::rodas4{}, truth.states[k], 0, 2, Tolerance(1e-10));
    for (std::size_t n = 0; n < 5; ++n) {
      const double size = 1 + std::abs(truth.states[k][n]);
      worst = std::max(worst, std::abs(together.states[k][n] - truth.states[k][n]) / size);
      worst_alone = std::max(worst_alone, std::abs(alone.states[k][n] - truth.states[k][n]) / size);
    }
  }
  EXPECT_LT(worst, 1.01 * worst_alone);
  EXPECT_LT(worst_alone, 20e-6);
}

TEST(Ensemble, FailuresAreThoseOfRunsAlone) {
  // y' = r x grows past what a double holds, or the step falls below the rounding of t.
  expect_as_alone<Lorenz>(methods::rk4{}, Step{0.5}, 40, {1e3, 2e3, 2e4}, 100);
  Ensemble<Lorenz> together = around<Lorenz>({1, 2, 20}, 100), alone = together;
  for (Ensemble<Lorenz>* all : {&together, &alone})
    for (std::size_t k = 0; k < 100; k += 3) all->states[k][0] = std::nan("");
  const auto ends = integrate_ensemble(together.members, methods::dormand_prince54{},
                                       together.states, 0.5, 1, Tolerance{1e-6});
  for (std::size_t k = 0; k < 100; ++k) {
    const RunEnd run = integrate(alone.members[k], methods::dormand_prince54{}, alone.states[k],
                                 0.5, 1, Tolerance{1e-6});
    EXPECT_EQ(ends[k].status, run.status) << k;
    EXPECT_EQ(ends[k].t, run.t) << k;
    EXPECT_TRUE(same(together.states[k], alone.states[k])) << k;
  }
}

TEST(Ensemble, ThreadsChangeNoBit) {
  Ensemble<Lorenz> one = around<Lorenz>({1, 2, 20}, 500), three = one;
  integrate_ensemble(one.members, methods::dormand_prince54{}, one.states, 0, 1, Tolerance{1e-6});
  integrate_ensemble(three.members, methods::dormand_prince54{}, three.states, 0, 1,
                     Tolerance{1e-6}, 3);
  EXPECT_EQ(one.states, three.states);
  integrate_ensemble(one.members, methods::rk4{}, one.states, 0, 1, Step{0.01});
  integrate_ensemble(three.members, methods::rk4{}, three.states, 0, 1, Step{0.01}, 3);
  EXPECT_EQ(one.states, three.states);
}

TEST(Ensemble, MalformedRequestsAreRefused) {
  std::vector<Lorenz<double>> members(3);
  std::vector<std::array<double, 3>> states(2);
  EXPECT_THROW(integrate_ensemble(members, methods::rk4{}, states, 0, 1, Step{0.1}),
               std::invalid_argument);
  states.resize(3);
  EXPECT_THROW(integrate_ensemble(members, methods::rk4{}, states, 1, 0, Step{0.1}),
               std::invalid_argument);
  EXPECT_THROW(integrate_ensemble(members, methods::rk4{}, states, 0, 1, Step{0}),
               std::invalid_argument);
  EXPECT_THROW(
      integrate_ensemble(members, methods::dormand_prince54{}, states, 0, 1, Tolerance{-1}),
      std::invalid_argument);
  members.clear();
  states.clear();
  EXPECT_TRUE(integrate_ensemble(members, methods::rk4{}, states, 0, 1, Step{0.1}).empty());
}

// In some lanes the first pivot is far too small, in one the matrix is singular.
TEST(LaneLu, ExchangesRowsWhereALaneNeedsIt) {
  constexpr std::size_t n = 6;
  std::mt19937 draw(3);
  std::uniform_real_distribution<double> entry(-1, 1);
  std::array<std::array<double, n * n>, Lanes::count> matrices{};
  linear::LaneLu<n> together(n);
  std::array<Lanes, n> x{};
  for (std::size_t lane = 0; lane < Lanes::count; ++lane) {
    for (double& each : matrices[lane]) each = entry(draw);
    for (std::size_t i = 0; i < n; ++i) matrices[lane][i * n + i] += 4;
    if (lane % 2 == 0) matrices[lane][0] = matrices[lane][2 * n + 2] = lane == 0 ? 0 : 1e-14;
    if (lane == 1)
      for (std::size_t i = 0; i < n; ++i) matrices[lane][i] = 0;
    for (std::size_t k = 0; k < n * n; ++k) together.data()[k].set(lane, matrices[lane][k]);
    for (std::size_t i = 0; i < n; ++i) x[i].set(lane, 1. + static_cast<double>(i));
  }
  together.factorise();
  together.solve(x.data());
  for (std::size_t lane = 0; lane < Lanes::count; ++lane) {
    double finite = 0;
    for (std::size_t i = 0; i < n; ++i) finite += x[i][lane] * 0;
    EXPECT_EQ(lane == 1, finite != 0) << lane;
    if (lane == 1) continue;
    for (std::size_t i = 0; i < n; ++i) {
      double sum = 0;
      for (std::size_t j = 0; j < n; ++j) sum += matrices[lane][i * n + j] * x[j][lane];
      EXPECT_NEAR(sum, 1. + static_cast<double>(i), 1e-11) << lane;
    }
  }
}

}  // namespace
}  // namespace odeum::tests::ensemble_test
