// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/isolated/isolated_process.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <exception>
#include <new>

#include "odeum/core/machine.hpp"
#include "odeum/isolated/child_process.hpp"
#include "odeum/isolated/waiting.hpp"

namespace odeum::isolated {
namespace {

Report* own_report = nullptr;

/// The work in a process of its own, see wait_for. The process ends with the thread that waits.
std::string run_isolated(Report& report, double seconds, bool& over_budget, double silence,
                         const std::function<void()>& work) {
  const pid_t process = start_child(Lifetime::thread, [&] { work_isolated(report, work); });
  if (process <= 0) return fmt::format("no process could be made: {}", std::strerror(errno));
  OwnWorker worker(process);
  return wait_for(worker, report, seconds, over_budget, silence);
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

void work_isolated(Report& report, const std::function<void()>& work) {
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
}

Outcome not_run() {
  return refused(fmt::format(
      "not run, since {} runs before, one after the other, had to be ended for their silence",
      most_ended));
}

Outcome solve_isolated(const std::function<Outcome(const Request&)>& solve, const Request& request,
                       std::size_t dimension, Ended& ended) {
  if (in_isolated_process()) return solve(request);
  if (ended >= most_ended) return not_run();
  const Waited waited;
  const std::size_t room = request.stops.size() * dimension;
  const SharedMemory memory(sizeof(Report) + (room + event_room) * sizeof(double));
  Report& report = *new (memory.get()) Report;
  bool over_budget = false;
  const std::string why =
      run_isolated(report, request.budget.seconds, over_budget, longest_silence(),
                   [&] { solve_for(report, solve, request, room); });
  return waited.outcome(report, request, dimension, why, over_budget, ended);
}

std::pair<bool, std::string> text_isolated(const std::function<std::string()>& work,
                                           std::size_t room, double seconds, double silence) {
  const SharedMemory memory(sizeof(Report) + room);
  Report& report = *new (memory.get()) Report;
  bool over_budget = false;
  const std::string why = run_isolated(report, seconds, over_budget, silence, [&] {
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
