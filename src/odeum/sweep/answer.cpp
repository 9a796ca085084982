// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/sweep/answer.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "odeum/why/why_answer.hpp"

namespace odeum::sweep {
namespace {

std::string setting_of(const Plan& plan) {
  return plan.study ? plan.study->words : why::setting_of(plan.request, *plan.base);
}

constexpr std::array names{"least", "5 %", "median", "95 %", "greatest"};

}  // namespace

std::string command_of(const Plan& plan, const Asked& asked, std::uint64_t member) {
  return fmt::format("odeum {} {}{}{}{}{}{}", plan.study ? plan.study->name : "run", asked.what,
                     asked.more, sets_of(plan, member), plan.solver.empty() ? "" : " --solver ",
                     plan.solver, setting_of(plan).empty() ? "" : " " + setting_of(plan));
}

std::string text_of(const Plan& plan, const Result& result, const Asked& asked) {
  std::string text = fmt::format("sweep     {} members of {}\n{:<9}", result.size, plan.base->id,
                                 plan.study ? plan.study->name : "solver");
  for (const std::string& word : {plan.solver, setting_of(plan)})
    if (!word.empty()) text += ' ' + word;
  text += '\n';
  text += fmt::format("solved    {} ({:.4g} %)\n", result.solved,
                      100 * static_cast<double>(result.solved) / static_cast<double>(result.size));
  for (const auto& [status, ending] : result.endings)
    text += fmt::format("{}    {} {}, first member {}{}{}\n          {}\n",
                        plan.study ? "answer" : "failed", ending.count, status, ending.first,
                        ending.detail.empty() ? "" : ": ", ending.detail,
                        command_of(plan, asked, ending.first));
  constexpr std::size_t most = 12;
  for (std::size_t q = 0; q < std::min(result.quantiles.size(), most); ++q) {
    if (result.solved == 0) break;
    text += fmt::format("{:<9}", plan.quantities[q].name);
    for (std::size_t k = 0; k < names.size(); ++k)
      text += fmt::format("{}{} {:.6g}", k == 0 ? " " : ", ", names[k], result.quantiles[q][k]);
    text += '\n';
  }
  if (result.quantiles.size() > most)
    text += fmt::format("          and {} more: --quantity names those that are wanted\n",
                        result.quantiles.size() - most);
  const Checks& checks = result.checks;
  if (checks.made > 0)
    text += fmt::format(
        "error     of {} members, {}: median {:.3g}, largest {:.3g}, member {}\n          {}\n",
        checks.made,
        checks.all
            ? fmt::format("each against its closed form{}",
                          checks.made < checks.wanted
                              ? fmt::format(", which holds for no other of {}", checks.wanted)
                              : "")
            : "evenly spread, each against a truth of its own",
        checks.median, checks.largest, checks.worst, command_of(plan, asked, checks.worst));
  else if (checks.wanted > 0)
    text += "error     not known: no member that was compared ended and has a truth\n";
  text += fmt::format(
      "time      {:.3g} s on {} thread{}, {:.3g} us a member and thread; {} evaluations\n",
      result.seconds, plan.jobs, plan.jobs == 1 ? "" : "s",
      1e6 * result.seconds * plan.jobs / static_cast<double>(result.size), result.evaluations);
  if (!result.one_code && !plan.study)
    text +=
        "note      a case was made for each member, since the parameters cannot change in place\n";
  return text;
}

Joined join(const std::vector<Plan>& plans, std::vector<Result> results) {
  Joined all{plans.front(), std::move(results.front())};
  if (plans.size() == 1) return all;
  const std::size_t solvers = plans.size(), quantities = plans.front().quantities.size();
  std::vector<double> values(all.result.results.size() * solvers);
  all.plan.quantities.clear();
  std::vector<std::vector<record::Cell>> over_time;
  for (std::size_t s = 0; s < solvers; ++s) {
    const Result& one = s == 0 ? all.result : results[s];
    for (std::size_t q = 0; q < quantities; ++q) {
      all.plan.quantities.push_back(plans[s].quantities[q]);
      all.plan.quantities.back().name += ", " + plans[s].solver;
      for (std::size_t member = 0; member < one.size; ++member)
        values[(member * solvers + s) * quantities + q] = one.results[member * quantities + q];
    }
    for (std::vector<record::Cell> row : one.over_time.rows) {
      row[1] = std::get<std::string>(row[1]) + ", " + plans[s].solver;
      over_time.push_back(std::move(row));
    }
    if (s > 0) all.result.csv += one.csv.substr(one.csv.find('\n') + 1);
  }
  all.result.results = std::move(values);
  all.result.over_time.rows = std::move(over_time);
  return all;
}

nlohmann::ordered_json json_of(const Plan& plan, const Result& result, const Asked& asked) {
  using nlohmann::ordered_json;
  ordered_json json{{"problem", plan.base->id},
                    {"solver", plan.solver},
                    {"setting", setting_of(plan)},
                    {"members", result.size},
                    {"solved", result.solved}};
  const char* const endings = plan.study ? "answers" : "failed";
  json[endings] = ordered_json::array();
  for (const auto& [status, ending] : result.endings)
    json[endings].push_back({{"status", status},
                             {"members", ending.count},
                             {"first", ending.first},
                             {"detail", ending.detail},
                             {"command", command_of(plan, asked, ending.first)}});
  json["quantities"] = ordered_json::array();
  for (std::size_t q = 0; q < result.quantiles.size(); ++q) {
    ordered_json one{{"name", plan.quantities[q].name}};
    for (std::size_t k = 0; k < names.size(); ++k) one[names[k]] = result.quantiles[q][k];
    json["quantities"].push_back(one);
  }
  const Checks& checks = result.checks;
  json["checked"] = {{"of_all", checks.all},
                     {"members", checks.made},
                     {"error_median", checks.median},
                     {"error_largest", checks.largest}};
  if (checks.made > 0) {
    json["checked"]["worst"] = checks.worst;
    json["checked"]["command"] = command_of(plan, asked, checks.worst);
  }
  json["seconds"] = result.seconds;
  json["threads"] = plan.jobs;
  json["rhs_evaluations"] = result.evaluations;
  return json;
}

}  // namespace odeum::sweep
