// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "odeum/contest/case.hpp"

namespace odeum::cli {

/// The settings of one run.
struct RunSettings {
  /// One of them: a step, a tolerance, or a relative tolerance with absolute ones.
  std::optional<double> step, tolerance, relative;
  std::vector<double> absolute;  ///< by component, or one for all
  std::optional<double> until;
  std::optional<double> every;  ///< between outputs
};

/// Whether a step or a tolerance is given.
bool has_setting(const RunSettings& settings);
/// The settings for a case: without one the tolerance that its author asks for, and a tolerance
/// alone with the absolute ones of its thresholds.
RunSettings settings_for(const Case& c, RunSettings settings);
/// `rtol R, atol A`, or `R` where it is one number, for people.
std::string text_of_tolerance(const Request& request);

/// The request for a solver over [t0, until or `horizon`], with the only stop at the end;
/// `numbers`: the size of a state. A step that does not divide it is reduced, with a remark. Throws
/// UsageError for an invalid setting or one that the solver does not support.
Request make_request(const RunSettings& settings, double t0, double horizon, std::size_t numbers,
                     const SolverInfo& info);

/// Makes the request ask for states at times `every` apart too (by default at some 500), which do
/// not limit the steps of own adaptive solvers; at a fixed step at the nearest whole steps, with a
/// remark where that is another interval. `numbers`: the size of a state. Throws UsageError for an
/// invalid interval, and where the states are too many to keep.
void ask_for_output(Request& request, const RunSettings& settings, double t0, std::size_t numbers);

}  // namespace odeum::cli
