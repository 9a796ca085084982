// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "odeum/contest/case.hpp"
#include "odeum/judge/growth.hpp"

namespace odeum::study {

/// How many steps a solver takes: `first_steps`, and four times as many again and again up to
/// `last_steps` until its growth is clear.
struct RunLength {
  std::uint64_t first_steps, last_steps;
};
/// For a limit, to be found to 1e-6, and for one point of many of a region.
inline constexpr RunLength limit_length{.first_steps = 64, .last_steps = 8192};
inline constexpr RunLength region_length{.first_steps = 32, .last_steps = 512};

/// Measures the growth of one solver anywhere on the plane of a probe: it solves at h = 1 from the
/// probe's start, and the growth is read off the states of the run, never off the method's theory.
/// Not safe to share between threads, since the probe is moved.
class GrowthMeter {
 public:
  /// On the oscillator planes the first parameter is omega, which scales q to the size of q'.
  GrowthMeter(const Probe& probe, const Entrant& entrant, bool oscillator, RunLength length);

  judge::Growth measure(double first, double second);

  /// How the solve of the last measure() ended.
  Status status() const { return status_; }
  /// Its detail, with the status in front where the detail does not begin with it.
  std::string failure() const;

 private:
  /// States after 0, 1, ..., n steps, or (n large) after the last `window` of them.
  bool run(std::uint64_t steps, double scale);

  const Probe& probe_;
  const Entrant& entrant_;
  bool oscillator_;
  RunLength length_;
  /// A state that has fallen below it has decayed, whatever comes later: what is left of it may be
  /// of the size of the tolerance of an implicit solver, and its growth is not the method's any
  /// more. A multistep method is not judged so soon: its start may die away before its own roots
  /// show.
  double decayed_below_;
  Request request_;
  std::vector<judge::PlaneState> states_;
  Status status_ = Status::ok;
  std::string detail_;
};

}  // namespace odeum::study
