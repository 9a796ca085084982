// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <string_view>

#include "odeum/core/status.hpp"
#include "odeum/kernel/components.hpp"
#include "odeum/kernel/method.hpp"
#include "odeum/kernel/simplified_newton.hpp"
#include "odeum/kernel/stage_system.hpp"
#include "odeum/linear/dense_limit.hpp"
#include "odeum/tableau/collocation.hpp"

namespace odeum {

/// One step of a fixed size: stages to rounding, y <- y + sum_j (b^T A^-1)_j Z_j.
template <const auto& T, Ode P>
class FullyImplicitRungeKutta {
 public:
  static constexpr std::size_t stages = T.stages;
  static constexpr int order = T.order;
  static constexpr auto nodes = StageSystem<T, P>::nodes;
  /// See UnseenEnds.
  static constexpr bool leaves_out_ends =
      nodes[0] > order_rounding || nodes[stages - 1] < 1 - order_rounding;

  explicit FullyImplicitRungeKutta(const P& problem) : system_(problem) {}

  Status step(double t, double h, State<P>& y) {
    newton_.begin();
    for (State<P>& z : system_.z)
      for (double& component : z) component = 0;
    if (h != factored_for_ && !renew(t, h, y)) return Status::newton_failed;
    system_.transform_guess();
    const auto correct = [&] {
      double size = 0, largest = max_norm(y);
      system_.iterate(t, h, y, [&](std::size_t i, const State<P>& correction) {
        const double norm = max_norm(correction);
        if (!(norm <= size)) size = norm;  // NaN stays
        largest = std::max(largest, max_norm(system_.z[i]));
      });
      newton_.measure_in(iteration_tolerance * std::max(largest, smallest_state));
      return size;
    };
    // The Jacobian at the mean of the stages' present values.
    const auto renew_within = [&] {
      State<P> where = y;
      if (newton_.contraction() < 1)
        each_component(y, [&](std::size_t n) { where[n] += system_.z[T.stages / 2][n]; });
      return renew(t + h / 2, h, where);
    };
    if (newton_(correct, renew_within) != NewtonVerdict::done) {
      factored_for_ = 0;
      return Status::newton_failed;
    }
    finish(y);
    return Status::ok;
  }
  /// f at the stages of the last step, and the filter of StageSystem with its matrix.
  const std::array<State<P>, T.stages>& slopes() const { return system_.slopes(); }
  void damp(State<P>& x) { system_.damp(x); }

 private:
  /// The last stage is the new state.
  static constexpr bool stiffly_accurate = T.a[T.stages - 1] == T.b;

  bool renew(double t, double h, const State<P>& y) {
    newton_.renewed();
    system_.linearise(t, y);
    factored_for_ = system_.factorise(h) ? h : 0;
    return factored_for_ == h;
  }

  void finish(State<P>& y) {
    if constexpr (stiffly_accurate) {
      each_component(y, [&](std::size_t n) { y[n] += system_.z[T.stages - 1][n]; });
    } else {
      const std::vector<double>& weights = stage_transform<T>().weights;
      each_component(y, [&](std::size_t n) {
        double sum = 0;
        for (std::size_t j = 0; j < T.stages; ++j) sum += weights[j] * system_.z[j][n];
        y[n] += sum;
      });
    }
  }

  StageSystem<T, P> system_;
  // The step is not retried: a large contraction asks for a Jacobian at the stages' values.
  SimplifiedNewton<NewtonSettings{
      .divergent = NewtonSettings::never, .slow_kept = 0.05, .slow_fresh = 0.2}>
      newton_{50};
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
  static constexpr bool leaves_out_ends = false;  ///< UnseenEnds looks at them
  template <class P>
  using Stepper = FullyImplicitRungeKutta<T, P>;
  static constexpr MethodInfo described(MethodInfo info) {
    return completed(info, "implicit_rk", T);
  }
};

}  // namespace odeum
