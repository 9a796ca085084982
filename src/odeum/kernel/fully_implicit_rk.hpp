// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <string_view>

#include "odeum/core/status.hpp"
#include "odeum/kernel/method.hpp"
#include "odeum/kernel/newton.hpp"
#include "odeum/kernel/stage_system.hpp"
#include "odeum/linear/dense_limit.hpp"
#include "odeum/tableau/collocation.hpp"

namespace odeum {

/// One step of a fixed size: stages to rounding, y <- y + sum_j (b^T A^-1)_j Z_j.
template <const auto& T, Ode P>
class FullyImplicitRungeKutta {
 public:
  explicit FullyImplicitRungeKutta(const P& problem) : system_(problem) {}

  Status step(double t, double h, State<P>& y) {
    constexpr int max_iterations = 50;
    constexpr double slow_kept = 0.05, slow_fresh = 0.2;
    bool fresh = false;
    for (State<P>& z : system_.z)
      for (double& component : z) component = 0;
    if (h != factored_for_ && !renew(t, h, y, fresh)) return Status::newton_failed;
    system_.transform_guess();
    double last = 0;
    int since_renewal = 0;
    for (int iteration = 0; iteration < max_iterations; ++iteration) {
      double size = 0, largest = max_norm(y);
      system_.iterate(t, h, y, [&](std::size_t i, const State<P>& correction) {
        const double norm = max_norm(correction);
        if (!(norm <= size)) size = norm;  // NaN stays
        largest = std::max(largest, max_norm(system_.z[i]));
      });
      if (!std::isfinite(size)) break;
      const double rate = since_renewal > 0 ? size / last : 0;
      const double unit = iteration_tolerance * std::max(largest, smallest_state);
      if (at_rounding(size / unit, rate, since_renewal > 0)) {
        finish(y);
        return Status::ok;
      }
      last = size;
      ++since_renewal;
      if (rate > (fresh ? slow_fresh : slow_kept)) {
        // The Jacobian at the mean of the stages' present values.
        State<P> where = y;
        if (rate < 1)
          for (std::size_t n = 0; n < y.size(); ++n) where[n] += system_.z[T.stages / 2][n];
        if (!renew(t + h / 2, h, where, fresh)) break;
        since_renewal = 0;
      }
    }
    factored_for_ = 0;
    return Status::newton_failed;
  }

 private:
  /// The last stage is the new state.
  static constexpr bool stiffly_accurate = T.a[T.stages - 1] == T.b;

  bool renew(double t, double h, const State<P>& y, bool& fresh) {
    fresh = true;
    system_.linearise(t, y);
    factored_for_ = system_.factorise(h) ? h : 0;
    return factored_for_ == h;
  }

  void finish(State<P>& y) {
    if constexpr (stiffly_accurate) {
      for (std::size_t n = 0; n < y.size(); ++n) y[n] += system_.z[T.stages - 1][n];
    } else {
      const std::vector<double>& weights = stage_transform<T>().weights;
      for (std::size_t n = 0; n < y.size(); ++n) {
        double sum = 0;
        for (std::size_t j = 0; j < T.stages; ++j) sum += weights[j] * system_.z[j][n];
        y[n] += sum;
      }
    }
  }

  StageSystem<T, P> system_;
  double factored_for_ = 0;
};

/// Fits problems of few unknowns, or with a sparse Jacobian. The stages couple through the whole
/// Jacobian, while a large problem's own solver inverts I - gamma h J for real gamma h only.
struct ForFewUnknowns {
  static constexpr std::string_view needs =
      "a sparse Jacobian or a dense one, of 128 unknowns at most: the stages couple through the "
      "whole of it";
  template <class P>
  static constexpr bool fits = Ode<P>;
  template <class P>
  static bool fits_problem(const P& problem) {
    if constexpr (WithSparsity<P>)
      if (problem.sparsity()) return true;
    return size_of(problem) <= dense_dimension_limit;
  }
};
static_assert(dense_dimension_limit == 128, "as `needs` says");

/// Base of a fully implicit method.
template <const auto& T>
struct FullyImplicitMethod : ForFewUnknowns, TableauMethod<T> {
  template <class P>
  using Stepper = FullyImplicitRungeKutta<T, P>;
  static constexpr MethodInfo described(MethodInfo info) {
    return completed(info, "implicit_rk", T);
  }
};

}  // namespace odeum
