// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/advise/winner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace odeum::advise {
namespace {

/// Why a command's run is not what was timed; empty: it is.
const char* not_kept(const Trial& made, const Trial& found, double error) {
  constexpr std::uint64_t dearer = 10;
  if (!made.reaches(error)) return "its run with no stop but the end misses the error";
  return made.counters().work > dearer * found.counters().work
             ? "its run with no stop but the end takes over ten times the evaluations"
             : "";
}

/// A candidate that won, with its command's run; none: the run on the stops.
struct Chosen {
  std::size_t candidate;
  std::optional<Trial> made;
};

std::optional<Chosen> chosen_of(Advice& advice, const std::vector<std::size_t>& order,
                                const AsCommand& as_command) {
  constexpr double little_longer = 1.25;
  std::optional<Chosen> on_stops;
  for (const std::size_t k : order) {
    Candidate& candidate = advice.candidates[k];
    if (on_stops && !(candidate.times.min() <=
                      little_longer * advice.candidates[on_stops->candidate].times.min()))
      break;
    Trial made = as_command(k);
    // Within a time the error is what it is.
    const char* const why =
        advice.run_ns > 0 ? "" : not_kept(made, *candidate.found, advice.wishes.error);
    if (!*why) return Chosen{k, std::move(made)};
    candidate.dropped = {why};
    if (advice.wishes.may_stop && !on_stops) on_stops = Chosen{k, std::nullopt};
  }
  return on_stops;
}

}  // namespace

void choose_winner(Advice& advice, const std::vector<std::size_t>& order,
                   const AsCommand& as_command) {
  std::optional<Chosen> chosen = chosen_of(advice, order, as_command);
  const auto is_left = [&](std::size_t k) {
    return !advice.candidates[k].dropped.empty() && !(chosen && k == chosen->candidate);
  };
  if (!chosen) {
    advice.failure = fmt::format(
        "nobody here keeps that in a run with no stop but the end: {} has an error of {:.3g} in "
        "one "
        "whose steps end on the stops",
        advice.candidates[order.front()].entrant->info.id(),
        advice.candidates[order.front()].found->error);
    std::erase_if(advice.timed, is_left);
    return;
  }
  Candidate& winner = advice.candidates[chosen->candidate];
  winner.dropped = {};
  std::erase_if(advice.timed, is_left);
  std::erase(advice.timed, chosen->candidate);
  advice.timed.insert(advice.timed.begin(), chosen->candidate);
  advice.winner = chosen->candidate;
  advice.on_stops = !chosen->made;
  if (chosen->made) winner.found = std::move(*chosen->made);
}

}  // namespace odeum::advise
