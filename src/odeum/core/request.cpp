// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/core/request.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace odeum {

void require_sound(const Request& request, double t0, std::size_t dimension) {
  if (request.stops.empty()) throw std::invalid_argument("a request needs a stop");
  double before = t0;
  for (const double stop : request.stops) {
    if (!std::isfinite(stop) || !(stop > before))
      throw std::invalid_argument(
          fmt::format("stop t = {} does not come after t = {}", stop, before));
    before = stop;
  }
  if (request.mode == Mode::fixed && request.steps == 0)
    throw std::invalid_argument("a run at a fixed step needs a number of steps");
  if (request.mode != Mode::adaptive) return;
  const double relative = request.tolerance.relative;
  const std::vector<double>& absolutes = request.tolerance.absolutes();
  if (!(relative > 0 && std::isfinite(relative)))
    throw std::invalid_argument(
        fmt::format("a tolerance of {} is not positive and finite", relative));
  for (const double each : absolutes)
    if (!(each > 0 && std::isfinite(each)))
      throw std::invalid_argument(
          fmt::format("an absolute tolerance of {} is not positive and finite", each));
  if (request.tolerance.by_component() && absolutes.size() != dimension)
    throw std::invalid_argument(fmt::format(
        "{} absolute tolerances for a state of {} numbers: give one for all, or one for each",
        absolutes.size(), dimension));
}

}  // namespace odeum
