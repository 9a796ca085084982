// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <type_traits>
#include <vector>

#include "odeum/core/lanes.hpp"
#include "odeum/linear/shifted_solver.hpp"
#include "odeum/linear/small_inverse.hpp"
#include "odeum/problem/concepts.hpp"

namespace odeum {
namespace linear {
inline namespace ODEUM_LANES {

/// LU factorisation of a row-major N x N matrix (N known, or `dynamic`) for the member in each
/// lane. A row is the pivot where it stands, unless that would make a factor of some lane large:
/// then each lane exchanges rows as it needs. Same interface as DenseLu.
template <std::size_t N>
class LaneLu {
 public:
  explicit LaneLu(std::size_t n) : n_(n) {
    if constexpr (N == dynamic) lu_.resize(n * n), inverse_pivot_.resize(n);
    if constexpr (N == dynamic) exchanges_.resize(n);
  }
  Lanes* data() { return lu_.data(); }

  /// A lane whose matrix is singular gets values that are not finite.
  void factorise() {
    const std::size_t n = size();
    for (std::size_t k = 0; k < n; ++k) {
      exchanges_[k].clear();
      if (!all(largest_below(k) < largest_factor * abs(at(k, k)))) exchange_rows(k);
      const Lanes inverse = inverse_pivot_[k] = 1 / at(k, k);
      for (std::size_t i = k + 1; i < n; ++i) {
        const Lanes factor = at(i, k) *= inverse;
        for (std::size_t j = k + 1; j < n; ++j) at(i, j) -= factor * at(k, j);
      }
    }
  }

  void solve(Lanes* x) const {
    const std::size_t n = size();
    for (std::size_t k = 0; k < n; ++k) {
      for (const Exchange& e : exchanges_[k]) exchange(e.where, x[k], x[e.row]);
      for (std::size_t i = k + 1; i < n; ++i) x[i] -= at(i, k) * x[k];
    }
    for (std::size_t k = n; k-- > 0;) {
      x[k] *= inverse_pivot_[k];
      for (std::size_t i = 0; i < k; ++i) x[i] -= at(i, k) * x[k];
    }
  }

 private:
  static constexpr double largest_factor = 100;  // two digits lost per column at most
  struct Exchange {
    LaneMask where;
    std::size_t row;
  };

  std::size_t size() const { return N == dynamic ? n_ : N; }
  Lanes& at(std::size_t i, std::size_t j) { return lu_[i * size() + j]; }
  const Lanes& at(std::size_t i, std::size_t j) const { return lu_[i * size() + j]; }
  Lanes largest_below(std::size_t k) {
    Lanes largest = 0;
    for (std::size_t i = k + 1; i < size(); ++i) largest = max(largest, abs(at(i, k)));
    return largest;
  }
  static void exchange(const LaneMask& where, Lanes& a, Lanes& b) {
    const Lanes before = a;
    a = select(where, b, a);
    b = select(where, before, b);
  }
  /// The largest entry of column k goes to row k. Factors on the left stay where they are: solve()
  /// exchanges before it uses column k.
  void exchange_rows(std::size_t k) {
    for (std::size_t i = k + 1; i < size(); ++i) {
      const LaneMask where = abs(at(i, k)) > abs(at(k, k));
      exchanges_[k].push_back({where, i});
      for (std::size_t j = k; j < size(); ++j) exchange(where, at(k, j), at(i, j));
    }
  }

  static constexpr std::size_t entries = N == dynamic ? dynamic : N * N;
  std::size_t n_;
  detail::StateOf<Lanes, entries> lu_{};
  detail::StateOf<Lanes, N> inverse_pivot_{};
  detail::StateOf<std::vector<Exchange>, N> exchanges_{};
};

}  // namespace ODEUM_LANES
}  // namespace linear

/// (I - gamma_h J) x = r for the member in each lane, J by the problem's own Jacobian.
template <Ode P>
class LaneSystem {
 public:
  explicit LaneSystem(const P& problem) : problem_(problem), solver_(size_of(problem)) {
    if constexpr (P::dimension == dynamic) j_.resize(size_of(problem) * size_of(problem));
  }
  void linearise(const Lanes& t, const State<P>& y) { problem_.jacobian(t, y.data(), j_.data()); }
  bool factorise(const Lanes& gamma_h) {
    const std::size_t n = size_of(problem_);
    Lanes* const m = solver_.data();
    for (std::size_t i = 0; i < n * n; ++i) m[i] = -gamma_h * j_[i];
    for (std::size_t i = 0; i < n; ++i) m[i * n + i] += 1;
    solver_.factorise();
    return true;  // what is singular in a lane shows in the error of that lane
  }
  bool solve(Lanes* x) {
    solver_.solve(x);
    return true;
  }
  static constexpr bool negative_determinant() { return false; }

 private:
  static constexpr std::size_t N = P::dimension;
  const P& problem_;
  detail::StateOf<Lanes, N == dynamic ? dynamic : N * N> j_{};
  std::conditional_t<(N <= 3), linear::SmallInverse<(N <= 3 ? N : 1), Lanes>, linear::LaneLu<N>>
      solver_;
};

template <>
struct detail::SystemIn<Lanes> {
  template <Ode P>
  using type = LaneSystem<P>;
};

}  // namespace odeum
