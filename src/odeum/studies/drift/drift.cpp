// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/drift/drift.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "odeum/studies/drift/kept_quantities.hpp"

namespace odeum::study {
namespace {

/// The invariants of a case, and the times at which they are observed.
struct LongRun {
  const Case& c;
  std::vector<KeptQuantity> kept;
  std::optional<HarmonicMotion> motion;
  Request request;
  double step;

  explicit LongRun(const Case& each)
      : c(each), kept(kept_quantities(each)), motion(harmonic_motion(each)) {
    const std::uint64_t steps = c.y0.size() > 12 ? 1'000 : 10'000;
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

/// Rows of one quantity: one per stop reached, and one more where the solve ended early.
class Series {
 public:
  Series(DriftRow blank, const char* name, std::vector<DriftRow>& rows)
      : blank_(std::move(blank)), rows_(rows) {
    blank_.invariant = name;
  }
  /// False: the numbers have left the range of doubles, and the series ends.
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

/// Calls add(stop, y) for the stops reached until it returns false, and ends the series where the
/// solve failed.
template <class Add>
void follow(const LongRun& run, const Outcome& outcome, Series& series, Add&& add) {
  const std::size_t n = run.c.y0.size();
  for (std::size_t k = 0; (k + 1) * n <= outcome.states.size(); ++k)
    if (!add(run.request.stops[k], outcome.states.data() + k * n)) return;
  if (outcome.status != Status::ok) series.end(outcome);
}

std::vector<DriftRow> run_pair(const LongRun& run, const Entrant& entrant) {
  std::vector<DriftRow> rows;
  auto blank = named_row<DriftRow>(run.c, entrant.info);
  if (const std::string reason = reason_against(run, entrant); !reason.empty())
    return {not_applicable(blank, reason)};
  blank.step = run.step;
  const Outcome outcome = entrant.solve(run.request);
  for (const KeptQuantity& kept : run.kept) {
    Series series(blank, kept.name.c_str(), rows);
    const double scale = kept.exact == 0 ? 1 : std::abs(kept.exact);
    follow(run, outcome, series, [&](double time, const double* y) {
      const double value = kept.value(y);
      return series.add(time, value, std::abs(value - kept.exact) / scale);
    });
  }
  if (run.motion) {
    const HarmonicMotion& motion = *run.motion;
    Series amplitude(blank, "amplitude", rows);
    follow(run, outcome, amplitude, [&](double time, const double* y) {
      const double value = motion.amplitude_of(y);
      return amplitude.add(time, value, std::abs(value / motion.amplitude - 1));
    });
    // The lag is proportional to time and far below one turn at the first stop: its value at one
    // stop determines the number of full turns at the next.
    Series phase(blank, "phase", rows);
    double rate = 0;
    follow(run, outcome, phase, [&](double time, const double* y) {
      const double elapsed = time - run.c.t0;
      const double lag = motion.lag_of(y, elapsed, rate * elapsed);
      rate = lag / elapsed;
      return phase.add(time, lag, std::abs(rate) / motion.omega);
    });
  }
  return rows;
}

}  // namespace

DriftResult measure_drift(const Options& options, const Runner& runner) {
  std::map<const Case*, LongRun> runs;
  const std::vector<const Case*> cases = select_cases(options.cases);
  for (const Case* c : cases) runs.try_emplace(c, *c);
  return runner.run("drift", select_pairs(cases, options.solvers), key_of, [&](const Pair& pair) {
    DriftResult result{.rows = run_pair(runs.at(pair.c), *pair.entrant), .horizons = {}};
    if (pair.c->has_tag("chaotic")) result.horizons = measure_horizons(*pair.c, *pair.entrant);
    return result;
  });
}

}  // namespace odeum::study
