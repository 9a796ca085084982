// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/advise/answer_parts.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>

namespace odeum::advise {

std::string text_of_ns(double ns) {
  if (ns < 1e3) return fmt::format("{:.3g} ns", ns);
  return ns < 1e6   ? fmt::format("{:.3g} us", ns / 1e3)
         : ns < 1e9 ? fmt::format("{:.3g} ms", ns / 1e6)
                    : fmt::format("{:.3g} s", ns / 1e9);
}

std::string name_of(const Candidate& candidate) {
  return candidate.entrant->info.id() + " --" + setting_kind(candidate.mode);
}

std::string command_of(const Advice& advice, const Case& c, const Asked& asked) {
  const Candidate& winner = winner_of(advice);
  std::string words = asked.more;
  // The command for a box sets the parameters of the largest error.
  if (!asked.points.empty())
    for (const std::string& set : asked.points[winner.found->worst()]) words += " --set " + set;
  if (advice.on_stops)
    words += " --stops " + std::string(c.timed_stops() == c.stops ? "speed" : "orders");
  else if (asked.until)
    words += fmt::format(" --until {}", *asked.until);
  return fmt::format("odeum run {}{} --solver {} {}", asked.problem, words, name_of(winner),
                     setting_of(winner.found->request(), c.t0));
}

std::vector<std::string> same_within_noise(const Advice& advice) {
  std::vector<std::string> ids;
  for (const std::size_t k : advice.timed) {
    const Candidate& other = advice.candidates[k];
    const Candidate& winner = winner_of(advice);
    const bool same = advice.run_ns > 0 ? advice.same_error(*other.found, *winner.found)
                                        : other.times.min() <= winner.times.median();
    if (k != advice.winner && !other.closed_form() && same) ids.push_back(name_of(other));
  }
  return ids;
}

std::vector<RunnerUp> runners_up(const Advice& advice) {
  const SolverInfo& first = winner_of(advice).entrant->info;
  std::set<std::string> libraries{first.library};
  bool family = false;
  std::vector<RunnerUp> found;
  for (const std::size_t k : advice.timed) {
    const Candidate& candidate = advice.candidates[k];
    const SolverInfo& info = candidate.entrant->info;
    if (k == advice.winner || candidate.closed_form()) continue;
    std::string why;
    if (!family && info.family != first.family) {
      why = "best of another family, " + info.family;
      family = true;
    }
    if (libraries.insert(info.library).second)
      why += (why.empty() ? "" : "; ") + ("best of " + info.library);
    if (!why.empty()) found.push_back({&candidate, why});
  }
  return found;
}

Dropped reason_of(const Candidate& candidate, bool within) {
  if (!candidate.dropped.empty()) return candidate.dropped;
  if (candidate.trials.empty()) return {"the seconds were over"};
  if (candidate.found)
    return {within ? "a larger error in its counted runs" : "slower in its counted runs",
            within ? "a larger error in their counted runs" : "slower in their counted runs"};
  const Trial& last = candidate.trials.back();
  if (within && last.ns > 0 && last.status == Status::ok) return {"slower than the time given"};
  if (within && last.status == Status::over_budget) return {"slower than ten times the time given"};
  if (last.status == Status::over_budget)
    return {
        "its last run was stopped after ten times the best run's time, or its share of the "
        "seconds",
        "stopped for time"};
  if (last.status != Status::ok)
    return {fmt::format("its last run ended {}", to_string(last.status)), "no run ended well"};
  return {fmt::format("its error stayed at {:.2g}", last.error), "without the error asked for"};
}

std::optional<double> known_part(const Case& c) {
  return c.end() > c.stops.back() ? std::optional(c.stops.back()) : std::nullopt;
}

bool is_whole(const Advice& advice, const Case& c) {
  return advice.failure.empty() && !known_part(c);
}

}  // namespace odeum::advise
