// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/reduction/reduction.hpp"

#include <fmt/format.h>

#include <cmath>

#include "odeum/cases/set_problem.hpp"
#include "odeum/core/glob.hpp"

namespace odeum::study {
namespace {

constexpr int decades = 8;
constexpr double horizon = reduction_end;

/// y' = lambda (y - cos t) - sin t.
struct ProtheroRobinson {
  static constexpr std::size_t dimension = 1;
  double lambda = -1;

  void rhs(double t, const double* y, double* f) const {
    f[0] = lambda * (y[0] - std::cos(t)) - std::sin(t);
  }
  void jacobian(double, const double*, double* j) const { j[0] = lambda; }
  void time_derivative(double t, const double*, double* d) const {
    d[0] = lambda * std::sin(t) - std::cos(t);
  }
};

Entrants entrants_at(double lambda) {
  Contest<ProtheroRobinson> contest;
  contest.problem = std::make_shared<const ProtheroRobinson>(ProtheroRobinson{lambda});
  contest.y0 = std::make_shared<const std::vector<double>>(1, 1.0);
  return cases::enroll(erase(contest));
}

ReductionRow measure(const Entrant& entrant, double lambda) {
  auto row = named_row<ReductionRow>(entrant.info);
  row.lambda = lambda;
  row.claimed_order = entrant.info.order;
  const std::string reason = !entrant.unfit.empty() ? entrant.unfit
                             : entrant.info.fixed   ? ""
                                                    : "chooses its own steps only";
  if (!reason.empty()) {
    row.fit.verdict = judge::Verdict::not_applicable;
    row.fit.reason = reason;
    return row;
  }
  std::vector<judge::ErrorPoint> points;
  std::string last_failure;
  for (std::uint64_t steps = reduction_fewest; steps <= reduction_most; steps *= 2) {
    if (interrupted) throw Interrupted();
    Request request;
    request.steps = steps;
    request.stops = {horizon};
    request.budget.evaluations = 1'000 * steps;
    const Outcome outcome = entrant.solve(request);
    const bool solved = outcome.status == Status::ok;
    if (!solved) last_failure = std::string(to_string(outcome.status)) + ", " + outcome.detail;
    points.push_back({.step = horizon / static_cast<double>(steps),
                      .error = solved ? std::abs(outcome.states.back() - std::cos(horizon)) : nan,
                      .steps = static_cast<double>(steps),
                      .rounding_unit = std::numeric_limits<double>::epsilon() / 2,
                      .scale = 1});
  }
  row.fit =
      judge::fit_order(points, row.claimed_order, judge::fixed_step_tolerance(row.claimed_order));
  row.error_finest = points.back().error;
  if (row.fit.verdict != judge::Verdict::confirmed && !last_failure.empty())
    row.fit.reason += "; " + last_failure;
  return row;
}

}  // namespace

ReductionResult measure_reduction(const Options& options, const Runner& runner) {
  struct Task {
    double lambda;
    Entrant entrant;
  };
  std::vector<Entrants> stages;
  for (int k = 0; k <= decades; ++k) stages.push_back(entrants_at(-std::pow(10.0, k)));
  std::vector<Task> tasks;  // by solver, then by stiffness
  for (std::size_t i = 0; i < stages.front().size(); ++i)
    if (any_glob_matches(options.solvers, stages.front().info(i).id()))
      for (int k = 0; k <= decades; ++k) tasks.push_back({-std::pow(10.0, k), stages[k][i]});
  return runner.run(
      "reduction", tasks,
      [](const Task& task) { return fmt::format("{} {}", task.entrant.info.id(), task.lambda); },
      [](const Task& task) { return ReductionResult{{measure(task.entrant, task.lambda)}}; });
}

}  // namespace odeum::study
