// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <vector>

#include "odeum/solvers/case.hpp"

/// The settings of runs, and those that measurements try.
namespace odeum {

/// What a setting is in this mode, as in columns of files.
inline const char* setting_kind(Mode mode) { return mode == Mode::fixed ? "step" : "tol"; }
/// The fixed step from t0 on.
inline double step_of(const Request& request, double t0) {
  return (request.stops.back() - t0) / static_cast<double>(request.steps);
}
/// The fixed step, or the relative tolerance.
inline double setting_of(const Request& request, double t0) {
  return request.mode == Mode::fixed ? step_of(request, t0) : request.tolerance.relative;
}
/// The larger, the finer: steps, or the inverse of the relative tolerance.
inline double fineness_of(const Request& request) {
  return request.mode == Mode::fixed ? static_cast<double>(request.steps)
                                     : 1 / request.tolerance.relative;
}

/// The multiple of `multiple` nearest to this number of steps, once it at least.
std::uint64_t nearest_multiple(double steps, std::uint64_t multiple);

/// Numbers of steps from coarse to fine: multiples of `multiple` near start * ratio^k for k below
/// `count`, none twice.
std::vector<std::uint64_t> step_ladder(double start, double ratio, int count,
                                       std::uint64_t multiple);

/// A tolerance as it is printed, so that the command of a row makes its run again.
double of_two_digits(double tolerance);

/// Relative tolerances from 1e-3 down to 1e-`finest`, by powers of ten; all else as in `request`.
std::vector<Request> tolerance_ladder(Request request, const Case& c, int finest);

}  // namespace odeum
