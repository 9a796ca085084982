// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cmath>
#include <complex>

#include "odeum/kernel/newton.hpp"
#include "odeum/linear/shifted_solver.hpp"

namespace odeum {

/// The systems (I - h/n_j J) x = r of the rows j. Where they are few numbers each row has its own
/// factors, so that rows may be computed side by side; else all have to share one, row by row.
template <Ode P, std::size_t Rows>
class RowSystems {
 public:
  static constexpr bool side_by_side = false;
  explicit RowSystems(const P& problem) : system_(problem) {}
  void linearise(double t, const State<P>& y) { system_.linearise(t, y); }
  bool factorise(std::size_t, double gamma_h) { return system_.factorise(gamma_h); }
  bool solve(std::size_t, double* x) { return system_.solve(x); }

 private:
  ShiftedSystem<P> system_;
};

template <Ode P, std::size_t Rows>
requires(P::dimension <= 8 && !WithShiftedSolver<P>) class RowSystems<P, Rows> {
 public:
  static constexpr bool side_by_side = true;
  explicit RowSystems(const P& problem) : jacobian_(problem) {}
  void linearise(double t, const State<P>& y) { jacobian_.linearise(t, y.data()); }
  bool factorise(std::size_t row, double gamma_h) {
    linear::shifted_matrix(P::dimension, gamma_h, jacobian_.jacobian().data(), rows_[row].data());
    return rows_[row].factorise();
  }
  bool solve(std::size_t row, double* x) {
    rows_[row].solve(x);
    return true;
  }

 private:
  DenseShiftedSolver<P> jacobian_;
  std::array<linear::DenseSolver<P::dimension>, Rows> rows_;
};

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
      : problem_(problem), systems_(problem), f_(make_state(problem)) {
    for (auto* states : {&now_, &table_}) states->fill(f_);
  }

  void linearise(double t, const State<P>& y) { systems_.linearise(t, y); }

  /// Row 0 of a step of h from (t, y). False, as everywhere here: a matrix cannot be used.
  /// `contraction`: how the corrections of a Newton iteration on its first substep would shrink;
  /// above one, the step is too long for its Jacobian.
  bool begin(double t, double h, const State<P>& y, double& contraction) {
    t_ = t;
    h_ = h;
    y0_ = y;
    computed_ = 1;
    const double length = h / static_cast<double>(substeps(0));
    now_[0] = y;
    if (!systems_.factorise(0, length) || !substep(0, 1)) return false;
    if (!look_ahead(t + length, length, contraction) || !substep(0, 2)) return false;
    extrapolate(0);
    return true;
  }

  /// Adds row j, after row j - 1; the table then holds T_{j,1}, ..., T_{j,j+1}. The first `sure`
  /// rows will be asked for: while one waits for its last evaluation the others go on.
  bool add_row(std::size_t j, std::size_t sure) {
    if (j >= computed_) {
      const std::size_t last = systems_.side_by_side && sure > j ? sure - 1 : j;
      if (!compute(j, last)) return false;
      computed_ = last + 1;
    }
    extrapolate(j);
    return true;
  }

  /// T_{j,k+1} of the last row j.
  const State<P>& column(std::size_t k) const { return table_[k]; }

 private:
  bool compute(std::size_t first, std::size_t last) {
    for (std::size_t j = first; j <= last; ++j) {
      if (!systems_.factorise(j, h_ / static_cast<double>(substeps(j)))) return false;
      now_[j] = y0_;
    }
    for (std::size_t i = 1; i <= substeps(last); ++i)
      for (std::size_t j = last + 1; j-- > first && substeps(j) >= i;)
        if (!substep(j, i)) return false;
    return true;
  }

  bool substep(std::size_t j, std::size_t i) {
    const double length = h_ / static_cast<double>(substeps(j));
    problem_.rhs(t_ + static_cast<double>(i) * length, now_[j].data(), f_.data());
    for (double& component : f_) component *= length;
    if (!systems_.solve(j, f_.data())) return false;
    for (std::size_t n = 0; n < f_.size(); ++n) now_[j][n] += f_[n];
    return true;
  }

  /// After the first substep of row 0, of which f_ has the increment.
  bool look_ahead(double time, double length, double& contraction) {
    State<P> second = f_;
    problem_.rhs(time, now_[0].data(), second.data());
    for (std::size_t n = 0; n < f_.size(); ++n) second[n] = length * second[n] - f_[n];
    if (!systems_.solve(0, second.data())) return false;
    contraction = 0;
    const double first = max_norm(f_);
    if (first > 0) contraction = max_norm(second) / first;
    return true;
  }

  // Along the new row; table_[k] holds T_{j-1,k+1} until it is overwritten by T_{j,k+1}.
  void extrapolate(std::size_t j) {
    State<P>& carried = now_[j];
    for (std::size_t k = 0; k < j; ++k)
      for (std::size_t n = 0; n < carried.size(); ++n) {
        const double next = carried[n] + (carried[n] - table_[k][n]) * weights[j][k];
        table_[k][n] = carried[n];
        carried[n] = next;
      }
    table_[j] = carried;
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
  RowSystems<P, max_columns> systems_;
  double t_ = 0, h_ = 0;
  std::size_t computed_ = 0;  ///< rows of which now_ has the result of the substeps
  State<P> f_, y0_;
  std::array<State<P>, max_columns> now_, table_;
};

/// A step of a fixed size by a fixed column.
template <std::size_t Column, Ode P>
class ExtrapolatedEuler {
 public:
  explicit ExtrapolatedEuler(const P& problem) : table_(problem) {}
  Status step(double t, double h, State<P>& y) {
    double contraction = 0;
    table_.linearise(t, y);
    if (!table_.begin(t, h, y, contraction)) return Status::newton_failed;
    for (std::size_t j = 1; j < Column; ++j)
      if (!table_.add_row(j, Column)) return Status::newton_failed;
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
    const double n = static_cast<double>(j + 2);
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

}  // namespace odeum
