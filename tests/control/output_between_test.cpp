// SPDX-License-Identifier: BSD-3-Clause
// Output inside the steps of adaptive runs: it changes no step, and has the order of the method.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>

#include "odeum/control/one_step.hpp"
#include "odeum/core/guarded.hpp"
#include "odeum/methods/bogacki_shampine32.hpp"
#include "odeum/methods/dormand_prince54.hpp"
#include "odeum/solvers/own_methods.hpp"
#include "support/catalogue.hpp"

namespace odeum::tests::output_between_test {
namespace {

std::vector<double> evenly(std::size_t count, double end) {
  std::vector<double> stops;
  for (std::size_t k = 1; k <= count; ++k)
    stops.push_back(end * static_cast<double>(k) / static_cast<double>(count));
  return stops;
}

Request dense_request(double tolerance, std::vector<double> stops) {
  Request request = adaptive_request(tolerance, std::move(stops));
  request.over_stops = request.record_steps = true;
  return request;
}

std::vector<std::string> adaptive_methods() {
  std::vector<std::string> ids;
  // Methods on residuals fit no built-in case: tests/formula/residual_methods_test.cpp.
  for (const Solver& method : own_methods())
    if (method.info.adaptive && !method.info.needs.starts_with("residuals"))
      ids.push_back(method.info.id());
  return ids;
}

struct Task {
  const Case& c;
  double end;
};

// Each method on the first of these that it fits: the last three are for Taylor's method, for
// additive ones, and for one that needs damping apart from the other forces.
Task task_of(const std::string& id) {
  for (const char* name : {"damped_oscillator_underdamped", "damped_oscillator_undamped",
                           "lotka_volterra", "brusselator2"})
    if (find_entrant(find_case(name), id).unfit.empty()) return {find_case(name), 5};
  return {find_case("cloth11_two_way"), 0.1};
}

// The exact states, one after the other; where the truth is not known at all times, a run whose
// steps end on them, a thousand times more accurate than those that are compared.
std::vector<double> exact_states(const Case& c, const std::vector<double>& times) {
  std::vector<double> states(c.y0.size() * times.size());
  bool known = true;
  for (std::size_t k = 0; k < times.size(); ++k)
    known = known && c.truth.at(times[k], states.data() + k * c.y0.size());
  if (known) return states;
  return find_entrant(c, "odeum/verner98").solve(adaptive_request(1e-12, times)).states;
}

double largest_error(const Case& c, const std::vector<double>& times, const Outcome& outcome) {
  const std::vector<double> exact = exact_states(c, times);
  double largest = 0;
  for (std::size_t i = 0; i < exact.size(); ++i)
    largest = std::fmax(largest, std::abs(outcome.states.at(i) - exact[i]));
  return largest;
}

class OutputBetween : public testing::TestWithParam<std::string> {};

TEST_P(OutputBetween, ChangesNoStep) {
  const auto [c, end] = task_of(GetParam());
  const Entrant& entrant = find_entrant(c, GetParam());
  const Outcome sparse = entrant.solve(dense_request(1e-4, {end}));
  ASSERT_EQ(sparse.status, Status::ok) << sparse.detail;
  if (GetParam() != "odeum/exponential_propagator") {  // it has no steps
    EXPECT_EQ(sparse.step_ends.size(), sparse.counters.steps);
  }
  for (const std::size_t count : {10U, 1000U}) {
    const Outcome dense = entrant.solve(dense_request(1e-4, evenly(count, end)));
    ASSERT_EQ(dense.status, Status::ok) << dense.detail;
    EXPECT_EQ(dense.counters.steps, sparse.counters.steps);
    EXPECT_EQ(dense.counters.rejected_steps, sparse.counters.rejected_steps);
    EXPECT_EQ(dense.step_ends, sparse.step_ends);
    const std::size_t n = c.y0.size();
    for (std::size_t i = 0; i < n; ++i)
      EXPECT_EQ(state_at(dense, count - 1, n)[i], state_at(sparse, 0, n)[i]);
  }
}

// The errors inside the steps are no larger than at their ends, at a loose and at a tight
// tolerance, but for a factor of 2: an interpolant's error is of the order of the method's own and
// may be added.
TEST_P(OutputBetween, IsAsAccurateAsTheEndsOfTheSteps) {
  const auto [c, end] = task_of(GetParam());
  const Entrant& entrant = find_entrant(c, GetParam());
  for (const double tolerance : {1e-3, 1e-5, 1e-7}) {
    const std::vector<double> stops = evenly(997, end);
    const Outcome dense = entrant.solve(dense_request(tolerance, stops));
    ASSERT_EQ(dense.status, Status::ok) << dense.detail;
    std::vector<double> ends = dense.step_ends;
    if (ends.empty()) ends = {end};
    const Outcome at_ends = entrant.solve(dense_request(tolerance, ends));
    const double at_steps = largest_error(c, ends, at_ends);
    EXPECT_LE(largest_error(c, stops, dense), 2 * at_steps + 1e-13) << "tolerance " << tolerance;
    if (entrant.info.order <= 2 || std::isnan(entrant.info.order)) break;  // millions of steps
  }
}

// Pairs of a method, a case and a tolerance, each run without outputs and with some: Newton's
// iteration of a step aside may fail where that of the step itself did not.
TEST(OutputBetween, ChangesNoEndOfRandomRuns) {
  const std::vector<std::string> methods = adaptive_methods();
  constexpr std::array cases{
      "lotka_volterra", "brusselator2", "robertson_40",         "hires",
      "vdp_mu1",        "vdp_eps1e_6",  "henon_heiles_regular", "pendulum_large"};
  std::uint32_t state = 29;
  const auto random = [&](std::size_t below) {
    state = state * 1664525U + 1013904223U;
    return (state >> 8) % below;
  };
  int compared = 0;
  for (int k = 0; k < 600; ++k) {
    const Case& c = find_case(cases.at(random(cases.size())));
    const std::string& id = methods[random(methods.size())];
    const double tolerance = std::pow(10, -1 - static_cast<double>(random(60)) / 10);
    const std::vector<double> stops = evenly(1 + random(40), c.stops.back());
    const Entrant& entrant = find_entrant(c, id);
    if (!entrant.unfit.empty()) continue;
    Request request = dense_request(tolerance, {stops.back()});
    request.budget.evaluations = 5000;  // what does not suit the case is left out
    const Outcome sparse = entrant.solve(request);
    if (sparse.status != Status::ok) continue;
    const Outcome dense = entrant.solve(dense_request(tolerance, stops));
    const std::string what = c.id + " by " + id + " to " + std::to_string(tolerance);
    ASSERT_EQ(dense.status, Status::ok) << what << ": " << dense.detail;
    EXPECT_EQ(dense.detail, sparse.detail) << what;
    EXPECT_EQ(dense.step_ends, sparse.step_ends) << what;
    const std::size_t n = c.y0.size();
    for (std::size_t i = 0; i < n; ++i)
      EXPECT_EQ(state_at(dense, stops.size() - 1, n)[i], sparse.states[i]) << what;
    ++compared;
  }
  EXPECT_GT(compared, 300);
}

struct Clock {
  static constexpr std::size_t dimension = 1;
  void rhs(double, const double*, double* f) const { f[0] = 1; }
};

// Where no step aside succeeds the run goes on, with a remark.
struct NoOutput {
  Decision operator()(double, double h, const std::array<double, 1>& y,
                      std::array<double, 1>& y_new) const {
    y_new[0] = y[0] + h;
    return {true, h};
  }
  Status between(const StepMade<std::array<double, 1>>& made, double time,
                 std::array<double, 1>& y) const {
    return step_aside(made, time, y, [](double, double, std::array<double, 1>&) { return false; });
  }
};
TEST(OutputBetween, AFailureIsARemark) {
  Guard guard(1, {});
  const Clock clock;
  const Guarded<Clock> problem(clock, guard);
  const Outcome outcome = run_adaptive(problem, 0, std::array<double, 1>{0},
                                       dense_request(1e-3, {0.25, 1}), 0.5, NoOutput());
  EXPECT_EQ(outcome.status, Status::ok);
  EXPECT_NE(outcome.detail.find("t = 0.25 is interpolated"), std::string::npos) << outcome.detail;
  EXPECT_EQ(outcome.states, (std::vector<double>{0.25, 1}));
}

// Steps aside go to the nodes of a step, not to each output.
TEST(OutputBetween, CostOfExtrapolationDoesNotGrowWithTheOutputs) {
  for (const char* id : {"odeum/gragg_bulirsch_stoer", "odeum/seulex"}) {
    const Case& c = find_case("damped_oscillator_underdamped");
    const auto evaluations = [&](std::size_t count) {
      const Outcome run = find_entrant(c, id).solve(dense_request(1e-7, evenly(count, 5)));
      EXPECT_EQ(run.status, Status::ok) << id;
      return static_cast<double>(run.counters.rhs_evaluations);
    };
    // The first steps are so short that a thousand outputs leave some without one.
    EXPECT_LE(evaluations(4000), 1.05 * evaluations(1000)) << id;
  }
}

INSTANTIATE_TEST_SUITE_P(Adaptive, OutputBetween, testing::ValuesIn(adaptive_methods()),
                         [](const auto& test) {
                           return test.param.substr(test.param.find('/') + 1);
                         });

/// Accepts every step and keeps its length.
struct KeepStep {
  [[maybe_unused]] static constexpr const char* name = "none";
  explicit KeepStep(int) {}
  Decision operator()(double h, double) const { return {true, h}; }
};

/// y' = -y^2 t, y = 2 / (2 + t^2) from y(0) = 1.
struct Bell {
  static constexpr std::size_t dimension = 1;
  void rhs(double t, const double* y, double* dydt) const { dydt[0] = -y[0] * y[0] * t; }
};

// The largest error inside the first step of length h, at nine places.
template <class M>
double error_inside(double h) {
  const Bell bell;
  Guard guard(1, {});
  const Guarded<Bell> problem(bell, guard);
  using Stepper = typename M::template Stepper<Guarded<Bell>>;
  EmbeddedPair<Stepper, KeepStep, Guarded<Bell>, M> trial(problem, 1e-6, 1);
  const double t = 0.5;
  const std::array<double, 1> before{2 / (2 + t * t)};
  std::array<double, 1> after{}, y{};
  trial(t, h, before, after);
  double largest = 0;
  for (int k = 1; k < 10; ++k) {
    const double time = t + h * k / 10;
    trial.between({t, h, before, after}, time, y);
    largest = std::fmax(largest, std::abs(y[0] - 2 / (2 + time * time)));
  }
  return largest;
}

template <class M>
double order_inside() {
  return std::log2(error_inside<M>(0.1) / error_inside<M>(0.05));
}

// The local error inside a step falls as h^4 (Hermite's cubic), h^5 (a row of order 4): a power of
// h below the method's own local error, which makes the same order over a whole run. To a quarter:
// the next term is h = 0.1 times smaller.
TEST(OutputBetween, HasTheLocalOrderOfTheInterpolant) {
  EXPECT_NEAR(order_inside<methods::bogacki_shampine32>(), 4, 0.25);
  EXPECT_NEAR(order_inside<methods::dormand_prince54>(), 5, 0.25);
}

}  // namespace
}  // namespace odeum::tests::output_between_test
