// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/formula/evaluator.hpp"

#include <unordered_map>

namespace odeum::formula {

template <class Real>
Evaluator<Real>::Evaluator(const Graph& graph, const std::vector<Id>& roots) {
  std::unordered_map<Id, std::uint32_t> place;
  const auto at = [&](Id id) { return id == no_node ? 0 : place.at(id); };
  for (const Id id : graph.needed(roots)) {
    const Node& node = graph[id];
    place.emplace(id, static_cast<std::uint32_t>(steps_.size()));
    steps_.push_back({node.op, is_leaf(node.op) ? node.index : at(node.of[0]), at(node.of[1]),
                      at(node.of[2]), static_cast<Real>(node.value)});
  }
  for (const Id root : roots) roots_.push_back(place.at(root));
}

template <class Real>
void Evaluator<Real>::operator()(Real t, const Real* y, Real* out) const {
  thread_local std::vector<Real> values;
  if (values.size() < steps_.size()) values.resize(steps_.size());
  Real* const v = values.data();
  for (std::size_t k = 0; k < steps_.size(); ++k) {
    const Step& step = steps_[k];
    switch (step.op) {
      case Op::constant:
        v[k] = step.value;
        break;
      case Op::time:
        v[k] = t;
        break;
      case Op::state:
        v[k] = y[step.a];
        break;
      default:
        v[k] = apply(step.op, v[step.a], v[step.b], v[step.c]);
    }
  }
  for (std::size_t k = 0; k < roots_.size(); ++k) out[k] = v[roots_[k]];
}

template <class Real>
void Evaluator<Real>::perturb(const std::function<Real(Real)>& moved) {
  for (Step& step : steps_)
    if (step.op == Op::constant) step.value = moved(step.value);
}

template <class Real>
void Evaluator<Real>::define(const std::vector<Real>& values) {
  for (Step& step : steps_)
    if (step.op == Op::constant && step.a > 0) step.value = values[step.a - 1];
}

template class Evaluator<double>;
template class Evaluator<long double>;

}  // namespace odeum::formula
