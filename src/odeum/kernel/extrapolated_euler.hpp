// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cmath>
#include <complex>

#include "odeum/kernel/components.hpp"
#include "odeum/kernel/newton.hpp"
#include "odeum/linear/shifted_solver.hpp"

namespace odeum {

/// The linearly implicit Euler method with n_j = 2, 3, 4, ... substeps, one Jacobian for all, and
/// its extrapolation to the substep zero (Hairer, Wanner, Solving ODEs II, IV.9):
///
///     (I - H J)(y_{i+1} - y_i) = H f(t_{i+1}, y_i),  H = h / n_j;
///     T_{j,k+1} = T_{j,k} + (T_{j,k} - T_{j-1,k}) / (n_j / n_{j-k} - 1).
///
/// Column k has order k.
template <Ode P>
class ExtrapolatedEulerTable {
 public:
  static constexpr std::size_t max_columns = 12;
  static constexpr std::size_t substeps(std::size_t row) { return row + 2; }

  explicit ExtrapolatedEulerTable(const P& problem)
      : problem_(problem), system_(problem), f_(make_state(problem)), argument_(f_) {
    table_.fill(f_);
  }

  void linearise(double t, const State<P>& y) { system_.linearise(t, y); }
  /// Overwrites x by what the steps of the last row make of a change of h f by x.
  void damp(State<P>& x) { system_.solve(x.data()); }

  /// Adds row j (from 0); the table then holds T_{j,1}, ..., T_{j,j+1}. False: the matrix is
  /// singular or not finite. `contraction` of the first row: how the corrections of a Newton
  /// iteration on its first substep would shrink; above one, the step is too long for its Jacobian.
  bool add_row(std::size_t j, double t, double h, const State<P>& y, double& contraction) {
    const double substep = h / static_cast<double>(substeps(j));
    if (!system_.factorise(substep)) return false;
    argument_ = y;
    for (std::size_t i = 1; i <= substeps(j); ++i) {
      const double time = t + static_cast<double>(i) * substep;
      problem_.rhs(time, argument_.data(), f_.data());
      for (double& component : f_) component *= substep;
      if (!system_.solve(f_.data())) return false;
      each_component(y, [&](std::size_t n) { argument_[n] += f_[n]; });
      if (j == 0 && i == 1 && !look_ahead(time, substep, contraction)) return false;
    }
    // Along the new row; table_[k] holds T_{j-1,k+1} until it is overwritten by T_{j,k+1}.
    for (std::size_t k = 0; k < j; ++k)
      each_component(y, [&](std::size_t n) {
        const double next = argument_[n] + (argument_[n] - table_[k][n]) * weights[j][k];
        table_[k][n] = argument_[n];
        argument_[n] = next;
      });
    table_[j] = argument_;
    return true;
  }

  /// T_{j,k+1} of the last row j.
  const State<P>& column(std::size_t k) const { return table_[k]; }

 private:
  bool look_ahead(double time, double substep, double& contraction) {
    State<P> second = f_;
    problem_.rhs(time, argument_.data(), second.data());
    each_component(f_, [&](std::size_t n) { second[n] = substep * second[n] - f_[n]; });
    if (!system_.solve(second.data())) return false;
    contraction = 0;
    const double first = max_norm(f_);
    if (first > 0) contraction = max_norm(second) / first;
    return true;
  }

  static constexpr auto weights = [] {
    std::array<std::array<double, max_columns>, max_columns> w{};
    for (std::size_t j = 0; j < max_columns; ++j)
      for (std::size_t k = 0; k < j; ++k) {
        const auto n = static_cast<double>(substeps(j));
        w[j][k] = 1 / (n / static_cast<double>(substeps(j - k - 1)) - 1);
      }
    return w;
  }();

  const P& problem_;
  ShiftedSystem<P> system_;
  State<P> f_, argument_;
  std::array<State<P>, max_columns> table_;
};

/// A step of a fixed size by a fixed column.
template <std::size_t Column, Ode P>
class ExtrapolatedEuler {
 public:
  explicit ExtrapolatedEuler(const P& problem) : table_(problem) {}
  Status step(double t, double h, State<P>& y) {
    double contraction = 0;
    table_.linearise(t, y);
    for (std::size_t j = 0; j < Column; ++j)
      // As in an adaptive run, which rejects such a step. Past it the state grows without bound,
      // and rounding with it.
      if (!table_.add_row(j, t, h, y, contraction) || !(contraction <= 1))
        return Status::newton_failed;
    y = table_.column(Column - 1);
    return Status::ok;
  }

 private:
  ExtrapolatedEulerTable<P> table_;
};

/// |R(z)| of that step.
template <std::size_t Column>
double extrapolated_euler_amplification(std::complex<double> z) {
  std::array<std::complex<double>, Column> table{};
  for (std::size_t j = 0; j < Column; ++j) {
    const auto n = static_cast<double>(j + 2);
    std::complex<double> carried = std::pow(1.0 / (1.0 - z / n), static_cast<int>(j + 2));
    for (std::size_t k = 0; k < j; ++k) {
      const double weight = 1 / (n / static_cast<double>(j - k + 1) - 1);
      const auto next = carried + (carried - table[k]) * weight;
      table[k] = carried;
      carried = next;
    }
    table[j] = carried;
  }
  return std::abs(table[Column - 1]);
}

/// What random rounding of the first column comes to in that step: the root of the sum of squares
/// of the weights with which extrapolation in powers of h combines it.
template <std::size_t Column>
double extrapolated_euler_rounding() {
  double squares = 0;
  for (std::size_t j = 0; j < Column; ++j) {
    double weight = 1;
    for (std::size_t k = 0; k < Column; ++k)
      if (k != j)
        weight *= static_cast<double>(j + 2) / (static_cast<double>(j) - static_cast<double>(k));
    squares += weight * weight;
  }
  return std::sqrt(squares);
}

}  // namespace odeum
