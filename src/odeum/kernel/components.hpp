// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

/// Loops over the components of states. A right-hand side of few unknowns stores its components one
/// by one; a vector load of what was just stored that way cannot be forwarded from the stores and
/// waits until they have reached the cache, which costs as much as a stage. States of few
/// components are therefore read one by one, too, and compilers keep them in registers where they
/// can. From some sixteen on vectors are faster.
namespace odeum {

inline constexpr std::size_t few_components = 12;
/// Up to so many the loop is unrolled; more would not fit into the registers.
inline constexpr std::size_t unrolled_components = 4;

/// The choice among numbers that core/lanes.hpp has for members in lanes.
template <class Real>
constexpr Real select(bool which, Real a, Real b) {
  return which ? a : b;
}

template <class S>
inline constexpr std::size_t static_size = 0;
template <class Real, std::size_t N>
inline constexpr std::size_t static_size<std::array<Real, N>> = N;

/// f(0), ..., f(size - 1), independent calls; `known`: the size where the type says it, else 0.
template <std::size_t known, class F>
[[gnu::always_inline]] inline void each_of(std::size_t size, F&& f) {
  if constexpr (known > 0 && known <= unrolled_components) {
    [&]<std::size_t... I>(std::index_sequence<I...>) __attribute__((always_inline)) { (f(I), ...); }
    (std::make_index_sequence<known>{});
  } else {
    if (size <= few_components)
      for (std::size_t n = 0; n < size; ++n) {
        f(n);
        asm volatile("");  // A loop with such a statement is not vectorised.
      }
    else
      for (std::size_t n = 0; n < size; ++n) f(n);
  }
}

/// The same for each component of a state of that size.
template <class S, class F>
[[gnu::always_inline]] inline void each_component(const S& like, F&& f) {
  each_of<static_size<S>>(like.size(), f);
}

/// The sum of f(0), f(1), ...; in pairs where the components are few and their number is known,
/// since each sum waits for the one before it.
template <class S, class F>
[[gnu::always_inline]] inline auto sum_of_components(const S& like, F&& f) {
  using Real = decltype(f(std::size_t{}));
  constexpr std::size_t known = static_size<S>;
  if constexpr (known > 2 && known <= few_components) {
    Real even = 0, odd = 0;
    each_component(like, [&](std::size_t n) { (n % 2 == 0 ? even : odd) += f(n); });
    return even + odd;
  } else {
    Real sum = 0;
    each_component(like, [&](std::size_t n) { sum += f(n); });
    return sum;
  }
}

/// sum_i weight_i x_i[n] over the states x_i whose entry of `row` is not zero, the last added last.
template <const auto& row, class Weights, class States>
[[gnu::always_inline]] inline auto weighted(const Weights& weights, const States& states,
                                            std::size_t n) {
  typename Weights::value_type sum = 0;
  [&]<std::size_t... I>(std::index_sequence<I...>) __attribute__((always_inline)) {
    ((row[I] != 0 ? void(sum += weights[I] * states[I][n]) : void()), ...);
  }
  (std::make_index_sequence<std::tuple_size_v<std::remove_cvref_t<decltype(row)>>>{});
  return sum;
}

template <class S>
void copy_components(const S& from, S& to) {
  each_component(from, [&](std::size_t n) { to[n] = from[n]; });
}

/// Exchanges two states, without moving components where they are on the heap.
template <class S>
void exchange_components(S& a, S& b) {
  if constexpr (static_size<S> == 0)
    std::swap(a, b);
  else
    each_component(a, [&](std::size_t n) { std::swap(a[n], b[n]); });
}

}  // namespace odeum
