// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/formula/modes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace odeum::formula {
namespace {

class Selection {
 public:
  Selection(const Graph& from, const Signs& signs,
            const std::function<long double(long double)>& constant)
      : from_(from), signs_(signs), constant_(constant), to_(from.size(), no_node) {}

  /// The equations in `graph`.
  std::vector<Id> select(Graph& graph, const std::vector<Id>& roots) {
    for (const Id id : from_.needed(roots)) to_[id] = selected(graph, id);
    std::vector<Id> result;
    for (const Id root : roots) result.push_back(to_[root]);
    return result;
  }
  /// The conditions on which the selected alternatives depend.
  std::vector<std::pair<Id, Id>> conditions(const std::vector<Id>& roots) const {
    std::vector<bool> matters(from_.size(), false);
    for (const Id root : roots) matters[root] = true;
    std::vector<std::pair<Id, Id>> found;
    for (Id id = static_cast<Id>(from_.size()); id-- > 0;) {
      if (!matters[id]) continue;
      const Node& node = from_[id];
      if (const auto at = condition_.find(id); at != condition_.end())
        found.emplace_back(id, at->second);
      const auto chosen = chosen_.find(id);
      for (std::size_t k = 0; k < arity(node.op); ++k)
        if (chosen == chosen_.end() || k == 0 || k == chosen->second) matters[node.of[k]] = true;
    }
    return found;
  }
  int sign_of(Id id) const {
    const auto found = signs_.find(id);
    return found == signs_.end() ? 0 : found->second;
  }

 private:
  Id selected(Graph& graph, Id id) {
    const Node& node = from_[id];
    if (node.op == Op::constant) return graph.constant(constant_(node.value));
    if (node.op == Op::time) return graph.time();
    if (node.op == Op::state) return graph.state(node.index);
    const auto at = [&](std::size_t k) { return k < arity(node.op) ? to_[node.of[k]] : no_node; };
    const Id a = at(0), b = at(1), c = at(2);
    if (node.op == Op::choose) {
      // A number in place of a condition is zero at single times only.
      const bool first = !graph.is_constant(a) || graph[a].value != 0;
      chosen_[id] = first ? 1 : 2;
      return first ? b : c;
    }
    if (!has_kinks(node.op) && node.op != Op::less && node.op != Op::less_equal &&
        node.op != Op::equal)
      return graph.make(node.op, a, b, c);
    const bool one = node.op == Op::abs || node.op == Op::sign || node.op == Op::floor;
    if (graph.is_constant(a) && (one || graph.is_constant(b))) return graph.make(node.op, a, b, c);
    if (node.op == Op::equal) return graph.constant(0);  // at single times
    const Id condition = one ? a : graph.make(Op::subtract, b, a);
    if (graph.is_constant(condition)) {
      const long double value = graph[condition].value;
      return by_sign(graph, node.op, a, b,
                     static_cast<int>(value > 0) - static_cast<int>(value < 0));
    }
    condition_[id] = condition;
    return by_sign(graph, node.op, a, b, sign_of(id));
  }
  static Id by_sign(Graph& graph, Op op, Id a, Id b, int sign) {
    switch (op) {
      case Op::less:
        return graph.constant(sign > 0 ? 1 : 0);
      case Op::less_equal:
        return graph.constant(sign >= 0 ? 1 : 0);
      case Op::abs:
        return sign >= 0 ? a : graph.make(Op::negate, a);
      case Op::min:
        return sign >= 0 ? a : b;
      case Op::max:
        return sign >= 0 ? b : a;
      case Op::floor:
        return graph.constant((sign - 1) / 2);
      default:
        return graph.constant(sign > 0 ? 1 : sign < 0 ? -1 : 0);
    }
  }

  const Graph& from_;
  const Signs& signs_;
  const std::function<long double(long double)>& constant_;
  std::vector<Id> to_;
  std::map<Id, Id> condition_;        ///< by old node, in the new graph
  std::map<Id, std::size_t> chosen_;  ///< the argument that a choice selects
};

}  // namespace

int Mode::sign(std::size_t k, long double value) const {
  constexpr long double most = 1e9L;
  if (floors[k]) return 2 * static_cast<int>(std::floor(std::clamp(value, -most, most))) + 1;
  return static_cast<int>(value > 0) - static_cast<int>(value < 0);
}

Id Mode::held(std::size_t k) {
  Graph& graph = problem.graph;
  const int sign = signs.at(ids[k]);
  const Id value = switches[k];
  if (!floors[k]) return sign > 0 ? value : graph.make(Op::negate, value);
  const int whole = (sign - 1) / 2;
  return graph.make(Op::multiply, graph.make(Op::subtract, value, graph.constant(whole)),
                    graph.make(Op::subtract, graph.constant(whole + 1), value));
}

Mode mode_of(const Problem& problem, const Signs& signs,
             const std::function<long double(long double)>& constant) {
  Mode mode;
  Problem& p = mode.problem;
  p.file = problem.file;
  p.states = problem.states;
  p.y0 = problem.y0;
  p.t0 = problem.t0;
  p.stops = problem.stops;
  Selection selection(problem.graph, signs, constant);
  std::vector<Id> roots = problem.equations;
  for (const Watched& watched : problem.watched) roots.push_back(watched.function);
  p.equations = selection.select(p.graph, roots);
  const auto first = p.equations.begin() + static_cast<std::ptrdiff_t>(problem.equations.size());
  mode.events.assign(first, p.equations.end());
  p.equations.erase(first, p.equations.end());
  for (const auto& [id, condition] : selection.conditions(roots)) {
    mode.signs[id] = selection.sign_of(id);
    mode.ids.push_back(id);
    mode.switches.push_back(condition);
    mode.floors.push_back(problem.graph[id].op == Op::floor);
  }
  return mode;
}

}  // namespace odeum::formula
