// SPDX-License-Identifier: BSD-3-Clause
#include "support/report_fixture.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <random>

namespace odeum::test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct Family {
  const char *library, *prefix, *family;
  std::vector<double> orders;
  bool fixed, adaptive;
};

const std::vector<Family>& families() {
  static const std::vector<Family> list{
      {"odeum", "explicit_method", "explicit_rk", {1, 2, 2, 4, 5, 4, 3, 2, 1}, true, true},
      {"odeum", "implicit_method", "implicit_rk", {1, 1, 1}, true, true},
      {"odeum", "symplectic_method", "symplectic", {1, 1, 2, 2, 2}, true, false},
      {"cvode", "variable_order", "multistep", {nan, nan}, false, true},
      {"cvode", "held", "multistep", {1, 2, 3, 5, 1, 2, 3, 4, 5}, true, false},
      {"arkode",
       "erkstep_long_name_of_a_table",
       "explicit_rk",
       {2, 2, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 5, 6, 6, 8},
       true,
       true},
      {"arkode",
       "arkstep_long_name_of_a_table",
       "explicit_rk",
       {2, 2, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 5, 6, 6, 8},
       true,
       true},
      {"arkode",
       "arkstep_implicit_table",
       "implicit_rk",
       {1, 2, 2, 2, 3, 3, 3, 3, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 5, 5, 5, 5},
       true,
       true},
      {"gsl", "stepper", "explicit_rk", {2, 4, 4, 5, 8}, true, true},
      {"gsl", "stepper_implicit", "implicit_rk", {1, 2, 4, nan}, true, true},
      {"gsl", "stepper_multistep", "multistep", {nan, nan}, false, true},
      {"odeint", "stepper", "explicit_rk", {1, 2, 4, 4, 5, 5, 5, 7, 8}, true, true},
      {"odeint", "adams_bashforth", "multistep", {1, 2, 3, 4, 5, 6, 7, 8}, true, false},
      {"odeint", "adams_bashforth_moulton", "multistep", {1, 2, 3, 4, 5, 6, 7, 8}, true, false},
      {"odeint", "extrapolation", "extrapolation", {4, 6, 8, nan, nan}, true, true},
      {"odeint", "rosenbrock", "linearly_implicit", {4, 1}, true, true},
      {"odeint", "symplectic", "symplectic", {1, 3, 5, 2}, true, false},
      {"bullet", "body", "physics_engine", {1, 1, 1, 1, 1, 1}, true, false}};
  return list;
}

constexpr const char* case_ids[] = {"cloth11_two_way",
                                    "cloth11_tension_only",
                                    "cloth11_two_way_k1e3",
                                    "damped_oscillator_undamped",
                                    "damped_oscillator_underdamped",
                                    "damped_oscillator_critical",
                                    "damped_oscillator_overdamped",
                                    "damped_oscillator_rest_length",
                                    "dahlquist_real",
                                    "dahlquist_complex",
                                    "dahlquist_imaginary",
                                    "free_fall",
                                    "lotka_volterra",
                                    "rc_circuit",
                                    "pendulum"};

/// Errors of one solver on one case as a function of the step.
struct Behaviour {
  double order, constant, floor;
  bool fails;
  double error(double h, std::mt19937& random) const {
    const double ripple = 1 + 0.02 * std::uniform_real_distribution<double>(-1, 1)(random);
    return constant * std::pow(h, order) * ripple + floor + 2e-16 * 10 / h;
  }
};

Behaviour behaviour_of(double claimed, std::mt19937& random) {
  const double p = std::isnan(claimed) ? 4 : claimed;
  Behaviour behaviour{p, std::pow(10, std::uniform_real_distribution<double>(-2, 0.5)(random)), 0,
                      false};
  const int lot = std::uniform_int_distribution<int>(0, 99)(random);
  if (lot < 4) behaviour.order = std::max(0.5, p - 1);
  if (lot >= 4 && lot < 6) behaviour.order = p + 1;
  if (lot >= 6 && lot < 9) behaviour.floor = 1e-5;
  behaviour.fails = lot >= 97;
  return behaviour;
}

void add_not_applicable(MadeUp& data, const std::string& c, const SolverInfo& solver, Mode mode) {
  const std::string reason = "needs a second-order problem q'' = a(t, q, v)";
  study::ConvergenceRow row;
  row.case_id = c;
  row.library = solver.library;
  row.solver = solver.method;
  row.mode = mode;
  row.status = "not_applicable";
  row.detail = reason;
  data.convergence.rows.push_back(row);
  study::OrderRow order{c, solver.library, solver.method, mode, solver.order, {}};
  order.fit.verdict = judge::Verdict::not_applicable;
  order.fit.reason = reason;
  data.convergence.orders.push_back(order);
}

void add_pair(MadeUp& data, const report::CaseFacts& c, const SolverInfo& solver, Mode mode,
              std::mt19937& random) {
  const Behaviour behaviour = behaviour_of(solver.order, random);
  std::vector<judge::ErrorPoint> points;
  for (int k = 0; k < 11; ++k) {
    const double h = 0.25 * std::pow(2.0, -k);
    const double error = behaviour.fails && k > 1 ? nan : behaviour.error(h, random);
    study::ConvergenceRow row;
    row.case_id = c.id;
    row.library = solver.library;
    row.solver = solver.method;
    row.mode = mode;
    row.status = std::isnan(error) ? "newton_failed" : "ok";
    row.detail = std::isnan(error) ? "newton_failed at t = 0.5" : "";
    row.step = h;
    row.setting = mode == Mode::adaptive ? std::pow(10, -3 - k) : row.step;
    row.steps = static_cast<std::uint64_t>(10 / h);
    row.error = error;
    row.error_rms = row.energy_error = error / 3;
    row.counters.steps = row.steps;
    row.counters.rhs_evaluations =
        row.steps * static_cast<std::uint64_t>(std::isnan(solver.order) ? 2 : solver.order);
    data.convergence.rows.push_back(row);
    points.push_back({.step = h, .error = error, .steps = 10 / h, .rounding_unit = 4e-16});
    if (c.id.starts_with("cloth"))
      for (const double t : {0.25, 0.5, 1.0, 2.0})
        data.convergence.times.push_back({c.id, solver.library, solver.method, mode, h, t,
                                          error * t, error * t / 3, 1.0, error * t * t / 5});
  }
  study::OrderRow order{c.id, solver.library, solver.method, mode, solver.order, {}};
  order.fit = judge::fit_order(points, solver.order,
                               mode == Mode::fixed ? judge::fixed_step_tolerance(solver.order)
                                                   : judge::adaptive_tolerance(solver.order));
  data.convergence.orders.push_back(order);
}

// |R(z)| of the Taylor polynomial of a degree; of backward Euler for degree 0.
double growth(int degree, std::complex<double> z) {
  if (degree == 0) return 1 / std::abs(1.0 - z);
  std::complex<double> sum = 1, term = 1;
  for (int k = 1; k <= degree; ++k) sum += term *= z / static_cast<double>(k);
  return std::abs(sum);
}

void add_stability(MadeUp& data, const SolverInfo& solver) {
  const bool implicit = solver.family == "implicit_rk";
  const int degree = implicit ? 0 : std::clamp(static_cast<int>(solver.order), 1, 6);
  const auto limit = [&](const char* axis, double measured, double theory) {
    data.stability.limits.push_back(
        {solver.library, solver.method, axis, measured, theory, measured - theory, "ok", ""});
  };
  const double infinity = std::numeric_limits<double>::infinity();
  limit("real", implicit ? infinity : 2.785293563405282, nan);
  limit("imaginary", 2.8284271, 2.8284271247461903);
  data.stability.limits.push_back({solver.library, solver.method, "oscillator", nan, nan, nan,
                                   "not_applicable", "needs a second-order problem"});
  const bool plane = solver.family != "symplectic" && solver.family != "physics_engine";
  study::StabilityRegion region{solver.library,
                                solver.method,
                                plane ? "lambda" : "oscillator",
                                "ok",
                                "",
                                81,
                                101,
                                -6,
                                2,
                                -5,
                                5,
                                {}};
  if (!plane) {
    region.first_low = region.second_low = 0;
    region.first_high = 4;
    region.second_high = 2;
  }
  for (int j = 0; j < region.rows; ++j)
    for (int i = 0; i < region.columns; ++i) {
      const double x = region.first_low + (region.first_high - region.first_low) * i / 80;
      const double y = region.second_low + (region.second_high - region.second_low) * j / 100;
      const double g = plane ? growth(degree, {x, y}) : x < 2 ? std::exp(-x * y) : x * x / 4 + y;
      region.growth.push_back(x > 1.5 && y > 4 ? std::numeric_limits<float>::quiet_NaN()
                                               : static_cast<float>(g));
    }
  data.stability.regions.push_back(region);
}

MadeUp fabricate(std::size_t cases, std::size_t solvers_at_most) {
  MadeUp data;
  for (std::size_t i = 0; i < cases; ++i) {
    report::CaseFacts c{.id = case_ids[i],
                        .title = "Made-up case",
                        .equation = "y' = f(t, y)",
                        .source = "this test",
                        .truth = "closed form",
                        .unit = {},
                        .truth_floor = 0,
                        .timed_floor = 0,
                        .timed_end = 10,
                        .scale = 1,
                        .tags = {}};
    if (c.id.starts_with("cloth")) {
      c.tags = {"cloth", "mechanical"};
      c.truth_floor = 1e-12;
    }
    data.facts.cases.push_back(c);
  }
  for (const Family& family : families()) {
    int number = 0;
    for (const double order : family.orders) {
      if (data.facts.solvers.size() == solvers_at_most) break;
      SolverInfo solver;
      solver.library = family.library;
      solver.method = family.prefix + std::string("_") + std::to_string(++number);
      solver.family = family.family;
      solver.order = order;
      solver.fixed = family.fixed;
      solver.adaptive = family.adaptive;
      data.facts.solvers.push_back(solver);
    }
  }
  std::mt19937 random(1);
  for (const report::CaseFacts& c : data.facts.cases)
    for (const SolverInfo& solver : data.facts.solvers)
      for (const Mode mode : {Mode::fixed, Mode::adaptive}) {
        if (!(mode == Mode::fixed ? solver.fixed : solver.adaptive)) continue;
        const bool mechanical = solver.family == "symplectic" || solver.family == "physics_engine";
        if (mechanical && c.id.starts_with("dahlquist"))
          add_not_applicable(data, c.id, solver, mode);
        else
          add_pair(data, c, solver, mode, random);
      }
  for (const SolverInfo& solver : data.facts.solvers)
    if (solver.fixed) add_stability(data, solver);
  data.facts.libraries = {{"sundials", {"cvode", "arkode"}, "ODEUM_WITH_SUNDIALS", true, "6.4.1"},
                          {"gsl", {"gsl"}, "ODEUM_WITH_GSL", true, "2.7.1"},
                          {"odeint", {"odeint"}, "ODEUM_WITH_ODEINT", true, "1.74"},
                          {"bullet", {"bullet"}, "ODEUM_WITH_BULLET", false, ""}};
  return data;
}

}  // namespace

MadeUp fabricate_report() { return fabricate(std::size(case_ids), 1000); }
MadeUp fabricate_small_report() { return fabricate(2, 3); }

bool has(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

}  // namespace odeum::test
