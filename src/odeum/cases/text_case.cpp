// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/text_case.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "odeum/cases/stage.hpp"
#include "odeum/cases/study_steps.hpp"
#include "odeum/cases/text_truth.hpp"

namespace odeum::cases {
namespace {

using formula::TextOde;

void enrol(Case& c, const std::shared_ptr<const TextOde>& ode) {
  c.problem = {.view = ode->view(),
               .keep_alive = ode,
               .t0 = c.t0,
               .y0 = std::make_shared<const std::vector<double>>(c.y0),
               .scene = nullptr};
  c.entrants = enroll(c.problem);
}

/// Checks along the truth that the invariants are kept, and adds them to the case.
void add_invariants(Case& c, const std::shared_ptr<const TextOde>& ode, const TextTruth& truth) {
  if (ode->problem().invariants.empty()) return;
  formula::Problem problem = ode->problem();
  std::vector<long double> y(ode->size());
  for (const double stop : truth.stops)
    if (truth.extended(stop, y.data())) formula::require_invariants(problem, stop, y.data());
  for (const formula::Kept& kept : problem.invariants) {
    const auto value = std::make_shared<const formula::Evaluator<double>>(
        problem.graph, std::vector<formula::Id>{kept.value});
    const auto function = [value](const double* state) {
      double result = 0;
      (*value)(0, state, &result);
      return result;
    };
    if (!c.energy && (kept.name == "energy" || kept.name == "H"))
      c.energy = function;
    else
      c.invariants.push_back({kept.name, function});
  }
}

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

void add_tags(Case& c, const formula::Structure& s) {
  c.tags = {s.linear ? "linear" : "nonlinear", s.autonomous ? "autonomous" : "non_autonomous"};
  if (s.second_order) c.tags.emplace_back("second_order");
  if (s.second_order && !s.velocity_dependent) c.tags.emplace_back("separable");
}

}  // namespace

TextCase text_case(const std::string& id, formula::Problem problem, TextOde::Code code) {
  const auto ode = std::make_shared<const TextOde>(std::move(problem), code);
  const formula::Problem& p = ode->problem();
  const formula::Structure& structure = ode->analysis().structure;
  const TextTruth truth = truth_of(ode);
  TextCase made;
  Case& c = made.c;
  c.id = id;
  c.title = p.name.empty() ? id : p.name;
  c.equation = p.equations_text;
  c.source = p.file;
  c.t0 = static_cast<double>(p.t0);
  c.y0.assign(p.y0.begin(), p.y0.end());
  // Names of other columns of the files would stand there twice.
  const std::vector<std::string> columns{"schema", "case",   "library", "solver",
                                         "time",   "energy", "error"};
  if (std::find_first_of(p.states.begin(), p.states.end(), columns.begin(), columns.end()) ==
      p.states.end())
    c.components = p.states;
  c.stops = truth.stops.empty() ? p.stops : truth.stops;
  c.truth = truth.truth;
  c.scale = p.scale;
  c.tolerance = p.tolerance;
  add_tags(c, structure);
  add_invariants(c, ode, truth);
  c.extended = std::make_shared<const ExtendedProblem>(
      ExtendedProblem{.f = [ode](long double t, const long double* y,
                                 long double* f) { ode->rhs_extended(t, y, f); },
                      .y0 = p.y0,
                      .truth = truth.extended,
                      .floor = truth.extended_floor});
  enrol(c, ode);
  choose_steps(c, structure.smooth, !truth.stops.empty());

  made.facts.emplace_back("problem", fmt::format("{} ({})", c.title, p.file));
  std::string parameters;
  for (const auto& [name, value] : p.parameters)
    parameters += fmt::format("{}{} = {:.12Lg}", parameters.empty() ? "" : ", ", name, value);
  if (!parameters.empty()) made.facts.emplace_back("set", parameters);
  std::vector<std::string> names(
      p.states.begin(),
      p.states.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(8, p.states.size())));
  made.facts.emplace_back("states", fmt::format("{}: {}{}", p.states.size(), fmt::join(names, ", "),
                                                names.size() < p.states.size() ? ", ..." : ""));
  for (const std::string& line : formula::describe(structure))
    made.facts.emplace_back("found", line);
  if (c.has_tag("stiff"))
    made.facts.emplace_back("found", "stiff: explicit methods need many more steps");
  if (p.kinetic_energy != formula::no_node) {
    made.facts.emplace_back("mass", p.mass_text);
    made.facts.emplace_back("kinetic", kinetic_energies(p, truth));
  }
  made.facts.emplace_back("code", ode->how());
  made.facts.emplace_back("truth", truth.words);
  return made;
}

}  // namespace odeum::cases
