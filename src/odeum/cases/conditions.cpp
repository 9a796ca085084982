// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/conditions.hpp"

#include <algorithm>
#include <memory>
#include <vector>

#include "odeum/cases/case_text.hpp"
#include "odeum/formula/evaluator.hpp"
#include "odeum/formula/switch_times.hpp"

namespace odeum::cases {

Conditions conditions_of(const formula::Problem& problem) {
  formula::Graph graph = problem.graph;
  std::vector<formula::Id> conditions;
  for (const formula::Id id : problem.graph.needed(problem.equations))
    if (const formula::Node node = problem.graph[id]; formula::is_switch(node.op))
      conditions.push_back(formula::zero_at_switch(graph, node));
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
