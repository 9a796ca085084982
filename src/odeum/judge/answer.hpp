// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <limits>
#include <string>
#include <vector>

#include "odeum/judge/amplification.hpp"
#include "odeum/judge/errors.hpp"
#include "odeum/record/row.hpp"

namespace odeum::judge {

/// The answer of a run, against the truth.
/// - `explained`: its error is what tolerance, steps and the case's amplification explain.
/// - `wrong`: it ended `ok`, and its error is larger, or of the size of the solution, see
///   explained_error; at a fixed step: ten times the solution's
///   size; in either case: it has a state past the end of the solution.
/// - `undetermined`: truth or amplification are not known, or the error is above the explained one
///   by less than that is known to.
/// - `none`: the run did not end `ok`, and so claims no answer.
/// - `not_applicable`: a fixed step, which promises no error; or no run.
enum class Answer { explained, wrong, undetermined, none, not_applicable };

const char* to_string(Answer answer);

struct JudgedAnswer {
  Answer answer = Answer::not_applicable;
  /// The largest error that is explained, at the stop where the error is largest in proportion to
  /// it; NaN where there is none.
  double explained = std::numeric_limits<double>::quiet_NaN();
  std::string reason;  ///< a sentence where the answer is wrong, undetermined or useless

  ODEUM_COLUMNS(answer, column("explained_error", explained), column("answer_reason", reason))
};

/// What a run of that tolerance and number of steps may miss the truth by: a controller holds the
/// error of each step to the tolerance, so that the sum over the steps, amplified, bounds the
/// error. A hundred are allowed in any case: an estimate may be ten times too small, and so may the
/// component that the controller's norm averages away. The bound is linear in the errors, and over
/// thousands of steps comes to the size of the solution, where it explains any answer. So more than
/// a hundred steps explain half of that size at most, unless the control, a method of order 5 or 8
/// at the same tolerance, is off by a hundredth of the error. `tolerance` is relative, `stop` an
/// index of `amplification.at_stops`; `floor` (of the truth), `scale` (Judge::scale) and the result
/// are in the units of the case's errors.
double explained_error(double tolerance, double steps, const Amplification& amplification,
                       std::size_t stop, double floor, double scale);

/// Whether a run has a state past the end of the solution, or an error of ten times the solution's
/// size.
bool has_diverged(const std::vector<StopError>& errors, double scale);

/// The answer of a run at a fixed step; units as in explained_error.
JudgedAnswer judge_fixed_answer(const std::vector<StopError>& errors, double scale);

/// The answer of a run to a tolerance; units as in explained_error. `errors`: one entry a stop, as
/// many as `amplification.at_stops`; `floor`: the truth's.
JudgedAnswer judge_answer(const std::vector<StopError>& errors, const Amplification& amplification,
                          double tolerance, double steps, double floor, double scale);

}  // namespace odeum::judge
