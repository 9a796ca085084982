// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/isolated/waiting.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>
#include <ctime>

#include "odeum/core/clocks.hpp"
#include "odeum/core/interrupt.hpp"
#include "odeum/isolated/child_process.hpp"
#include "odeum/isolated/isolated_times.hpp"

namespace odeum::isolated {
namespace {

using Clock = std::chrono::steady_clock;

/// How a process ended that was not ended by this one; empty: it is done.
std::string said_of(int state, const Report& report) {
  if (WIFSIGNALED(state))
    return fmt::format("foreign code crashed: {} (signal {})", strsignal(WTERMSIG(state)),
                       WTERMSIG(state));
  if (!report.done)
    return fmt::format("foreign code ended its process with exit code {}", WEXITSTATUS(state));
  return {};
}

/// Solves until the memory of the new process is in place and the caches are as in a process that
/// has worked for a while, for short solves some tenths of a millisecond.
void warm_up(const std::function<Outcome(const Request&)>& solve, const Request& request) {
  const auto start = Clock::now();
  do solve(request);
  while (seconds_since(start) < 3e-4);
}

}  // namespace

OwnWorker::OwnWorker(pid_t process)
    : process_(process), descriptor_(static_cast<int>(syscall(SYS_pidfd_open, process, 0))) {}

OwnWorker::~OwnWorker() {
  if (descriptor_ >= 0) close(descriptor_);
}

bool OwnWorker::ended(int& state) {
  if (descriptor_ >= 0) {
    pollfd wait{.fd = descriptor_, .events = POLLIN, .revents = 0};
    poll(&wait, 1, 100);
  } else {
    const timespec pause{0, 1'000'000};
    nanosleep(&pause, nullptr);
  }
  return waitpid(process_, &state, WNOHANG) == process_;
}

void OwnWorker::end() { end_child(process_); }

std::string wait_for(Worker& worker, Report& report, double seconds, bool& over_budget,
                     double silence) {
  const auto start = Clock::now();
  auto last_sign = start;
  std::uint64_t signs = 0;
  std::string why;
  int state = 0;
  while (!worker.ended(state)) {
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
    worker.end();
    return why;
  }
  return said_of(state, report);
}

void solve_for(Report& report, const std::function<Outcome(const Request&)>& solve,
               const Request& request, std::size_t room) {
  if (!request.budget.watched) warm_up(solve, request);
  const double used_before = processor_seconds();
  const auto begun = Clock::now();
  const Outcome outcome = solve(request);
  report.solve_ns = 1e9 * seconds_since(begun);
  report.processor_s = processor_seconds() - used_before;
  write_result(outcome, room, report);
}

Waited::Waited() : start_(Clock::now()), used_(processor_seconds()) {}

Outcome Waited::outcome(Report& report, const Request& request, std::size_t dimension,
                        const std::string& why, bool over_budget, Ended& ended) const {
  if (over_budget && !interrupted)
    ++ended;
  else
    ended = 0;
  Outcome outcome = read_result(report, request.stops.size() * dimension, dimension);
  if (!why.empty()) {
    outcome.status = over_budget ? Status::over_budget : Status::refused;
    outcome.detail = why;
    outcome.states.clear();
    if (!report.done && request.budget.watched) {
      outcome.counters.rhs_evaluations = outcome.counters.work = report.evaluations;
      outcome.counters.jacobian_evaluations = report.jacobians;
    }
  }
  const double isolation = 1e9 * seconds_since(start_) - report.solve_ns;
  isolated_times.isolation_ns += isolation;
  isolated_times.processor_s +=
      1e-9 * isolation - (processor_seconds() - used_) + report.processor_s;
  return outcome;
}

}  // namespace odeum::isolated
