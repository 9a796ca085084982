// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "odeum/judge/growth.hpp"
#include "odeum/solvers/case.hpp"

namespace odeum::measure {

/// The case that has a plane of this kind, see Probe.
const Case& case_with_plane(const std::string& plane);

/// Lengths of runs: `first_steps`, then four times as many up to `last_steps` until the growth is
/// clear.
struct RunLength {
  std::uint64_t first_steps, last_steps;
};
/// Runs for a limit, measured to 1e-6, and for one of the many points of a region.
inline constexpr RunLength limit_length{.first_steps = 64, .last_steps = 8192};
inline constexpr RunLength region_length{.first_steps = 32, .last_steps = 512};

/// Measures the growth of one solver anywhere on the plane of a probe: it solves at h = 1 from the
/// probe's start, and measures the growth on the states of the run, without theory. Not
/// thread-safe, since the probe's parameters are changed.
class GrowthMeter {
 public:
  /// On the oscillator planes the first parameter is omega, which scales q to the size of q'.
  GrowthMeter(const Probe& probe, const Entrant& entrant, bool oscillator, RunLength length);

  judge::Growth measure(double first, double second);

  /// The status of the last solve of measure().
  Status status() const { return status_; }
  /// Its detail, beginning with the status.
  std::string failure() const;

 private:
  /// States after 0, 1, ..., n steps, or (n large) after the last `window` of them.
  bool run(std::uint64_t steps, double scale);

  const Probe& probe_;
  const Entrant& entrant_;
  bool oscillator_;
  RunLength length_;
  /// A state below it has decayed: the remainder may be of the size of an implicit solver's
  /// tolerance, and its growth is not the method's. Not for multistep methods, whose start may
  /// decay before the growing roots show.
  double decayed_below_;
  Request request_;
  std::vector<judge::PlaneState> states_;
  Status status_ = Status::ok;
  std::string detail_;
};

}  // namespace odeum::measure
