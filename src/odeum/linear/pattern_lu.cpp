// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/linear/pattern_lu.hpp"

#include <algorithm>
#include <bitset>
#include <limits>
#include <stdexcept>

namespace odeum::linear {
namespace {

/// The entries by rows and by columns, the diagonal among them, and those that elimination adds.
template <std::size_t N>
struct Filled {
  using Unknowns = std::bitset<N>;
  std::vector<Unknowns> rows, columns;

  explicit Filled(const Sparsity& pattern) : rows(pattern.unknowns()), columns(pattern.unknowns()) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i].set(i), columns[i].set(i);
      for (int k = pattern.start[i]; k < pattern.start[i + 1]; ++k) {
        const auto j = static_cast<std::size_t>(pattern.column[k]);
        rows[i].set(j), columns[j].set(i);
      }
    }
  }

  /// Eliminates the unknown with the fewest products among those left, and adds its fill.
  std::size_t eliminate_next(Unknowns& left) {
    const std::size_t n = rows.size();
    std::size_t least = std::numeric_limits<std::size_t>::max(), pivot = 0;
    for (std::size_t k = 0; k < n; ++k) {
      if (!left[k]) continue;
      const std::size_t products =
          ((rows[k] & left).count() - 1) * ((columns[k] & left).count() - 1);
      if (products < least) least = products, pivot = k;
    }
    left.reset(pivot);
    const Unknowns row = rows[pivot] & left, column = columns[pivot] & left;
    for (std::size_t i = 0; i < n; ++i) {
      if (column[i]) rows[i] |= row;
      if (row[i]) columns[i] |= column;
    }
    return pivot;
  }
};

/// Fills all but the lists that follow from these; returns the place of each entry, both by number.
template <std::size_t N>
std::vector<int> order_and_fill(const Sparsity& pattern, Elimination& e) {
  auto& [order, start, diagonal, column, places, targets, without_gaps, multiplications] = e;
  const std::size_t n = pattern.unknowns();
  Filled<N> filled(pattern);
  std::bitset<N> left;
  for (std::size_t i = 0; i < n; ++i) left.set(i);
  for (std::size_t k = 0; k < n; ++k)
    order.push_back(static_cast<int>(filled.eliminate_next(left)));
  std::vector<int> at(n * n, -1);
  for (std::size_t i = 0; i < n; ++i) {
    start.push_back(static_cast<int>(column.size()));
    const std::bitset<N>& row = filled.rows[static_cast<std::size_t>(order[i])];
    for (std::size_t j = 0; j < n; ++j) {
      if (!row[static_cast<std::size_t>(order[j])]) continue;
      at[i * n + j] = static_cast<int>(column.size());
      if (i == j) diagonal.push_back(at[i * n + j]);
      column.push_back(static_cast<int>(j));
    }
  }
  start.push_back(static_cast<int>(column.size()));
  return at;
}

}  // namespace

Elimination::Elimination(const Sparsity& pattern, double most_multiplications) {
  const std::size_t n = pattern.unknowns();
  if (n > largest) throw std::length_error("a list of eliminations: too many unknowns");
  const std::vector<int> at = n <= 128    ? order_and_fill<128>(pattern, *this)
                              : n <= 1024 ? order_and_fill<1024>(pattern, *this)
                              : n <= 2048 ? order_and_fill<2048>(pattern, *this)
                                          : order_and_fill<largest>(pattern, *this);
  std::vector<std::size_t> number(n);
  for (std::size_t k = 0; k < n; ++k) number[static_cast<std::size_t>(order[k])] = k;
  for (std::size_t i = 0; i < n; ++i)
    for (int k = pattern.start[i]; k < pattern.start[i + 1]; ++k)
      places.push_back(at[number[i] * n + number[static_cast<std::size_t>(pattern.column[k])]]);
  for (std::size_t i = 0; i < n; ++i)
    for (int p = start[i]; p < diagonal[i]; ++p) {
      const auto k = static_cast<std::size_t>(column[p]);
      multiplications += start[k + 1] - diagonal[k];
    }
  if (multiplications > most_multiplications)
    throw std::length_error("a list of eliminations: too many multiplications");
  for (std::size_t i = 0; i < n; ++i) {
    const int first = diagonal[i] + 1, last = start[i + 1] - 1;
    without_gaps.push_back(first > last || column[last] - column[first] == last - first);
  }
  if (n > few_unknowns) return;
  for (std::size_t i = 0; i < n; ++i)
    for (int p = start[i]; p < diagonal[i]; ++p) {
      const auto k = static_cast<std::size_t>(column[p]);
      for (int q = diagonal[k] + 1; q < start[k + 1]; ++q)
        targets.push_back(at[i * n + static_cast<std::size_t>(column[q])]);
    }
}

std::shared_ptr<const Elimination> elimination_of(const Sparsity& pattern) {
  struct Last {
    Sparsity pattern;
    std::shared_ptr<const Elimination> elimination;
  };
  thread_local Last last;
  if (!last.elimination || last.pattern.start != pattern.start ||
      last.pattern.column != pattern.column)
    last = {pattern, std::make_shared<const Elimination>(pattern)};
  return last.elimination;
}

}  // namespace odeum::linear
