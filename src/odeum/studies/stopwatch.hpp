// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "odeum/core/numbers.hpp"
#include "odeum/record/row.hpp"

/// Measurement of times.
namespace odeum::study {

/// Pins the calling thread to its present processor, where the system can, for the lifetime of the
/// object: another processor has cold caches and another clock frequency.
class Pinned {
 public:
  Pinned();
  ~Pinned();
  Pinned(const Pinned&) = delete;
  Pinned& operator=(const Pinned&) = delete;

 private:
  std::vector<unsigned char> before_;  ///< where it ran; empty: not pinned
};

/// Nanoseconds of a fixed piece of arithmetic, the least of several runs: a measure of the
/// machine's present speed.
double calibration_ns();

/// Seconds of processor time that the calling thread, and processes that it waited for (see
/// isolated/isolated_times.hpp), have used so far. Its quotient with wall time
/// shows whether another program had the processor in between, which calibrations before and after
/// do not.
double thread_seconds();

/// The conditions of the machine while times were taken.
struct Conditions {
  /// How its own speed changed from before to after, as a fraction: an effect of other programs on
  /// times. NaN where nothing was timed.
  double drift = nan;
  /// Processor time over wall time: 1 where no other program ran. NaN where nothing was timed.
  double processor_share = nan;
  std::string measured;  ///< when, UTC

  ODEUM_COLUMNS(drift, processor_share, measured)
};

/// Beyond this drift of the machine's speed, or this loss of the processor to others, times are
/// marked as disturbed.
inline constexpr double most_disturbance = 0.05;
/// False where nothing was timed.
bool disturbed(const Conditions& conditions);

/// Measures the conditions since its construction.
class ConditionsMeter {
 public:
  Conditions end() const;

 private:
  double before_ = calibration_ns(), used_ = thread_seconds();
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// The columns of wall times of one piece of work.
struct WallTimes {
  double wall_ns_min = nan, wall_ns_median = nan;
  std::uint64_t repetitions = 0;
};

/// Wall times of one piece of work, taken at different times.
struct Times {
  std::vector<double> ns;

  double min() const;     ///< NaN where there is none
  double median() const;  ///< NaN where there is none
  /// The columns of one of so many equal parts of the work.
  WallTimes columns(double parts = 1) const { return {min() / parts, median() / parts, ns.size()}; }
};

/// Wall time of one call of work, in nanoseconds, without that of making processes; short work is
/// repeated to fill 20 microseconds, with `guess_ns` the estimated time of a call.
double time_call(const std::function<void()>& work, double guess_ns);

}  // namespace odeum::study
