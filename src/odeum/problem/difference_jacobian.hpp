// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "odeum/problem/concepts.hpp"

namespace odeum {

/// Increments of the forward differences of f at a state y, for every solver whose library has none
/// of its own:
///
///     sqrt(eps) max(|y_j|, 1e-3 w_j max_i |y_i| / w_i)
///
/// The root balances truncation against rounding (Dennis, Schnabel, Numerical Methods for
/// Unconstrained Optimization, A5.4.1). The lower bound keeps f's change by a small component above
/// the rounding that its large components cause, and below what is not linear in the small one.
/// LSODE and CVODE take it from h f, RADAU5 has sqrt(1e-5) for states of size one; h is not known
/// here, and a bound by the state's size is the same in every unit. Weights are the thresholds of a
/// tolerance by component, else equal. f stands in for a state of zeros, and 1 where it is zero
/// too.
class DifferenceIncrements {
 public:
  /// `f`: the value at y.
  DifferenceIncrements(std::size_t n, const double* y, const double* f,
                       const double* weights = nullptr)
      : y_(y), weights_(weights) {
    constexpr double normal = 1e15 * std::numeric_limits<double>::min();
    for (const double* const values : {y, f}) {
      double size = 0;
      for (std::size_t i = 0; i < n; ++i) size = std::max(size, std::abs(values[i]) / weight(i));
      if (!(size > normal)) continue;
      size_ = size;
      return;
    }
  }
  double operator()(std::size_t j) const {
    const double root_epsilon = std::sqrt(std::numeric_limits<double>::epsilon());
    return root_epsilon * std::max(std::abs(y_[j]), 1e-3 * size_ * weight(j));
  }

 private:
  double weight(std::size_t i) const { return weights_ ? weights_[i] : 1; }

  const double *y_, *weights_;
  double size_ = 1;
};

/// Room for n numbers each.
struct DifferenceSpace {
  double *f, *moved, *f_moved;
};

/// df/dy by forward differences, dense and row-major, in n + 1 evaluations. `rhs(t, y, f)` returns
/// whether to go on; returns whether all did.
template <class Rhs>
bool difference_jacobian(Rhs&& rhs, std::size_t n, double t, const double* y, double* j,
                         const DifferenceSpace& at, const double* weights = nullptr) {
  if (!rhs(t, y, at.f)) return false;
  const DifferenceIncrements increment(n, y, at.f, weights);
  std::copy(y, y + n, at.moved);
  for (std::size_t k = 0; k < n; ++k) {
    at.moved[k] = y[k] + increment(k);
    const double delta = at.moved[k] - y[k];
    if (!rhs(t, at.moved, at.f_moved)) return false;
    at.moved[k] = y[k];
    for (std::size_t i = 0; i < n; ++i) j[i * n + k] = (at.f_moved[i] - at.f[i]) / delta;
  }
  return true;
}

/// What a problem that is watched weighs its components by; null: all alike.
template <class P>
const double* difference_weights(const P& problem) {
  if constexpr (requires { problem.watch().weights(); }) return problem.watch().weights();
  return nullptr;
}

/// The same of a problem. A guarded one counts each evaluation.
template <Ode P>
void difference_jacobian(const P& problem, double t, const double* y, double* j) {
  State<P> f = make_state(problem), moved = f, f_moved = f;
  const auto rhs = [&](double time, const double* at, double* value) {
    problem.rhs(time, at, value);
    return true;
  };
  difference_jacobian(rhs, size_of(problem), t, y, j, {f.data(), moved.data(), f_moved.data()},
                      difference_weights(problem));
}

/// The problem's own, else by differences; a watched problem counts either as a Jacobian.
template <Ode P>
void jacobian_or_differences(const P& problem, double t, const double* y, double* j) {
  if constexpr (WithJacobian<P>)
    if (offers_jacobian(problem)) return void(problem.jacobian(t, y, j));
  if constexpr (requires { problem.watch().count_jacobian(); }) problem.watch().count_jacobian();
  difference_jacobian(problem, t, y, j);
}

}  // namespace odeum
