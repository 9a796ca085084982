// SPDX-License-Identifier: BSD-3-Clause
#include "support/text_case.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "support/stage.hpp"
#include "support/text_truth.hpp"

namespace odeum::cases {
namespace {

using formula::TextOde;

/// The smallest number of equal steps that has every stop on a step; 0 where 1000 are too few.
std::uint64_t steps_multiple(double t0, const std::vector<double>& stops) {
  for (std::uint64_t steps = 1; steps <= 1000; ++steps) {
    const bool fits = std::all_of(stops.begin(), stops.end(), [&](double stop) {
      const double at = (stop - t0) / (stops.back() - t0) * static_cast<double>(steps);
      return std::abs(at - std::round(at)) < 1e-9 && std::round(at) >= 1;
    });
    if (fits) return steps;
  }
  return 0;
}

/// The smallest number of steps, by doubling, with which a method of order 4 has an error below a
/// fiftieth of the solution; 0 where `most` are too few.
std::uint64_t enough_steps(const Case& c, const std::string& method, std::uint64_t most) {
  const auto solver = std::find_if(c.entrants.begin(), c.entrants.end(), [&](const Entrant& e) {
    return e.info.library == "odeum" && e.info.method == method;
  });
  if (solver == c.entrants.end() || !solver->solve) return 0;
  const std::size_t n = c.y0.size();
  std::vector<double> exact(n);
  const auto is_close = [&](const Outcome& outcome) {
    double error = 0, size = 0;
    for (std::size_t stop = 0; stop < c.stops.size(); ++stop) {
      if (!c.truth.at(c.stops[stop], exact.data())) return false;
      for (std::size_t i = 0; i < n; ++i) {
        const double difference = (outcome.states[stop * n + i] - exact[i]) / c.scale_of(i);
        error = std::max(error, std::abs(difference));  // a run that ended well is finite
        size = std::max(size, std::abs(exact[i]) / c.scale_of(i));
      }
    }
    return error <= 0.02 * size;
  };
  const std::uint64_t unit = c.settings.steps_multiple;
  for (std::uint64_t steps = unit * ((15 + unit) / unit); steps <= most; steps *= 2) {
    Request request{.steps = steps, .stops = c.stops};
    request.budget.evaluations = 5'000'000;
    const Outcome outcome = solver->solve(request);
    if (outcome.status == Status::ok && is_close(outcome)) return steps;
  }
  return 0;
}

/// The same for several methods: what the one of them needs that needs most; 0 where one has not
/// enough.
std::uint64_t enough_for_all(const Case& c, std::initializer_list<const char*> methods,
                             std::uint64_t most) {
  std::uint64_t largest = 0;
  for (const char* method : methods) {
    const std::uint64_t steps = enough_steps(c, method, most);
    if (steps == 0) return 0;
    largest = std::max(largest, steps);
  }
  return largest;
}

void choose_steps(Case& c, bool smooth, bool known) {
  StudySettings& s = c.settings;
  const std::uint64_t multiple = steps_multiple(c.t0, c.stops);
  if (multiple == 0) {
    s.no_fixed_steps = "no number of equal steps up to 1000 has every stop on a step";
    return;
  }
  s.steps_multiple = multiple;
  if (!known) return;
  constexpr std::uint64_t most = 40'000, many = 1000;
  const std::uint64_t by_explicit = enough_steps(c, "rk4", most);
  // Newton's method may need smaller steps than the solution does.
  const std::uint64_t by_implicit =
      by_explicit == 0 || by_explicit > many
          ? enough_for_all(c, {"sdirk4", "radau_iia5", "rodas4"}, most / 4)
          : 0;
  if (by_explicit == 0 && by_implicit == 0) {
    s.no_fixed_steps = fmt::format(
        "{} equal steps of an explicit method of order 4, {} of implicit ones, leave more than 2 %",
        most, most / 4);
    s.evaluation_budget = 60'000;
    return;
  }
  if (by_implicit > 0 && (by_explicit == 0 || by_explicit > 8 * by_implicit)) {
    c.tags.emplace_back("stiff");
    s.coarsest_steps = by_implicit;
    s.finest_steps = 32 * by_implicit;
    s.evaluation_budget = 60'000;
    return;
  }
  s.coarsest_steps = by_explicit;
  s.finest_steps = std::clamp<std::uint64_t>(256 * by_explicit, 4096, 16 * most);
  s.evaluation_budget = std::max<std::uint64_t>(500'000, 10 * s.finest_steps);
  if (smooth) c.tags.emplace_back("smooth");
}

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
