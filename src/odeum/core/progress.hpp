// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <chrono>
#include <mutex>
#include <string>

namespace odeum {

/// A line on stderr with the progress of long work and the time left; silent unless stderr is a
/// terminal. Safe to call from several threads.
class Progress {
 public:
  /// `total` is in any unit of work, the same as advance() takes.
  Progress(std::string what, double total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void advance(double amount = 1);

 private:
  using Clock = std::chrono::steady_clock;

  std::string what_;
  double total_, done_ = 0;
  bool visible_;
  Clock::time_point start_ = Clock::now(), drawn_ = start_;
  std::mutex mutex_;
};

}  // namespace odeum
