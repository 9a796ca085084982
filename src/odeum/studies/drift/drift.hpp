// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "odeum/measure/run_record.hpp"
#include "odeum/studies/study.hpp"

namespace odeum::study {

/// The error of an invariant at a time: a line of drift.csv.
struct DriftRow {
  std::string case_id, library, solver;
  std::string status;  ///< a Status at that time, or not_applicable
  std::string detail;
  double step = nan, time = nan;
  /// `energy`, an invariant of the case, or on a harmonic oscillator `amplitude` and `phase`;
  /// `none` where there is none.
  std::string invariant = "none";
  /// |value - exact| / |exact|, or |value - exact| where the exact value is 0. Of the phase: the
  /// lag over the exact angle, which is the relative error of the frequency.
  double relative_error = nan;
  /// The invariant in the case's units; for the phase the lag in radians, > 0 behind.
  double value = nan;

  static constexpr const char* file = "drift.csv";
  ODEUM_COLUMNS(case_id, library, solver, status, step, time, invariant, relative_error, value,
                detail)
};

/// The time up to which a solver follows a chaotic solution: a line of horizons.csv.
struct HorizonRow : measure::RunRecord {
  /// When the largest error of a component reaches 1e-3, by linear interpolation of its logarithm
  /// between times at which the truth is known; NaN where the solve failed before.
  double horizon = nan;

  static constexpr const char* file = "horizons.csv";
  static constexpr const char* shown = "case solver mode setting:.2g horizon:.2f status";
  ODEUM_COLUMNS(case_id, library, solver, status, detail, mode, setting, horizon)
};

/// Steps of a run; of systems of more unknowns than `drift_most_unknowns`, fewer.
inline constexpr std::uint64_t drift_steps = 10'000, drift_steps_of_large = 1'000;
inline constexpr std::size_t drift_most_unknowns = 12;

struct DriftResult {
  std::vector<DriftRow> rows = {};
  std::vector<HorizonRow> horizons = {};
  static auto lists(auto& result) { return std::tie(result.rows, result.horizons); }
};

/// Runs every fitting pair at a fixed step, half of that at which the case's study of convergence
/// begins, over 10,000 steps (1,000 where there are more than 12 unknowns), and compares the
/// invariants of the exact solution at some 35 times between the first step and the last. Chaotic
/// cases are run for their horizons too. Throws Interrupted.
DriftResult measure_drift(const Options& options, const Runner& runner = Runner());

/// The horizons of one solver on one case: three steps and three tolerances.
std::vector<HorizonRow> measure_horizons(const Case& c, const Entrant& entrant);

/// The case's energy, where the truth shows that it is constant (a damped system has an energy
/// too), then its invariants.
std::vector<Invariant> kept_quantities(const Case& c);

/// The motion of q'' = -omega^2 q, in the plane of q and q' / omega: a circle at a constant rate.
struct HarmonicMotion {
  double omega = 0;      ///< radians per unit of time
  double amplitude = 0;  ///< in the units of q
  double start = 0;      ///< angle at the initial state, radians

  double amplitude_of(const double* y) const;
  /// The lag of a state behind the exact angle after `elapsed` time, in radians. An angle is known
  /// up to full turns; of these lags the one nearest to `expected` is returned.
  double lag_of(const double* y, double elapsed, double expected) const;
};

/// The harmonic motion of a case; none where it is not a harmonic oscillator.
std::optional<HarmonicMotion> harmonic_motion(const Case& c);

/// The time when errors, positive and at increasing times, first reach a limit; NaN where they
/// never do.
double time_of_reaching(const std::vector<double>& times, const std::vector<double>& errors,
                        double limit);

}  // namespace odeum::study
