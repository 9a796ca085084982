// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "odeum/contest/case.hpp"
#include "odeum/record/output_folder.hpp"

namespace odeum::study {

/// What "bounded" means here: a solver steps at h = 1 on y' = z y from y = 1, or on the oscillator
/// q'' = -2 zeta w q' - w^2 q from q = 1, q' = 0, and its growth a step is read off the states that
/// come out (growth_meter.hpp); bounded where that is at most 1 to within what the states resolve.

/// A limit of stability along an axis: a line of stability_limits.csv. `limit` is measured on the
/// running code, `theory` comes from the method's own stability function by the same search (NaN:
/// none).
struct StabilityLimit {
  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  std::string library, solver;
  std::string axis;  ///< real, imaginary, oscillator
  double limit = nan, theory = nan;
  double difference = nan;  ///< |limit - theory|, 0 where both are infinite
  std::string status;       ///< a Status, or not_applicable
  std::string detail;
};

/// Growth per step measured on a grid of a parameter plane, row by row from the lowest second
/// coordinate up, each row from the lowest first coordinate up; both edges of the plane are on the
/// grid. NaN where the solver failed, infinity where numbers overflowed. On the lambda plane only
/// the upper half is solved and mirrored, since a method with real coefficients answers the
/// conjugate of z with the conjugate of y.
struct StabilityRegion {
  std::string library, solver;
  std::string plane;           ///< lambda or oscillator
  std::string status, detail;  ///< a Status or not_applicable; then there is no growth
  int columns = 0, rows = 0;
  double first_low = 0, first_high = 0;    ///< real part, or omega h
  double second_low = 0, second_high = 0;  ///< imaginary part, or zeta
  std::vector<float> growth;
};

struct StabilityResult {
  std::vector<StabilityLimit> limits;
  std::vector<StabilityRegion> regions;
};

struct StabilityOptions {
  std::vector<std::string> solvers;  ///< globs on library/method; empty: all
  std::string plane;                 ///< lambda, oscillator, or empty: both
  int own_grid = 0;   ///< points along the first axis, own methods; 0: 257 in lanes, else 129
  int peer_grid = 0;  ///< and other libraries' solvers; 0: 65
  unsigned jobs = 1;
};

/// Stability regions and limits of every solver with a fixed step. Throws Interrupted.
StabilityResult measure_stability(const StabilityOptions& options,
                                  record::Journal* journal = nullptr);

/// Writes
/// - stability_limits.csv: a row for every solver and axis;
/// - stability_regions.csv: a row for every solver and plane, with the file that holds its data;
/// - stability/<library>_<solver>_<plane>.csv: a header and a line with schema, plane, columns,
///   rows, first_low, first_high, second_low, second_high; then `rows` lines of `columns` growths
///   per step to 4 digits, in the order of StabilityRegion.
void write_csv(const StabilityResult& result, const record::OutputFolder& folder);

/// The lines of growths of a region as its file holds them, and back (columns and rows must be set;
/// throws std::runtime_error where the text has not as many numbers).
std::string growth_text(const StabilityRegion& region);
std::vector<float> read_growth(std::string_view text, const StabilityRegion& region);

}  // namespace odeum::study
