// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/text_facts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "odeum/cases/text_events.hpp"
#include "odeum/formula/evaluator.hpp"

namespace odeum::cases {
namespace {

/// v M v / 2 at the start and at the stops, of the exact solution.
std::string kinetic_energies(const formula::Problem& p, const TextTruth& truth) {
  const formula::Evaluator<long double> energy(p.graph, {p.kinetic_energy});
  std::vector<long double> y = p.y0;
  long double value = 0;
  energy(p.t0, y.data(), &value);
  std::string text = fmt::format("energy v M v / 2 = {:.9Lg} at t = {:.6Lg}", value, p.t0);
  for (const double stop : truth.stops) {
    if (!truth.extended(stop, y.data())) continue;
    energy(stop, y.data(), &value);
    text += fmt::format(", {:.9Lg} at t = {:.6g}", value, stop);
  }
  return text;
}

/// Empty where the equations name no times.
std::string switches_in_words(const Case& c) {
  if (!c.problem.switches) return {};
  const std::vector<Switch> all = c.problem.switches(c.t0, c.end());
  constexpr std::size_t most = 8;
  std::string text;
  for (std::size_t k = 0; k < std::min(all.size(), most); ++k)
    text += fmt::format("{}{:.9g}", k == 0 ? "" : ", ", all[k].t);
  if (text.empty()) return {};
  return fmt::format("at t = {}{}, where steps to a tolerance end", text,
                     all.size() > most ? fmt::format(", ... ({} times)", all.size()) : "");
}

}  // namespace

Facts text_facts(const formula::Problem& p, const formula::Analysis& analysis,
                 const formula::TextOde* ode, const TextTruth& truth, const Case& c) {
  Facts facts;
  std::string parameters;
  for (const auto& [name, value] : p.parameters)
    parameters += fmt::format("{}{} = {:.12Lg}", parameters.empty() ? "" : ", ", name, value);
  if (!parameters.empty()) facts.emplace_back("set", parameters);
  std::vector<std::string> names(
      p.states.begin(),
      p.states.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(8, p.states.size())));
  facts.emplace_back("states", fmt::format("{}: {}{}", p.states.size(), fmt::join(names, ", "),
                                           names.size() < p.states.size() ? ", ..." : ""));
  facts.insert(facts.end(), p.notes.begin(), p.notes.end());
  for (const std::string& line : formula::describe(analysis.structure))
    facts.emplace_back("found", line);
  if (c.nature.stiff) facts.emplace_back("found", "stiff: explicit methods need many more steps");
  if (const std::string switches = switches_in_words(c); !switches.empty())
    facts.emplace_back("switches", switches);
  if (c.problem.events) facts.emplace_back("events", events_in_words(c.problem.events.get()));
  if (p.kinetic_energy != formula::no_node) {
    facts.emplace_back("mass", p.mass_text);
    facts.emplace_back("kinetic", kinetic_energies(p, truth));
  }
  facts.emplace_back("code", ode ? ode->how() : "compiled with Odeum, as a built-in case");
  facts.emplace_back("truth", truth.words.empty() ? c.truth.source : truth.words);
  return facts;
}

void add_invariants(const formula::Problem& problem, Case& c) {
  for (const formula::Invariant& invariant : problem.invariants) {
    const auto value = std::make_shared<const formula::Evaluator<double>>(
        problem.graph, std::vector<formula::Id>{invariant.value});
    const auto function = [value](const double* state) {
      double result = 0;
      (*value)(0, state, &result);
      return result;
    };
    if (!c.energy && invariant.is_energy())
      c.energy = function;
    else
      c.invariants.push_back({invariant.name, function});
  }
}

void add_outputs(const formula::Problem& problem, Case& c) {
  if (problem.outputs.empty()) return;
  std::vector<formula::Id> roots;
  for (const formula::Output& output : problem.outputs) {
    roots.push_back(output.value);
    c.outputs.names.push_back(output.name);
  }
  c.outputs.at = [values =
                      std::make_shared<const formula::Evaluator<double>>(problem.graph, roots)](
                     double t, const double* y, double* out) { (*values)(t, y, out); };
}

bool has_name_of_column(const std::vector<std::string>& states) {
  const std::vector<std::string> columns{"schema", "case",   "library", "solver",
                                         "time",   "energy", "error"};
  return std::find_first_of(states.begin(), states.end(), columns.begin(), columns.end()) !=
         states.end();
}

}  // namespace odeum::cases
