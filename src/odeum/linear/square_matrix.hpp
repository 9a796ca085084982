// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "odeum/problem/concepts.hpp"

/// Rows and square matrices (row-major) of N entries a side: in the object itself where N is known
/// at compile time, on the heap where it is `dynamic`.
namespace odeum::linear {

namespace detail {
template <std::size_t N, class T>
struct Storage {
  using Row = std::array<T, N>;
  using Square = std::array<T, N * N>;
};
template <class T>
struct Storage<dynamic, T> {
  using Row = std::vector<T>;
  using Square = std::vector<T>;
};
}  // namespace detail

template <std::size_t N>
using RowOf = typename detail::Storage<N, double>::Row;
template <std::size_t N>
using IndexRow = typename detail::Storage<N, std::size_t>::Row;
template <std::size_t N>
using Square = typename detail::Storage<N, double>::Square;

template <std::size_t N>
RowOf<N> make_row(std::size_t n) {
  RowOf<N> row{};
  if constexpr (N == dynamic) row.assign(n, 0.0);
  return row;
}
template <std::size_t N>
IndexRow<N> make_index_row(std::size_t n) {
  IndexRow<N> row{};
  if constexpr (N == dynamic) row.assign(n, 0);
  return row;
}
template <std::size_t N>
Square<N> make_square(std::size_t n) {
  Square<N> matrix{};
  if constexpr (N == dynamic) matrix.assign(n * n, 0.0);
  return matrix;
}

}  // namespace odeum::linear
