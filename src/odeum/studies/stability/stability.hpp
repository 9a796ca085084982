// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <complex>
#include <string>
#include <tuple>
#include <vector>

#include "odeum/studies/study.hpp"

namespace odeum::study {

/// A solver is stable here where its growth per step, measured on the states of a run at h = 1
/// (growth_meter.hpp) of y' = z y from y = 1, or of the oscillator q'' = -2 zeta w q' - w^2 q from
/// q = 1, q' = 0, is at most 1 to within the accuracy of the measurement.

/// The difference from theory that a measured limit may have, relative above 1.
inline constexpr double limit_tolerance = 1e-6;

/// A limit of stability along an axis: a line of stability_limits.csv. `limit` is measured on the
/// running code, `theory` comes from the method's own stability function by the same search (NaN:
/// none).
struct StabilityLimit {
  std::string library, solver;
  std::string axis;  ///< real, imaginary, oscillator
  double limit = nan, theory = nan;
  double difference = nan;  ///< |limit - theory|, 0 where both are infinite
  std::string status;  ///< a Status, not_applicable, or differs: from theory, see limit_tolerance
  std::string detail;

  static constexpr const char* file = "stability_limits.csv";
  static constexpr const char* shown = "solver axis limit:.7g theory:.7g status";
  ODEUM_COLUMNS(library, solver, axis, limit, theory, difference, status, detail)
};

/// Growth per step measured on a grid of a parameter plane, row by row from the lowest second
/// coordinate up, each row from the lowest first coordinate up; both edges of the plane are on the
/// grid. NaN where the solver failed, infinity where numbers overflowed. On the lambda plane only
/// the upper half is solved and mirrored, since a method with real coefficients maps the conjugate
/// of z to the conjugate of y.
struct StabilityRegion {
  std::string library, solver;
  std::string plane;           ///< lambda or oscillator
  std::string status, detail;  ///< a Status or not_applicable; then there is no growth
  int columns = 0, rows = 0;
  double first_low = 0, first_high = 0;    ///< real part, or omega h
  double second_low = 0, second_high = 0;  ///< imaginary part, or zeta
  std::vector<float> growth;

  /// The file that holds the growth, stability/<library>_<solver>_<plane>.csv.gz; empty: no growth.
  std::string growth_file() const;

  static constexpr const char* file = "stability_regions.csv";
  ODEUM_COLUMNS(library, solver, plane, status, detail, columns, rows, first_low, first_high,
                second_low, second_high, column("growth", StoredOnly{growth}),
                column("file", ComputedColumn{growth_file()}))
};

/// What the region of a solver means for a problem: the largest step h for which h lambda lies
/// within it, for every eigenvalue lambda of the Jacobian along the solution that has no positive
/// real part. A line of stability_steps.csv.
struct StableStep {
  std::string case_id, library, solver;
  std::string status, detail;  ///< a Status or not_applicable
  /// The eigenvalue that limits the step; where none does, the largest.
  std::complex<double> eigenvalue{nan, nan};
  double limit = nan;  ///< the largest |z| without growth on the ray of that eigenvalue, measured
  double step = nan;   ///< limit / |eigenvalue|; infinity: any

  static constexpr const char* file = "stability_steps.csv";
  static constexpr const char* shown = "case solver step eigenvalue limit:.5g status";
  ODEUM_COLUMNS(case_id, library, solver, status, detail, eigenvalue, limit, step)
};

struct StabilityResult {
  std::vector<StabilityLimit> limits = {};
  std::vector<StabilityRegion> regions = {};
  std::vector<StableStep> steps = {};
  static auto lists(auto& result) { return std::tie(result.limits, result.regions, result.steps); }
};

/// Stability regions and limits of every solver with a fixed step. Own options: `plane` is lambda
/// or oscillator (both), `grid` the points along the first axis (own methods 257 where vectorised,
/// else 129; peers 65), `peer-grid` the same for peers only. Where cases are selected, the steps
/// that regions allow on them are measured instead. Throws Interrupted.
StabilityResult measure_stability(const Options& options, const Runner& runner = Runner());

/// The part of it for the selected cases.
StabilityResult measure_steps(const Options& options, const Runner& runner);

/// The lines of a region's file: `rows` lines of `columns` growths per step to 4 digits, in the
/// order of StabilityRegion.
std::string growth_text(const StabilityRegion& region);

}  // namespace odeum::study
