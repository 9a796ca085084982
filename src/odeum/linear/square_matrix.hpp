// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>

#include "odeum/problem/concepts.hpp"

/// Rows and square matrices (row-major) of N entries a side: in the object itself where N is known
/// at compile time, on the heap where it is `dynamic`.
namespace odeum::linear {

template <std::size_t N, class T = double>
using RowOf = odeum::detail::StateOf<T, N>;
template <std::size_t N>
inline constexpr std::size_t entries_of_square = N == dynamic ? dynamic : N* N;
template <std::size_t N>
using Square = RowOf<entries_of_square<N>>;

/// Filled with zeros.
template <std::size_t N, class T = double>
RowOf<N, T> make_row([[maybe_unused]] std::size_t n) {
  RowOf<N, T> row{};
  if constexpr (N == dynamic) row.resize(n);
  return row;
}
template <std::size_t N>
Square<N> make_square(std::size_t n) {
  return make_row<entries_of_square<N>>(n * n);
}

}  // namespace odeum::linear
