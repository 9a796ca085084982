// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "odeum/truth/system.hpp"

namespace odeum::truth {

Run run_across(Method method, const System& system, const std::vector<Real>& times,
               const Effort& effort, bool moved) {
  if (!system.mode_at) return method(system, times, effort);
  constexpr int most_at_once = 8;  // changes at one time
  constexpr double work_of_change = 1e4;
  Run whole;
  whole.split = true;
  Real t = system.t0;
  State y = moved ? system.moved_y0 : system.y0;
  std::vector<Real> left = times;
  for (int at_once = 0; !left.empty();) {
    const std::shared_ptr<System> mode = system.mode_at(t, y, times.back() - system.t0, moved);
    if (!mode || at_once > most_at_once) {
      whole.end = fmt::format("{} t = {:.9Lg}",
                              mode ? "conditions change ever faster at"
                                   : "the solution stays where a condition changes, from",
                              t);
      return whole;
    }
    mode->t0 = t;
    mode->y0 = y;
    mode->along = system.along;
    // Equations with more operations than a series is made for.
    const Method used = method == taylor_run && !mode->taylor ? extrapolation_run : method;
    Effort of_part = effort;
    of_part.budget -= whole.work;
    of_part.inspect = true;
    Run part = used(*mode, left, of_part);
    whole.work += part.work + work_of_change;
    left.erase(left.begin(), left.begin() + static_cast<std::ptrdiff_t>(part.states.size()));
    std::move(part.states.begin(), part.states.end(), std::back_inserter(whole.states));
    if (!part.changed) {
      whole.end = std::move(part.end);
      whole.ends_at = part.ends_at;
      return whole;
    }
    at_once = part.changed->first - t > 0x1p-38L * (times.back() - system.t0) ? 0 : at_once + 1;
    t = part.changed->first;
    y = std::move(part.changed->second);
  }
  return whole;
}

}  // namespace odeum::truth
