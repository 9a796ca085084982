// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/tableau/interpreter.hpp"

#include <algorithm>
#include <cmath>

namespace odeum {
namespace {

constexpr int most_iterations = 50;
/// The relative size of a correction below which Newton's iteration has converged.
constexpr double settled = 1e-14;

double largest(const std::vector<double>& x) {
  double norm = 0;
  for (const double component : x) {
    if (!std::isfinite(component)) return std::abs(component);
    norm = std::max(norm, std::abs(component));
  }
  return norm;
}

/// Decides from its corrections whether Newton's iteration has converged.
class Settling {
 public:
  /// `size` of a correction to quantities of size `scale`.
  bool reached(double size, double scale) {
    const bool small = size <= settled * (1 + scale);
    // Rounding may keep a correction just above the threshold: it then stops falling.
    const bool stuck = size <= 1e3 * settled * (1 + scale) && size >= 0.5 * last_;
    last_ = size;
    return small || stuck;
  }

 private:
  double last_ = INFINITY;
};

}  // namespace

TableauInterpreter::TableauInterpreter(const DynamicTableau<double>& tableau,
                                       const FunctionProblem& problem)
    : tableau_(tableau),
      problem_(problem),
      n_(problem.size()),
      s_(tableau.stages),
      one_by_one_(tableau.is_diagonally_implicit()),
      k_(n_ * s_),
      f_(n_),
      argument_(n_),
      jacobian_(n_ * n_),
      residual_(n_ * s_),
      stage_lu_(n_),
      all_lu_(one_by_one_ ? 0 : n_ * s_) {}

Status TableauInterpreter::step(double t, double h, std::vector<double>& y) {
  const Status status = solve_stages(t, h, y);
  if (status == Status::ok) add(h, tableau_.b, y);
  return status;
}

Status TableauInterpreter::step(double t, double h, std::vector<double>& y,
                                std::vector<double>& error) {
  const Status status = solve_stages(t, h, y);
  if (status != Status::ok) return status;
  std::vector<double> difference = tableau_.b;
  for (std::size_t i = 0; i < s_; ++i) difference[i] -= tableau_.b_hat[i];
  error.assign(n_, 0.0);
  add(h, difference, error);
  add(h, tableau_.b, y);
  return Status::ok;
}

void TableauInterpreter::add(double h, const std::vector<double>& weights,
                             std::vector<double>& y) const {
  for (std::size_t n = 0; n < n_; ++n) {
    double sum = 0;
    for (std::size_t i = 0; i < s_; ++i) sum += weights[i] * k_[i * n_ + n];
    y[n] += h * sum;
  }
}

void TableauInterpreter::form_argument(std::size_t i, double h, const std::vector<double>& y) {
  for (std::size_t n = 0; n < n_; ++n) {
    double sum = 0;
    for (std::size_t j = 0; j < s_; ++j) sum += tableau_.at(i, j) * k_[j * n_ + n];
    argument_[n] = y[n] + h * sum;
  }
}

Status TableauInterpreter::solve_stages(double t, double h, const std::vector<double>& y) {
  if (!one_by_one_) return solve_together(t, h, y);
  std::ranges::fill(k_, 0.0);
  for (std::size_t i = 0; i < s_; ++i) {
    if (tableau_.at(i, i) == 0) {
      form_argument(i, h, y);
      problem_.rhs(t + tableau_.c[i] * h, argument_.data(), k(i));
    } else if (const Status status = solve_stage(i, t, h, y); status != Status::ok) {
      return status;
    }
  }
  return Status::ok;
}

// k_i - f(t_i, argument(k_i)) = 0, with the derivative I - h a_ii J.
Status TableauInterpreter::solve_stage(std::size_t i, double t, double h,
                                       const std::vector<double>& y) {
  const double at = t + tableau_.c[i] * h, shift = h * tableau_.at(i, i);
  problem_.rhs(at, y.data(), k(i));
  Settling settling;
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    form_argument(i, h, y);
    problem_.rhs(at, argument_.data(), f_.data());
    problem_.jacobian(at, argument_.data(), jacobian_.data());
    for (std::size_t m = 0; m < n_ * n_; ++m)
      stage_lu_.data()[m] = (m % (n_ + 1) == 0 ? 1 : 0) - shift * jacobian_[m];
    if (!stage_lu_.factorise()) return Status::newton_failed;
    for (std::size_t n = 0; n < n_; ++n) f_[n] -= k(i)[n];
    stage_lu_.solve(f_.data());
    for (std::size_t n = 0; n < n_; ++n) k(i)[n] += f_[n];
    const double size = std::abs(h) * largest(f_);
    if (!std::isfinite(size)) return Status::newton_failed;
    if (settling.reached(size, largest(y))) return Status::ok;
  }
  return Status::newton_failed;
}

// The same for all stages: the derivative has the blocks delta_ij I - h a_ij J_i.
Status TableauInterpreter::solve_together(double t, double h, const std::vector<double>& y) {
  for (std::size_t i = 0; i < s_; ++i) problem_.rhs(t + tableau_.c[i] * h, y.data(), k(i));
  Settling settling;
  const std::size_t all = n_ * s_;
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    for (std::size_t i = 0; i < s_; ++i) {
      const double at = t + tableau_.c[i] * h;
      form_argument(i, h, y);
      problem_.rhs(at, argument_.data(), f_.data());
      problem_.jacobian(at, argument_.data(), jacobian_.data());
      for (std::size_t n = 0; n < n_; ++n) {
        residual_[i * n_ + n] = f_[n] - k(i)[n];
        double* const row = all_lu_.data() + (i * n_ + n) * all;
        for (std::size_t j = 0; j < s_; ++j)
          for (std::size_t m = 0; m < n_; ++m)
            row[j * n_ + m] =
                (i == j && n == m ? 1 : 0) - h * tableau_.at(i, j) * jacobian_[n * n_ + m];
      }
    }
    if (!all_lu_.factorise()) return Status::newton_failed;
    all_lu_.solve(residual_.data());
    for (std::size_t m = 0; m < all; ++m) k_[m] += residual_[m];
    const double size = std::abs(h) * largest(residual_);
    if (!std::isfinite(size)) return Status::newton_failed;
    if (settling.reached(size, largest(y))) return Status::ok;
  }
  return Status::newton_failed;
}

}  // namespace odeum
