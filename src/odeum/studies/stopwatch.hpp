// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <chrono>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

/// How a time is taken.
namespace odeum::study {

/// Keeps the calling thread on the processor that it is on, where the system can, until the end of
/// its life: a thread that moves finds cold caches and another clock frequency.
class Pinned {
 public:
  Pinned();
  ~Pinned();
  Pinned(const Pinned&) = delete;
  Pinned& operator=(const Pinned&) = delete;
  bool held() const { return held_; }

 private:
  bool held_ = false;
  std::vector<unsigned char> before_;
};

/// Nanoseconds that a fixed piece of arithmetic takes now, the least of several runs: what the
/// machine was like when the times beside it were taken.
double calibration_ns();

/// Seconds of processor time that the calling thread has used so far. Over a stretch of work, its
/// quotient with wall time tells whether another program took the processor in between, which a
/// calibration between two such moments does not see.
double thread_seconds();

/// What the machine was like while times were taken, see PrecisionRow.
struct Conditions {
  double drift = std::numeric_limits<double>::quiet_NaN();
  double processor_share = std::numeric_limits<double>::quiet_NaN();
  std::string measured;  ///< when, UTC
};

/// Beyond this drift of the machine's speed, or this loss of the processor to others, times are
/// marked as disturbed.
inline constexpr double most_disturbance = 0.05;
/// False where nothing was timed.
bool disturbed(double drift, double processor_share);

/// Measures the conditions from its construction on.
class ConditionsMeter {
 public:
  Conditions end() const;

 private:
  double before_ = calibration_ns(), used_ = thread_seconds();
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Wall times of one thing, taken at different moments.
struct Times {
  std::vector<double> ns;

  double min() const;     ///< NaN where there is none
  double median() const;  ///< NaN where there is none
};

/// Wall time of one call of work, in nanoseconds; short work is called as often as fills 20
/// microseconds, `guess_ns` being what a call is thought to take.
double time_call(const std::function<void()>& work, double guess_ns);

}  // namespace odeum::study
