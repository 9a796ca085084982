// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string>

#include "odeum/core/outcome.hpp"

namespace odeum::isolated {

/// Numbers of events that are handed back, at most: times, which ones, states before and after.
inline constexpr std::size_t event_room = 1U << 20U;

/// What a process hands back, in memory that it shares with the one that waits; states follow it,
/// then events.
struct Report {
  std::atomic<std::uint64_t> signs{0};  ///< of work
  std::atomic<std::uint64_t> evaluations{0}, jacobians{0};
  std::atomic<bool> done{false};
  int status = 0;
  double t = 0;
  Counters counters;
  std::uint64_t states = 0, events = 0;
  double solve_ns = 0, processor_s = 0;
  char detail[2000] = {};

  void say(const std::string& text);
  double* values() { return reinterpret_cast<double*>(this + 1); }
};

/// The outcome with at most `room` numbers of its states; step ends are left out.
void write_result(const Outcome& outcome, std::size_t room, Report& report);
/// The same, of states of n components.
Outcome read_result(Report& report, std::size_t room, std::size_t n);

}  // namespace odeum::isolated
