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
#include "odeum/solvers/loaded.hpp"

namespace odeum::advise {
namespace {

std::string text_of_twice(const Advice& advice) {
  if (!advice.twice) return {};
  const Trial& twice = *advice.twice;
  const char* what =
      winner_of(advice).mode == Mode::fixed ? "a step twice as long" : "ten times the tolerance";
  if (twice.status != Status::ok)
    return fmt::format("coarser   {}: the run ends {}\n", what, to_string(twice.status));
  return fmt::format("coarser   {}: error {:.3g}, {} steps\n", what, twice.state_error(),
                     twice.counters.steps);
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
  for (const std::size_t k : advice.timed)
    if (const Candidate& candidate = advice.candidates[k]; candidate.closed_form())
      text += fmt::format(
          "apart     {} evaluates the closed form of this linear problem and is no method that "
          "steps: {}\n",
          candidate.entrant->info.id(), text_of_ns(candidate.times.min()));
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

/// Names of a few, numbers by library of many.
std::string text_of_many(const std::vector<std::string>& ids) {
  constexpr std::size_t few = 4;
  if (ids.size() <= few) return fmt::format("{}", fmt::join(ids, ", "));
  std::map<std::string, int> by_library;
  for (const std::string& id : ids) ++by_library[id.substr(0, id.find('/'))];
  std::vector<std::string> texts;
  for (const auto& [library, count] : by_library)
    texts.push_back(fmt::format("{} of {}", count, library));
  return fmt::format("{}", fmt::join(texts, ", "));
}

std::string text_of_rest(const Advice& advice) {
  std::map<std::string, std::vector<std::string>> dropped;
  each_dropped(advice, [&](const Candidate& candidate) {
    const bool within = advice.run_ns > 0;
    const char* left = within ? "far behind within the time" : "too slow before they had the error";
    // Of those that came so far each has its reason.
    const bool own = candidate.dropped.empty() || candidate.found;
    dropped[own ? reason_of(candidate, within) : left].push_back(name_of(candidate));
  });
  std::string text;
  for (const auto& [reason, ids] : dropped)
    text += fmt::format("dropped   {}: {}\n", reason, text_of_many(ids));
  for (const auto& [reason, ids] : advice.not_tried)
    text += fmt::format("not tried {}: {}\n", reason, text_of_many(ids));
  return text.empty() ? text : text + "          (--format json names each of them)\n";
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
  const auto slower = [](const Part& a, const Part& b) { return a.ns < b.ns; };
  const auto slow = std::ranges::max_element(found.parts, slower),
             fast = std::ranges::min_element(found.parts, slower);
  const auto point = [&](auto part) {
    return asked.points[static_cast<std::size_t>(part - found.parts.begin())];
  };
  return text + fmt::format(
                    "box       {} points of it; the error is largest at {}; a run takes {} at {} "
                    "and {} at {}\n",
                    asked.points.size(), asked.points[found.worst()], text_of_ns(fast->ns),
                    point(fast), text_of_ns(slow->ns), point(slow));
}

/// What `odeum run` says, where that is not what the race measured.
std::string difference(const Advice& advice, const Case& c) {
  const Trial &run = advice.repeated, &found = *winner_of(advice).found;
  if (c.stops.size() == 1) return {};
  return fmt::format(
      "the command has no stop but the end: error there {:.6g} and {} evaluations, against {:.6g} "
      "at {} stops and {}",
      run.error, run.counters.rhs_evaluations, found.state_error(), c.stops.size(),
      found.counters.rhs_evaluations);
}

}  // namespace

std::string text_of(const Advice& advice, const Case& c, const Asked& asked) {
  if (!advice.failure.empty()) return advice.failure + "\n" + text_of_rest(advice);
  const Candidate& winner = winner_of(advice);
  const Trial& found = *winner.found;
  std::string text = fmt::format(
      "{} {:.4g}: error {:.3g} (+- {:.1g}), {}, in {} ({} median of {}){}\n", name_of(winner),
      setting_of(found.request(), c.t0), found.state_error(), advice.floor,
      c.scale.empty() ? "absolute" : "in the units of the scale", text_of_ns(winner.times.min()),
      text_of_ns(winner.times.median()), winner.times.ns.size(), sureness(advice));
  if (advice.frames > 0)
    text += fmt::format("frame     {:g} steps of it a frame, {} of the {} given\n",
                        static_cast<double>(found.request().steps) / advice.frames,
                        text_of_ns(winner.times.min() / advice.frames),
                        text_of_ns(advice.wishes.time_ns));
  text += text_of_absolutes(found, c);
  text += text_of_wishes(advice, asked);
  if (c.end() > c.stops.back()) text += fmt::format("truth     {}\n", words_of_truth(c));
  text += fmt::format("run       {}\n", command_of(advice, c, asked));
  if (const std::string other = difference(advice, c); !other.empty())
    text += fmt::format("          {}\n", other);
  text += fmt::format("cost      {} evaluations, {} steps, {} rejected\nlimit     {}\n",
                      found.counters.rhs_evaluations, found.counters.steps,
                      found.counters.rejected_steps, limit_of(advice));
  return text + text_of_twice(advice) + text_of_runners(advice, c) + text_of_rest(advice) +
         text_of_builds(advice);
}

}  // namespace odeum::advise
