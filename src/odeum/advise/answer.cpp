// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/advise/answer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "odeum/advise/answer_parts.hpp"
#include "odeum/advise/no_answer.hpp"
#include "odeum/core/machine.hpp"
#include "odeum/judge/errors.hpp"
#include "odeum/solvers/loaded.hpp"

namespace odeum::advise {
namespace {

std::string text_of_coarser(const Advice& advice) {
  if (!advice.coarser) return {};
  const Trial &coarser = *advice.coarser, &found = *winner_of(advice).found;
  const std::string what =
      winner_of(advice).mode == Mode::fixed
          ? fmt::format("a step {:.3g} times as long", found.fineness / coarser.fineness)
          : fmt::format("{:.3g} times the tolerance", found.fineness / coarser.fineness);
  if (coarser.status != Status::ok)
    return fmt::format("coarser   {}: the run ends {}\n", what, to_string(coarser.status));
  return fmt::format("coarser   {}: error {:.3g}, {} steps\n", what, coarser.state_error(),
                     coarser.counters().steps);
}

std::string text_of_runners(const Advice& advice, const Case& c) {
  const double least = winner_of(advice).times.min();
  std::string text;
  for (const auto& [other, why] : runners_up(advice)) {
    const double error = other->found->state_error(), ns = other->times.min();
    text += fmt::format("behind    {} {:.3g}: ", name_of(*other),
                        setting_of(other->found->request(), c.t0));
    text += advice.run_ns > 0
                ? fmt::format("{:.3g} times the error in {}",
                              error / winner_of(advice).found->state_error(), text_of_ns(ns))
                : fmt::format("{:.2f} times the time, error {:.2g}", ns / least, error);
    text += fmt::format(" ({})\n", why);
  }
  std::map<std::string, double> closed;  // by solver, the faster of its modes
  for (const std::size_t k : advice.timed) {
    const Candidate& candidate = advice.candidates[k];
    if (!candidate.closed_form()) continue;
    const double ns = candidate.times.min();
    const auto known = closed.try_emplace(candidate.entrant->info.id(), ns).first;
    known->second = std::min(known->second, ns);
  }
  for (const auto& [id, ns] : closed)
    text += fmt::format(
        "apart     {} evaluates the closed form of this linear problem and is not a method that "
        "steps: {}\n",
        id, text_of_ns(ns));
  return text;
}

std::string sureness(const Advice& advice) {
  std::string text;
  const std::vector<std::string> same = same_within_noise(advice);
  if (!same.empty()) text += fmt::format("; the same within noise: {}", fmt::join(same, ", "));
  if (advice.disturbed) text += "; the machine was disturbed";
  if (advice.cut) text += "; cut short by --seconds, others may be faster";
  return text;
}

/// Solvers by reason in one line, the largest groups first; a few solvers by their names.
std::string text_of_groups(const char* head,
                           const std::map<std::string, std::vector<std::string>>& groups) {
  constexpr std::size_t most_groups = 4, few = 2;
  std::vector<const std::pair<const std::string, std::vector<std::string>>*> order;
  std::size_t count = 0;
  for (const auto& group : groups) {
    order.push_back(&group);
    count += group.second.size();
  }
  if (order.empty()) return {};
  std::ranges::stable_sort(order, std::ranges::greater(),
                           [](const auto* group) { return group->second.size(); });
  std::vector<std::string> texts;
  for (std::size_t k = 0; k < order.size() && k < most_groups; ++k) {
    const auto& [reason, ids] = *order[k];
    texts.push_back(fmt::format("{} {}", ids.size(), reason));
    if (ids.size() <= few) texts.back() += fmt::format(" ({})", fmt::join(ids, ", "));
  }
  if (order.size() > most_groups)
    texts.push_back(fmt::format("{} more reasons", order.size() - most_groups));
  return fmt::format("{}{}: {} (--format json names each)\n", head, count, fmt::join(texts, "; "));
}

std::string text_of_rest(const Advice& advice) {
  std::map<std::string, std::vector<std::string>> dropped;
  each_dropped(advice, [&](const Candidate& candidate) {
    const Dropped reason = reason_of(candidate, advice.run_ns > 0);
    dropped[reason.group.empty() ? reason.why : reason.group].push_back(name_of(candidate));
  });
  return text_of_groups("dropped   ", dropped) + text_of_groups("not tried ", advice.not_tried);
}

/// Times of a library that was compiled without optimisation are none of its methods.
std::string text_of_builds(const Advice& advice) {
  std::set<std::string> slow;
  for (const Candidate& candidate : advice.candidates) {
    const std::string& library = candidate.entrant->info.library;
    if (how_library_was_compiled(library) == unoptimised) slow.insert(library);
  }
  if (slow.empty()) return {};
  return fmt::format(
      "builds    {}: compiled without optimisation, so that their times are several times too long "
      "(odeum doctor)\n",
      fmt::join(slow, ", "));
}

/// Absolute tolerances that are not the same for all components.
std::string text_of_absolutes(const Trial& found, const Case& c) {
  constexpr std::size_t most = 12;
  const std::vector<double>& absolutes = found.request().tolerance.absolutes();
  if (found.request().mode == Mode::fixed || absolutes.size() < 2 || absolutes.size() > most)
    return {};
  const std::vector<std::string> names = component_names(c);
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < absolutes.size(); ++i)
    texts.push_back(fmt::format("{}={:.2g}", names[i], absolutes[i]));
  return fmt::format("absolute  {}\n", fmt::join(texts, ","));
}

/// What varies over a box of parameters, and the energy where it was asked for.
std::string text_of_wishes(const Advice& advice, const Asked& asked) {
  const Trial& found = *winner_of(advice).found;
  std::string text;
  if (advice.wishes.energy > 0)
    text += fmt::format("energy    {:.3g} of it at most{}\n", found.energy_error(),
                        advice.wishes.horizon > 0
                            ? fmt::format(", in 16 looks up to t = {:g}", advice.wishes.horizon)
                            : " at the stops");
  if (asked.points.empty()) return text;
  // Counts of the same run are the same each time.
  const auto work = [](const Part& part) { return part.counters.rhs_evaluations; };
  const auto [least, most] = std::ranges::minmax_element(found.parts, {}, work);
  const auto point = [&](auto part) {
    return fmt::format(
        "{}", fmt::join(asked.points[static_cast<std::size_t>(part - found.parts.begin())], " "));
  };
  text += fmt::format("box       {} points of it; the error is largest at {}; ",
                      asked.points.size(), fmt::join(asked.points[found.worst()], " "));
  return text + (work(*least) == work(*most)
                     ? fmt::format("a run takes {} evaluations at each\n", work(*least))
                     : fmt::format("a run takes {} evaluations at {} and {} at {}\n", work(*least),
                                   point(least), work(*most), point(most)));
}

/// At which times the error is the largest of those measured: between them nothing is.
std::string text_of_stops(const Case& c) {
  constexpr std::size_t few = 8;
  const std::size_t count = c.stops.size();
  return count <= few ? fmt::format("t = {:g}", fmt::join(c.stops, ", "))
                      : fmt::format("{} times up to t = {:g}", count, c.stops.back());
}

/// What `odeum run` says, where that is not the error of the answer.
std::string text_of_run(const Advice& advice, const Case& c, const Asked& asked) {
  const Part& part = winner_of(advice).found->parts[winner_of(advice).found->worst()];
  std::string text = fmt::format("run       {}\n", command_of(advice, c, asked));
  if (advice.on_stops)
    return text + "          its steps end on the stops, without which it misses the error\n";
  if (part.end_error < part.error)
    text += fmt::format("          error at its end: {:.6g}\n", part.end_error);
  return text;
}

/// The time up to which there is an answer, where that is not the whole.
std::string text_of_part(const Case& c) {
  const std::optional<double> until = known_part(c);
  return until ? fmt::format("no answer beyond t = {:g} of {:g}; up to there: ", *until, c.end())
               : "";
}

}  // namespace

std::string text_of(const Advice& advice, const Case& c, const Asked& asked) {
  if (!advice.failure.empty()) return advice.failure + "\n" + text_of_rest(advice);
  const Candidate& winner = winner_of(advice);
  const Trial& found = *winner.found;
  std::string text = fmt::format(
      "{}{} {:.4g}: error {:.3g} (+- {:.1g}), {}, in {} ({} median of {}){}\n", text_of_part(c),
      name_of(winner), setting_of(found.request(), c.t0), found.state_error(), advice.floor,
      judge::unit_text(c), text_of_ns(winner.times.min()), text_of_ns(winner.times.median()),
      winner.times.ns.size(), sureness(advice));
  if (advice.frames > 0)
    text +=
        fmt::format("frame     {:g} steps of it a frame, {}{}\n",
                    static_cast<double>(found.request().steps) / advice.frames,
                    text_of_ns(winner.times.min() / advice.frames),
                    advice.run_ns > 0
                        ? fmt::format(" of the {} given", text_of_ns(advice.wishes.time_ns))
                        : fmt::format("; the error is the largest at {:g} frames", advice.frames));
  else
    text += fmt::format("stops     {}: the error is the largest there{}\n", text_of_stops(c),
                        c.measures_particles ? "; --frame 1/60 keeps it at every frame" : "");
  text += text_of_absolutes(found, c);
  text += text_of_wishes(advice, asked);
  if (known_part(c)) text += fmt::format("truth     {}\n", words_of_truth(c));
  text += text_of_run(advice, c, asked);
  text += fmt::format("cost      {} evaluations, {} steps, {} rejected\nlimit     {}\n",
                      found.counters().rhs_evaluations, found.counters().steps,
                      found.counters().rejected_steps, advice.limit);
  if (!advice.growth.empty()) text += fmt::format("growth    {}\n", advice.growth);
  return text + text_of_coarser(advice) + text_of_runners(advice, c) + text_of_rest(advice) +
         text_of_builds(advice);
}

}  // namespace odeum::advise
