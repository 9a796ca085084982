// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/drift/drift.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

namespace odeum::study {
namespace {

/// Whether the truth's energy is constant at all of its stops. A truth is rounded to double, which
/// changes an energy by some 1e-13 at most; weak damping changes it by 1e-3 and more.
bool keeps_energy(const Case& c) {
  constexpr double allowed = 1e-9;
  const double start = c.energy(c.y0.data());
  std::vector<double> exact(c.y0.size());
  bool known = false;
  for (const double stop : c.stops) {
    if (!c.truth.at(stop, exact.data())) continue;
    known = true;
    if (!(std::abs(c.energy(exact.data()) - start) <= allowed * std::abs(start))) return false;
  }
  return known;
}

/// The invariants of a case, and the times at which they are observed.
struct LongRun {
  const Case& c;
  std::vector<Invariant> kept;
  std::optional<HarmonicMotion> motion;
  Request request;
  double step;

  explicit LongRun(const Case& each)
      : c(each), kept(kept_quantities(each)), motion(harmonic_motion(each)) {
    const std::uint64_t steps =
        c.y0.size() > drift_most_unknowns ? drift_steps_of_large : drift_steps;
    step = (c.stops.back() - c.t0) / (2 * static_cast<double>(c.settings.coarsest_steps));
    request.steps = steps;
    // Eight times per decade: power laws are lines over the logarithm of time.
    std::uint64_t last = 0;
    for (int k = 0; last < steps; ++k) {
      const auto index =
          std::min(static_cast<std::uint64_t>(std::llround(std::pow(10.0, k / 8.0))), steps);
      if (index > last) request.stops.push_back(c.t0 + static_cast<double>(index) * step);
      last = index;
    }
    // Enough for five implicit stages with six iterations each.
    request.budget.evaluations = 64 * steps;
  }
};

/// Why nothing can be measured; empty: it can.
std::string reason_against(const LongRun& run, const Entrant& entrant) {
  if (!entrant.unfit.empty()) return entrant.unfit;
  if (run.kept.empty()) return "no invariant of the case is known";
  if (!run.c.settings.no_fixed_steps.empty()) return run.c.settings.no_fixed_steps;
  return entrant.info.fixed ? "" : "chooses its own steps only";
}

/// What is followed along a run: its value at a time and a state, and the relative error of that.
struct Observed {
  std::string name;
  std::function<std::pair<double, double>(double time, const double* y)> at;
};

std::vector<Observed> observed_in(const LongRun& run) {
  std::vector<Observed> all;
  for (const Invariant& kept : run.kept) {
    const double exact = kept.value(run.c.y0.data()), scale = exact == 0 ? 1 : std::abs(exact);
    all.push_back({kept.name, [=, &kept](double, const double* y) {
                     const double value = kept.value(y);
                     return std::pair(value, std::abs(value - exact) / scale);
                   }});
  }
  if (!run.motion) return all;
  const HarmonicMotion& motion = *run.motion;
  all.push_back({"amplitude", [&motion](double, const double* y) {
                   const double value = motion.amplitude_of(y);
                   return std::pair(value, std::abs(value / motion.amplitude - 1));
                 }});
  // The lag is proportional to time and far below one turn at the first stop: its value at one
  // stop determines the number of full turns at the next.
  all.push_back({"phase", [&motion, &run, rate = 0.0](double time, const double* y) mutable {
                   const double elapsed = time - run.c.t0;
                   const double lag = motion.lag_of(y, elapsed, rate * elapsed);
                   rate = lag / elapsed;
                   return std::pair(lag, std::abs(rate) / motion.omega);
                 }});
  return all;
}

/// Adds a row for each stop reached as long as the numbers are finite, and one more where the run
/// ended before the last.
void follow(const LongRun& run, const Outcome& outcome, const Observed& observed, DriftRow blank,
            std::vector<DriftRow>& rows) {
  blank.invariant = observed.name;
  const auto add = [&](double time, Status status, const std::string& detail) -> DriftRow& {
    DriftRow& row = rows.emplace_back(blank);
    row.time = time;
    row.status = to_string(status);
    row.detail = detail;
    return row;
  };
  const std::size_t n = run.c.y0.size();
  for (std::size_t k = 0; (k + 1) * n <= outcome.states.size(); ++k) {
    const double time = run.request.stops[k];
    const auto [value, relative_error] = observed.at(time, outcome.states.data() + k * n);
    if (!std::isfinite(value) || !std::isfinite(relative_error)) {
      add(time, Status::non_finite, "beyond the range of doubles");
      return;
    }
    DriftRow& row = add(time, Status::ok, "");
    row.value = value;
    row.relative_error = relative_error;
  }
  if (outcome.status != Status::ok) add(outcome.t, outcome.status, outcome.detail);
}

std::vector<DriftRow> run_pair(const LongRun& run, const Entrant& entrant) {
  auto blank = named_row<DriftRow>(run.c, entrant.info);
  if (const std::string reason = reason_against(run, entrant); !reason.empty())
    return {not_applicable(blank, reason)};
  blank.step = run.step;
  const Outcome outcome = entrant.solve(run.request);
  std::vector<DriftRow> rows;
  for (const Observed& observed : observed_in(run)) follow(run, outcome, observed, blank, rows);
  return rows;
}

}  // namespace

std::vector<Invariant> kept_quantities(const Case& c) {
  std::vector<Invariant> kept = c.invariants;
  if (c.energy && keeps_energy(c)) kept.insert(kept.begin(), {"energy", c.energy});
  return kept;
}

double HarmonicMotion::amplitude_of(const double* y) const {
  return std::hypot(y[0], y[1] / omega);
}

double HarmonicMotion::lag_of(const double* y, double elapsed, double expected) const {
  // The angle runs clockwise from q towards -q'.
  const double exact = start + omega * elapsed;
  const double lag = exact - std::atan2(-y[1] / omega, y[0]);
  constexpr double turn = 2 * std::numbers::pi;
  return lag - turn * std::round((lag - expected) / turn);
}

std::optional<HarmonicMotion> harmonic_motion(const Case& c) {
  const OdeView& view = c.problem.view;
  if (!view.linear_matrix || view.degrees_of_freedom != 1) return std::nullopt;
  double matrix[4], rest[2];
  view.linear_matrix(view.problem, matrix);
  const double origin[2] = {0, 0};
  view.rhs(view.problem, c.t0, origin, rest);
  const bool harmonic = matrix[2] < 0 && matrix[3] == 0 && rest[0] == 0 && rest[1] == 0;
  if (!harmonic) return std::nullopt;
  HarmonicMotion motion{.omega = std::sqrt(-matrix[2])};
  motion.amplitude = motion.amplitude_of(c.y0.data());
  motion.start = std::atan2(-c.y0[1] / motion.omega, c.y0[0]);
  return motion;
}

DriftResult measure_drift(const Options& options, const Runner& runner) {
  std::map<const Case*, LongRun> runs;
  const std::vector<const Case*> cases = select_cases(options.cases);
  for (const Case* c : cases) runs.try_emplace(c, *c);
  return runner.run("drift", select_pairs(cases, options.solvers), key_of, [&](const Pair& pair) {
    DriftResult result{.rows = run_pair(runs.at(pair.c), *pair.entrant)};
    if (pair.c->nature.chaotic) result.horizons = measure_horizons(*pair.c, *pair.entrant);
    return result;
  });
}

}  // namespace odeum::study
