// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/isolated/isolated_process.hpp"

#include <poll.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <ctime>
#include <exception>
#include <new>

#include <fmt/format.h>

#include "odeum/core/clocks.hpp"
#include "odeum/core/interrupt.hpp"
#include "odeum/core/machine.hpp"
#include "odeum/isolated/child_process.hpp"
#include "odeum/isolated/isolated_times.hpp"

namespace odeum::isolated {
namespace {

using Clock = std::chrono::steady_clock;

/// Numbers of events that are handed back, at most: times, which ones, states before and after.
constexpr std::size_t event_room = 1U << 20U;

/// What the process hands back, in memory that both share; states follow it, then events.
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

  void say(const std::string& text) {
    const std::size_t n = std::min(text.size(), sizeof detail - 1);
    std::memcpy(detail, text.data(), n);
    detail[n] = 0;
  }
  double* values() { return reinterpret_cast<double*>(this + 1); }
};

Report* own_report = nullptr;

/// Waits a little for a process to end; true: it has.
bool ended(pid_t process, int descriptor, int& state) {
  if (descriptor >= 0) {
    pollfd wait{.fd = descriptor, .events = POLLIN, .revents = 0};
    poll(&wait, 1, 100);
  } else {
    const timespec pause{0, 1'000'000};
    nanosleep(&pause, nullptr);
  }
  return waitpid(process, &state, WNOHANG) == process;
}

/// Waits until the process ends or has to be ended; how, in a sentence; empty: it is done.
std::string wait_for(pid_t process, Report& report, double seconds, bool& over_budget) {
  const int descriptor = static_cast<int>(syscall(SYS_pidfd_open, process, 0));
  const auto start = Clock::now();
  auto last_sign = start;
  const double silence = longest_silence();
  std::uint64_t signs = 0;
  std::string why;
  int state = 0;
  while (!ended(process, descriptor, state)) {
    if (const std::uint64_t now = report.signs; now != signs) {
      signs = now;
      last_sign = Clock::now();
    }
    if (interrupted)
      why = "interrupted";
    else if (seconds_since(last_sign) > silence)
      why = fmt::format(
          "foreign code evaluated no right-hand side within its budget for {} s, or went on at one "
          "time for ever, and was ended",
          silence);
    else if (seconds_since(start) > seconds + silence)
      why = fmt::format("foreign code did not return within {} s after the budget and was ended",
                        silence);
    if (why.empty()) continue;
    over_budget = true;
    end_child(process);
    break;
  }
  if (descriptor >= 0) close(descriptor);
  if (!why.empty()) return why;
  if (WIFSIGNALED(state))
    return fmt::format("foreign code crashed: {} (signal {})", strsignal(WTERMSIG(state)),
                       WTERMSIG(state));
  if (!report.done)
    return fmt::format("foreign code ended its process with exit code {}", WEXITSTATUS(state));
  return {};
}

/// The work in a process of its own, see wait_for. The process ends with the thread that waits.
std::string run_isolated(Report& report, double seconds, bool& over_budget,
                         const std::function<void()>& work) {
  const pid_t process = start_child(Lifetime::thread, [&] {
    own_report = &report;
    try {
      work();
    } catch (const std::exception& error) {
      report.status = static_cast<int>(Status::refused);
      report.say(fmt::format("foreign code threw {}", error.what()));
    } catch (...) {
      report.status = static_cast<int>(Status::refused);
      report.say("foreign code threw an object that does not derive from std::exception");
    }
    report.done = true;
  });
  return process > 0 ? wait_for(process, report, seconds, over_budget)
                     : fmt::format("no process could be made: {}", std::strerror(errno));
}

/// Solves until the memory of the new process is in place and the caches are as in a process that
/// has worked for a while, for short solves some tenths of a millisecond.
void warm_up(const std::function<Outcome(const Request&)>& solve, const Request& request) {
  const auto start = Clock::now();
  do solve(request);
  while (seconds_since(start) < 3e-4);
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

}  // namespace

double longest_silence() { return number_of_environment("ODEUM_SILENCE_SECONDS", 5); }

bool in_isolated_process() { return own_report != nullptr; }
void alive(Sign sign) {
  if (!own_report) return;
  own_report->signs.fetch_add(1, std::memory_order_relaxed);
  if (sign == Sign::evaluation) own_report->evaluations.fetch_add(1, std::memory_order_relaxed);
  if (sign == Sign::jacobian) own_report->jacobians.fetch_add(1, std::memory_order_relaxed);
}
void alive(const Guard& guard) {
  if (!own_report) return;
  alive();
  own_report->evaluations.store(guard.rhs_evaluations(), std::memory_order_relaxed);
  own_report->jacobians.store(guard.jacobian_evaluations(), std::memory_order_relaxed);
}

Outcome solve_isolated(const std::function<Outcome(const Request&)>& solve, const Request& request,
                       std::size_t dimension, Ended& ended) {
  if (in_isolated_process()) return solve(request);
  if (ended >= most_ended)
    return refused(fmt::format(
        "not run, since {} runs before, one after the other, had to be ended for their silence",
        most_ended));
  const auto start = Clock::now();
  const double used = processor_seconds();
  const std::size_t room = request.stops.size() * dimension;
  const SharedMemory memory(sizeof(Report) + (room + event_room) * sizeof(double));
  Report& report = *new (memory.get()) Report;
  bool over_budget = false;
  const std::string why = run_isolated(report, request.budget.seconds, over_budget, [&] {
    if (!request.budget.watched) warm_up(solve, request);
    const double used_before = processor_seconds();
    const auto begun = Clock::now();
    const Outcome outcome = solve(request);
    report.solve_ns = 1e9 * seconds_since(begun);
    report.processor_s = processor_seconds() - used_before;
    write_result(outcome, room, report);
  });
  if (over_budget && !interrupted)
    ++ended;
  else
    ended = 0;
  Outcome outcome = read_result(report, room, dimension);
  if (!why.empty()) {
    outcome.status = over_budget ? Status::over_budget : Status::refused;
    outcome.detail = why;
    outcome.states.clear();
    if (!report.done && request.budget.watched) {
      outcome.counters.rhs_evaluations = outcome.counters.work = report.evaluations;
      outcome.counters.jacobian_evaluations = report.jacobians;
    }
  }
  const double isolation = 1e9 * seconds_since(start) - report.solve_ns;
  isolated_times.isolation_ns += isolation;
  isolated_times.processor_s +=
      1e-9 * isolation - (processor_seconds() - used) + report.processor_s;
  return outcome;
}

std::pair<bool, std::string> text_isolated(const std::function<std::string()>& work,
                                           std::size_t room, double seconds) {
  const SharedMemory memory(sizeof(Report) + room);
  Report& report = *new (memory.get()) Report;
  bool over_budget = false;
  const std::string why = run_isolated(report, seconds, over_budget, [&] {
    const std::string text = work();
    report.states = std::min(text.size(), room);
    std::memcpy(report.values(), text.data(), report.states);
  });
  if (!why.empty()) return {false, why};
  if (report.detail[0] != 0) return {false, report.detail};
  return {true, std::string(reinterpret_cast<const char*>(report.values()),
                            std::min<std::size_t>(report.states, room))};
}

}  // namespace odeum::isolated
