// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <complex>
#include <functional>
#include <string>
#include <tuple>
#include <vector>

#include "odeum/studies/study.hpp"

namespace odeum::study {

/// The largest stable step of one solver on one case: a line of largest_steps.csv.
struct LargestStep {
  std::string case_id, library, solver;
  std::string status;  ///< ok, a Status where no step was bounded, or not_applicable
  std::string detail;
  double largest_stable_step = nan;
  /// The step that the method's stability function allows for the eigenvalues of the Jacobian along
  /// the solution; infinity: any step; NaN: no function is known.
  double predicted_step = nan;
  /// The eigenvalue that limits the step; without a prediction, the largest.
  std::complex<double> eigenvalue{nan, nan};
  double window = nan;  ///< length of the runs

  static constexpr const char* file = "largest_steps.csv";
  static constexpr const char* shown =
      "case solver largest_stable_step predicted_step eigenvalue status";
  ODEUM_COLUMNS(case_id, library, solver, status, detail, largest_stable_step, predicted_step,
                eigenvalue, window)
};

struct LimitsResult {
  std::vector<LargestStep> rows;
  static auto lists(auto& result) { return std::tie(result.rows); }
};

/// The largest stable step of every fitting pair, to within 0.5 % or one step in the window. No
/// choice of cases: those tagged `stiff`.
///
/// A run is bounded where it ends `ok` and at each quarter of the window no component exceeds ten
/// times its maximum along the solution. The window is the case's horizon, halved until it is below
/// 20,000 / |largest eigenvalue in it|: growth shows, and the search is short. A solution by Radau
/// IIA to 1e-8 gives the points of the spectrum and the sizes of the components; it is not used as
/// a truth. Throws Interrupted.
LimitsResult measure_limits(const Options& options, const Runner& runner = Runner());

/// The number of steps, a multiple of 4, from which on a run is bounded: doubled from 4 until it is
/// bounded twice in a row, then bisected. 0 where it is not with `most` steps.
std::uint64_t fewest_bounded_steps(const std::function<bool(std::uint64_t steps)>& bounded,
                                   std::uint64_t most);

}  // namespace odeum::study
