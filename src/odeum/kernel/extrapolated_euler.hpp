// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

#include "odeum/control/adaptive.hpp"
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
  static constexpr double substeps(std::size_t row) { return static_cast<double>(row + 2); }

  explicit ExtrapolatedEulerTable(const P& problem)
      : problem_(problem), system_(problem), f_(make_state(problem)), argument_(f_) {
    table_.fill(f_);
  }

  void linearise(double t, const State<P>& y) { system_.linearise(t, y); }

  /// Adds row j (from 0); the table then holds T_{j,1}, ..., T_{j,j+1}. False: the matrix cannot be
  /// used. `contraction` of the first row: how the corrections of a Newton iteration on its first
  /// substep would shrink; above one, the step is too long for its Jacobian.
  bool add_row(std::size_t j, double t, double h, const State<P>& y, double& contraction) {
    const double substep = h / substeps(j);
    if (!system_.factorise(substep)) return false;
    argument_ = y;
    for (std::size_t i = 1; i <= j + 2; ++i) {
      const double time = t + static_cast<double>(i) * substep;
      problem_.rhs(time, argument_.data(), f_.data());
      for (double& component : f_) component *= substep;
      if (!system_.solve(f_.data())) return false;
      for (std::size_t n = 0; n < y.size(); ++n) argument_[n] += f_[n];
      if (j == 0 && i == 1 && !look_ahead(time, substep, contraction)) return false;
    }
    State<P> carried = argument_;
    // Down the new row; table_[k] holds T_{j-1,k+1} until it is overwritten by T_{j,k+1}.
    for (std::size_t k = 0; k < j; ++k) {
      const double weight = 1 / (substeps(j) / substeps(j - k - 1) - 1);
      for (std::size_t n = 0; n < y.size(); ++n) {
        const double next = carried[n] + (carried[n] - table_[k][n]) * weight;
        table_[k][n] = carried[n];
        carried[n] = next;
      }
    }
    table_[j] = carried;
    return true;
  }

  /// T_{j,k+1} of the last row j.
  const State<P>& column(std::size_t k) const { return table_[k]; }

 private:
  bool look_ahead(double time, double substep, double& contraction) {
    State<P> second = f_;
    problem_.rhs(time, argument_.data(), second.data());
    for (std::size_t n = 0; n < f_.size(); ++n) second[n] = substep * second[n] - f_[n];
    if (!system_.solve(second.data())) return false;
    contraction = 0;
    const double first = max_norm(f_);
    if (first > 0) contraction = max_norm(second) / first;
    return true;
  }

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
      if (!table_.add_row(j, t, h, y, contraction)) return Status::newton_failed;
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

/// Chooses step and column of an adaptive run by the work a unit of time (IV.9; Solving ODEs I,
/// II.9): it aims at column `target`, takes the one before where that is exact enough, the one
/// after where it is needed.
template <Ode P>
class ExtrapolatedEulerControl {
 public:
  ExtrapolatedEulerControl(const P& problem, double tolerance)
      : table_(problem), scale_(make_state(problem)), tolerance_(tolerance) {
    target_ = std::clamp(static_cast<std::size_t>(1.5 - 0.6 * std::log10(tolerance)),
                         std::size_t{2}, last - 1);
    // In units of an evaluation with its solve; a factorisation counts as two.
    work_[0] = 3 + ExtrapolatedEulerTable<P>::substeps(0) + 2;
    for (std::size_t j = 1; j < columns; ++j)
      work_[j] = work_[j - 1] + ExtrapolatedEulerTable<P>::substeps(j) + 2;
  }

  Status operator()(double t, double h, const State<P>& y, State<P>& y_new, double& error) {
    if (moved_) {
      table_.linearise(t, y);
      moved_ = false;
    }
    for (std::size_t n = 0; n < y.size(); ++n) scale_[n] = 1 / (tolerance_ * (1 + std::abs(y[n])));
    used_ = 0;
    double before = 0;
    for (std::size_t j = 0; j <= std::min(target_ + 1, last); ++j) {
      double contraction = 0;
      if (!table_.add_row(j, t, h, y, contraction) || !(contraction <= 1)) return unusable();
      if (j == 0) continue;
      error = difference(j);
      if (!std::isfinite(error) || (j > 1 && error > before && error > 1)) return unusable();
      before = std::max(4 * error, 1.0);
      used_ = j;
      step_[j] = h * std::clamp(0.94 * std::pow(0.65 / std::max(error, 1e-12),
                                                1.0 / static_cast<double>(j + 1)),
                                0.1, 8.0);
      cost_[j] = work_[j] / step_[j];
      if (error <= 1 && (j + 1 >= target_ || first_)) break;
      // No hope within the columns that are left.
      const double n = ExtrapolatedEulerTable<P>::substeps(target_);
      if (j + 1 == target_ && error > 4 * n * (n + 1)) break;
      if (j == target_ && error > 2 * (n + 1)) break;
    }
    y_new = table_.column(used_);
    return Status::ok;
  }

  Decision decide(double h, double error) {
    Decision decision{error <= 1, h};
    if (decision.accept) {
      accepted(h, decision.next_step);
      first_ = rejected_ = false;
      moved_ = true;
    } else {
      target_ = std::min({target_, used_, last - 1});
      if (target_ > 2 && cost_[target_ - 1] < 0.7 * cost_[target_]) --target_;
      target_ = std::max(target_, std::size_t{1});
      decision.next_step = std::min(step_[std::max(target_, std::size_t{1})], 0.8 * h);
      rejected_ = true;
    }
    return decision;
  }

 private:
  static constexpr std::size_t columns = ExtrapolatedEulerTable<P>::max_columns, last = columns - 1;

  Status unusable() {
    rejected_ = true;
    return Status::newton_failed;
  }

  void accepted(double h, double& next) {
    const std::size_t k = used_;
    std::size_t best = k;
    if (k >= 2 && cost_[k - 1] < 0.7 * cost_[k])
      best = k - 1;
    else if (k == 1 || cost_[k] < 0.9 * cost_[k - 1])
      best = std::min(k + 1, last - 1);
    if (rejected_) {
      target_ = std::max(std::min(best, k), std::size_t{1});
      next = std::min(h, step_[target_]);
      return;
    }
    next = best <= k ? step_[best] : step_[k] * work_[best] / work_[k];
    target_ = std::max(best, std::size_t{2});
  }

  double difference(std::size_t j) const {
    double sum = 0;
    const State<P>&a = table_.column(j), &b = table_.column(j - 1);
    for (std::size_t n = 0; n < a.size(); ++n) {
      const double scaled = (a[n] - b[n]) * scale_[n];
      sum += scaled * scaled;
    }
    return std::sqrt(sum / static_cast<double>(a.size()));
  }

  ExtrapolatedEulerTable<P> table_;
  State<P> scale_;
  double tolerance_;
  std::size_t target_ = 2, used_ = 0;  ///< columns, from 0
  bool first_ = true, rejected_ = false, moved_ = true;
  std::array<double, columns> work_{}, step_{}, cost_{};
};

}  // namespace odeum
