// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/advise/answer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <sstream>

namespace odeum::advise {
namespace {

const Candidate& winner_of(const Advice& advice) { return advice.candidates[advice.winner]; }

/// A step, or a relative tolerance.
double setting_of(const Trial& trial, const Case& c) {
  return trial.request().mode == Mode::adaptive
             ? trial.request().tolerance.relative
             : (c.stops.back() - c.t0) / static_cast<double>(trial.request().steps);
}

const char* kind_of(Mode mode) { return mode == Mode::fixed ? "step" : "tol"; }

std::string text_of_ns(double ns) {
  if (ns < 1e3) return fmt::format("{:.3g} ns", ns);
  return ns < 1e6   ? fmt::format("{:.3g} us", ns / 1e3)
         : ns < 1e9 ? fmt::format("{:.3g} ms", ns / 1e6)
                    : fmt::format("{:.3g} s", ns / 1e9);
}

std::vector<std::string> words_in(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

std::string command_of(const Advice& advice, const Case& c, const Asked& asked) {
  const Candidate& winner = winner_of(advice);
  // Of a box, at the parameters of the largest error.
  std::string sets;
  if (!asked.points.empty())
    for (const std::string& set : words_in(asked.points[winner.found->worst()]))
      sets += " --set " + set;
  return fmt::format("odeum run {}{}{} --solver {} --{} {}", asked.problem, asked.more, sets,
                     winner.entrant->info.id(), kind_of(winner.mode), setting_of(*winner.found, c));
}

/// Others that the times do not tell from the winner; within a time, others of about its error.
std::vector<std::string> same_within_noise(const Advice& advice) {
  std::vector<std::string> ids;
  for (const std::size_t k : advice.timed) {
    const Candidate& other = advice.candidates[k];
    const Candidate& winner = winner_of(advice);
    const bool same = advice.run_ns > 0 ? advice.same_error(*other.found, *winner.found)
                                        : other.times.min() <= winner.times.median();
    if (k != advice.winner && !other.closed_form() && same)
      ids.push_back(fmt::format("{} --{}", other.entrant->info.id(), kind_of(other.mode)));
  }
  return ids;
}

/// What a run with twice the step says of a fixed step, one with ten times the tolerance of a
/// step control.
std::string limit_of(const Advice& advice) {
  if (!advice.twice) return "unknown: half as many steps do not end on the stops";
  const Candidate& winner = winner_of(advice);
  const Trial &found = *winner.found, &twice = *advice.twice;
  if (winner.mode == Mode::fixed) {
    // Four times what the order explains.
    const double explained = 4 * std::pow(2, winner.slope()) * found.error;
    return twice.status == Status::ok && twice.error <= explained ? "accuracy" : "stability";
  }
  if (twice.status != Status::ok) return "stability";
  const auto all = [](const Trial& trial) {
    return static_cast<double>(trial.counters.steps + trial.counters.rejected_steps);
  };
  // A pair of order 20 would save a tenth of its steps.
  return all(twice) > 0.9 * all(found) ? "stability" : "accuracy";
}

std::string text_of_twice(const Advice& advice) {
  if (!advice.twice) return {};
  const Trial& twice = *advice.twice;
  const char* what =
      winner_of(advice).mode == Mode::fixed ? "a step twice as long" : "ten times the tolerance";
  if (twice.status != Status::ok)
    return fmt::format("twice     {}: the run ends {}\n", what, to_string(twice.status));
  return fmt::format("twice     {}: error {:.3g}, {} steps\n", what, twice.state_error(),
                     twice.counters.steps);
}

struct RunnerUp {
  const Candidate* candidate;
  std::string why;  ///< the best of its library or family
};

/// The best of every other library, and the best of another family.
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

std::string text_of_runners(const Advice& advice, const Case& c) {
  const double least = winner_of(advice).times.min();
  std::string text;
  for (const auto& [other, why] : runners_up(advice)) {
    if (advice.run_ns > 0) {
      text +=
          fmt::format("behind    {} --{} {:.3g}: {:.3g} times the error in {} ({})\n",
                      other->entrant->info.id(), kind_of(other->mode), setting_of(*other->found, c),
                      other->found->state_error() / winner_of(advice).found->state_error(),
                      text_of_ns(other->times.min()), why);
      continue;
    }
    text +=
        fmt::format("behind    {} --{} {:.3g}: {:.2f} times the time, error {:.2g} ({})\n",
                    other->entrant->info.id(), kind_of(other->mode), setting_of(*other->found, c),
                    other->times.min() / least, other->found->state_error(), why);
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

/// Why each of those that take no part any more was left.
std::string reason_of(const Candidate& candidate, bool within) {
  if (candidate.trials.empty()) return "the seconds were over";
  if (!candidate.dropped.empty()) return candidate.dropped;
  if (candidate.found)
    return within ? "a larger error in its counted runs" : "slower in its counted runs";
  const Trial& last = candidate.trials.back();
  if (within && last.ns > 0 && last.status == Status::ok) return "slower than the time given";
  if (within && last.status == Status::over_budget) return "slower than ten times the time given";
  if (last.status == Status::over_budget)
    return "its last run was stopped after ten times the best run's time, or its share of the "
           "seconds";
  return last.status == Status::ok ? fmt::format("its error stayed at {:.2g}", last.error)
                                   : fmt::format("its last run ended {}", to_string(last.status));
}

template <class Visit>
void each_dropped(const Advice& advice, const Visit& visit) {
  for (std::size_t k = 0; k < advice.candidates.size(); ++k)
    if (std::find(advice.timed.begin(), advice.timed.end(), k) == advice.timed.end())
      visit(advice.candidates[k]);
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
    dropped[candidate.dropped.empty() ? reason_of(candidate, within) : left].push_back(
        fmt::format("{} --{}", candidate.entrant->info.id(), kind_of(candidate.mode)));
  });
  std::string text;
  for (const auto& [reason, ids] : dropped)
    text += fmt::format("dropped   {}: {}\n", reason, text_of_many(ids));
  for (const auto& [reason, ids] : advice.not_tried)
    text += fmt::format("not tried {}: {}\n", reason, text_of_many(ids));
  return text.empty() ? text : text + "          (--format json names each of them)\n";
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
  const auto slow = std::max_element(found.parts.begin(), found.parts.end(), slower),
             fast = std::min_element(found.parts.begin(), found.parts.end(), slower);
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
  std::string text =
      fmt::format("{} --{} {:.4g}: error {:.3g} (+- {:.1g}) in {} ({} median of {}){}\n",
                  winner.entrant->info.id(), kind_of(winner.mode), setting_of(found, c),
                  found.state_error(), advice.floor, text_of_ns(winner.times.min()),
                  text_of_ns(winner.times.median()), winner.times.ns.size(), sureness(advice));
  if (advice.frames > 0)
    text += fmt::format("frame     {:g} steps of it a frame, {} of the {} given\n",
                        static_cast<double>(found.request().steps) / advice.frames,
                        text_of_ns(winner.times.min() / advice.frames),
                        text_of_ns(advice.wishes.time_ns));
  text += text_of_wishes(advice, asked);
  text += fmt::format("run       {}\n", command_of(advice, c, asked));
  if (const std::string other = difference(advice, c); !other.empty())
    text += fmt::format("          {}\n", other);
  text += fmt::format("cost      {} evaluations, {} steps, {} rejected\nlimit     {}\n",
                      found.counters.rhs_evaluations, found.counters.steps,
                      found.counters.rejected_steps, limit_of(advice));
  return text + text_of_twice(advice) + text_of_runners(advice, c) + text_of_rest(advice);
}

nlohmann::ordered_json json_of(const Advice& advice, const Case& c, const Asked& asked) {
  using Json = nlohmann::ordered_json;
  Json json, not_tried = Json::array();
  for (const auto& [reason, ids] : advice.not_tried)
    not_tried.push_back({{"reason", reason}, {"solvers", ids}});
  if (!advice.failure.empty()) return {{"failure", advice.failure}, {"not_tried", not_tried}};
  const Candidate& winner = winner_of(advice);
  const Trial& found = *winner.found;
  json["solver"] = winner.entrant->info.id();
  json["setting_kind"] = kind_of(winner.mode);
  json["setting"] = setting_of(found, c);
  const std::vector<double>& absolutes = found.request().tolerance.absolutes();
  if (winner.mode == Mode::fixed)
    json["absolute"] = nullptr;
  else if (absolutes.size() > 1)
    json["absolute"] = absolutes;
  else
    json["absolute"] = absolutes.empty() ? setting_of(found, c) : absolutes.front();
  json["error"] = found.state_error();
  json["error_low"] = std::max(0.0, found.state_error() - advice.floor);
  json["error_high"] = found.state_error() + advice.floor;
  if (advice.wishes.energy > 0) json["energy_error"] = found.energy_error();
  for (std::size_t k = 0; k < asked.points.size(); ++k)
    json["box"].push_back({{"parameters", asked.points[k]},
                           {"error", found.parts[k].error},
                           {"time_ns", found.parts[k].ns}});
  json["time_ns"] = json["time_low"] = winner.times.min();
  json["time_high"] = winner.times.median();
  if (advice.run_ns > 0) json["time_asked"] = advice.wishes.time_ns;
  if (advice.frames > 0) {
    json["steps_per_frame"] = static_cast<double>(found.request().steps) / advice.frames;
    json["frame_ns"] = winner.times.min() / advice.frames;
  }
  json["limited_by"] = limit_of(advice);
  json["runners_up"] = Json::array();
  for (const auto& [other, why] : runners_up(advice))
    json["runners_up"].push_back({{"solver", other->entrant->info.id()},
                                  {"setting_kind", kind_of(other->mode)},
                                  {"setting", setting_of(*other->found, c)},
                                  {"error", other->found->state_error()},
                                  {"ratio", other->times.min() / winner.times.min()},
                                  {"why", why}});
  json["not_tried"] = not_tried;
  json["command"] = command_of(advice, c, asked);
  json["command_error"] = advice.repeated.error;
  json["command_evaluations"] = advice.repeated.counters.rhs_evaluations;
  json["evaluations"] = found.counters.rhs_evaluations;
  json["same_within_noise"] = same_within_noise(advice);
  json["dropped"] = Json::array();
  each_dropped(advice, [&](const Candidate& candidate) {
    json["dropped"].push_back({{"solver", candidate.entrant->info.id()},
                               {"setting_kind", kind_of(candidate.mode)},
                               {"reason", reason_of(candidate, advice.run_ns > 0)}});
  });
  json["cut_short"] = advice.cut;
  json["disturbed"] = advice.disturbed;
  return json;
}

}  // namespace odeum::advise
