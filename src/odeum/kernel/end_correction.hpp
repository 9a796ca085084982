// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>
#include <optional>

#include "odeum/core/tolerance.hpp"
#include "odeum/kernel/scaled_norm.hpp"
#include "odeum/problem/concepts.hpp"

namespace odeum {

/// Looks at nothing, where the last stage of the method does not correct the end of its step.
template <Ode P, bool corrects_its_end>
class EndCorrection {
 public:
  EndCorrection(const P&, const State<P>&) {}
  void solve_to(const Tolerance&) {}
  void keep_slope(const State<P>&) {}
  void keep_residual(const State<P>&) {}
  template <class Real>
  static constexpr bool holds(Real, Real, const State<P>&, const State<P>&) {
    return true;
  }
};

/// Whether the matrix of a Rosenbrock method holds to the end of its step. The last stage u is then
/// one step of Newton's method, (I - gamma h J) u = r, and the estimated error. Where f leaves a
/// steep slope behind, as friction does when a body that sticks is torn off, that matrix damps any
/// residual r to next to nothing, and the run sticks for long. The residual after the correction,
/// gamma h (f(y) - f - J u), is zero where J holds. It matters where it is many times the tolerance
/// and more than half of r: Newton's method would hardly converge by this matrix. Without a
/// tolerance nothing is looked at.
template <Ode P>
class EndCorrection<P, true> {
 public:
  EndCorrection(const P& problem, const State<P>& like)
      : problem_(problem), slope_(like), residual_(like), after_(like) {}

  void solve_to(const Tolerance& tolerance) { scale_.emplace(tolerance, slope_); }
  void keep_slope(const State<P>& f) {  ///< of the last stage
    if (scale_) slope_ = f;
  }
  void keep_residual(const State<P>& r) {
    if (scale_) residual_ = r;
  }
  /// For a step to y at t with the correction u; evaluates f where r is of any size and u is not.
  bool holds(double t, double gamma_h, const State<P>& y, const State<P>& u) {
    constexpr double matters = 10, contracts = 0.5, estimated = 2;
    if (!scale_ || !(size_of(residual_, y) > matters) || size_of(u, y) > estimated) return true;
    problem_.rhs(t, y.data(), after_.data());
    for (std::size_t i = 0; i < y.size(); ++i)
      after_[i] = gamma_h * (after_[i] - slope_[i]) - (u[i] - residual_[i]);
    const double after = size_of(after_, y);
    return !(after > matters && after > contracts * size_of(residual_, y));
  }

 private:
  /// The largest component over its tolerance.
  double size_of(const State<P>& x, const State<P>& y) const {
    double largest = 0;
    for (std::size_t i = 0; i < y.size(); ++i)
      largest = std::max(largest, std::abs(x[i]) / (*scale_)(i, std::abs(y[i])));
    return largest;
  }

  const P& problem_;
  State<P> slope_, residual_, after_;
  std::optional<ErrorScale<State<P>>> scale_;
};

}  // namespace odeum
