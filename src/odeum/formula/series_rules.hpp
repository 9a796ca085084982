// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <type_traits>
#include <utility>

#include "odeum/formula/series.hpp"

/// The rules of Series, for whoever has a type of numbers of its own: it needs the operations of
/// Real, `apply` as in operations.hpp, and may have a `convolution`.
namespace odeum::formula {

/// sum_{j = from}^{k} a_j b_{k - j}
template <class Real>
Real convolution(const Real* a, const Real* b, std::size_t from, std::size_t k) {
  Real sum(0);
  for (std::size_t j = from; j <= k; ++j) sum += a[j] * b[k - j];
  return sum;
}

/// sum_{j = 1}^{k - 1} a_j a_{k - j}
template <class Real>
Real inner_square(const Real* a, std::size_t k) {
  Real half(0);
  for (std::size_t j = 1; 2 * j < k; ++j) half += a[j] * a[k - j];
  return 2 * half + (k % 2 == 0 ? a[k / 2] * a[k / 2] : Real(0));
}

/// Coefficient k of w = sqrt(a): w^2 = a. That of zero is zero.
template <class Real>
Real root_coefficient(const Real* a, const Real* w, std::size_t k) {
  const Real rest = a[k] - inner_square(w, k);
  if constexpr (std::is_floating_point_v<Real>)
    if (w[0] == 0 && rest == 0) return 0;
  return rest / (2 * w[0]);
}

/// Coefficient k of w = a^b: a w' = b w a'. Where a is 0, those below k = b are zero, and all of
/// them where a is 0 throughout.
template <class Real>
Real power_coefficient(const Real* a, const Real* w, const Real& b, std::size_t k) {
  if constexpr (std::is_floating_point_v<Real>)
    if (const Real* const first = std::find_if(a, a + k + 1, [](Real each) { return each != 0; });
        w[0] == 0 && first != a && (first == a + k + 1 || static_cast<Real>(k) < b))
      return 0;
  Real sum(0);
  for (std::size_t j = 1; j <= k; ++j)
    sum += (b * static_cast<Real>(j) - static_cast<Real>(k - j)) * a[j] * w[k - j];
  return sum / (static_cast<Real>(k) * a[0]);
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
      case Op::sqrt:
        w[k] = root_coefficient(a, w, k);
        break;
      default: {
        if (SeriesPlan::has_power_rule(step)) {
          w[k] = power_coefficient(a, w, b[0], k);
          break;
        }
        Real sum(0);
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

}  // namespace odeum::formula
