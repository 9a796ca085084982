// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/conditions.hpp"

#include <algorithm>
#include <memory>
#include <vector>

#include "odeum/formula/evaluator.hpp"

namespace odeum::cases {

Conditions conditions_of(const formula::Problem& problem) {
  using formula::Op;
  formula::Graph graph = problem.graph;
  std::vector<formula::Id> conditions;
  for (const formula::Id id : problem.graph.needed(problem.equations)) {
    const formula::Node node = graph[id];
    if (node.op == Op::less || node.op == Op::less_equal || node.op == Op::min ||
        node.op == Op::max)
      conditions.push_back(graph.make(Op::subtract, node.of[1], node.of[0]));
    else if (node.op == Op::abs || node.op == Op::sign)
      conditions.push_back(node.of[0]);
  }
  std::erase_if(conditions, [&](formula::Id id) { return graph.is_constant(id); });
  std::ranges::sort(conditions);
  conditions.erase(std::unique(conditions.begin(), conditions.end()), conditions.end());
  if (conditions.empty()) return {};
  const auto values = std::make_shared<const formula::Evaluator<double>>(graph, conditions);
  return {conditions.size(),
          [values](double t, const double* y, double* out) { (*values)(t, y, out); }};
}

Conditions conditions_of(const Case& c) {
  return c.text ? conditions_of(CaseText(*c.text).problem()) : Conditions();
}

}  // namespace odeum::cases
