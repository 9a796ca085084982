// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/advise/winner.hpp"

#include <algorithm>
#include <utility>

namespace odeum::advise {
namespace {

/// Why a command's run is not what was timed; empty: it is.
const char* not_kept(const Trial& repeated, const Trial& found, double twice_the_error) {
  constexpr std::uint64_t dearer = 10;
  if (!repeated.reaches(twice_the_error))
    return "its run with no stop but the end fails or has over twice the error";
  return repeated.counters.work > dearer * found.counters.work
             ? "its run with no stop but the end takes over ten times the evaluations"
             : "";
}

}  // namespace

void choose_winner(Advice& advice, const std::vector<std::size_t>& order,
                   const std::function<Trial(std::size_t)>& repeat) {
  const double error = 2 * advice.wishes.error;
  std::vector<Trial> repeated;
  std::vector<const char*> why;
  for (const std::size_t k : order) {
    repeated.push_back(repeat(k));
    // Within a time the error is what it is.
    const bool within = advice.run_ns > 0;
    why.push_back(within ? "" : not_kept(repeated.back(), *advice.candidates[k].found, error));
    if (!*why.back()) break;
  }
  std::size_t chosen = repeated.size() - 1;
  if (*why.back()) {
    const auto has_error =
        std::ranges::find_if(repeated, [&](const Trial& each) { return each.reaches(error); });
    chosen = has_error == repeated.end() ? 0 : has_error - repeated.begin();
  }
  advice.winner = order[chosen];
  advice.repeated = std::move(repeated[chosen]);
  for (std::size_t k = 0; k < chosen; ++k) {
    advice.candidates[order[k]].dropped = why[k];
    std::erase(advice.timed, order[k]);
  }
}

}  // namespace odeum::advise
