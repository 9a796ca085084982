// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "odeum/advise/answer_parts.hpp"

namespace odeum::advise {

namespace {

nlohmann::ordered_json box_of(const Trial& found, const Asked& asked) {
  nlohmann::ordered_json box;
  for (std::size_t k = 0; k < asked.points.size(); ++k)
    box.push_back({{"parameters", fmt::format("{}", fmt::join(asked.points[k], " "))},
                   {"error", found.parts[k].error},
                   {"rhs_evaluations", found.parts[k].counters.rhs_evaluations}});
  return box;
}

}  // namespace

nlohmann::ordered_json json_of(const Advice& advice, const Case& c, const Asked& asked) {
  using Json = nlohmann::ordered_json;
  Json json, not_tried = Json::array();
  for (const auto& [reason, ids] : advice.not_tried)
    not_tried.push_back({{"reason", reason}, {"solvers", ids}});
  if (!advice.failure.empty()) return {{"failure", advice.failure}, {"not_tried", not_tried}};
  const Candidate& winner = winner_of(advice);
  const Trial& found = *winner.found;
  json["solver"] = winner.entrant->info.id();
  json["setting_kind"] = setting_kind(winner.mode);
  json["setting"] = setting_of(found.request(), c.t0);
  const std::vector<double>& absolutes = found.request().tolerance.absolutes();
  if (winner.mode == Mode::fixed)
    json["absolute"] = nullptr;
  else if (absolutes.size() > 1)
    json["absolute"] = absolutes;
  else
    json["absolute"] = absolutes.empty() ? setting_of(found.request(), c.t0) : absolutes.front();
  json["error"] = found.state_error();
  json["error_low"] = std::max(0.0, found.state_error() - advice.floor);
  json["error_high"] = found.state_error() + advice.floor;
  if (advice.wishes.energy > 0) json["energy_error"] = found.energy_error();
  if (!asked.points.empty()) json["box"] = box_of(found, asked);
  json["time_ns"] = json["time_low"] = winner.times.min();
  json["time_high"] = winner.times.median();
  if (advice.run_ns > 0) json["time_asked"] = advice.wishes.time_ns;
  if (advice.frames > 0) {
    json["steps_per_frame"] = static_cast<double>(found.request().steps) / advice.frames;
    json["frame_ns"] = winner.times.min() / advice.frames;
  }
  json["limited_by"] = advice.limit;
  if (!advice.growth.empty()) json["growth"] = advice.growth;
  if (known_part(c)) json["known_until"] = *known_part(c);
  json["runners_up"] = Json::array();
  for (const auto& [other, why] : runners_up(advice))
    json["runners_up"].push_back({{"solver", other->entrant->info.id()},
                                  {"setting_kind", setting_kind(other->mode)},
                                  {"setting", setting_of(other->found->request(), c.t0)},
                                  {"error", other->found->state_error()},
                                  {"ratio", other->times.min() / winner.times.min()},
                                  {"why", why}});
  json["not_tried"] = not_tried;
  json["command"] = command_of(advice, c, asked);
  const Part& worst = found.parts[found.worst()];
  json["command_error"] = advice.on_stops ? worst.error : worst.end_error;
  json["command_rhs_evaluations"] = worst.counters.rhs_evaluations;
  json["rhs_evaluations"] = found.counters().rhs_evaluations;
  json["same_within_noise"] = same_within_noise(advice);
  json["dropped"] = Json::array();
  each_dropped(advice, [&](const Candidate& candidate) {
    json["dropped"].push_back({{"solver", candidate.entrant->info.id()},
                               {"setting_kind", setting_kind(candidate.mode)},
                               {"reason", reason_of(candidate, advice.run_ns > 0).why}});
  });
  json["cut_short"] = advice.cut;
  json["disturbed"] = advice.disturbed;
  return json;
}

}  // namespace odeum::advise
