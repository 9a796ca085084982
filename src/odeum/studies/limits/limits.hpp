// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <complex>
#include <functional>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include "odeum/studies/study.hpp"

namespace odeum::study {

/// The largest stable step of one solver on one case: a line of largest_steps.csv.
struct LargestStep {
  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  std::string case_id, library, solver;
  std::string status;  ///< ok, a Status where no step was bounded, or not_applicable
  std::string detail;
  double largest_stable_step = nan;
  /// What the method's stability function allows for the eigenvalues of the Jacobian along the
  /// solution; infinity: any step; NaN: no function is known.
  double predicted_step = nan;
  /// The eigenvalue that sets the prediction; without one, the largest.
  std::complex<double> eigenvalue{nan, nan};
  double window = nan;  ///< how long the runs are

  static constexpr const char* file = "largest_steps.csv";
  static void each(auto& row, auto&& visit) {
    visit("case", row.case_id), visit("library", row.library), visit("solver", row.solver);
    visit("status", row.status), visit("detail", row.detail);
    visit("largest_stable_step", row.largest_stable_step);
    visit("predicted_step", row.predicted_step), visit("eigenvalue", row.eigenvalue);
    visit("window", row.window);
  }
};

struct LimitsResult {
  std::vector<LargestStep> rows;
  static auto lists(auto& result) { return std::tie(result.rows); }
};

/// The largest stable step of every fitting pair, to within 0.5 % or one step in the window. No
/// choice of cases: those tagged `stiff`.
///
/// A run is bounded where it ends `ok` and at each quarter of the window no component is beyond ten
/// times the largest that it has along the solution. The window is the case's horizon, halved
/// until it is below 20,000 / |largest eigenvalue in it|: growth shows, and the search is short.
/// The solution in it is followed by Radau IIA to 1e-8, which says where to take the spectrum and
/// how large the components are; nothing is judged by it. Throws Interrupted.
LimitsResult measure_limits(const Options& options, const Runner& runner = Runner());

/// The number of steps, a multiple of 4, from which on a run is bounded: doubled from 4 until it is
/// bounded twice in a row, then bisected. 0 where it is not with `most` steps.
std::uint64_t fewest_bounded_steps(const std::function<bool(std::uint64_t steps)>& bounded,
                                   std::uint64_t most);

}  // namespace odeum::study
