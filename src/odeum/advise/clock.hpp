// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <utility>

namespace odeum::advise {

/// The times of a race, in seconds. A test gives a time of its own, which its solvers move on.
class Clock {
 public:
  explicit Clock(std::function<double()> given = {});

  /// Processor time of this thread and of the runs in processes of their own, without what making
  /// these takes; its differences have a meaning.
  double used() const;
  /// What of an answer's seconds is spent since the clock was made: processor time, and where other
  /// programs have the processor a third of the wall time at least.
  double spent() const;
  /// Wall time over processor time since then, 1 to 10.
  double crowding() const;
  /// Nanoseconds of a call that takes about `guess_ns`, repeated where it is short.
  double of(const std::function<void()>& work, double guess_ns) const;

 private:
  double wall() const;

  std::function<double()> given_;
  double used_before_, wall_before_;
};

/// Processor time of all threads of this process.
double process_seconds();

}  // namespace odeum::advise
