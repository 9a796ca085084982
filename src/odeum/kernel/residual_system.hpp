// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "odeum/linear/dense_lu.hpp"
#include "odeum/problem/concepts.hpp"

namespace odeum {

/// A problem that is stated by residuals R(t, y, y') = 0, see ImplicitForm. Its right-hand side
/// gives the rates of a consistent state.
template <class P>
concept WithResiduals = Ode<P> && requires(const P& p, const double* y, double* r) {
  p.residual(0.0, y, y, r);     // R(t, y, y')
  p.matrix(0.0, y, y, 0.0, r);  // dR/dy + alpha dR/dy', by rows
};

/// The linear systems of methods that solve R(t, y, (y - base) / c) = 0 for y by Newton's method:
/// their matrix is J + M / c, J = dR/dy and M = dR/dy'. It is regular at small c where the index is
/// at most 1.
template <class P>
class ResidualSystem {
 public:
  explicit ResidualSystem(const P& problem)
      : problem_(problem),
        n_(size_of(problem)),
        j_(n_ * n_),
        m_(n_ * n_),
        rates_(make_state(problem)),
        lu_(n_) {}

  void linearise(double t, const State<P>& y) {
    problem_.rhs(t, y.data(), rates_.data());
    linearise(t, y, rates_);
  }
  void linearise(double t, const State<P>& y, const State<P>& rates) {
    problem_.matrix(t, y.data(), rates.data(), 0, j_.data());
    problem_.matrix(t, y.data(), rates.data(), 1, m_.data());
    for (std::size_t i = 0; i < n_ * n_; ++i) m_[i] -= j_[i];
  }
  /// False: singular or not finite.
  bool factorise(double c) {
    for (std::size_t i = 0; i < n_ * n_; ++i) lu_.data()[i] = j_[i] + m_[i] / c;
    return lu_.factorise();
  }
  /// Overwrites x by -(J + M / c)^-1 R(t, y, x).
  void correct(double t, const State<P>& y, State<P>& x) {
    rates_ = x;
    problem_.residual(t, y.data(), rates_.data(), x.data());
    for (double& component : x) component = -component;
    lu_.solve(x.data());
  }
  void solve(double* x) { lu_.solve(x); }

 private:
  const P& problem_;
  std::size_t n_;
  std::vector<double> j_, m_;
  State<P> rates_;
  linear::DenseLu lu_;
};

}  // namespace odeum
