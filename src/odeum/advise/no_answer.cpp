// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/advise/no_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace odeum::advise {

void check_wishes(const Case& c, const Wishes& wishes) {
  if (wishes.energy == 0) return;
  if (!c.energy) throw std::invalid_argument("the problem has no energy");
  const double before = c.energy(c.y0.data());
  std::vector<double> state(c.y0.size());
  double size = std::abs(before);
  for (const double stop : c.stops)
    if (c.truth.at && c.truth.at(stop, state.data()))
      size = std::max(size, std::abs(c.energy(state.data())));
  // Errors of the energy are relative to its size, which must be more than rounding: here beside
  // what a small change of the state makes of it.
  constexpr double change = 1e-3, rounding = 1e-9;
  std::vector<double> moved = c.y0;
  for (std::size_t i = 0; i < moved.size(); ++i) moved[i] += change * (c.scale_of(i) + moved[i]);
  const double least = rounding * std::abs(c.energy(moved.data()) - before);
  if (!(size > least) || (wishes.horizon > 0 && !(std::abs(before) > least)))
    throw std::invalid_argument(
        "the energy is 0 at the start, so that no error can be relative to it: a constant that is "
        "added to it gives it a size");
  if (wishes.horizon == 0) return;
  if (!(wishes.horizon >= c.stops.back()))
    throw std::invalid_argument(
        fmt::format("a horizon of {:g} ends before the run, which goes to {:g}", wishes.horizon,
                    c.stops.back()));
  if (c.truth.at && c.truth.at(c.stops.back(), state.data()) &&
      !(std::abs(c.energy(state.data()) / before - 1) <= 0.1 * wishes.energy))
    throw std::invalid_argument("the energy is not conserved, so that no horizon can be given");
}

std::string words_of_truth(const Case& c) {
  for (const auto& [name, words] : c.facts)
    if (name == "truth") return words;
  return c.truth.source;
}

std::string unknown(const Case& c, const Wishes& wishes) {
  std::vector<double> state(c.y0.size());
  double known = c.t0;
  for (const double stop : c.stops) {
    if (!c.truth.at || !c.truth.at(stop, state.data()))
      return known == c.t0 ? "the solution is not known at any stop: " + words_of_truth(c)
                           : fmt::format("the solution is known only to t = {}: {}", known,
                                         words_of_truth(c));
    known = stop;
  }
  if (wishes.time_ns == 0 && wishes.error <= c.truth.floor)
    return fmt::format("the solution itself is known to {:.2g} only, so that {:g} can't be told",
                       c.truth.floor, wishes.error);
  return {};
}

std::string nobody(const Advice& advice) {
  const bool within = advice.run_ns > 0;
  double least = infinity;
  std::string id;
  for (const Candidate& candidate : advice.candidates)
    for (const Trial& trial : candidate.trials)
      if (const double value = within ? trial.ns : trial.error;
          trial.status == Status::ok && value < least && !candidate.closed_form()) {
        least = value;
        id = candidate.entrant->info.id();
      }
  if (within ? advice.cut && (id.empty() || least <= advice.run_ns) : id.empty())
    return "not known: no run ended within its share of the seconds; --seconds gives more";
  if (within && id.empty()) return "nobody here ends a run within ten times that time";
  if (within)
    return fmt::format(
        "nobody here ends a run within that time: the shortest took {:.3g} ms, by {}", 1e-6 * least,
        id);
  return fmt::format("nobody here reaches that{}: best is {} with an error of {:.3g}",
                     advice.cut ? " within the seconds given" : "", id, least);
}

}  // namespace odeum::advise
