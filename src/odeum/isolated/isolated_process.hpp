// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <atomic>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>

#include "odeum/core/guard.hpp"
#include "odeum/core/outcome.hpp"

/// Work of foreign code (a plug-in, an FMU) in a process of its own, so that whatever it does costs
/// nothing but its result.
namespace odeum::isolated {

/// Whether this is such a process.
bool in_isolated_process();
/// What a process that is ended early is known to have done.
enum class Sign { other, evaluation, jacobian };
/// In such a process: work goes on. Without it for `longest_silence` seconds the process is ended.
void alive(Sign sign = Sign::other);
/// The same, with what has been counted since the start.
void alive(const Guard& guard);
/// $ODEUM_SILENCE_SECONDS, else 5.
double longest_silence();

/// solve(request) in a process of its own. A process that ends early, is ended by a signal, or
/// shows no sign of work gives an outcome with status `refused` or `over_budget`, a sentence, and
/// the evaluations that were made until then. What a timed run (Budget::watched off) spends on this
/// is reported to isolated_times.hpp, and the solve is made twice, the second time timed: the first
/// one copies the memory that it writes.
///
/// `ended` counts the solves in a row that had to be ended, of one solver on one problem, each of
/// which took seconds: after `most_ended` of them the solver is not run again, and the outcome is
/// refused with a sentence, since a study makes thousands. Thread-safe.
using Ended = std::atomic<unsigned>;
inline constexpr unsigned most_ended = 3;
Outcome solve_isolated(const std::function<Outcome(const Request&)>& solve, const Request& request,
                       std::size_t dimension, Ended& ended);

/// work() in a process of its own: its text, of which at most `room` bytes come back, and true; or
/// false and a sentence that says how the process ended. It is ended after `seconds`, and where it
/// shows no sign of work for `silence`.
std::pair<bool, std::string> text_isolated(const std::function<std::string()>& work,
                                           std::size_t room = 2000,
                                           double seconds = longest_silence(),
                                           double silence = longest_silence());

}  // namespace odeum::isolated
