// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/measure/run_record.hpp"

namespace odeum::measure {

void RunRecord::take_errors(const std::vector<judge::StopError>& errors) {
  if (errors.empty()) return;
  const judge::StopError all = judge::over_stops(errors);
  error = all.error_max;
  error_rms = all.error_rms;
  energy_error = all.energy_error;
}

judge::JudgedAnswer answer_of(const Request& request, const Outcome& outcome,
                              const std::vector<judge::StopError>& errors,
                              const judge::Amplification& amplification, double floor,
                              double scale) {
  return request.mode == Mode::fixed
             ? judge::judge_fixed_answer(errors, scale)
             : judge::judge_answer(errors, amplification, request.tolerance.relative,
                                   static_cast<double>(outcome.counters.steps), floor, scale);
}

}  // namespace odeum::measure
