// SPDX-License-Identifier: BSD-3-Clause
// Runs to a tolerance by Dormand and Prince's pair, with faults in the pair and in its controller.
#include <algorithm>
#include <cmath>

#include "accuracy/tableau_steps.hpp"
#include "accuracy/wrong_solvers.hpp"

namespace odeum::tests {
namespace {

struct Controlled {
  Tableau pair = dormand_prince5();
  double exponent = 0.2, past = 0;  ///< of the error, and of that of the step before
  double safety = 0.9, grows = 5;
  bool rejects = true, propagates_lower = false;
  double mix = 0;  ///< of Kutta's method of order 3
};

double norm(const Vector& error, const Vector& a, const Vector& b, const Tolerance& tolerance) {
  double squares = 0;
  for (std::size_t i = 0; i < error.size(); ++i) {
    const double unit = tolerance.relative * (1 + std::max(std::abs(a[i]), std::abs(b[i])));
    squares += error[i] / unit * (error[i] / unit);
  }
  return std::max(std::sqrt(squares / static_cast<double>(error.size())), 1e-10);
}

Outcome run(const Controlled& how, const Case& c, const Request& request) {
  const OdeView& problem = c.problem.view;
  Vector y = c.y0, next, error(y.size()), last(y.size());
  double t = c.t0, h = 0.01 * (request.stops.back() - c.t0), before = 1;
  Outcome outcome;
  for (std::size_t stop = 0; stop < request.stops.size();) {
    const double left = request.stops[stop] - t;
    const bool ends = h >= left;
    const double taken = ends ? left : h;
    next = y;
    const auto k = take_step(problem, how.pair, t, taken, next);
    problem.rhs(problem.problem, t + taken, next.data(), last.data());
    for (std::size_t i = 0; i < y.size(); ++i) {
      double sum = -how.pair.embedded.back() * last[i];
      for (std::size_t s = 0; s < k.size(); ++s)
        sum += (how.pair.b[s] - how.pair.embedded[s]) * k[s][i];
      error[i] = taken * sum;
    }
    const double size = norm(error, y, next, request.tolerance);
    const double factor = how.safety * std::pow(size, -how.exponent) * std::pow(before, how.past);
    if (how.rejects && !(size <= 1)) {
      h = taken * std::clamp(factor, 0.1, 0.9);
      ++outcome.counters.rejected_steps;
      outcome.counters.work += k.size();
      if (h < 1e-14 * std::abs(t + h)) return outcome.status = Status::step_too_small, outcome;
      continue;
    }
    if (how.propagates_lower)
      for (std::size_t i = 0; i < y.size(); ++i) next[i] -= error[i];
    if (how.mix > 0) {
      Vector low = y;
      take_step(problem, kutta3(), t, taken, low);
      for (std::size_t i = 0; i < y.size(); ++i) next[i] += how.mix * (low[i] - next[i]);
    }
    y = next;
    before = size;
    t = ends ? request.stops[stop] : t + taken;
    if (!ends || factor < 1) h = taken * std::clamp(factor, 0.2, how.grows);
    outcome.counters.work += k.size();
    outcome.counters.rhs_evaluations = outcome.counters.work;
    ++outcome.counters.steps;
    if (ends) outcome.record(request.stops[stop++], y.data(), y.size());
    if (outcome.counters.work > request.budget.evaluations)
      return outcome.status = Status::over_budget, outcome;
  }
  for (const double x : outcome.states)
    if (!std::isfinite(x)) outcome.status = Status::non_finite;
  return outcome;
}

Run with(const Controlled& how) {
  return [how](const Case& c, const Request& request) { return run(how, c, request); };
}

WrongSolver to_tolerance(const std::string& name, double claimed, const Controlled& how,
                         const Controlled& right) {
  WrongSolver solver{"to a tolerance: DOPRI5, " + name, claimed, {}, {}};
  solver.wrong_run = with(how);
  solver.right_run = with(right);
  return solver;
}

}  // namespace

std::vector<WrongSolver> right_adaptive() {
  std::vector<WrongSolver> solvers;
  const auto add = [&](const std::string& name, double order, const Controlled& how) {
    solvers.push_back(to_tolerance(name, order, how, how));
  };
  add("the usual controller", 5, {});
  add("PI controller", 5, {.exponent = 0.14, .past = 0.08});
  add("safety 0.8, growth 2", 5, {.safety = 0.8, .grows = 2});
  add("order 4 carried on", 4, {.propagates_lower = true});
  return solvers;
}

std::vector<WrongSolver> wrong_adaptive() {
  std::vector<WrongSolver> solvers;
  const auto changed = [&](const std::string& fault, auto&& change) {
    Controlled how;
    change(how);
    solvers.push_back(to_tolerance(fault, 5, how, {}));
  };
  changed("order 4 carried on, claims 5", [](Controlled& d) { d.propagates_lower = true; });
  changed("0.1 of Kutta 3 mixed in", [](Controlled& d) { d.mix = 0.1; });
  changed("1e-3 of Kutta 3 mixed in", [](Controlled& d) { d.mix = 1e-3; });
  changed("b3 off by 1e-3", [](Controlled& d) { d.pair.b[2] += 1e-3; });
  changed("b3 off by 1e-4, sum kept",
          [](Controlled& d) { d.pair.b[2] += 1e-4, d.pair.b[0] -= 1e-4; });
  changed("a32 off by 1e-2", [](Controlled& d) { d.pair.a[2][1] += 1e-2; });
  changed("a54 of the other sign", [](Controlled& d) { d.pair.a[4][3] = -d.pair.a[4][3]; });
  changed("nodes are zero", [](Controlled& d) { d.pair.c.assign(6, 0); });
  changed("rejects nothing", [](Controlled& d) { d.rejects = false; });
  changed("exponent 1", [](Controlled& d) { d.exponent = 1; });
  changed("embedded weights off by 0.01", [](Controlled& d) { d.pair.embedded[3] += 0.01; });
  return solvers;
}

}  // namespace odeum::tests
