// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/why/why_answer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "odeum/record/table.hpp"
#include "odeum/solvers/settings.hpp"

namespace odeum::why {
namespace {

using Json = nlohmann::ordered_json;

std::string number(double value, const char* format = "{:.3g}") {
  return std::isnan(value) ? "-" : fmt::format(fmt::runtime(format), value);
}

std::string counts_of(const Counters& counters) {
  return fmt::format("{} steps, {} rejected, {} evaluations, {} Jacobians", counters.steps,
                     counters.rejected_steps, counters.rhs_evaluations,
                     counters.jacobian_evaluations);
}

/// A fixed step is bound by nothing but an edge.
const char* word_of(const Why& why, const std::optional<Cause>& cause) {
  if (cause) return name_of(*cause);
  return why.request.mode == Mode::fixed ? "-" : "unknown";
}

std::string table_of(const Why& why) {
  if (why.segments.empty()) return {};
  record::Table table{.columns = {{"from"},
                                  {"to"},
                                  {"steps", true},
                                  {"evaluations", true},
                                  {"bound by"},
                                  {"step", true},
                                  {"|lambda|", true},
                                  {"rate", true},
                                  {"of edge", true},
                                  {"component"}},
                      .rows = {}};
  for (const Segment& s : why.segments)
    table.rows.push_back({number(s.from, "{:.5g}"), number(s.to, "{:.5g}"),
                          number(s.steps, "{:.0f}"), std::to_string(s.evaluations),
                          word_of(why, s.cause), number(s.h), number(s.fastest), number(s.rate),
                          number(s.used), s.component});
  return table.text();
}

/// Another run's solver, or its tolerance where that alone is another one.
std::string said(const Other& other, const Why& why) {
  const double tolerance = other.request.tolerance.relative;
  return other.id() == why.solver && other.request.mode == Mode::adaptive &&
                 tolerance != why.request.tolerance.relative
             ? fmt::format("the same to a tolerance of {:g}", tolerance)
             : other.id();
}

/// What the better run does better.
std::string compared(const Why& why) {
  if (!why.better) return why.advice.empty() ? "" : "; " + why.advice;
  const Other& other = why.others[*why.better];
  const std::string name = said(other, why);
  const Counters &ours = why.outcome.counters, &theirs = other.counters;
  if (other.request.stops.back() < why.request.stops.back())
    return fmt::format("; up to t = {:.6g} {} takes {} steps", other.request.stops.back(), name,
                       theirs.steps);
  if (why.outcome.status != Status::ok)
    return fmt::format("; it takes {} steps to t = {:.4g}, where {} takes {} to the end",
                       ours.steps, why.reached, name, theirs.steps);
  const bool nearer = other.difference < 0.5 * why.difference;
  if (nearer && why.difference > 1e-3)
    return fmt::format(
        "; it ends {:.2g} of the solution's size away, and {} ends {:.1g} away in {} "
        "steps",
        why.difference, name, std::max(other.difference, why.doubt), theirs.steps);
  if (theirs.steps < ours.steps)
    return fmt::format("; {} steps where {} takes {}", ours.steps, name, theirs.steps);
  return fmt::format("; {} evaluations where {} takes {}{}", ours.rhs_evaluations, name,
                     theirs.rhs_evaluations, nearer ? " and ends nearer to the solution" : "");
}

/// What distances are measured from.
std::string measure_of(const Why& why) {
  if (why.known_by.empty())
    return "measure        none: neither is the truth known at the end, nor do two runs of "
           "different families agree there\n";
  return fmt::format(
      "measure        the end of {}{}; `off` is the largest distance of a component "
      "over its size\n",
      why.known_by, why.doubt > 0 ? fmt::format(", which agree to {:.1g}", why.doubt) : "");
}

/// How far a run is off, as far as that is known.
std::string off_text(double difference, const Why& why) {
  if (!std::isfinite(difference)) return "";
  return difference < why.doubt ? fmt::format(", off below {:.1g}", why.doubt)
                                : fmt::format(", off {:.2g}", difference);
}

}  // namespace

std::string setting_of(const Request& request, const Case& c) {
  std::string text;
  const Tolerance &tolerance = request.tolerance, usual = c.tolerance.requested(tolerance.relative);
  if (request.mode == Mode::fixed) {
    text = fmt::format("--step {}", step_of(request, c.t0));
  } else if (tolerance.absolutes() == usual.absolutes()) {
    text = fmt::format("--tol {}", tolerance.relative);
  } else {
    std::vector<double> absolutes = tolerance.absolutes();
    if (absolutes.empty()) absolutes.push_back(tolerance.relative);
    text = fmt::format("--rtol {} --atol {}", tolerance.relative, fmt::join(absolutes, ","));
  }
  if (request.stops.back() != c.end()) text += fmt::format(" --until {}", request.stops.back());
  return text;
}

std::string command_of(const Why& why, const Case& c, const advise::Asked& asked) {
  if (!why.better) return {};
  const Other& other = why.others[*why.better];
  return fmt::format("odeum run {}{} --solver {} {}", asked.problem, asked.more, other.id(),
                     setting_of(other.request, c));
}

record::Records segments_of(const Why& why) {
  record::Records table{{"from", "to", "steps", "rhs_evaluations", "bound_by", "step", "fastest",
                         "rate", "of_edge", "component"}};
  for (const Segment& s : why.segments)
    table.rows.push_back({s.from, s.to, s.steps, s.evaluations, word_of(why, s.cause), s.h,
                          s.fastest, s.rate, s.used, s.component});
  return table;
}

std::string first_line(const Why& why) {
  const std::vector<Finding>& findings = why.findings;
  std::string text;
  if (findings.empty()) {
    text =
        why.outcome.status == Status::ok
            ? "nothing that was measured binds or harms this run"
            : fmt::format("the run ends {} at t = {:.6g}, and nothing that was measured says why",
                          to_string(why.outcome.status), why.reached);
  } else if (const Finding& main = findings.front();
             std::isnan(main.share) ||
             (why.request.mode == Mode::fixed && main.cause != Cause::kink)) {
    text = main.text;
  } else if (main.cause == Cause::accuracy || main.cause == Cause::stability) {
    text = fmt::format("from t = {:.4g} on, {:.0f} % of the steps are bound by {}: {}", main.from,
                       100 * main.share,
                       main.cause == Cause::accuracy ? "the error test" : "stability", main.text);
  } else if (main.cause == Cause::events) {
    text = main.text;
  } else {
    text =
        fmt::format("{}: {:.0f} % of the evaluations are spent on it", main.text, 100 * main.share);
  }
  return text + compared(why);
}

std::string text_of(const Why& why, const Case& c, const advise::Asked& asked,
                    const std::vector<std::pair<std::string, std::string>>& judged) {
  std::string text = first_line(why) + "\n";
  text += fmt::format("run            {} {}\n", why.solver, setting_of(why.request, c));
  text += fmt::format("status         {}{}{}\n", to_string(why.outcome.status),
                      why.outcome.detail.empty() ? "" : ": ", why.outcome.detail);
  text += fmt::format("cost           {} to t = {:.6g}{}{}\n", counts_of(why.outcome.counters),
                      why.reached,
                      std::isnan(why.error) ? "" : fmt::format(", error {:.3g}", why.error),
                      off_text(why.difference, why));
  if (why.outcome.status == Status::over_budget)
    text +=
        fmt::format("               some {:.2g} more steps to the end, of the length of the last\n",
                    why.steps_left);
  for (const auto& [name, said] : judged) text += fmt::format("{:<15}{}\n", name, said);
  for (const Finding& finding : why.findings)
    text +=
        fmt::format("{:<15}{}{}\n", name_of(finding.cause),
                    std::isnan(finding.share) ? "" : fmt::format("{:.0f} %: ", 100 * finding.share),
                    finding.text);
  text += table_of(why);
  if (!why.exact_steps)
    text +=
        "steps          their ends are not told by the solver: they are taken from its "
        "evaluations\n";
  text += measure_of(why);
  for (const Other& other : why.others)
    text += fmt::format("tried          {} {}: {}, {}{}{}\n", other.id(),
                        setting_of(other.request, c), other.status, counts_of(other.counters),
                        std::isnan(other.error) ? "" : fmt::format(", error {:.3g}", other.error),
                        off_text(other.difference, why));
  if (!why.advice.empty()) text += fmt::format("besides        {}\n", why.advice);
  const std::string command = command_of(why, c, asked);
  return text +
         (command.empty()
              ? "next           none of those tried at its tolerance ends clearly nearer to the "
                "solution, or as near for less work\n"
              : fmt::format("next           {}\n", command));
}

Json json_of(const Why& why, const Case& c, const advise::Asked& asked) {
  const auto counters = [](Json& json, const Counters& of) {
    json["steps"] = of.steps;
    json["rejected_steps"] = of.rejected_steps;
    json["rhs_evaluations"] = of.rhs_evaluations;
    json["jacobian_evaluations"] = of.jacobian_evaluations;
  };
  Json json;
  json["summary"] = first_line(why);
  json["solver"] = why.solver;
  json["setting"] = setting_of(why.request, c);
  json["status"] = to_string(why.outcome.status);
  json["detail"] = why.outcome.detail;
  json["reached"] = why.reached;
  json["error"] = why.error;
  json["difference"] = why.difference;
  json["known_by"] = why.known_by;
  json["doubt"] = why.doubt;
  counters(json, why.outcome.counters);
  json["causes"] = Json::array();
  for (const Finding& finding : why.findings)
    json["causes"].push_back({{"cause", name_of(finding.cause)},
                              {"share", finding.share},
                              {"from", finding.from},
                              {"text", finding.text}});
  json["segments"] = Json::array();
  const record::Records segments = segments_of(why);
  for (const std::vector<record::Cell>& row : segments.rows) {
    Json& segment = json["segments"].emplace_back();
    for (std::size_t k = 0; k < row.size(); ++k)
      std::visit([&](const auto& value) { segment[segments.columns[k]] = value; }, row[k]);
  }
  json["steps_left"] = why.steps_left;
  json["exact_steps"] = why.exact_steps;
  json["others"] = Json::array();
  for (const Other& other : why.others) {
    Json each{{"solver", other.id()},
              {"setting", setting_of(other.request, c)},
              {"status", other.status},
              {"error", other.error},
              {"difference", other.difference}};
    counters(each, other.counters);
    json["others"].push_back(each);
  }
  json["advice"] = why.advice;
  json["command"] = command_of(why, c, asked);
  return json;
}

}  // namespace odeum::why
