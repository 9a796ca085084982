// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <array>
#include <cmath>

#include "odeum/core/tolerance.hpp"
#include "odeum/kernel/components.hpp"
#include "odeum/kernel/scaled_norm.hpp"
#include "odeum/problem/concepts.hpp"

namespace odeum {

/// Looks at nothing: the method sees the ends of its steps, or looks at each by itself.
template <class Stepper, Ode P>
class UnseenEnds {
 public:
  UnseenEnds(const P&, const Tolerance&) {}
  void remember_first_half(const Stepper&) {}
  static constexpr bool agree(Stepper&, double, double, const State<P>&, const State<P>&) {
    return true;
  }
};

/// Looks at f at the ends of a step that a fully implicit method makes in two halves. Between an
/// end and the stage next to it the method sees nothing: the whole step and its halves agree to
/// rounding on a fall through a floor that begins there. The slopes of the 2S stages of the halves,
/// extrapolated to an end, are compared with f there; a difference d that holds for the time up to
/// the stage next to it changes the state by as much as the error that is returned.
///
/// The differences are damped by the matrix of the method's own systems, as Radau's estimate is:
/// f multiplies the errors of stiff components.
template <class Stepper, Ode P>
requires Stepper::leaves_out_ends class UnseenEnds<Stepper, P> {
 public:
  UnseenEnds(const P& problem, const Tolerance& tolerance)
      : problem_(problem),
        before_(make_state(problem)),
        after_(before_),
        scale_(tolerance, before_) {
    first_.fill(before_);
    // Stages are of order S, and so are slopes that are extrapolated from them: S + 2 powers of the
    // step, in stiff components S + 1. Those of the order of a Gauss method are held to the former.
    constexpr double powers = stages + (Stepper::order == 2 * stages ? 2.0 : 1.0);
    held_ =
        0.3 * std::pow(tolerance.relative, powers / (Stepper::order + 1.0)) / tolerance.relative;
  }

  /// To be called after the first half.
  void remember_first_half(const Stepper& stepper) { first_ = stepper.slopes(); }

  /// After the second half of a step of h from y to y_new; whether the ends are as the stages have
  /// them.
  bool agree(Stepper& stepper, double t, double h, const State<P>& y, const State<P>& y_new) {
    problem_.rhs(t, y.data(), before_.data());
    problem_.rhs(t + h, y_new.data(), after_.data());
    return error_at(stepper, before_, weights().before, gap_before, h, y, y_new) <= held_ &&
           error_at(stepper, after_, weights().after, gap_after, h, y, y_new) <= held_;
  }

 private:
  static constexpr std::size_t stages = Stepper::stages;
  using Weights = std::array<double, 2 * stages>;
  struct BothEnds {
    Weights before, after;
  };
  static constexpr double gap_before = Stepper::nodes[0] / 2,
                          gap_after = (1 - Stepper::nodes[stages - 1]) / 2;

  /// Lagrange's polynomials of the nodes of both halves at the ends.
  static const BothEnds& weights() {
    static const BothEnds both = [] {
      Weights nodes{};
      for (std::size_t i = 0; i < 2 * stages; ++i)
        nodes[i] = (Stepper::nodes[i % stages] + (i < stages ? 0 : 1)) / 2;
      const auto at = [&](double x) {
        Weights w{};
        for (std::size_t i = 0; i < w.size(); ++i) {
          w[i] = 1;
          for (std::size_t j = 0; j < w.size(); ++j)
            if (j != i) w[i] *= (x - nodes[j]) / (nodes[i] - nodes[j]);
        }
        return w;
      };
      return BothEnds{at(0), at(1)};
    }();
    return both;
  }

  double error_at(Stepper& stepper, State<P>& f, const Weights& weights, double gap, double h,
                  const State<P>& y, const State<P>& y_new) {
    const auto& second = stepper.slopes();
    each_component(y, [&](std::size_t n) {
      for (std::size_t i = 0; i < stages; ++i)
        f[n] -= weights[i] * first_[i][n] + weights[stages + i] * second[i][n];
      f[n] *= gap * h;
    });
    stepper.damp(f);
    double sum = 0;
    each_component(y, [&](std::size_t n) {
      const double scaled = f[n] / scale_(n, std::max(std::abs(y[n]), std::abs(y_new[n])));
      sum += scaled * scaled;
    });
    return std::sqrt(sum / static_cast<double>(y.size()));
  }

  const P& problem_;
  State<P> before_, after_;
  std::array<State<P>, stages> first_;
  ErrorScale<State<P>> scale_;
  double held_;
};

}  // namespace odeum
