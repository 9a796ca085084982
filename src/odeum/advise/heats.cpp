// SPDX-License-Identifier: BSD-3-Clause
// In which order candidates are searched. Where runs are short, each is run once. Where they are
// dear, runs to the first stop order the candidates; what they foresee is said where somebody is
// left for it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "odeum/advise/search.hpp"
#include "odeum/core/progress.hpp"

namespace odeum::advise {
namespace {

constexpr std::size_t most_solves = 10;
constexpr double half_a_decade = 0.5;
/// A run of this time is dear: not every candidate has its turn, and the answer may take longer, up
/// to thirty of the runs that are foreseen to be the best.
constexpr double dear_ns = 2e6, dear_seconds = 20, dear_runs = 30, most_seconds = 600;
/// A candidate foreseen to cost so many times the least is left where its library has an answer.
constexpr double far_behind = 4;
/// Seconds, of a time in nanoseconds.
constexpr double ten_times = 1e-8;

/// Solvers of a library whose names begin alike, in one mode.
using Kind = std::pair<std::string, Mode>;
Kind kind_of(const Candidate& candidate) {
  const std::string& method = candidate.entrant->info.method;
  const std::size_t letters = method.find_first_not_of("abcdefghijklmnopqrstuvwxyz");
  return {candidate.entrant->info.library + "/" + method.substr(0, letters), candidate.mode};
}

/// Runs of the same library that agree to the last digit are of one method.
using Fingerprint = std::tuple<std::string, Mode, double, double, std::uint64_t>;
Fingerprint fingerprint_of(const Candidate& candidate, const Trial& trial) {
  return {candidate.entrant->info.library, candidate.mode, trial.fineness, trial.error,
          trial.counters().rhs_evaluations};
}

Dropped like_stopped(const std::string& other) {
  return {fmt::format("not tried: {} was stopped", other),
          "not tried, since one of their kind was stopped"};
}
Dropped twin_of(const std::string& other) {
  return {fmt::format("its steps are those of {}", other), "the steps of another one"};
}

/// Candidates by what was foreseen of them, the least first.
std::vector<Candidate*> by_foresight(std::vector<Candidate>& candidates) {
  std::vector<Candidate*> order;
  for (Candidate& candidate : candidates)
    if (!std::isnan(candidate.foreseen)) order.push_back(&candidate);
  std::ranges::stable_sort(
      order, [](const Candidate* a, const Candidate* b) { return a->foreseen < b->foreseen; });
  return order;
}

}  // namespace

void Search::order_by_rank(std::vector<Candidate>& candidates) {
  // Where each solve takes long, not all have their turn: in each library and mode first those that
  // need what the problem has, then orders 4 to 8. That orders them, and drops none.
  const auto rank = [](const Candidate& candidate) {
    const SolverInfo& info = candidate.entrant->info;
    if (!info.needs.empty()) return 0.0;
    return 1 + (std::isnan(info.order) ? 4 : std::max({0.0, 4 - info.order, info.order - 8}));
  };
  std::ranges::stable_sort(
      candidates, [&](const Candidate& a, const Candidate& b) { return rank(a) < rank(b); });
  // The kinds of all libraries and modes take turns, so that none waits for the many of another.
  std::map<Kind, double> turns;
  std::map<std::pair<std::string, Mode>, double> kinds_of;
  for (const Candidate& candidate : candidates) {
    double& count = kinds_of[{candidate.entrant->info.library, candidate.mode}];
    if (turns.emplace(kind_of(candidate), count).second) ++count;
  }
  std::ranges::stable_sort(
      candidates, {}, [&](const Candidate& candidate) { return turns.at(kind_of(candidate)); });
}

/// What a run to the end takes, from one to the first stop. Where stops are decades apart, a run to
/// a tolerance takes about as long from each to the next.
double Search::whole_ns(const Candidate& candidate, const Trial& to_first) const {
  const double part = part_of(To::first), each = 1 / static_cast<double>(c_.stops.size());
  return to_first.ns / (candidate.mode == Mode::fixed ? part : std::max(part, each));
}

/// Foresees, from a run to the first stop, the time to the error asked, or the error in the time.
void Search::foresee(Candidate& candidate, const Trial& trial) const {
  // Coarser settings may be unstable: no more than half of the time is expected to be saved.
  constexpr double most_saved = 2;
  const bool within = wishes_.time_ns > 0;
  const double error = std::max(trial.error, 1e-17), ns = whole_ns(candidate, trial),
               order = candidate.order();
  // The factor by which the steps have to become more.
  const double more = std::clamp(
      within ? wishes_.time_ns / ns : std::pow(error / wishes_.error, 1 / order), 1e-3, 1e3);
  candidate.foreseen =
      within ? error * std::pow(more, -order) : ns * std::max(more, 1 / most_saved);
  candidate.starts_at = in_range(
      candidate, trial.fineness * (candidate.mode == Mode::fixed ? more : std::pow(more, order)));
}

/// Runs until one ends well.
Trial Search::heat(Candidate& candidate) {
  double fineness = first(candidate);
  candidate.foreseen = infinity;
  constexpr int most_tries = 4;
  Trial trial;
  for (int attempt = 0; attempt < most_tries; ++attempt) {
    trial = run(candidate, fineness, To::first);
    if (trial.status == Status::ok && !std::isnan(trial.error)) foresee(candidate, trial);
    if (trial.status == Status::ok) break;
    if (trial.status == Status::over_budget) {
      candidate.dropped = {fmt::format("a run to t = {:g} was stopped after {:.2g} s", first_,
                                       trial.request().budget.seconds),
                           "a run to the first stop took too long"};
      break;
    }
    // An unstable step; a tolerance that was too loose.
    fineness = in_range(candidate, 4 * fineness);
  }
  return trial;
}

bool Search::heats(std::vector<Candidate>& candidates) {
  // There are two rounds: the first of each kind, then the others of kinds that are near.
  std::map<Kind, std::vector<Candidate*>> kinds;
  for (Candidate& candidate : candidates) kinds[kind_of(candidate)].push_back(&candidate);
  cap_seconds_ = 0.02 * seconds_;
  double least = infinity;
  std::map<Kind, std::string> stopped;  // solvers
  std::map<Fingerprint, std::string> same;
  const auto try_it = [&](Candidate& candidate) {
    const std::string id = candidate.entrant->info.id();
    candidate.foreseen = infinity;
    if (const auto other = stopped.find(kind_of(candidate)); other != stopped.end()) {
      candidate.dropped = like_stopped(other->second);
      return infinity;
    }
    const Trial trial = heat(candidate);
    if (trial.status == Status::over_budget) {
      const auto& [kind, mode] = kind_of(candidate);
      stopped.emplace(Kind{kind, mode}, id);
      // One that can't be stopped within a step is too dear in the other mode as well.
      if (trial.ns > 3e9 * trial.request().budget.seconds)
        stopped.emplace(Kind{kind, mode == Mode::fixed ? Mode::adaptive : Mode::fixed}, id);
    }
    if (trial.status != Status::ok) return infinity;
    // A few that are slow must not take the turn of the others.
    constexpr double shortest = 2e-3, few_times = 4e-9;
    cap_seconds_ = std::min(cap_seconds_, std::max(shortest, few_times * trial.ns));
    const auto [twin, alone] = same.emplace(fingerprint_of(candidate, trial), id);
    if (!alone) candidate.dropped = twin_of(twin->second);
    least = std::min(least, candidate.foreseen);
    return whole_ns(candidate, trial);
  };
  for (Candidate& candidate : candidates) {
    if (late(dear_ ? 0.2 : 0.5)) break;
    if (&candidate != kinds[kind_of(candidate)].front()) continue;
    if (try_it(candidate) < dear_ns) {  // somebody's run is short
      for (Candidate& other : candidates) {
        other.foreseen = nan;
        other.starts_at = 0;
        other.dropped = {};
      }
      return false;
    }
  }
  dear_ = true;
  if (wishes_.seconds == 0) {
    const bool foreseen = wishes_.time_ns == 0 && std::isfinite(least);  // a time, by a run
    seconds_ =
        foreseen ? std::clamp(1e-9 * dear_runs * least, dear_seconds, most_seconds) : dear_seconds;
  }
  const double known = far_behind * least;
  for (const auto& [kind, members] : kinds)
    for (Candidate* member : members) {
      const double first = members.front()->foreseen;  // NaN: it had no turn
      const bool worth = member == members.front() ? std::isnan(first) : first <= known;
      if (worth && !late(0.3)) try_it(*member);
    }
  return true;
}

void Search::each_worth(std::vector<Candidate>& candidates,
                        const std::function<void(Candidate&)>& visit) {
  const std::vector<Candidate*> order = by_foresight(candidates);
  Progress progress("advise", static_cast<double>(order.size()));
  std::map<std::string, double> spent;  // seconds, by library without an answer
  for (Candidate* candidate : order) {
    progress.advance();
    if (!candidate->dropped.empty()) continue;
    if (late(wishes_.time_ns > 0 ? 0.6 : 0.75)) break;
    if (!std::isfinite(candidate->foreseen)) {
      candidate->dropped = {fmt::format("no run to t = {:g} ended well", first_)};
      continue;
    }
    // One of each library, and then those that may be the best.
    constexpr double share = 0.04, near = 1.5, few_times = 2.5, many_times = 10;
    double& seconds = spent.try_emplace(candidate->entrant->info.library, 0).first->second;
    const bool has_answer = seconds > share * seconds_;
    const double times = candidate->foreseen / best_cost();
    if (has_answer && times > near) {
      candidate->dropped = {
          fmt::format("a run to t = {:g} foresees {:.2g} times the best", first_, times),
          "far behind by a run to the first stop"};
      continue;
    }
    patience_ = has_answer ? few_times : many_times;
    const double start = clock_.spent();
    visit(*candidate);
    seconds = candidate->found ? infinity : seconds + clock_.spent() - start;
  }
  patience_ = 10;
}

void Search::all(std::vector<Candidate>& candidates) {
  order_by_rank(candidates);
  if (heats(candidates)) {
    each_worth(candidates, [&](Candidate& candidate) {
      // The first stop may foresee far too little of a low order: the next one has its turn soon.
      cap_seconds_ = std::min(0.1 * seconds_, ten_times * candidate.foreseen);
      take(candidate, first(candidate));
      search(candidate, most_solves, half_a_decade);
    });
  } else {
    search_cheap(candidates);
  }
  try_longer(candidates);
  for (Candidate& candidate : candidates) settle(candidate);
}

/// All of them, in the order of the cost that a whole run foresees.
void Search::search_cheap(std::vector<Candidate>& candidates) {
  cap_seconds_ = seconds_ / (4.0 * static_cast<double>(candidates.size()));
  Progress progress("advise", 2.0 * static_cast<double>(candidates.size()));
  // All have a turn: one that is stopped there begins again at a coarser setting.
  constexpr double few_times = 3;
  const double usual = std::exchange(patience_, few_times);
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t k = 0; k < candidates.size(); ++k, progress.advance()) {
    if (late(0.5)) break;
    take(candidates[k], first(candidates[k]));
    // An error need not fall with the setting, and the coarsest one costs the least.
    if (candidates[k].trials.back().status == Status::ok && candidates[k].dropped.empty() &&
        !candidates[k].trials.back().reaches(wishes_.error))
      take(candidates[k], in_range(candidates[k], 1));
    const Trial& trial = candidates[k].trials.front();
    order.emplace_back(std::isnan(trial.error)
                           ? infinity
                           : trial.ns * std::pow(std::max(trial.error, 1e-17) / wishes_.error,
                                                 1 / candidates[k].order()),
                       k);
  }
  patience_ = usual;
  std::ranges::stable_sort(order);
  for (const auto& [cost, k] : order) {
    // Nobody has ended a run: coarser ones are tried below, with more time.
    if (late(0.7) || (cost == infinity && !std::isfinite(best_ns_))) break;
    search(candidates[k], most_solves, half_a_decade);
    progress.advance();
  }
}

/// Where each solve takes long, the first runs had too little time.
void Search::try_longer(std::vector<Candidate>& candidates) {
  while (!std::isfinite(best_ns_) && !late(0.7) && cap_seconds_ < seconds_) {
    cap_seconds_ *= 8;
    bool any = false;
    for (Candidate& candidate : candidates) {
      if (late(0.7)) break;
      if (candidate.trials.empty() || candidate.trials.back().status != Status::over_budget)
        continue;
      any = true;
      const double again = candidate.trials.back().fineness;
      candidate.trials.pop_back();
      take(candidate, again);
      search(candidate, most_solves, half_a_decade);
    }
    if (!any) break;
  }
}

}  // namespace odeum::advise
