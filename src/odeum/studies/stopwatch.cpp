// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/stopwatch.hpp"

#ifdef __linux__
#include <sched.h>
#endif

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>

#include "odeum/core/clocks.hpp"
#include "odeum/core/machine.hpp"
#include "odeum/core/numbers.hpp"
#include "odeum/isolated/isolated_times.hpp"
#include "odeum/record/row.hpp"

namespace odeum::study {
namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) {
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count();
}

}  // namespace

#ifdef __linux__
Pinned::Pinned() {
  cpu_set_t before, one;
  if (sched_getaffinity(0, sizeof before, &before) != 0) return;
  const int here = sched_getcpu();
  if (here < 0) return;
  CPU_ZERO(&one);
  CPU_SET(static_cast<unsigned>(here), &one);
  if (sched_setaffinity(0, sizeof one, &one) != 0) return;
  before_.resize(sizeof before);
  std::memcpy(before_.data(), &before, sizeof before);
}

Pinned::~Pinned() {
  if (before_.empty()) return;
  cpu_set_t before;
  std::memcpy(&before, before_.data(), sizeof before);
  sched_setaffinity(0, sizeof before, &before);
}
#else
Pinned::Pinned() = default;
Pinned::~Pinned() = default;
#endif

Conditions ConditionsMeter::end() const {
  return {.drift = calibration_ns() / before_ - 1,
          .processor_share = 1e9 * (thread_seconds() - used_) / since(start_),
          .measured = utc_text(std::chrono::system_clock::now())};
}

bool disturbed(const Conditions& conditions) {
  return std::abs(conditions.drift) > most_disturbance ||
         conditions.processor_share < 1 - most_disturbance;
}

double calibration_ns() {
  double least = infinity;
  for (int run = 0; run < 9; ++run) {
    // Four chains of the logistic map: dependent arithmetic, as a trajectory is.
    double x[4] = {0.1, 0.2, 0.3, 0.4};
    const auto start = Clock::now();
    for (int i = 0; i < 100'000; ++i)
      for (double& chain : x) chain = 3.7 * chain * (1 - chain);
    const double taken = since(start);
    volatile double kept = x[0] + x[1] + x[2] + x[3];  // or the compiler drops the work
    static_cast<void>(kept);
    least = std::min(least, taken);
  }
  return least;
}

double thread_seconds() { return processor_seconds() + isolated_times.processor_s; }

double Times::min() const { return ns.empty() ? nan : *std::ranges::min_element(ns); }

double Times::median() const {
  if (ns.empty()) return nan;
  std::vector<double> sorted = ns;
  std::ranges::sort(sorted);
  const std::size_t middle = sorted.size() / 2;
  return sorted.size() % 2 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
}

double time_call(const std::function<void()>& work, double guess_ns) {
  constexpr double shortest_ns = 20'000;
  const auto calls =
      static_cast<int>(std::clamp(std::ceil(shortest_ns / std::max(guess_ns, 1.0)), 1.0, 1000.0));
  const double isolation = isolated_times.isolation_ns;
  const auto start = Clock::now();
  for (int i = 0; i < calls; ++i) work();
  return (since(start) - (isolated_times.isolation_ns - isolation)) / calls;
}

}  // namespace odeum::study
