// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "odeum/core/numbers.hpp"
#include "odeum/core/parallel.hpp"
#include "odeum/studies/precision/timing.hpp"

namespace odeum::study {
namespace {

/// The search for settings of one solver, by the errors of its guarded runs.
class Settings {
 public:
  Settings(const TimedCase& stage, TimedSolver& solver)
      : stage_(stage),
        solver_(solver),
        search_{.grid = {solver.mode, stage.c.settings.steps_multiple, true},
                .close = 1 / 1.3,
                .coarser_least = 0.5,
                .coarser_most = 0.5} {
    for (const TimedRun& trial : solver.trials)
      if (!std::isnan(trial.row.setting)) keep(trial);
  }

  /// The coarsest setting that reaches the error with most of it, or where luck has a part in that
  /// a finer one. The run found joins the trials.
  void settle(double error) {
    constexpr int most_between = 5, most_finer = 5;
    measure::SettingSearch::Bracket found = search_.bracket(error);
    if (found.reaches < 0) return;
    // The settings of the study begin where all methods do something: some do with fewer steps.
    for (int between = 0; between < most_between; between += found.misses >= 0) {
      const double fineness = search_.next(error);
      if (fineness == 0) break;
      error_at(fineness);
      found = search_.bracket(error);
    }
    double fine = search_.tried[static_cast<std::size_t>(found.reaches)].fineness;
    const double factor = solver_.mode == Mode::fixed ? 1.15 : 2;
    for (int k = 0; k < most_finer; ++k, fine = search_.grid.on_grid(fine * factor)) {
      if (!(error_at(fine) <= error)) continue;
      const double near = near_error(fine);
      if (keeps_error(error_at(fine), near, error)) return accept(fine, near);
    }
  }

  /// Runs the neighbours of a trial.
  void check(TimedRun& trial) { trial.row.near_error = near_error(fineness_of(trial.request)); }

 private:
  void keep(const TimedRun& run) {
    search_.tried.push_back({.fineness = fineness_of(run.request),
                             .status = run.status,
                             .error = run.row.error,
                             .ns = run.guarded_ns});
  }

  /// Infinite where the run failed.
  double error_at(double fineness) {
    if (!search_.at(fineness)) {
      Request request = solver_.trials.front().request;
      if (request.mode == Mode::fixed)
        request.steps = static_cast<std::uint64_t>(fineness);
      else
        set_tolerance(request, stage_.c, of_two_digits(1 / fineness));
      TimedRun run = run_guarded(stage_, *solver_.entrant, request);
      keep(run);
      runs_.push_back(std::move(run));
    }
    const double error = search_.at(fineness)->error;
    return std::isnan(error) ? infinity : error;
  }

  /// A resonance is narrow: with 2 % fewer steps a pendulum has sixty times the error.
  double near_error(double fineness) {
    const measure::SettingGrid& grid = search_.grid;
    const bool fixed = solver_.mode == Mode::fixed;
    double largest = 0;
    for (const double apart : fixed ? std::array{1.02, 1.05} : std::array{1.1, 1.25}) {
      const double finer =
          fixed ? std::max(grid.on_grid(apart * fineness), grid.on_grid(fineness + 0.5))
                : grid.on_grid(apart * fineness);
      const double coarser = fixed ? 2 * fineness - finer : 1 / of_two_digits(apart / fineness);
      largest = std::max(largest, error_at(finer));
      // Few steps have no neighbour that is near.
      if (!fixed || coarser >= 0.9 * fineness) largest = std::max(largest, error_at(coarser));
    }
    return largest;
  }

  void accept(double fineness, double near) {
    std::vector<TimedRun>& trials = solver_.trials;
    const auto is_it = [&](const TimedRun& run) {
      return std::abs(fineness_of(run.request) / fineness - 1) < 1e-9;
    };
    auto at = std::ranges::find_if(trials, [&](const TimedRun& trial) {
      return fineness_of(trial.request) >= fineness * (1 - 1e-9);
    });
    if (const auto made = std::ranges::find_if(runs_, is_it); made != runs_.end()) {
      at = trials.insert(at, std::move(*made));
      runs_.erase(made);
    }
    at->row.near_error = near;
  }

  const TimedCase& stage_;
  TimedSolver& solver_;
  measure::SettingSearch search_;
  std::vector<TimedRun> runs_;  ///< those that are not trials
};

/// The time in which a solver seems to reach an error: that of a run, or between two runs, where
/// the logarithms of time and error are taken to be linear; beyond the coarsest two, too, where
/// both have less than the error, down to a step from stop to stop.
double promised_ns(const TimedCase& stage, const TimedSolver& solver, double error) {
  double least = infinity, bound = 0;
  const PrecisionRow *coarsest = nullptr, *coarse = nullptr;
  for (const TimedRun& trial : solver.trials) {
    const PrecisionRow& fine = trial.row;
    if (!fine.timed()) continue;
    if (fine.error <= error) least = std::min(least, fine.wall_ns_min);
    if (!coarsest) coarsest = &fine;
    if (coarsest == &fine && solver.mode == Mode::fixed)
      bound = fine.wall_ns_min * static_cast<double>(stage.c.settings.steps_multiple) /
              static_cast<double>(trial.request.steps);
    if (coarse && (coarse->error > error || coarse == coarsest) && fine.error < error &&
        fine.error > 0 && fine.error < coarse->error) {
      const double part = std::log(coarse->error / error) / std::log(coarse->error / fine.error);
      const double log_ns =
          (1 - part) * std::log(coarse->wall_ns_min) + part * std::log(fine.wall_ns_min);
      least = std::min(least, std::max(bound, std::exp(log_ns)));
    }
    coarse = &fine;
  }
  return least;
}

/// A closed form is compared with no method.
bool competes(const TimedSolver& solver, const std::string& library) {
  const SolverInfo& info = solver.entrant->info;
  return info.library == library && !info.closed_form();
}

/// The least time of a run of a library that reaches an error.
double found_ns(const std::vector<TimedSolver>& solvers, const std::string& library, double error) {
  double least = infinity;
  for (const TimedSolver& solver : solvers)
    if (competes(solver, library))
      for (const TimedRun& trial : solver.trials)
        if (reaches(trial.row, error)) least = std::min(least, trial.row.wall_ns_min);
  return least;
}

/// The solvers of a library that may be the fastest at an error and were not searched for it: those
/// whose promises are within a tenth of the best, three at most.
std::vector<std::size_t> promising(const TimedCase& stage, const std::vector<TimedSolver>& solvers,
                                   const std::string& library, double error) {
  const double found = found_ns(solvers, library, error);
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < solvers.size(); ++i) {
    if (!competes(solvers[i], library) || solvers[i].searched.contains(error)) continue;
    if (const double promised = promised_ns(stage, solvers[i], error); promised < found)
      order.emplace_back(promised, i);
  }
  std::ranges::sort(order);
  std::vector<std::size_t> list;
  for (const auto& [promised, i] : order)
    if (list.size() < 3 && promised <= 1.1 * order.front().first) list.push_back(i);
  return list;
}

/// The fastest run of a library that seems to reach an error, faster than what is known to, and
/// whose neighbours were not run; null: none.
std::pair<TimedSolver*, TimedRun*> unchecked(std::vector<TimedSolver>& solvers,
                                             const std::string& library, double error) {
  std::pair<TimedSolver*, TimedRun*> best{nullptr, nullptr};
  double least = found_ns(solvers, library, error);
  for (TimedSolver& solver : solvers) {
    if (!competes(solver, library)) continue;
    for (TimedRun& trial : solver.trials) {
      const PrecisionRow& row = trial.row;
      if (!row.timed() || !std::isnan(row.near_error)) continue;
      if (!(row.error <= error && row.wall_ns_min < least)) continue;
      least = row.wall_ns_min;
      best = {&solver, &trial};
    }
  }
  return best;
}

std::vector<std::string> libraries_of(const std::vector<TimedSolver>& solvers) {
  std::set<std::string> libraries;
  for (const TimedSolver& solver : solvers) libraries.insert(solver.entrant->info.library);
  return {libraries.begin(), libraries.end()};
}

}  // namespace

bool settle_errors(const TimedCase& stage, std::vector<TimedSolver>& solvers, unsigned jobs) {
  std::map<std::size_t, std::vector<double>> tasks;
  for (const std::string& library : libraries_of(solvers))
    for (const double error : compared_errors())
      if (error > stage.floor)
        for (const std::size_t i : promising(stage, solvers, library, error))
          tasks[i].push_back(error);
  const std::vector<std::pair<std::size_t, std::vector<double>>> list(tasks.begin(), tasks.end());
  parallel_for(list.size(), jobs, [&](std::size_t k) {
    const auto& [i, errors] = list[k];
    Settings search(stage, solvers[i]);
    for (const double error : errors) {
      search.settle(error);
      solvers[i].searched.insert(error);
    }
  });
  return !list.empty();
}

void check_fastest(const TimedCase& stage, std::vector<TimedSolver>& solvers, unsigned jobs) {
  const std::vector<std::string> libraries = libraries_of(solvers);
  parallel_for(libraries.size(), jobs, [&](std::size_t k) {
    for (const double error : compared_errors()) {
      if (!(error > stage.floor)) continue;
      for (auto [solver, trial] = unchecked(solvers, libraries[k], error); trial;
           std::tie(solver, trial) = unchecked(solvers, libraries[k], error))
        Settings(stage, *solver).check(*trial);
    }
  });
}

}  // namespace odeum::study
