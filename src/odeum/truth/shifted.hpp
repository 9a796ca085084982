// SPDX-License-Identifier: BSD-3-Clause
#pragma once
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

  explicit Jacobian(const System& of) : system(of) {
    if (!system.entries) return;
    const Sparsity& pattern = *system.sparsity;
    if (!system.elimination)
      narrow = linear::band_of(pattern, linear::reverse_cuthill_mckee(pattern));
    values.resize(pattern.entries());
  }
  void linearise(Real t, const State& y) {
    if (system.entries) return system.entries(t, y.data(), values.data());
    dense.resize(system.states * system.states);
    system.jacobian(t, y.data(), dense.data());
  }
};

/// The factors of I - g J for a real or complex g.
template <class Scalar>
class Shifted {
  static constexpr bool is_complex = !std::is_same_v<Scalar, Real>;

 public:
  explicit Shifted(const Jacobian& jacobian)
      : j_(jacobian), dense_(jacobian.system.entries ? 0 : jacobian.system.states) {
    if (j_.system.elimination) listed_.emplace(*j_.system.sparsity, j_.system.elimination);
  }

  /// False where the matrix is singular or not finite.
  bool factorise(Scalar g) {
    if (listed_) return listed_->factorise(j_.values, g);
    if (j_.system.entries) return factorise_band(g);
    for (std::size_t k = 0; k < j_.dense.size(); ++k)
      dense_.data()[k] = Scalar(k % (size() + 1) == 0 ? 1 : 0) - g * j_.dense[k];
    return dense_.factorise();
  }
  /// Overwrites x by the solution.
  void solve(std::vector<Scalar>& x) {
    if (listed_) return listed_->solve(x.data());
    if (!j_.system.entries) return dense_.solve(x.data());
    State re(size()), im(is_complex ? size() : 0);
    for (std::size_t i = 0; i < size(); ++i) {
      re[place(i)] = std::real(x[i]);
      if constexpr (is_complex) im[place(i)] = std::imag(x[i]);
    }
    band_->solve(re.data(), im.data());
    for (std::size_t i = 0; i < size(); ++i)
      if constexpr (is_complex)
        x[i] = {re[place(i)], im[place(i)]};
      else
        x[i] = re[place(i)];
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
  bool factorise_band(Scalar g) {
    band_.emplace(size(), j_.narrow.lower, j_.narrow.upper);
    const Sparsity& pattern = *j_.system.sparsity;
    for (std::size_t i = 0; i < size(); ++i)
      for (int k = pattern.start[i]; k < pattern.start[i + 1]; ++k) {
        const std::size_t at =
            band_->place(place(i), place(static_cast<std::size_t>(pattern.column[k])));
        band_->re()[at] -= std::real(g) * j_.values[static_cast<std::size_t>(k)];
        if constexpr (is_complex)
          band_->im()[at] -= std::imag(g) * j_.values[static_cast<std::size_t>(k)];
      }
    for (std::size_t k = 0; k < size(); ++k) band_->re()[band_->place(k, k)] += 1;
    return band_->factorise();
  }

  const Jacobian& j_;
  linear::Lu<Scalar> dense_;
  std::optional<linear::BandedLu<is_complex, Real>> band_;
  std::optional<linear::PatternLu<Scalar>> listed_;
};

}  // namespace odeum::truth
