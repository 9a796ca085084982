// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/advise/race.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "odeum/advise/limit.hpp"
#include "odeum/advise/no_answer.hpp"
#include "odeum/advise/search.hpp"
#include "odeum/advise/winner.hpp"
#include "odeum/core/glob.hpp"
#include "odeum/core/interrupt.hpp"
#include "odeum/core/parallel.hpp"

namespace odeum::advise {
namespace {

// A single run of less than that says little of its time, and many rounds cost nothing.
constexpr double short_ns = 5e4;
constexpr std::size_t most_finalists = 12, most_short_finalists = 40;
constexpr double finalist_factor = 3, finalist_ns = 3e4, most_rounds = 25;

bool selected(const SolverInfo& info, const Wishes& wishes) {
  const auto& libraries = wishes.libraries;
  if (!libraries.empty() && std::ranges::find(libraries, info.library) == libraries.end())
    return false;
  return wishes.solvers.empty() || any_glob_matches(wishes.solvers, info.id());
}

/// The solver on each case; empty where it does not fit one of them, whose reason is given.
std::vector<const Entrant*> on_each(const std::vector<const Case*>& cases, const Entrant& entrant,
                                    std::string& unfit) {
  std::vector<const Entrant*> on;
  for (const Case* c : cases) {
    on.push_back(c == cases.front() ? &entrant : c->entrants.find(entrant.info.id()));
    if (on.back() && on.back()->unfit.empty()) continue;
    unfit = on.back() ? on.back()->unfit : "does not fit for all parameters";
    return {};
  }
  return on;
}

void enter(const std::vector<const Case*>& cases, const Wishes& wishes, Advice& advice) {
  const Case& c = *cases.front();
  bool any = false;
  for (std::size_t k = 0; k < c.entrants.size(); ++k) {
    if (!selected(c.entrants.info(k), wishes)) continue;
    any = true;
    const Entrant& entrant = c.entrants[k];
    const std::string id = entrant.info.id();
    std::string unfit;
    const std::vector<const Entrant*> on = on_each(cases, entrant, unfit);
    if (on.empty()) {
      advice.not_tried[unfit].push_back(id);
      continue;
    }
    const bool adaptive = entrant.info.adaptive && wishes.frame == 0;
    if (entrant.info.adaptive && !adaptive && !entrant.info.fixed)
      advice.not_tried["chooses its own steps, which do not divide a frame"].push_back(id);
    if (adaptive) advice.candidates.push_back({&entrant, Mode::adaptive, on});
    if (!entrant.info.fixed) continue;
    if (c.settings.no_fixed_steps.empty())
      advice.candidates.push_back({&entrant, Mode::fixed, on});
    else if (!adaptive)
      advice.not_tried[c.settings.no_fixed_steps].push_back(id);
  }
  if (!any) throw std::invalid_argument("no solver has that name and library");
  if (advice.candidates.empty())
    throw std::invalid_argument("no solver fits: " + advice.not_tried.begin()->first);
}

/// The candidates that may be the fastest, or where a time is given have the least error, and the
/// best of each other library and family.
std::vector<std::size_t> finalists(const std::vector<Candidate>& candidates, bool within,
                                   double floor = 0) {
  std::vector<std::size_t> by_cost;
  for (std::size_t k = 0; k < candidates.size(); ++k)
    if (candidates[k].found) by_cost.push_back(k);
  std::ranges::stable_sort(by_cost, {}, [&](std::size_t k) {
    return within ? candidates[k].found->error : candidates[k].found->ns;
  });
  double least = infinity, least_error = infinity;
  std::size_t racing = 0;
  std::set<std::string> seen;
  std::vector<std::size_t> chosen;
  for (const std::size_t k : by_cost) {
    const Candidate& candidate = candidates[k];
    const SolverInfo& info = candidate.entrant->info;
    if (candidate.closed_form()) {
      chosen.push_back(k);
      continue;
    }
    least = std::min(least, candidate.found->ns);
    least_error = std::min(least_error, 10 * candidate.found->error + 2 * floor);
    const bool near =
        (within ? candidate.found->error <= least_error
                : candidate.found->ns <= finalist_factor * least + finalist_ns) &&
        racing++ < (!within && least < short_ns ? most_short_finalists : most_finalists);
    const bool of_library = seen.insert(info.library).second,
               of_family = seen.insert("family " + info.family).second;
    if (near || of_library || of_family) chosen.push_back(k);
  }
  return chosen;
}

/// Interleaved rounds over all that are timed.
void time_them(Advice& advice, Search& search, double seconds) {
  double once = 0;
  for (const std::size_t k : advice.timed) once += 1e-9 * advice.candidates[k].found->ns + 2e-5;
  const auto rounds = static_cast<std::size_t>(std::clamp(0.15 * seconds / once, 2.0, most_rounds));
  const study::Pinned pinned;
  const study::ConditionsMeter meter;
  for (std::size_t round = 0; round < rounds; ++round) {
    if (round > 0 && search.late(0.85)) break;
    for (const std::size_t k : advice.timed) {
      if (interrupted) throw Interrupted();
      Candidate& candidate = advice.candidates[k];
      // It ended well under the guard; without a time it can't be advised.
      candidate.times.ns.push_back(search.bare_ns(candidate, *candidate.found));
    }
  }
  advice.disturbed = study::disturbed(meter.end());
}

auto time_of(const Advice& advice) {
  return [&](std::size_t k) { return advice.candidates[k].times.min(); };
}

/// Races to an error.
void race_to_error(Advice& advice, Search& search) {
  search.all(advice.candidates);
  advice.cut = search.late(0.7);
  for (const std::size_t k : finalists(advice.candidates, false)) {
    if (search.late(0.8)) break;
    search.refine(advice.candidates[k]);
  }
  advice.timed = finalists(advice.candidates, false);
  time_them(advice, search, search.seconds());
  std::ranges::stable_sort(advice.timed, {}, time_of(advice));
}

/// Races within a time: those whose bare runs take longer get a coarser setting.
void race_within(Advice& advice, Search& search, const Wishes& wishes) {
  search.all_within(advice.candidates);
  advice.cut =
      search.late(0.6) || std::ranges::any_of(advice.candidates, [](const Candidate& each) {
        return each.trials.empty() && each.dropped.empty();
      });
  advice.timed = finalists(advice.candidates, true, advice.floor);
  // Where runs are dear, a round of all has to fit into what is left.
  double round_ns = 0;
  const std::size_t first = advice.timed.empty() ? 0 : advice.timed.front();
  std::erase_if(advice.timed, [&](std::size_t k) {
    round_ns += advice.candidates[k].found->ns;
    return k != first && round_ns > 0.15e9 * search.left();
  });
  constexpr int most_adjustments = 4;
  for (int round = 0; round < most_adjustments; ++round) {
    time_them(advice, search, search.seconds() / most_adjustments);
    bool changed = false;
    for (const std::size_t k : advice.timed) {
      Candidate& candidate = advice.candidates[k];
      if (round + 1 == most_adjustments || search.late(0.75)) continue;
      if (!search.adjust_within(candidate, candidate.times.min())) continue;
      candidate.times = {};
      changed = true;
    }
    if (!changed) break;
  }
  std::erase_if(advice.timed, [&](std::size_t k) {
    const bool slow = !(advice.candidates[k].times.min() <= wishes.time_ns);
    if (slow) advice.candidates[k].dropped = {"it takes longer at its coarsest good setting"};
    return slow;
  });
  std::ranges::stable_sort(advice.timed, {},
                           [&](std::size_t k) { return advice.candidates[k].found->error; });
  // The fastest among those of the least error comes first.
  const auto counts = [&](std::size_t k) { return !advice.candidates[k].closed_form(); };
  const auto least = std::ranges::find_if(advice.timed, counts);
  if (least == advice.timed.end()) return;
  const Trial& best = *advice.candidates[*least].found;
  const auto same = std::stable_partition(least, advice.timed.end(), [&](std::size_t k) {
    return advice.same_error(*advice.candidates[k].found, best);
  });
  std::ranges::stable_sort(least, same, {}, time_of(advice));
}

/// The frames of a run; 0: they do not divide it.
std::uint64_t frames_of(const Case& c, double frame) {
  const double count = (c.stops.back() - c.t0) / frame;
  return std::abs(count - std::round(count)) < 1e-9 * count
             ? static_cast<std::uint64_t>(std::llround(count))
             : 0;
}

/// The time of the command's own run, and what else is measured of it.
void look_at_winner(Advice& advice, Search& search, const std::vector<const Case*>& cases) {
  Candidate& winner = advice.candidates[advice.winner];
  if (winner.mode == Mode::adaptive && !advice.on_stops) {
    const std::size_t rounds = winner.times.ns.size();
    winner.times = {};
    for (std::size_t k = 0; k < rounds && (k < 2 || !search.late(0.95)); ++k)
      winner.times.ns.push_back(search.bare_ns(winner, *winner.found));
  }
  const double fineness = winner.found->fineness, coarser = search.coarser_than(winner, fineness);
  if (coarser < fineness)
    advice.coarser = advice.on_stops || winner.mode == Mode::fixed
                         ? search.run(winner, coarser)
                         : search.command_run(winner, coarser);
  const Case& c = *cases[winner.found->worst()];
  advice.limit = limit_of(advice, c);
  if (!search.dear()) advice.growth = growth_of(advice, c);
}

}  // namespace

Advice advise(const std::vector<const Case*>& cases, const Wishes& asked) {
  const Case& c = *cases.front();
  Wishes wishes = asked;
  Advice advice;
  advice.wishes = asked;
  enter(cases, wishes, advice);
  for (const Case* each : cases) {
    advice.floor = std::max(advice.floor, each->truth.floor);
    check_wishes(*each, wishes);
    if (advice.failure.empty()) advice.failure = unknown(*each, wishes);
  }
  const std::uint64_t frames = wishes.frame > 0 ? frames_of(c, wishes.frame) : 0;
  if (wishes.frame > 0 && frames == 0)
    advice.failure = fmt::format("frames of {:.6g} do not divide the run of {:.6g}", wishes.frame,
                                 c.stops.back() - c.t0);
  if (!advice.failure.empty()) {
    advice.candidates.clear();  // none was raced, and so none was dropped
    return advice;
  }
  if (frames > 0) wishes.time_ns *= static_cast<double>(frames);
  advice.run_ns = wishes.time_ns;
  advice.frames = static_cast<double>(frames);
  Search search(cases, wishes, frames);
  if (wishes.time_ns > 0)
    race_within(advice, search, wishes);
  else
    race_to_error(advice, search);
  std::vector<std::size_t> order = advice.timed;
  std::erase_if(order, [&](std::size_t k) { return advice.candidates[k].closed_form(); });
  if (order.empty()) {
    advice.failure = nobody(advice);
    return advice;
  }
  choose_winner(advice, order,
                [&](std::size_t k) { return search.as_command(advice.candidates[k]); });
  if (advice.failure.empty()) look_at_winner(advice, search, cases);
  return advice;
}

}  // namespace odeum::advise
