// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/formula/series.hpp"

#include <array>
#include <unordered_map>
#include <utility>

#include "odeum/formula/series_rules.hpp"

namespace odeum::formula {
namespace {

bool is_elementary(const Graph& graph, const Node& node) {
  const Op op = node.op;
  if (op == Op::power) return graph.is_constant(node.of[1]);
  return arity(op) == 0 || op == Op::add || op == Op::subtract || op == Op::negate ||
         op == Op::multiply || op == Op::divide || op == Op::sqrt;
}

}  // namespace

SeriesPlan make_series_plan(Graph& graph, const std::vector<Id>& equations) {
  // The partial derivatives of functions are nodes whose series are needed as well, and so on: the
  // rules lead back to nodes that exist.
  std::vector<Id> roots = equations;
  std::unordered_map<Id, std::array<Id, 2>> partials;
  for (bool grows = true; grows;) {
    grows = false;
    for (const Id id : graph.needed(roots)) {
      const Node node = graph[id];
      if (is_elementary(graph, node) || partials.contains(id)) continue;
      std::array<Id, 2> of{no_node, no_node};
      for (std::size_t k = 0; k < arity(node.op); ++k) {
        if (graph.is_constant(node.of[k])) continue;
        of[k] = graph.partial(id, k);
        if (of[k] != no_node) roots.push_back(of[k]);
      }
      partials.emplace(id, of);
      grows = true;
    }
  }
  SeriesPlan plan;
  std::unordered_map<Id, std::uint32_t> place;
  const std::vector<Id> nodes = graph.needed(roots);
  for (std::uint32_t k = 0; k < nodes.size(); ++k) place.emplace(nodes[k], k);
  for (const Id id : nodes) {
    const Node& node = graph[id];
    SeriesPlan::Step step{.op = node.op, .id = id, .parts = {}};
    if (node.op == Op::state)
      step.a = node.index;
    else if (arity(node.op) > 0)
      step.a = place.at(node.of[0]);
    if (arity(node.op) > 1) step.b = place.at(node.of[1]);
    if (const auto found = partials.find(id); found != partials.end())
      for (std::size_t k = 0; k < 2; ++k)
        if (found->second[k] != no_node)
          step.parts.push_back({place.at(node.of[k]), place.at(found->second[k])});
    plan.steps.push_back(std::move(step));
  }
  for (const Id id : equations) plan.roots.push_back(place.at(id));
  return plan;
}

template class Series<double>;
template class Series<long double>;

}  // namespace odeum::formula
