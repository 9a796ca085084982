// SPDX-License-Identifier: BSD-3-Clause
#include "odepack/run.hpp"

#include <algorithm>

namespace odeum::adapters::odepack {

Problem::Problem(const ErasedContest& contest, const Request& request)
    : n_(contest.view.dimension),
      guarded_(contest.view, request.budget, &request.tolerance),
      dense_(guarded_),
      watched_(request.budget.watched) {
  const OdeView& view = guarded_.view();
  if (view.sparsity) {
    band_ = linear::band_of(*view.sparsity);
    banded_ = 2 * band_.lower + band_.upper + 1 < n_;
    values_.resize(view.sparsity->entries());
  }
  if (!banded_) values_.resize(std::min(n_, dense_dimension_limit) * n_);
}

void Problem::rhs(double t, const double* y, double* dydt) {
  if (guarded_.rhs(t, y, dydt) != 0) throw Left{};
  if (!watched_) return;
  // A step that is shortened to a quarter after each few of them is below the rounding of t.
  constexpr int most = 100;
  not_finite_ = is_finite(dydt, n_) ? 0 : not_finite_ + 1;
  if (not_finite_ > most) throw Left{Status::non_finite};
}

void Problem::fill(double t, const double* y, double* jacobian, int rows) {
  const auto stride = static_cast<std::size_t>(rows);
  if (!banded_) {
    if (dense_(t, y, values_.data()) != 0) throw Left{};
    for (std::size_t j = 0; j < n_; ++j)
      for (std::size_t i = 0; i < n_; ++i) jacobian[j * stride + i] = values_[i * n_ + j];
    return;
  }
  if (guarded_.jacobian_entries(t, y, values_.data()) != 0) throw Left{};
  for (std::size_t j = 0; j < n_; ++j)
    std::fill_n(jacobian + j * stride, band_.lower + band_.upper + 1, 0.0);
  const Sparsity& pattern = *guarded_.view().sparsity;
  for (std::size_t i = 0; i < n_; ++i)
    for (int k = pattern.start[i]; k < pattern.start[i + 1]; ++k) {
      const auto j = static_cast<std::size_t>(pattern.column[k]);
      jacobian[j * stride + (i + band_.upper - j)] = values_[static_cast<std::size_t>(k)];
    }
}

std::vector<double> Problem::absolute(const Tolerance& tolerance) const {
  std::vector<double> all;
  for (std::size_t i = 0; i < (tolerance.by_component() ? n_ : 1); ++i)
    all.push_back(tolerance.absolute(i));
  return all;
}

}  // namespace odeum::adapters::odepack
