// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Plain C++17, see ode_view.hpp.
#include <algorithm>
#include <cstddef>
#include <vector>

namespace odeum {

/// Which entries of a Jacobian may differ from zero, by rows: those of row i stand in the columns
/// column[start[i]] to column[start[i + 1] - 1], rising. Values of the entries come in that order.
struct Sparsity {
  std::vector<int> start{0}, column;

  std::size_t unknowns() const { return start.size() - 1; }
  std::size_t entries() const { return column.size(); }
  /// Adds the next row; its columns in any order, each once.
  void add_row(std::vector<int> columns) {
    std::ranges::sort(columns);
    column.insert(column.end(), columns.begin(), columns.end());
    start.push_back(static_cast<int>(column.size()));
  }
};

/// All entries at most `lower` below and `upper` above the diagonal.
inline Sparsity banded_sparsity(std::size_t unknowns, std::size_t lower, std::size_t upper) {
  Sparsity s;
  for (std::size_t i = 0; i < unknowns; ++i) {
    const std::size_t last = std::min(i + upper + 1, unknowns);
    for (std::size_t j = i > lower ? i - lower : 0; j < last; ++j)
      s.column.push_back(static_cast<int>(j));
    s.start.push_back(static_cast<int>(s.column.size()));
  }
  return s;
}

/// product = J x.
inline void multiply(const Sparsity& s, const double* values, const double* x, double* product) {
  for (std::size_t i = 0; i < s.unknowns(); ++i) {
    double sum = 0;
    for (int k = s.start[i]; k < s.start[i + 1]; ++k) sum += values[k] * x[s.column[k]];
    product[i] = sum;
  }
}

/// J as a dense row-major matrix.
template <class Real>
void fill_dense(const Sparsity& s, const Real* values, Real* j) {
  const std::size_t n = s.unknowns();
  std::fill(j, j + n * n, Real(0));
  for (std::size_t i = 0; i < n; ++i)
    for (int k = s.start[i]; k < s.start[i + 1]; ++k)
      j[i * n + static_cast<std::size_t>(s.column[k])] = values[k];
}

}  // namespace odeum
