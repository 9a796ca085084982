// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "odeum/formula/consistent_start.hpp"
#include "odeum/formula/infix.hpp"
#include "odeum/formula/jumps.hpp"
#include "odeum/formula/reader.hpp"

namespace odeum::formula::reading {

using Real = long double;

namespace {

std::string times(int count) {
  return count == 1 ? "once" : count == 2 ? "twice" : fmt::format("{} times", count);
}

}  // namespace

std::string Reader::name_of(const Constraint& constraint) const {
  const auto name = [&](std::size_t k) {
    return k < residual_names_.size() ? residual_names_[k] : "a rate among the states";
  };
  if (constraint.level > 0)
    return fmt::format("{}, differentiated {}", name(constraint.own), times(constraint.level));
  std::vector<std::size_t> numbers;
  for (const std::size_t k : constraint.of)
    if (k < residual_names_.size()) numbers.push_back(k);
  if (numbers.size() == 1) return name(numbers.front());
  std::vector<std::string> names;
  for (const std::size_t k : numbers)
    names.push_back(section("residuals") ? fmt::format("{}", k + 1) : name(k));
  return fmt::format("{}{} together", section("residuals") ? "residuals " : "",
                     fmt::join(names, ", "));
}

void Reader::find_start(const std::vector<Constraint>& constraints) {
  const std::vector<std::size_t> unknown(unknown_.begin(), unknown_.end());
  if (unknown.empty()) return;
  std::vector<Id> roots;
  for (const Constraint& constraint : constraints)
    for (const Id id : problem_.graph.needed({constraint.value})) {
      const Node& node = problem_.graph[id];
      if (node.op != Op::state || !unknown_.contains(node.index)) continue;
      roots.push_back(constraint.value);
      break;
    }
  if (roots.size() < unknown.size())
    fail(section("states")->value->place,
         "states: {} of unknown start; got {} constraints on them, expected as many",
         unknown.size(), roots.size());
  const std::vector<Real> given = problem_.y0;
  for (const Real guess : {0.L, 1.L, -1.L, 0.1L, 10.L}) {
    std::vector<Real> y = given;
    for (const std::size_t k : unknown)
      if (y[k] == 0) y[k] = guess;
    if (!find_roots(problem_.graph, roots, problem_.t0, y, unknown)) continue;
    problem_.y0 = y;
    for (const std::size_t k : unknown) problem_.start[k] = problem_.graph.constant(y[k]);
    return;
  }
  fail(section("states")->value->place,
       "states: no start was found for {}; got none by Newton's method from several guesses, "
       "expected values among the states",
       problem_.states[unknown.front()]);
}

void Reader::require_constraints(const std::vector<Constraint>& constraints) {
  constexpr Real rounding = 1e-12L;
  for (const Constraint& constraint : constraints) {
    const Linearised at =
        linearise(problem_.graph, {constraint.value}, problem_.t0, problem_.y0, {});
    if (std::abs(at.values[0]) <= rounding * at.sizes[0]) continue;
    const std::string text = infix_of(problem_.graph, constraint.value, problem_.states);
    fail(place_of_residual(constraint.own),
         "{}: {}, a {}constraint{}, {} not zero at the start; got {:.9Lg}, expected 0: another "
         "start, or ~ for a state that is to be found",
         section("residuals") ? "residuals" : "constraints", name_of(constraint),
         constraint.level > 0 ? "hidden " : "",
         constraint.level > 0 && !text.empty() ? ", " + text : "",
         constraint.level == 0 && constraint.of.size() > 1 ? "are" : "is", at.values[0]);
  }
}

void Reader::note_constraint(const Reduction& reduction, const Constraint& constraint) {
  std::vector<std::string> gives;
  for (std::size_t k = 0; k < problem_.states.size(); ++k)
    if (reduction.by[k] == constraint.own) gives.push_back(problem_.states[k] + "'");
  int index = 1;
  for (const Constraint& hidden : reduction.constraints)
    if (hidden.own == constraint.own) index = std::max(index, hidden.level + 1);
  bool is_rate = false;
  for (const Id id : problem_.graph.needed({constraint.value}))
    is_rate = is_rate ||
              (problem_.graph[id].op == Op::state && problem_.graph[id].index >= given_states_);
  const std::string name = name_of(constraint);
  if (is_rate && *constraint.of.begin() < residual_places_.size()) {
    problem_.notes.emplace_back(
        "residuals",
        fmt::format("{} cannot be solved for its rate in symbols: the rate is a state too", name));
    return;
  }
  problem_.notes.emplace_back(
      section("residuals") ? "residuals" : "constrained",
      fmt::format("{}: a constraint without rates, index {}; its {} gives {}", name, index,
                  index == 1   ? "derivative"
                  : index == 2 ? "second derivative"
                               : "third derivative",
                  fmt::join(gives, ", ")));
  for (const Constraint& hidden : reduction.constraints) {
    if (hidden.own != constraint.own || hidden.level == 0) continue;
    const std::string text = infix_of(problem_.graph, hidden.value, problem_.states);
    problem_.notes.emplace_back(
        "hidden", fmt::format("{}{}", name_of(hidden), text.empty() ? "" : ": " + text + " = 0"));
  }
}

void Reader::note_residuals(const Reduction& reduction) {
  const std::size_t count = residual_places_.size();
  if (reduction.constraints.empty()) {
    problem_.notes.emplace_back(
        "residuals",
        fmt::format("{}, solved for all rates: an ordinary problem, which every solver takes",
                    count));
    return;
  }
  const auto hidden = static_cast<std::size_t>(
      std::ranges::count_if(reduction.constraints, [](const auto& c) { return c.level > 0; }));
  const std::size_t given = reduction.constraints.size() - hidden;
  for (const Constraint& constraint : reduction.constraints)
    if (constraint.level == 0) note_constraint(reduction, constraint);
  if (section("residuals"))
    problem_.notes.emplace_back(
        "residuals",
        fmt::format("{} of {} are differentiated{}, so that every solver of ordinary "
                    "problems takes them; what a run lets {} drift is part of its error",
                    given, count, reduction.index == 1 ? " once" : "",
                    problem_.states.size() > given_states_ ? "the residuals" : "the constraints"));
  if (reduction.index > 1)
    problem_.notes.emplace_back(
        "index", fmt::format("{}: {} constraint{}, of which {} hidden one{} follow{} by "
                             "differentiation",
                             reduction.index, given, given == 1 ? "" : "s", hidden,
                             hidden == 1 ? "" : "s", hidden == 1 ? "s" : ""));
}

void Reader::find_jumps() {
  for (const StateConstraint& constraint : problem_.constraints) {
    const Id by =
        jump_of(problem_.graph, constraint.value, problem_.t0, problem_.stops.back(), problem_.y0);
    if (by == no_node) continue;
    const std::string text = infix_of(problem_.graph, by, problem_.states);
    problem_.jumps =
        fmt::format("{}{} jumps{}, and so do states that follow from it", constraint.name,
                    constraint.is_hidden ? "," : "", text.empty() ? "" : " where " + text + " = 0");
    problem_.notes.emplace_back("jumps", problem_.jumps +
                                             "; rates do not say where to: expected --option "
                                             "projection=1, or a solver of residuals");
    return;
  }
}

void Reader::add_drift() {
  Graph& graph = problem_.graph;
  for (const bool hidden : {false, true}) {
    Id largest = no_node;
    for (const StateConstraint& constraint : problem_.constraints) {
      if (constraint.is_hidden != hidden) continue;
      const Id size = graph.make(Op::abs, constraint.value);
      largest = largest == no_node ? size : graph.make(Op::max, largest, size);
    }
    if (largest != no_node)
      problem_.outputs.push_back({hidden ? "hidden_drift" : "constraint_drift", largest});
  }
}

}  // namespace odeum::formula::reading
