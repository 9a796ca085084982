// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/precision/timing.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "odeum/core/interrupt.hpp"
#include "odeum/core/numbers.hpp"
#include "odeum/core/parallel.hpp"
#include "odeum/solvers/loaded.hpp"

namespace odeum::study {
namespace {

constexpr std::uint64_t most_repetitions = 15;
constexpr double longest_repeated_ns = 2e7;

/// Times a trial once with the bare right-hand side, and checks that it ends at the state of the
/// counted run: to a tenth of that run's error, or to rounding. A run that fails has no time.
void time_once(const TimedCase& stage, TimedSolver& solver, TimedRun& trial) {
  const auto& solve = solver.inlined ? solver.inlined->solve : solver.entrant->solve;
  trial.row.library_compiled = how_library_was_compiled(trial.row.library);
  trial.row.right_hand_side = solver.inlined ? "inlined" : "function pointer";
  Request request = trial.request;
  request.budget.watched = false;
  Outcome outcome;
  const double guess = trial.times.ns.empty() ? trial.guarded_ns / 2 : trial.times.min();
  const double ns = time_call([&] { outcome = solve(request); }, guess);
  // Not all settings are compiled for inlined problems (absolute tolerances by component).
  if (outcome.status == Status::refused && solver.inlined) {
    solver.inlined = nullptr;
    return time_once(stage, solver, trial);
  }
  trial.failed = outcome.status != Status::ok;
  if (trial.failed) {
    trial.times.ns.clear();
    trial.row.detail =
        fmt::format("the timed run ended {}: {}", to_string(outcome.status), outcome.detail);
    return;
  }
  trial.times.ns.push_back(ns);
  double apart = outcome.states.size() == trial.states.size() ? 0 : nan;
  for (std::size_t i = 0; i < trial.states.size() && !std::isnan(apart); ++i)
    apart = std::max(apart, std::abs(outcome.states[i] - trial.states[i]));
  const double allowed = 0.1 * trial.row.error + stage.floor + 1e-12 * stage.judge.scale();
  if (!(apart <= allowed))
    trial.row.detail = fmt::format("the timed run ended {:.2g} away from the counted one", apart);
}

/// A trial is dropped if another of its library is at least as accurate and faster by this factor:
/// guard and pointer cost up to 4.5 times an inlined right-hand side, and other programs may double
/// a single time. Processor time without the guard's share is known better than that.
constexpr double slow_factor = 10, exact_slow_factor = 1.5, guarded_time_factor = 2;

void mark_slow_solvers(std::vector<TimedSolver>& solvers) {
  std::vector<std::pair<const TimedSolver*, TimedRun*>> trials;
  for (TimedSolver& solver : solvers)
    for (TimedRun& trial : solver.trials)
      if (trial.ok()) trials.emplace_back(&solver, &trial);
  const auto smaller = [](auto& a, auto& b) { return a.second->row.error < b.second->row.error; };
  std::ranges::stable_sort(trials, smaller);
  std::map<std::string, double> least;  // by library, of those of no larger error
  for (const auto& [solver, trial] : trials) {
    const std::string& library = solver->entrant->info.library;
    double& known = least.try_emplace(library, trial->guarded_ns).first->second;
    known = std::min(known, trial->guarded_ns);
    if (trial->done) continue;
    const bool exact = !solver->inlined && trial->measurable();
    trial->cannot_be_fastest =
        exact ? trial->guarded_ns - 2 * trial->guard_ns() > exact_slow_factor * known
              : trial->guarded_ns > slow_factor * known;
    if (!exact || !trial->lightly_guarded() || trial->guarded_ns <= guarded_time_factor * known)
      continue;
    trial->row.right_hand_side = "guarded";
    trial->times.ns = {trial->guarded_ns};
  }
}

/// Times each run that cannot be the fastest once, several at a time.
void time_slow_solvers(const TimedCase& stage, std::vector<TimedSolver>& solvers, unsigned jobs) {
  parallel_for(solvers.size(), jobs, [&](std::size_t i) {
    for (TimedRun& trial : solvers[i].trials)
      if (trial.ok() && trial.cannot_be_fastest && !trial.guarded() && !trial.done)
        time_once(stage, solvers[i], trial);
  });
}

}  // namespace

void time_all(const TimedCase& stage, std::vector<TimedSolver>& solvers, double seconds,
              unsigned jobs) {
  mark_slow_solvers(solvers);
  time_slow_solvers(stage, solvers, jobs);
  double once = 0;
  std::size_t most_settings = 0;
  for (const TimedSolver& solver : solvers) {
    most_settings = std::max(most_settings, solver.trials.size());
    for (const TimedRun& trial : solver.trials)
      if (trial.ok() && !trial.cannot_be_fastest && !trial.done)
        once += std::max(trial.guarded_ns, 20'000.0);
  }
  const auto rounds = static_cast<std::uint64_t>(
      std::clamp(seconds * 1e9 / std::max(once, 1.0), 2.0, double(most_repetitions)));
  const Pinned pinned;
  for (std::size_t k = 0; k < most_settings; ++k)
    for (std::uint64_t round = 0; round < rounds; ++round)
      for (TimedSolver& solver : solvers) {
        if (k >= solver.trials.size() || !solver.trials[k].ok()) continue;
        if (interrupted) throw Interrupted();
        TimedRun& trial = solver.trials[k];
        if (trial.failed || trial.cannot_be_fastest || trial.done) continue;
        // A long run averages disturbances: two repetitions suffice.
        if (round > 1 && trial.guarded_ns > longest_repeated_ns) continue;
        time_once(stage, solver, trial);
      }
  for (TimedSolver& solver : solvers)
    for (TimedRun& trial : solver.trials) {
      trial.done = true;
      static_cast<WallTimes&>(trial.row) = trial.times.columns();
    }
}

}  // namespace odeum::study
