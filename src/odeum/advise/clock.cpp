// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/advise/clock.hpp"

#include <algorithm>
#include <chrono>
#include <ctime>

#include "odeum/isolated/isolated_times.hpp"
#include "odeum/studies/stopwatch.hpp"

namespace odeum::advise {

Clock::Clock(std::function<double()> given)
    : given_(std::move(given)), used_before_(used()), wall_before_(wall()) {}

double Clock::wall() const {
  if (given_) return given_();
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double Clock::used() const {
  return given_ ? given_() : study::thread_seconds() - 1e-9 * isolated_times.isolation_ns;
}

double Clock::spent() const { return std::max(used() - used_before_, (wall() - wall_before_) / 3); }

double Clock::crowding() const {
  constexpr double shortest = 0.1, most = 10;
  const double passed = wall() - wall_before_;
  return passed < shortest ? 1 : std::clamp(passed / (used() - used_before_), 1.0, most);
}

double Clock::of(const std::function<void()>& work, double guess_ns) const {
  const double before = used();
  const double wall_ns =
      given_ ? (work(), 1e9 * (used() - before)) : study::time_call(work, guess_ns);
  // Other programs stretch the wall time of a long run.
  constexpr double long_ns = 1e7, in_this_thread = 0.05;
  const double own_ns = 1e9 * (used() - before);
  return wall_ns > long_ns && own_ns > in_this_thread * wall_ns ? std::min(own_ns, wall_ns)
                                                                : wall_ns;
}

double process_seconds() {
  timespec used{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
  return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

}  // namespace odeum::advise
