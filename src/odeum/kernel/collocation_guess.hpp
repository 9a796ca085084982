// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <utility>

#include "odeum/kernel/components.hpp"
#include "odeum/problem/concepts.hpp"

namespace odeum {

/// Guesses for the stages Z_i of a collocation step with nodes c_i, the last of which is 1: from
/// the polynomial through (0, 0) and (c_i, Z_i) of the step before, beyond its right end (Solving
/// ODEs II, IV.8).
template <std::size_t Stages, Ode P>
class CollocationGuess {
 public:
  using Nodes = std::array<double, Stages>;

  CollocationGuess(const P& problem, const Nodes& nodes) : nodes_(nodes) {
    last_z_.fill(make_state(problem));
  }

  /// Fills z for a step of h from y; zeros before the first step.
  void operator()(double h, const State<P>& y, std::array<State<P>, Stages>& z) {
    if (last_h_ == 0) {
      for (State<P>& stage : z)
        for (double& component : stage) component = 0;
      return;
    }
    if (const double ratio = h / last_h_; ratio != weights_for_) compute_weights(ratio);
    for (std::size_t i = 0; i < Stages; ++i)
      each_component(y, [&](std::size_t n) {
        double sum = -last_z_[Stages - 1][n];
        for (std::size_t j = 0; j < Stages; ++j) sum += weights_[i][j] * last_z_[j][n];
        // A component guessed with the other sign than y's starts from y instead: it could converge
        // to another solution, or overshoot a decay to zero.
        z[i][n] = (y[n] + sum) * y[n] < 0 ? 0 : sum;
      });
  }

  /// z <- the polynomial of the last step at a share of it, from 0 at its start to 1.
  void at(double share, State<P>& z) const {
    const std::array<double, Stages> weights = basis(share);
    each_component(z, [&](std::size_t n) {
      double sum = 0;
      for (std::size_t j = 0; j < Stages; ++j) sum += weights[j] * last_z_[j][n];
      z[n] = sum;
    });
  }

  /// Takes over the stages of an accepted step of h by swapping; z then holds older ones.
  void remember(double h, std::array<State<P>, Stages>& z) {
    std::swap(last_z_, z);
    last_h_ = h;
  }

 private:
  /// Lagrange's polynomials of the nodes and of 0, where the stages vanish.
  std::array<double, Stages> basis(double x) const {
    const Nodes& c = nodes_;
    std::array<double, Stages> l{};
    for (std::size_t j = 0; j < Stages; ++j) {
      l[j] = x / c[j];
      for (std::size_t m = 0; m < Stages; ++m)
        if (m != j) l[j] *= (x - c[m]) / (c[j] - c[m]);
    }
    return l;
  }
  void compute_weights(double ratio) {
    for (std::size_t i = 0; i < Stages; ++i) weights_[i] = basis(1 + ratio * nodes_[i]);
    weights_for_ = ratio;
  }

  const Nodes& nodes_;
  std::array<State<P>, Stages> last_z_;
  std::array<std::array<double, Stages>, Stages> weights_{};
  double weights_for_ = 0, last_h_ = 0;
};

}  // namespace odeum
