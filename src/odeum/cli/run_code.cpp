// SPDX-License-Identifier: BSD-3-Clause
// Programs are texts, *.program: @name@ stands for a value, and a line that begins with //word: is
// there where the word holds.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include "odeum/cases/case_text.hpp"
#include "odeum/cli/run.hpp"
#include "odeum/record/csv.hpp"
#include "odeum/solvers/first_step.hpp"
#include "odeum/solvers/pieces.hpp"

namespace odeum::cli {
namespace {

struct Program {
  const char *name, *text;
};
const Program programs[] = {
#include "lists/programs.inc"
};

std::string filled(const std::string& text, const std::map<std::string, std::string>& values,
                   const std::set<std::string>& holds) {
  std::istringstream lines(text);
  std::string result;
  for (std::string line; std::getline(lines, line);) {
    if (const std::size_t end = line.find(':'); line.starts_with("//") && end < 20)
      if (const std::string word = line.substr(2, end - 2); word.find(' ') == std::string::npos) {
        if (!holds.contains(word)) continue;
        line.erase(0, end + 1);
      }
    for (std::size_t from = 0; (from = line.find('@', from)) != std::string::npos;) {
      const std::size_t end = line.find('@', from + 1);
      const std::string& value = values.at(line.substr(from + 1, end - from - 1));
      line.replace(from, end + 1 - from, value);
      from += value.size();
    }
    result += line + "\n";
  }
  return result;
}

std::string number(double value) { return record::format_number(value); }
std::string list_of(const std::vector<double>& values) {
  std::vector<std::string> texts;
  for (const double value : values) texts.push_back(number(value));
  return fmt::format("{}", fmt::join(texts, ", "));
}

/// The same type as the one that the run is made with, see solvers/enroll_method.hpp.
const char* shared_type(const Case& c, const SolverInfo& info) {
  if (info.needs.find("second-order") == std::string::npos) return "SharedOde";
  return c.problem.view.velocity_dependent ? "SharedSecondOrder" : "SharedSeparable";
}

std::vector<formula::Event> events_of(const Case& c) {
  cases::CaseText text(*c.text);
  return text.problem().events;
}

/// The program that makes the run. Throws UsageError where none does.
std::string program_for(const Case& c, const SolverInfo& info, bool stated,
                        const Request& request) {
  const auto refuse = [&](const char* why) {
    throw UsageError("--code: there is no program for {} {}", info.id(), why);
  };
  if (info.method.ends_with(as_it_comes) || request.options.contains("projection"))
    refuse("which only this laboratory runs so");
  if (c.problem.implicit && !c.problem.implicit->constraints.jumps.empty())
    refuse("on a text whose states jump with a constraint");
  if (c.problem.events) {
    if (!stated) refuse("on a model with events that no text states");
    if (info.library != "odeum" || info.needs.starts_with("residuals"))
      refuse("on a text with events: own methods have one");
    for (const formula::Event& event : events_of(c))
      if (event.condition != formula::no_node || event.delay != formula::no_node ||
          event.priority != formula::no_node)
        refuse("on events with conditions, delays or priorities");
    return "events";
  }
  if (info.library == "odeum" && !info.needs.starts_with("residuals"))
    return stated ? "odeum" : "laboratory";
  if (!stated) refuse("on a case that no text of equations states");
  if (request.mode == Mode::fixed) refuse("at a fixed step: give --tol");
  const std::string& m = info.method;
  if (info.library == "gsl" || (info.library == "cvode" && (m == "bdf" || m == "adams")))
    return info.library;
  for (const char* pair :
       {"runge_kutta_cash_karp54", "runge_kutta_dopri5", "runge_kutta_fehlberg78"})
    if (info.library == "odeint" && m == pair && !request.tolerance.by_component()) return "odeint";
  refuse(
      "yet: there are programs for own methods, gsl, cvode/bdf and cvode/adams, and with one "
      "absolute tolerance for odeint's pairs runge_kutta_cash_karp54, runge_kutta_dopri5 and "
      "runge_kutta_fehlberg78");
  return {};
}

/// The first step, where a library leaves it to its user; adapters use the same rule.
double first_step_of(const Case& c, const SolverInfo& info, const Request& request) {
  GuardedView view(c.problem.view, Budget{}, &request.tolerance);
  const double lower = info.library == "odeint" ? 1 : 0;
  const int order = info.family == "extrapolation" ? 6
                    : std::isnan(info.order)       ? 1
                                                   : static_cast<int>(info.order - lower);
  return first_step(view, c.t0, c.y0, request.stops.back(), order, request.tolerance);
}

/// What the program of a text with events has of them.
void add_events(const Case& c, std::map<std::string, std::string>& values) {
  const std::vector<formula::Event> events = events_of(c);
  std::vector<std::string> whens, ranks, clock;
  std::vector<std::pair<double, std::size_t>> times;
  std::vector<std::size_t> order(events.size());
  for (std::size_t k = 0; k < events.size(); ++k) {
    order[k] = k;
    if (events[k].when != formula::no_node)
      whens.push_back(fmt::format("std::pair<std::size_t, Crossing>{{{}, Crossing::{}}}", k,
                                  events[k].sense > 0   ? "rising"
                                  : events[k].sense < 0 ? "falling"
                                                        : "any"));
    for (const long double t : events[k].times)
      if (t > c.t0 && t <= c.end()) times.emplace_back(static_cast<double>(t), k);
  }
  std::ranges::sort(times);
  for (const auto& [t, k] : times) clock.push_back(fmt::format("{{{}, {}}}", number(t), k));
  std::ranges::stable_sort(order, {}, [&](std::size_t k) { return events[k].order; });
  for (const std::size_t k : order)
    ranks.push_back(fmt::format("{{{}, {}, {}}}", k, events[k].order, events[k].stop));
  values["watched"] = fmt::format("{}", whens.size());
  values["whens"] = fmt::format("{}", fmt::join(whens, ", "));
  values["clock"] = fmt::format("{}", fmt::join(clock, ", "));
  values["ranks"] = fmt::format("{}", fmt::join(ranks, ", "));
}

}  // namespace

std::string code_of(const Case& c, const std::string& problem, const Entrant& entrant,
                    const Request& request) {
  const SolverInfo& info = entrant.info;
  const std::string name = program_for(c, info, !problem.empty(), request);
  const bool fixed = request.mode == Mode::fixed;
  const double end = request.stops.back();
  const bool needs_eigen = info.family == "implicit_rk" || info.family == "exponential";
  std::map<std::string, std::string> values{
      {"id", c.id},
      {"solver", info.id()},
      {"method", info.method},
      {"equation", c.equation},
      {"problem", problem},
      {"shared", shared_type(c, info)},
      {"target", needs_eigen ? "integrators_eigen" : "integrators"},
      {"t0", number(c.t0)},
      {"end", number(end)},
      {"y0", list_of(c.y0)}};
  if (name == "events") add_events(c, values);
  std::set<std::string> holds{info.method};
  if (fixed) {
    holds.insert("step");
    values["step"] = number((end - c.t0) / static_cast<double>(request.steps));
  } else {
    const Tolerance& tolerance = request.tolerance;
    holds.insert(tolerance.by_component() ? "many" : "one");
    values["relative"] = number(tolerance.relative);
    values["absolute"] = number(tolerance.absolute(0));
    values["absolutes"] = list_of(tolerance.absolutes());
    values["thresholds"] = list_of(tolerance.thresholds);
    values["explicit"] = info.family == "explicit_rk" ? "1" : "0";
    values["METHOD"] = info.method == "bdf" ? "BDF" : "ADAMS";
    if (info.library != "odeum") values["first"] = number(first_step_of(c, info, request));
  }
  for (const auto& [option, value] : request.options) {
    holds.insert(option);
    values[option] = number(value);
  }
  holds.insert(problem.find("void time_derivative(") == std::string::npos ? "autonomous" : "timed");
  const auto* const found = std::find_if(std::begin(programs), std::end(programs),
                                         [&](const Program& each) { return each.name == name; });
  return filled(found->text, values, holds);
}

}  // namespace odeum::cli
