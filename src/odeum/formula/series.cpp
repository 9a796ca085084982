// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/formula/series.hpp"

#include <algorithm>
#include <array>
#include <unordered_map>
#include <utility>

namespace odeum::formula {
namespace {

bool is_elementary(Op op) {
  return arity(op) == 0 || op == Op::add || op == Op::subtract || op == Op::negate ||
         op == Op::multiply || op == Op::divide || op == Op::sqrt;
}

/// sum_{j = from}^{k} a_j b_{k - j}
template <class Real>
Real convolution(const Real* a, const Real* b, std::size_t from, std::size_t k) {
  Real sum = 0;
  for (std::size_t j = from; j <= k; ++j) sum += a[j] * b[k - j];
  return sum;
}

/// sum_{j = 1}^{k - 1} a_j a_{k - j}
template <class Real>
Real inner_square(const Real* a, std::size_t k) {
  Real half = 0;
  for (std::size_t j = 1; 2 * j < k; ++j) half += a[j] * a[k - j];
  return 2 * half + (k % 2 == 0 ? a[k / 2] * a[k / 2] : 0);
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
      if (is_elementary(node.op) || partials.contains(id)) continue;
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

template <class Real>
Series<Real>::Series(const Graph& graph, SeriesPlan plan, std::size_t states)
    : plan_(std::move(plan)), states_(states) {
  for (const SeriesPlan::Step& step : plan_.steps)
    constants_.push_back(static_cast<Real>(graph[step.id].value));
}

template <class Real>
void Series<Real>::operator()(Real t, const Real* y, int order, Real* c) {
  const auto n = static_cast<std::size_t>(order), width = n + 1;
  v_.resize(plan_.steps.size() * width);
  std::copy(y, y + states_, c);
  for (std::size_t s = 0; s < plan_.steps.size(); ++s) {
    const SeriesPlan::Step& step = plan_.steps[s];
    Real& value = v_[s * width];
    if (step.op == Op::constant)
      value = constants_[s];
    else if (step.op == Op::time)
      value = t;
    else if (step.op == Op::state)
      value = y[step.a];
    else
      value = apply(step.op, v_[step.a * width], v_[step.b * width], 0);
  }
  for (std::size_t k = 0; k < n; ++k) {
    if (k > 0) {
      for (std::size_t s = 0; s < plan_.steps.size(); ++s)
        if (plan_.steps[s].op == Op::state) v_[s * width + k] = c[k * states_ + plan_.steps[s].a];
      advance(k, width);
    }
    for (std::size_t i = 0; i < states_; ++i)
      c[(k + 1) * states_ + i] = v_[plan_.roots[i] * width + k] / static_cast<Real>(k + 1);
  }
}

template <class Real>
void Series<Real>::advance(std::size_t k, std::size_t width) {
  for (std::size_t s = 0; s < plan_.steps.size(); ++s) {
    const SeriesPlan::Step& step = plan_.steps[s];
    Real* const w = v_.data() + s * width;
    const Real* const a = v_.data() + step.a * width;
    const Real* const b = v_.data() + step.b * width;
    switch (step.op) {
      case Op::state:
        break;
      case Op::constant:
        w[k] = 0;
        break;
      case Op::time:
        w[k] = k == 1 ? Real(1) : Real(0);
        break;
      case Op::add:
        w[k] = a[k] + b[k];
        break;
      case Op::subtract:
        w[k] = a[k] - b[k];
        break;
      case Op::negate:
        w[k] = -a[k];
        break;
      case Op::multiply:
        w[k] = plan_.steps[step.a].op == Op::constant   ? a[0] * b[k]
               : plan_.steps[step.b].op == Op::constant ? a[k] * b[0]
               : a == b                                 ? 2 * a[0] * a[k] + inner_square(a, k)
                                                        : convolution(a, b, 0, k);
        break;
      case Op::divide:
        w[k] = plan_.steps[step.b].op == Op::constant ? a[k] / b[0]
                                                      : (a[k] - convolution(b, w, 1, k)) / b[0];
        break;
      case Op::sqrt:  // w^2 = a
        w[k] = (a[k] - inner_square(w, k)) / (2 * w[0]);
        break;
      default: {
        Real sum = 0;
        for (const SeriesPlan::Part& part : step.parts) {
          const Real* const u = v_.data() + part.argument * width;
          const Real* const g = v_.data() + part.partial * width;
          for (std::size_t j = 1; j <= k; ++j) sum += static_cast<Real>(j) * u[j] * g[k - j];
        }
        w[k] = sum / static_cast<Real>(k);
      }
    }
  }
}

template class Series<double>;
template class Series<long double>;

}  // namespace odeum::formula
