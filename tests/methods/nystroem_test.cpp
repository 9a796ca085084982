// SPDX-License-Identifier: BSD-3-Clause
// Runge-Kutta-Nystroem methods of q'' = a(t, q): order, conditions, embedded pairs.
#include <gtest/gtest.h>

#include <cmath>

#include "odeum/control/run_method.hpp"
#include "odeum/core/guarded.hpp"
#include "support/second_order_methods.hpp"

namespace odeum::tests::nystroem_test {
namespace {

TEST(Nystroem, HasTheOrderThatItClaimsAlsoWhereTimeAppears) {
  int checked = 0;
  for_each_nystroem([&]<class M>() {
    expect_claimed_order<M>();
    ++checked;
  });
  EXPECT_GE(checked, 2);
}

TEST(NystroemTrees, CountsAreThoseOfTheLiterature) {
  // Hairer, Norsett, Wanner, Solving ODEs I, table II.14.3: special Nystroem trees by nodes.
  constexpr std::array<int, 10> known{1, 1, 2, 3, 6, 10, 20, 36, 72, 137};
  constexpr const auto& trees = nystroem_trees<10>;
  for (int n = 1; n <= 10; ++n) {
    int count = 0;
    for (const int nodes : trees.nodes) count += nodes == n;
    EXPECT_EQ(count, known[static_cast<std::size_t>(n - 1)]) << n;
  }
}

TEST(NystroemConditions, HoldForRungeKuttaInDisguise) {
  // RK4 on [q, v] is a Nystroem method with a = A A, b_q = b A: order 4, by theory.
  constexpr const auto& rk = methods::rk4_tableau;
  NystroemTableau<4> n{.order = 4};
  for (std::size_t i = 0; i < 4; ++i) {
    n.c[i] = rk.c(i);
    n.b_v[i] = rk.b[i];
    for (std::size_t j = 0; j < 4; ++j) {
      n.b_q[i] += rk.b[j] * rk.a[j][i];
      for (std::size_t k = 0; k < 4; ++k) n.a[i][j] += rk.a[i][k] * rk.a[k][j];
    }
  }
  EXPECT_EQ(order_fault(n, n.b_q, n.b_v, 4).order, 0);
  EXPECT_EQ(order_fault(n, n.b_q, n.b_v, 3).order, 4);
  EXPECT_EQ(order_fault(n, n.b_q, n.b_v, 5).order, 5);
}

TEST(NystroemConditions, SeeEveryCoefficient) {
  int altered = 0;
  for_each_nystroem([&]<class M>() {
    constexpr const auto& good = M::nystroem;
    using Tableau = std::remove_cvref_t<decltype(good)>;
    const auto accepted = [](const Tableau& t) {
      return first_fault(t).order == 0 && t.reuses_last_stage();
    };
    ASSERT_TRUE(accepted(good));
    const auto alter = [&](auto&& entry) {
      Tableau mutant = good;
      if (entry(mutant) == 0) return;
      entry(mutant) += 1e-6;
      EXPECT_FALSE(accepted(mutant)) << M::info.id;
      ++altered;
    };
    for (std::size_t i = 0; i < good.stages; ++i) {
      alter([i](auto& t) -> double& { return t.c[i]; });
      alter([i](auto& t) -> double& { return t.b_q[i]; });
      alter([i](auto& t) -> double& { return t.b_v[i]; });
      alter([i](auto& t) -> double& { return t.b_q_hat[i]; });
      alter([i](auto& t) -> double& { return t.b_v_hat[i]; });
      for (std::size_t j = 0; j < i; ++j) alter([i, j](auto& t) -> double& { return t.a[i][j]; });
    }
  });
  EXPECT_GE(altered, 80);
}

template <class M>
void expect_pair_to_adapt() {
  const auto run = [](double tolerance, Counters& counters) {
    const Kepler problem;
    Request request;
    request.mode = Mode::adaptive;
    request.tolerance = tolerance;
    request.stops = {3, 20};
    Guard guard(4, request.budget);
    const Guarded<Kepler> guarded(problem, guard);
    Outcome outcome = run_method<M>(guarded, 0, Kepler::exact(0), request);
    guard.conclude(request, outcome);
    EXPECT_EQ(outcome.status, Status::ok) << outcome.detail;
    counters = outcome.counters;
    const State<Kepler> end{outcome.states[4], outcome.states[5], outcome.states[6],
                            outcome.states[7]};
    return distance(end, Kepler::exact(20));
  };
  Counters coarse_cost, fine_cost;
  const double coarse = run(1e-6, coarse_cost), fine = run(1e-9, fine_cost);
  // h goes as tol^(1/(q+1)), the error as h^p: the slope is p / (q + 1) = 6/5 and 8/7.
  const double slope = M::info.order / (M::info.order_embedded + 1.0);
  EXPECT_NEAR(std::log10(coarse / fine) / 3, slope, 0.35) << M::info.id;
  const auto stages = static_cast<std::uint64_t>(M::nystroem.stages);
  EXPECT_EQ(coarse_cost.rhs_evaluations,
            3 + (stages - 1) * (coarse_cost.steps + coarse_cost.rejected_steps))
      << M::info.id << ": the last stage is the first of the next step";
}

TEST(Nystroem, PairsFollowTheTolerance) {
  expect_pair_to_adapt<methods::dormand_nystroem64>();
  expect_pair_to_adapt<methods::dormand_nystroem86>();
}

template <class M>
double estimate_power() {
  const Kepler problem;
  typename M::template Stepper<Kepler> stepper(problem);
  const auto estimate = [&](double h) {
    State<Kepler> y = Kepler::exact(0.3), error{};
    stepper.step(0.3, h, y, error);
    return distance(error, State<Kepler>{});
  };
  return std::log2(estimate(0.2) / estimate(0.05)) / 2;
}

TEST(Nystroem, EstimateFallsWithThePowerOfTheLowerOrder) {
  // The next power of h adds about h.
  EXPECT_NEAR(estimate_power<methods::dormand_nystroem64>(), 5, 0.3);
  EXPECT_NEAR(estimate_power<methods::dormand_nystroem86>(), 7, 0.3);
}

}  // namespace
}  // namespace odeum::tests::nystroem_test
