// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <charconv>
#include <cmath>

#include "odeum/studies/convergence/convergence.hpp"

namespace odeum::study {
namespace {

double rounded(double value, int digits) {
  if (!std::isfinite(value)) return value;
  std::array<char, 40> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                 std::chars_format::scientific, digits - 1)
                       .ptr;
  std::from_chars(text.data(), end, value);
  return value;
}

}  // namespace

TimeRow time_row(const ConvergenceRow& run, const judge::StopError& stop) {
  return {.case_id = run.case_id,
          .library = run.library,
          .solver = run.solver,
          .mode = run.mode,
          .step = run.step,
          .time = stop.time,
          .error_max = rounded(stop.error_max, 6),
          .error_rms = rounded(stop.error_rms, 6),
          .energy = rounded(stop.energy, 9),
          .energy_error = rounded(stop.energy_error, 6)};
}

}  // namespace odeum::study
