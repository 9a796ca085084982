// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/formula/analysis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>

#include "odeum/formula/interval.hpp"

namespace odeum::formula {
namespace {

constexpr std::size_t largest_series = 2000;  // nodes: a coefficient array each, on the stack

/// Whether a derivative of an operation may not be finite where its value is: also of a quotient,
/// if it stands in a function that has a limit.
bool is_steep(const Graph& graph, Id id) {
  const Node& node = graph[id];
  switch (node.op) {
    case Op::divide:
      return !graph.is_constant(node.of[1]);
    case Op::asin:
    case Op::acos:
    case Op::log:
    case Op::log10:
    case Op::sqrt:
    case Op::power:
    case Op::atan2:
    case Op::hypot:
      return true;
    default:
      return false;
  }
}

/// The nodes that are differentiated: not those that a power with a half exponent is made of.
std::vector<bool> differentiated(const Graph& graph, const std::vector<Id>& roots) {
  std::vector<bool> is(graph.size(), false);
  for (const Id root : roots) is[root] = true;
  for (Id id = static_cast<Id>(graph.size()); id-- > 0;) {
    if (!is[id]) continue;
    if (const Id base = graph.half_power(id).first; base != no_node) {
      is[base] = true;
      continue;
    }
    for (const Id argument : graph[id].of)
      if (argument != no_node) is[argument] = true;
  }
  return is;
}

/// Whether the argument of a root, or of a power below 1, passes through 0 somewhere: a sum of
/// squares does not.
bool has_infinite_slopes(const Graph& graph, const Problem& problem) {
  Enclosure enclosure(graph, problem.equations);
  constexpr double infinite = std::numeric_limits<double>::infinity();
  Intervals everything;
  everything.fill({-infinite, infinite});
  const auto& values =
      enclosure(everything, std::vector<Intervals>(problem.states.size(), everything));
  const std::vector<Id> ids = graph.needed(problem.equations);  // those of the steps
  const std::vector<bool> counts = differentiated(graph, problem.equations);
  for (std::size_t k = 0; k < ids.size(); ++k) {
    const Enclosure::Step& step = enclosure.steps()[k];
    if (!counts[ids[k]] || (step.op != Op::sqrt && step.op != Op::power)) continue;
    const Interval exponent = step.op == Op::power ? values[step.b][0] : Interval{0.5, 0.5};
    if (exponent.low > 0 && exponent.high < 1 &&
        values[step.a][0].low < -std::numeric_limits<double>::min())
      return true;
  }
  return false;
}

void find_second_order(const Problem& problem, Structure& s) {
  if (s.states % 2 != 0) return;
  const auto half = static_cast<std::uint32_t>(s.states / 2);
  bool in_order = true;
  std::set<std::uint32_t> velocities, positions;
  for (std::uint32_t k = 0; k < s.states; ++k) {
    const Node& rate = problem.graph[problem.equations[k]];
    const bool is_state = rate.op == Op::state;
    if (k < half) in_order = in_order && is_state && rate.index == k + half;
    if (!is_state || rate.index == k) continue;
    positions.insert(k);
    velocities.insert(rate.index);
  }
  s.second_order = in_order;
  if (!in_order) {
    s.second_order_in_other_order =
        positions.size() == half && velocities.size() == half &&
        std::ranges::none_of(positions, [&](std::uint32_t k) { return velocities.contains(k); });
    return;
  }
  // The forces tell whether velocities matter, since the sign of a velocity has no derivative.
  const std::vector<Id> forces(problem.equations.begin() + half, problem.equations.end());
  s.velocity_dependent = std::ranges::any_of(problem.graph.needed(forces), [&](Id id) {
    return problem.graph[id].op == Op::state && problem.graph[id].index >= half;
  });
}

void find_implicit_part(Problem& problem, Analysis& analysis) {
  const auto n = static_cast<std::uint32_t>(problem.states.size());
  if (problem.implicit_part.empty()) return;
  analysis.implicit_jacobian = gradients(problem.graph, problem.implicit_part, n);
  for (std::vector<Entry>& row : analysis.implicit_jacobian)
    if (!row.empty() && row.back().by == n) row.pop_back();  // the time
  analysis.structure.with_implicit_part = static_cast<std::size_t>(std::ranges::count_if(
      problem.implicit_part, [&](Id id) { return !problem.graph.is(id, 0); }));
}

}  // namespace

Analysis analyse(Problem& problem) {
  Analysis analysis;
  Structure& s = analysis.structure;
  Graph& graph = problem.graph;
  s.states = problem.states.size();
  const auto n = static_cast<std::uint32_t>(s.states);
  for (const Id id : graph.needed(problem.equations)) {
    if (has_kinks(graph[id].op)) s.smooth = false;
    s.steep = s.steep || is_steep(graph, id);
  }
  s.infinite_slopes = s.steep && has_infinite_slopes(graph, problem);
  analysis.jacobian = gradients(graph, problem.equations, n);
  analysis.time_derivative.assign(n, graph.constant(0));
  std::vector<Id> varying;  // entries of the Jacobian
  for (std::uint32_t row = 0; row < n; ++row) {
    std::vector<Entry>& entries = analysis.jacobian[row];
    if (!entries.empty() && entries.back().by == n) {
      analysis.time_derivative[row] = entries.back().value;
      entries.pop_back();
    }
    s.entries += entries.size();
    for (const Entry& entry : entries) {
      if (!graph.is_constant(entry.value)) varying.push_back(entry.value);
      if (entry.by < row) s.lower = std::max<std::size_t>(s.lower, row - entry.by);
      if (entry.by > row) s.upper = std::max<std::size_t>(s.upper, entry.by - row);
    }
  }
  // A condition or sign(t) has no derivative, and does not make a problem linear either.
  // Coefficients of a linear one may depend on t.
  s.linear = s.smooth && std::ranges::none_of(graph.needed(varying),
                                              [&](Id id) { return graph[id].op == Op::state; });
  // A condition on t has no derivative.
  s.autonomous = std::ranges::none_of(graph.needed(problem.equations),
                                      [&](Id id) { return graph[id].op == Op::time; });
  if (s.autonomous) analysis.time_derivative.clear();
  find_implicit_part(problem, analysis);
  find_second_order(problem, s);
  if (s.smooth) {
    SeriesPlan plan = make_series_plan(graph, problem.equations);
    if (plan.steps.size() <= largest_series) analysis.series = std::move(plan);
  }
  return analysis;
}

std::vector<Id> jacobian_roots(const std::vector<std::vector<Entry>>& jacobian) {
  std::vector<Id> roots;
  for (const auto& row : jacobian)
    for (const Entry& entry : row) roots.push_back(entry.value);
  return roots;
}

bool Structure::is_sparse() const { return states > 16 && 4 * entries <= states * states; }

std::vector<std::string> describe(const Structure& s) {
  std::vector<std::string> lines;
  lines.push_back(fmt::format(
      "{}, {}, {}", s.linear ? "linear" : "nonlinear", s.autonomous ? "autonomous" : "depends on t",
      s.smooth ? "smooth"
               : "with kinks (if, abs, sign, min, max or floor: no order above 2 "
                 "can be expected)"));
  if (s.second_order)
    lines.emplace_back(s.velocity_dependent
                           ? "second order, q'' = a(t, q, v): the forces depend on velocities"
                           : "second order, q'' = a(t, q): separable");
  else if (s.second_order_in_other_order)
    lines.emplace_back(
        "first order as written; with the positions first and then their rates in the "
        "same order among the states, methods of second order fit too");
  else
    lines.emplace_back("first order");
  lines.push_back(fmt::format("Jacobian with {} of {} entries, {} below and {} above the diagonal",
                              s.entries, s.states * s.states, s.lower, s.upper) +
                  (s.is_sparse()
                       ? ": implicit methods solve with the factors of a band or of its entries"
                       : ""));
  if (s.infinite_slopes)
    lines.emplace_back(
        "a root or a power below 1: its derivative is infinite at 0, where the Jacobian is taken "
        "by differences inside of the domain");
  if (s.with_implicit_part > 0)
    lines.push_back(
        fmt::format("split for additive methods: {} of {} equations have an implicit part",
                    s.with_implicit_part, s.states));
  return lines;
}

}  // namespace odeum::formula
