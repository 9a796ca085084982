// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/drift/drift.hpp"

#include <algorithm>
#include <cmath>

#include "odeum/core/glob.hpp"
#include "odeum/core/parallel.hpp"
#include "odeum/core/progress.hpp"
#include "odeum/studies/drift/kept_quantities.hpp"

namespace odeum::study {
namespace {

/// What a case keeps, and how long it is watched.
struct Watch {
  const Case& c;
  std::vector<KeptQuantity> kept;
  std::optional<HarmonicMotion> motion;
  Request request;
  double step;

  explicit Watch(const Case& each)
      : c(each), kept(kept_quantities(each)), motion(harmonic_motion(each)) {
    const std::uint64_t steps = c.y0.size() > 12 ? 1'000 : 10'000;
    step = (c.stops.back() - c.t0) / (2 * static_cast<double>(c.settings.coarsest_steps));
    request.steps = steps;
    // Eight times a decade: a law of growth is a straight line over the logarithm of time.
    std::uint64_t last = 0;
    for (int k = 0; last < steps; ++k) {
      const auto index =
          std::min(static_cast<std::uint64_t>(std::llround(std::pow(10.0, k / 8.0))), steps);
      if (index > last) request.stops.push_back(c.t0 + static_cast<double>(index) * step);
      last = index;
    }
    // Enough for every solver that makes progress: five implicit stages, six iterations each.
    request.budget.evaluations = 64 * steps;
  }
};

DriftRow blank_row(const Watch& watch, const SolverInfo& info) {
  DriftRow row;
  row.case_id = watch.c.id;
  row.library = info.library;
  row.solver = info.method;
  return row;
}

/// Why there is nothing to measure; empty: there is.
std::string reason_against(const Watch& watch, const Entrant& entrant) {
  if (!entrant.unfit.empty()) return entrant.unfit;
  if (watch.kept.empty()) return "the exact solution of the case keeps nothing that is known";
  if (!watch.c.settings.no_fixed_steps.empty()) return watch.c.settings.no_fixed_steps;
  return entrant.info.fixed ? "" : "chooses its own steps only";
}

/// Rows of one quantity: a row a stop that was reached, and one more where the solve ended early.
class Series {
 public:
  Series(DriftRow blank, const char* name, std::vector<DriftRow>& rows)
      : blank_(std::move(blank)), rows_(rows) {
    blank_.invariant = name;
  }
  /// False: the numbers have left the range of doubles, and nothing that follows is of use.
  bool add(double time, double value, double relative_error) {
    DriftRow row = blank_;
    row.time = time;
    const bool finite = std::isfinite(value) && std::isfinite(relative_error);
    row.status = to_string(finite ? Status::ok : Status::non_finite);
    if (finite) {
      row.value = value;
      row.relative_error = relative_error;
    } else {
      row.detail = "beyond the range of doubles";
    }
    rows_.push_back(std::move(row));
    return finite;
  }
  void end(const Outcome& outcome) {
    DriftRow row = blank_;
    row.status = to_string(outcome.status);
    row.detail = outcome.detail;
    row.time = outcome.t;
    rows_.push_back(std::move(row));
  }

 private:
  DriftRow blank_;
  std::vector<DriftRow>& rows_;
};

/// Calls add(stop, y) for the stops that were reached until it says no, and ends the series where
/// the solve failed.
template <class Add>
void follow(const Watch& watch, const Outcome& outcome, Series& series, Add&& add) {
  const std::size_t n = watch.c.y0.size();
  for (std::size_t k = 0; (k + 1) * n <= outcome.states.size(); ++k)
    if (!add(watch.request.stops[k], outcome.states.data() + k * n)) return;
  if (outcome.status != Status::ok) series.end(outcome);
}

std::vector<DriftRow> run_pair(const Watch& watch, const Entrant& entrant) {
  std::vector<DriftRow> rows;
  DriftRow blank = blank_row(watch, entrant.info);
  if (const std::string reason = reason_against(watch, entrant); !reason.empty()) {
    blank.status = "not_applicable";
    blank.detail = reason;
    return {blank};
  }
  blank.step = watch.step;
  const Outcome outcome = entrant.solve(watch.request);
  for (const KeptQuantity& kept : watch.kept) {
    Series series(blank, kept.name.c_str(), rows);
    const double scale = kept.exact == 0 ? 1 : std::abs(kept.exact);
    follow(watch, outcome, series, [&](double time, const double* y) {
      const double value = kept.value(y);
      return series.add(time, value, std::abs(value - kept.exact) / scale);
    });
  }
  if (watch.motion) {
    const HarmonicMotion& motion = *watch.motion;
    Series amplitude(blank, "amplitude", rows);
    follow(watch, outcome, amplitude, [&](double time, const double* y) {
      const double value = motion.amplitude_of(y);
      return amplitude.add(time, value, std::abs(value / motion.amplitude - 1));
    });
    // The lag grows in proportion to time, from far less than a turn at the first stop: what it was
    // at one stop tells the number of full turns at the next.
    Series phase(blank, "phase", rows);
    double rate = 0;
    follow(watch, outcome, phase, [&](double time, const double* y) {
      const double elapsed = time - watch.c.t0;
      const double lag = motion.lag_of(y, elapsed, rate * elapsed);
      rate = lag / elapsed;
      return phase.add(time, lag, std::abs(rate) / motion.omega);
    });
  }
  return rows;
}

}  // namespace

DriftResult measure_drift(const DriftOptions& options) {
  struct Task {
    std::shared_ptr<const Watch> watch;
    const Entrant* entrant;
    DriftResult result;
  };
  std::vector<Task> tasks;
  for (const Case& c : all_cases()) {
    if (!any_glob_matches(options.cases, c.id)) continue;
    const auto watch = std::make_shared<const Watch>(c);
    for (const Entrant& entrant : c.entrants)
      if (any_glob_matches(options.solvers, entrant.info.id()))
        tasks.push_back({watch, &entrant, {}});
  }
  Progress progress("drift", static_cast<double>(tasks.size()));
  parallel_for(tasks.size(), options.jobs, [&](std::size_t i) {
    Task& task = tasks[i];
    task.result.rows = run_pair(*task.watch, *task.entrant);
    if (task.watch->c.has_tag("chaotic"))
      task.result.horizons = measure_horizons(task.watch->c, *task.entrant);
    progress.advance();
  });
  DriftResult all;
  for (Task& task : tasks) {
    std::move(task.result.rows.begin(), task.result.rows.end(), std::back_inserter(all.rows));
    std::move(task.result.horizons.begin(), task.result.horizons.end(),
              std::back_inserter(all.horizons));
  }
  return all;
}

}  // namespace odeum::study
