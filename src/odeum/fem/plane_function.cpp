// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/fem/plane_function.hpp"

#include "odeum/formula/parser.hpp"

namespace odeum::fem {

PlaneFunction::PlaneFunction(const std::string& text) {
  formula::Graph graph;
  formula::Scope scope;
  scope.names["x"] = graph.state(0), scope.names["y"] = graph.state(1);
  scope.refused["t"] = "a function of x and y";
  const formula::Id root = formula::parse_expression(text, scope, graph);
  std::vector<formula::Id> roots{root, graph.constant(0), graph.constant(0)};
  const auto gradient = formula::gradients(graph, {root}, 2);
  for (const formula::Entry& entry : gradient[0])
    if (entry.by < 2) roots[1 + entry.by] = entry.value;
  evaluate_ = std::make_shared<const formula::Evaluator<double>>(graph, roots);
}

std::array<double, 3> PlaneFunction::values(Point p) const {
  const double at[2] = {p.x, p.y};
  std::array<double, 3> all{};
  (*evaluate_)(0, at, all.data());
  return all;
}

}  // namespace odeum::fem
