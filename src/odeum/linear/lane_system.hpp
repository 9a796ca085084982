// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "odeum/core/lanes.hpp"
#include "odeum/linear/shifted_solver.hpp"
#include "odeum/linear/small_inverse.hpp"
#include "odeum/problem/concepts.hpp"

namespace odeum {
namespace linear {
inline namespace ODEUM_LANES {

/// LU factorisation of a row-major N x N matrix (N known, or `dynamic`) for the member in each
/// lane. A row is the pivot where it stands; a lane in which that would make a factor large
/// exchanges it for the row of the largest. Same interface as DenseLu.
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
    if (any_exchange_)
      for (auto& each : exchanges_) each.clear();
    any_exchange_ = false;
    each_row([&](std::size_t k) {
      // A lane does what it would do beside any others.
      const LaneMask sound = largest_below(k) < largest_factor * abs(at(k, k));
      if (!all(sound)) exchange_rows(k, !sound);
      const Lanes inverse = inverse_pivot_[k] = 1 / at(k, k);
      for (std::size_t i = k + 1; i < size(); ++i) {
        const Lanes factor = at(i, k) *= inverse;
        each_row([&](std::size_t j) __attribute__((always_inline)) {
          if (j > k) at(i, j) -= factor * at(k, j);
        });
      }
    });
  }

  void solve(Lanes* x) const {
    each_row([&](std::size_t k) __attribute__((always_inline)) {
      if (any_exchange_)
        for (const Exchange& e : exchanges_[k]) exchange(e.where, x[k], x[e.row]);
      each_row([&](std::size_t i) __attribute__((always_inline)) {
        if (i > k) x[i] -= at(i, k) * x[k];
      });
    });
    each_row([&](std::size_t from_last) __attribute__((always_inline)) {
      const std::size_t k = size() - 1 - from_last;
      x[k] *= inverse_pivot_[k];
      each_row([&](std::size_t i) __attribute__((always_inline)) {
        if (i < k) x[i] -= at(i, k) * x[k];
      });
    });
  }

 private:
  static constexpr double largest_factor = 100;  // two digits lost per column at most
  struct Exchange {
    LaneMask where;
    std::size_t row;
  };

  std::size_t size() const { return N == dynamic ? n_ : N; }
  /// f(0), ..., f(n - 1), without a loop where n is known.
  template <class F>
  [[gnu::always_inline]] void each_row(F&& f) const {
    if constexpr (N == dynamic)
      for (std::size_t i = 0; i < n_; ++i) f(i);
    else
      [&]<std::size_t... I>(std::index_sequence<I...>) __attribute__((always_inline)) {
        (f(I), ...);
      }
    (std::make_index_sequence<N>{});
  }
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
  void exchange_rows(std::size_t k, const LaneMask& needed) {
    any_exchange_ = true;
    for (std::size_t i = k + 1; i < size(); ++i) {
      const LaneMask where = needed & (abs(at(i, k)) > abs(at(k, k)));
      exchanges_[k].push_back({where, i});
      for (std::size_t j = k; j < size(); ++j) exchange(where, at(k, j), at(i, j));
    }
  }

  static constexpr std::size_t entries = N == dynamic ? dynamic : N * N;
  std::size_t n_;
  bool any_exchange_ = false;
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
