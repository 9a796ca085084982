// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Dense>
#include <complex>
#include <optional>
#include <type_traits>

#include "odeum/linear/banded_lu.hpp"
#include "odeum/linear/ordering.hpp"
#include "odeum/truth/system.hpp"

/// The linear algebra of the implicit methods of the truth.
namespace odeum::truth {

using Complex = std::complex<Real>;
template <class Scalar>
using MatrixOf = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
template <class Scalar>
using VectorOf = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
using Matrix = MatrixOf<Real>;
using Index = Eigen::Index;

/// The Jacobian of a system, dense or in a band.
struct Jacobian {
  const System& system;
  Matrix dense = {};
  linear::Band narrow = {};
  State values = {};

  explicit Jacobian(const System& of) : system(of) {
    if (!system.entries) return;
    narrow = linear::band_of(*system.sparsity, linear::reverse_cuthill_mckee(*system.sparsity));
    values.resize(system.sparsity->entries());
  }
  void linearise(Real t, const State& y) {
    if (system.entries) return system.entries(t, y.data(), values.data());
    const auto n = static_cast<Index>(system.states);
    dense.resize(n, n);
    system.jacobian(t, y.data(), dense.data());
  }
};

/// The factors of I - g J for a real or complex g.
template <class Scalar>
class Shifted {
  static constexpr bool is_complex = !std::is_same_v<Scalar, Real>;

 public:
  explicit Shifted(const Jacobian& jacobian) : j_(jacobian) {}

  /// False where a band is singular or not finite.
  bool factorise(Scalar g) {
    const auto n = static_cast<Index>(size());
    if (j_.system.entries) return factorise_band(g);
    factors_.compute(MatrixOf<Scalar>::Identity(n, n) - g * j_.dense.template cast<Scalar>());
    return true;
  }
  VectorOf<Scalar> solve(const VectorOf<Scalar>& right) {
    if (!j_.system.entries) return factors_.solve(right);
    State re(size()), im(is_complex ? size() : 0);
    for (std::size_t i = 0; i < size(); ++i) {
      const Scalar x = right(static_cast<Index>(i));
      re[place(i)] = std::real(x);
      if constexpr (is_complex) im[place(i)] = std::imag(x);
    }
    band_->solve(re.data(), im.data());
    VectorOf<Scalar> result(right.size());
    for (std::size_t i = 0; i < size(); ++i)
      if constexpr (is_complex)
        result(static_cast<Index>(i)) = {re[place(i)], im[place(i)]};
      else
        result(static_cast<Index>(i)) = re[place(i)];
    return result;
  }
  /// Operations of a factorisation, and of a solution with it.
  double factor_work() const {
    const auto n = static_cast<double>(size());
    return arithmetic * (j_.system.entries
                             ? 2 * n * static_cast<double>(j_.narrow.lower + 1) * width()
                             : n * n * n * 2 / 3);
  }
  double solve_work() const {
    const auto n = static_cast<double>(size());
    return arithmetic * 2 * n *
           (j_.system.entries ? width() + static_cast<double>(j_.narrow.lower) : n);
  }

 private:
  static constexpr double arithmetic = is_complex ? 4 : 1;  ///< real operations of one
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
  Eigen::PartialPivLU<MatrixOf<Scalar>> factors_;
  std::optional<linear::BandedLu<is_complex, Real>> band_;
};

}  // namespace odeum::truth
