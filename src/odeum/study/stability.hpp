// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "odeum/harness/case.hpp"
#include "odeum/report/output_folder.hpp"

namespace odeum::study {

/// A limit of stability along an axis: a line of stability_limits.csv. `limit` is measured on the
/// running code, `theory` comes from the method's own stability function (NaN: none).
struct StabilityLimit {
  std::string library, solver;
  std::string axis;  ///< real, imaginary, oscillator
  double limit = 0, theory = 0, difference = 0;
  std::string status;  ///< a Status, or not_applicable
  std::string detail;
};

/// Growth per step measured on a grid of a parameter plane, row by row from the lowest second
/// coordinate up; NaN where the solver failed.
struct StabilityRegion {
  std::string library, solver;
  std::string plane;  ///< lambda or oscillator
  std::string status, detail;
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
  int own_grid = 0;                  ///< points along an axis, own methods; 0: the default
  int peer_grid = 0;                 ///< and other libraries' solvers
  unsigned jobs = 1;
};

/// Stability regions and limits of every solver with a fixed step. Throws Interrupted.
StabilityResult measure_stability(const StabilityOptions& options,
                                  report::Journal* journal = nullptr);

/// stability_limits.csv, and stability/<library>_<solver>_<plane>.csv a region.
void write_csv(const StabilityResult& result, const report::OutputFolder& folder);

}  // namespace odeum::study
