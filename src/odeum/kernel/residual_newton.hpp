// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>

#include "odeum/core/status.hpp"
#include "odeum/kernel/components.hpp"
#include "odeum/kernel/iteration.hpp"
#include "odeum/kernel/newton.hpp"
#include "odeum/kernel/residual_system.hpp"
#include "odeum/kernel/simplified_newton.hpp"

namespace odeum {

/// Newton's method on residuals: y with R(t, y, (y - base) / gamma_h) = 0, to rounding, with a new
/// matrix at each iteration. In place of y = base + gamma_h f(t, y), it gives multistep formulas
/// and diagonally implicit stages on y' = f(t, y) the same equations on residuals.
template <WithResiduals P>
class Newton<P> {
 public:
  explicit Newton(const P& problem, double = 1)
      : system_(problem), increment_(make_state(problem)), change_(increment_) {}

  Status solve(double t, double gamma_h, const State<P>& base, State<P>& y) {
    newton_.begin();
    const auto correct = [&] {
      each_component(y, [&](std::size_t i) {
        increment_[i] = y[i] - base[i];
        change_[i] = increment_[i] / gamma_h;
      });
      system_.linearise(t, y, change_);
      if (!system_.factorise(gamma_h)) return newton_.no_solution;
      system_.correct(t, y, change_);
      each_component(y, [&](std::size_t i) { y[i] += change_[i]; });
      newton_.measure_in(iteration_tolerance *
                         std::max({max_norm(y), max_norm(base), smallest_state}));
      return max_norm(change_);
    };
    return newton_(correct) == NewtonVerdict::done ? Status::ok : Status::newton_failed;
  }

 private:
  ResidualSystem<P> system_;
  State<P> increment_, change_;
  // A matrix at each iteration: a correction that is larger than the one before it means nothing.
  SimplifiedNewton<NewtonSettings{.divergent = NewtonSettings::never}> newton_{30};
};

}  // namespace odeum
