// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/isolated/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace odeum::isolated {

void Report::say(const std::string& text) {
  const std::size_t n = std::min(text.size(), sizeof detail - 1);
  std::memcpy(detail, text.data(), n);
  detail[n] = 0;
}

void write_result(const Outcome& outcome, std::size_t room, Report& report) {
  report.status = static_cast<int>(outcome.status);
  report.t = outcome.t;
  report.counters = outcome.counters;
  report.states = std::min(outcome.states.size(), room);
  std::copy_n(outcome.states.data(), report.states, report.values());
  double* to = report.values() + room;
  const double* const end = to + event_room;
  for (const EventMet& met : outcome.events) {
    const std::size_t n = met.before.size();
    if (static_cast<std::size_t>(end - to) < 2 + 2 * n) break;
    *to++ = met.t;
    *to++ = static_cast<double>(met.event);
    to = std::ranges::copy(met.before, to).out;
    to = std::ranges::copy(met.after, to).out;
    ++report.events;
  }
  std::string detail = outcome.detail;
  if (report.events < outcome.events.size())
    detail += fmt::format("{}the first {} of {} events are told", detail.empty() ? "" : "; ",
                          report.events, outcome.events.size());
  report.say(detail);
}

Outcome read_result(Report& report, std::size_t room, std::size_t n) {
  Outcome outcome;
  outcome.status =
      static_cast<Status>(std::clamp(report.status, 0, static_cast<int>(Status::refused)));
  outcome.t = report.t;
  outcome.counters = report.counters;
  const std::size_t states = std::min<std::size_t>(report.states, room);
  outcome.states.assign(report.values(), report.values() + states);
  const double* from = report.values() + room;
  for (std::uint64_t k = 0; k < std::min<std::uint64_t>(report.events, event_room / (2 + 2 * n));
       ++k, from += 2 + 2 * n)
    outcome.events.push_back({from[0],
                              static_cast<std::size_t>(from[1]),
                              {from + 2, from + 2 + n},
                              {from + 2 + n, from + 2 + 2 * n}});
  report.detail[sizeof report.detail - 1] = 0;
  outcome.detail = report.detail;
  return outcome;
}

}  // namespace odeum::isolated
