// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/solvers/settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace odeum {

std::uint64_t nearest_multiple(double steps, std::uint64_t multiple) {
  const auto times = std::llround(steps / static_cast<double>(multiple));
  return multiple * static_cast<std::uint64_t>(std::max(times, 1LL));
}

std::vector<std::uint64_t> step_ladder(double start, double ratio, int count,
                                       std::uint64_t multiple) {
  std::vector<std::uint64_t> ladder;
  for (int k = 0; k < count; ++k) {
    const std::uint64_t steps = nearest_multiple(start * std::pow(ratio, k), multiple);
    if (ladder.empty() || steps > ladder.back()) ladder.push_back(steps);
  }
  return ladder;
}

double of_two_digits(double tolerance) { return std::stod(fmt::format("{:.1e}", tolerance)); }

std::vector<Request> tolerance_ladder(Request request, const Case& c, int finest) {
  std::vector<Request> requests;
  for (int exponent = 3; exponent <= finest; ++exponent) {
    set_tolerance(request, c, std::pow(10.0, -exponent));
    requests.push_back(request);
  }
  return requests;
}

}  // namespace odeum
