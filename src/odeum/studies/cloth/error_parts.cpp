// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <map>

#include "odeum/cases/catalogue.hpp"
#include "odeum/studies/cloth/cloth.hpp"

namespace odeum::study {
namespace {

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  return rms_distance(a, b, a.size() / 3);
}

/// The limit h -> 0 of a scheme of order p from two runs, the second at half the step.
std::vector<double> extrapolate(const std::vector<double>& coarse, const std::vector<double>& fine,
                                double order) {
  std::vector<double> limit;
  const double weight = 1 / (std::exp2(order) - 1);
  for (std::size_t i = 0; i < fine.size(); ++i)
    limit.push_back(fine[i] + weight * (fine[i] - coarse[i]));
  return limit;
}

}  // namespace

std::vector<ErrorPartsRow> split_error(const SplitPlan& plan, const RunCloth& run,
                                       const std::vector<double>& truth) {
  std::map<std::uint64_t, Reached> converged;
  for (const std::uint64_t steps : plan.steps) converged[steps] = run(steps, plan.converged);
  std::optional<std::vector<double>> limit;
  double step_left = nan;
  std::string no_limit;
  const std::size_t n = plan.steps.size();
  const Reached &a = converged[plan.steps[n - 3]], &b = converged[plan.steps[n - 2]],
                &c = converged[plan.steps[n - 1]];
  if (a.positions && b.positions && c.positions) {
    limit = extrapolate(*b.positions, *c.positions, plan.order);
    step_left = distance(*limit, extrapolate(*a.positions, *b.positions, plan.order));
  } else {
    no_limit = "no limit h -> 0: " + (c.positions ? b.positions ? a.reason : b.reason : c.reason);
  }
  std::vector<ErrorPartsRow> rows;
  for (const std::uint64_t steps : plan.steps) {
    const Reached& at = converged[steps];
    const bool iterates = plan.converged.sweeps + plan.converged.newton > 0;
    const Reached half = iterates ? run(steps, plan.half) : at;
    for (const Iterations& iterations : plan.tried) {
      ErrorPartsRow& row = rows.emplace_back(plan.blank);
      row.time = plan.time;
      row.step = plan.time / static_cast<double>(steps);
      row.sweeps = iterations.sweeps;
      row.newton = iterations.newton;
      row.step_left = step_left;
      const Reached tried = iterates ? run(steps, iterations) : at;
      row.status = tried.positions ? "ok" : "unstable";
      row.detail = tried.positions ? no_limit : tried.reason;
      if (tried.positions) row.total = distance(*tried.positions, truth);
      if (tried.positions && at.positions)
        row.iteration = distance(*tried.positions, *at.positions);
      if (at.positions && half.positions)
        row.iteration_left = distance(*at.positions, *half.positions);
      if (limit && at.positions) row.time_step = distance(*at.positions, *limit);
      if (limit) row.model = distance(*limit, truth);
    }
  }
  return rows;
}

ClothResult measure_error_parts(const Options& options, const Runner& runner) {
  const Case& cloth = known_case("cloth11_two_way");
  const std::size_t n = cloth.y0.size(), positions = n / 2;
  SplitPlan plan;
  plan.steps = {20, 40, 80, 160, 320, 640};
  std::vector<double> truth(n);
  if (!cloth.truth.at(plan.time, truth.data())) return {};
  truth.resize(positions);
  struct Task {
    const Entrant* entrant;
    SplitPlan plan;
  };
  std::vector<Task> tasks;
  for (const Entrant& entrant : cloth.entrants) {
    const SolverInfo& info = entrant.info;
    if (!is_compared(info, options)) continue;
    plan.blank = named_row<ErrorPartsRow>(info);
    plan.order = std::isfinite(info.order) ? info.order : 1;
    plan.tried = {{}};
    plan.converged = plan.half = {};
    if (info.options.contains("newton")) {  // the default of sweeps is converged, see the adapter
      plan.tried = {{.sweeps = 1}, {.sweeps = 2}, {.sweeps = 4}, {.sweeps = 8}, {}};
      plan.converged = {.newton = 4}, plan.half = {.newton = 2};
    } else if (info.options.contains("sweeps")) {
      plan.tried = {
          {}, {.sweeps = 2}, {.sweeps = 4}, {.sweeps = 8}, {.sweeps = 16}, {.sweeps = 32}};
      plan.converged = {.sweeps = 64}, plan.half = {.sweeps = 32};
    }
    tasks.push_back({&entrant, plan});
  }
  const auto key = [](const Task& task) { return task.entrant->info.id(); };
  return runner.run("error parts", tasks, key, [&](const Task& task) {
    const auto run = [&](std::uint64_t steps, const Iterations& iterations) -> Reached {
      if (interrupted) throw Interrupted();
      Request request;
      request.steps = steps;
      request.stops = {task.plan.time};
      iterations.ask(request);
      request.budget.evaluations = 10'000 * steps;
      Outcome outcome = task.entrant->solve(request);
      if (outcome.status != Status::ok) return {{}, outcome.detail};
      outcome.states.resize(positions);
      return {std::move(outcome.states), {}};
    };
    if (!task.entrant->unfit.empty())
      return ClothResult{.errors = {not_applicable(task.plan.blank, task.entrant->unfit)}};
    return ClothResult{.errors = split_error(task.plan, run, truth)};
  });
}

}  // namespace odeum::study
