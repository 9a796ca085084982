// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>
#include <type_traits>
#include <vector>

#include "odeum/linear/banded_lu.hpp"
#include "odeum/linear/dense_lu.hpp"
#include "odeum/linear/ordering.hpp"
#include "odeum/linear/pattern_lu.hpp"
#include "odeum/truth/system.hpp"

/// The linear algebra of the implicit methods of the truth.
namespace odeum::truth {

using Complex = std::complex<Real>;

/// The Jacobian of a system: dense by rows, in a band, or by its entries.
struct Jacobian {
  const System& system;
  State dense = {};
  linear::Band narrow = {};
  State values = {};
  std::vector<double> rounded = {};  ///< the values

  explicit Jacobian(const System& of) : system(of) {
    if (!system.entries) return;
    const Sparsity& pattern = *system.sparsity;
    if (!system.elimination)
      narrow = linear::band_of(pattern, linear::reverse_cuthill_mckee(pattern));
    values.resize(pattern.entries());
  }
  void linearise(Real t, const State& y) {
    if (system.entries) {
      system.entries(t, y.data(), values.data());
      rounded.assign(values.begin(), values.end());
      return;
    }
    dense.resize(system.states * system.states);
    system.jacobian(t, y.data(), dense.data());
  }
};

/// The factors of I - g J for a real or complex g, in double. A complex one corrects the iterates
/// of Newton's method, whose residuals are in extended precision. Where a real one stands in a
/// formula, its solutions are refined by residuals in extended precision (Wilkinson 1963; Moler,
/// JACM 14 (1967) 316-321).
template <class Scalar>
class Shifted {
  static constexpr bool is_complex = !std::is_same_v<Scalar, Real>;
  using Factor = std::conditional_t<is_complex, std::complex<double>, double>;

 public:
  explicit Shifted(const Jacobian& jacobian)
      : j_(jacobian), dense_(jacobian.system.entries ? 0 : jacobian.system.states), part_(size()) {
    if (j_.system.elimination) listed_.emplace(*j_.system.sparsity, j_.system.elimination);
  }

  /// False where the matrix is singular or not finite.
  bool factorise(Scalar g) {
    g_ = g;
    if (listed_) return listed_->factorise(j_.rounded, static_cast<Factor>(g));
    if (j_.system.entries) return factorise_band(static_cast<Factor>(g));
    for (std::size_t k = 0; k < j_.dense.size(); ++k)
      dense_.data()[k] =
          static_cast<Factor>(Scalar(k % (size() + 1) == 0 ? 1 : 0) - g * j_.dense[k]);
    return dense_.factorise();
  }
  /// Overwrites x by the solution.
  void solve(std::vector<Scalar>& x) {
    for (std::size_t i = 0; i < size(); ++i) part_[i] = static_cast<Factor>(x[i]);
    apply();
    if constexpr (is_complex) {
      std::ranges::copy(part_, x.begin());
    } else {
      right_ = x;
      std::ranges::copy(part_, x.begin());
      refine(x);
    }
  }
  /// Operations of a factorisation, and of a solution with it.
  double factor_work() const {
    const auto n = static_cast<double>(size());
    if (listed_)
      return arithmetic * looked_up * static_cast<double>(j_.system.elimination->targets.size());
    return arithmetic * (j_.system.entries
                             ? 2 * n * static_cast<double>(j_.narrow.lower + 1) * width()
                             : n * n * n * 2 / 3);
  }
  double solve_work() const {
    const auto n = static_cast<double>(size());
    if (listed_)
      return arithmetic * looked_up * static_cast<double>(j_.system.elimination->column.size());
    return arithmetic * 2 * n *
           (j_.system.entries ? width() + static_cast<double>(j_.narrow.lower) : n);
  }

 private:
  static constexpr double arithmetic = is_complex ? 4 : 1;  ///< real operations of one
  static constexpr double looked_up = 3;  ///< operations of a multiplication whose place is
  std::size_t size() const { return j_.system.states; }
  double width() const { return static_cast<double>(j_.narrow.lower + j_.narrow.upper + 1); }
  std::size_t place(std::size_t i) const { return static_cast<std::size_t>(j_.narrow.number[i]); }

  /// Overwrites `part_` by the solution in double.
  void apply() {
    if (listed_) return listed_->solve(part_.data());
    if (!j_.system.entries) return dense_.solve(part_.data());
    re_.resize(size());
    im_.resize(is_complex ? size() : 0);
    for (std::size_t i = 0; i < size(); ++i) {
      re_[place(i)] = std::real(part_[i]);
      if constexpr (is_complex) im_[place(i)] = std::imag(part_[i]);
    }
    band_->solve(re_.data(), im_.data());
    for (std::size_t i = 0; i < size(); ++i)
      if constexpr (is_complex)
        part_[i] = {re_[place(i)], im_[place(i)]};
      else
        part_[i] = re_[place(i)];
  }

  /// `part_` becomes the residual of x.
  void take_residual(const State& x) {
    for (std::size_t i = 0; i < size(); ++i) {
      Real slope = 0;
      if (j_.system.entries) {
        const Sparsity& pattern = *j_.system.sparsity;
        for (int k = pattern.start[i]; k < pattern.start[i + 1]; ++k)
          slope += j_.values[static_cast<std::size_t>(k)] *
                   x[static_cast<std::size_t>(pattern.column[k])];
      } else {
        for (std::size_t j = 0; j < size(); ++j) slope += j_.dense[i * size() + j] * x[j];
      }
      part_[i] = static_cast<double>(right_[i] - x[i] + g_ * slope);
    }
  }

  void refine(State& x) {
    constexpr int most = 2;
    constexpr double small = 0x1p-33;  // what the next one adds is then below extended rounding
    for (int round = 0; round < most; ++round) {
      take_residual(x);
      apply();
      bool is_last = true;
      for (std::size_t i = 0; i < size(); ++i) {
        is_last = is_last && std::abs(part_[i]) <= small * std::abs(x[i]);
        x[i] += part_[i];
      }
      if (is_last) return;
    }
  }

  bool factorise_band(Factor g) {
    band_.emplace(size(), j_.narrow.lower, j_.narrow.upper);
    const Sparsity& pattern = *j_.system.sparsity;
    for (std::size_t i = 0; i < size(); ++i)
      for (int k = pattern.start[i]; k < pattern.start[i + 1]; ++k) {
        const std::size_t at =
            band_->place(place(i), place(static_cast<std::size_t>(pattern.column[k])));
        const double value = j_.rounded[static_cast<std::size_t>(k)];
        band_->re()[at] -= std::real(g) * value;
        if constexpr (is_complex) band_->im()[at] -= std::imag(g) * value;
      }
    for (std::size_t k = 0; k < size(); ++k) band_->re()[band_->place(k, k)] += 1;
    return band_->factorise();
  }

  const Jacobian& j_;
  Scalar g_ = 0;
  linear::Lu<Factor> dense_;
  std::optional<linear::BandedLu<is_complex>> band_;
  std::optional<linear::PatternLu<Factor>> listed_;
  std::vector<Factor> part_;
  std::vector<double> re_, im_;
  State right_;
};

}  // namespace odeum::truth
