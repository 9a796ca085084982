// SPDX-License-Identifier: BSD-3-Clause
#include <utility>

#include "odeum/linear/sparse_system.hpp"
#include "odeum/problem/difference_jacobian.hpp"

namespace odeum {
namespace {

/// An entry with its place among the values.
struct Entry {
  int row, column, at;
};

std::vector<std::vector<Entry>> by_colour(const Sparsity& pattern) {
  const std::vector<int> colours = column_colours(pattern);
  int count = 0;
  for (const int colour : colours) count = std::max(count, colour + 1);
  std::vector<std::vector<Entry>> entries(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < pattern.unknowns(); ++i)
    for (int k = pattern.start[i]; k < pattern.start[i + 1]; ++k)
      entries[colours[pattern.column[k]]].push_back({static_cast<int>(i), pattern.column[k], k});
  return entries;
}

}  // namespace

std::vector<int> column_colours(const Sparsity& pattern) {
  std::vector<std::vector<int>> rows(pattern.unknowns());
  for (std::size_t i = 0; i < pattern.unknowns(); ++i)
    for (int k = pattern.start[i]; k < pattern.start[i + 1]; ++k)
      rows[pattern.column[k]].push_back(static_cast<int>(i));
  std::vector<int> colour(pattern.unknowns(), -1), taken_by(pattern.unknowns() + 1, -1);
  for (std::size_t j = 0; j < pattern.unknowns(); ++j) {
    for (const int row : rows[j])
      for (int k = pattern.start[row]; k < pattern.start[row + 1]; ++k)
        if (const int taken = colour[pattern.column[k]]; taken >= 0)
          taken_by[taken] = static_cast<int>(j);
    int free = 0;
    while (taken_by[free] == static_cast<int>(j)) ++free;
    colour[j] = free;
  }
  return colour;
}

JacobianEntries differenced_entries(const Sparsity& pattern,
                                    std::function<void(double t, const double* y, double* f)> rhs,
                                    const double* weights) {
  const std::size_t n = pattern.unknowns();
  return [n, weights, rhs = std::move(rhs), colours = by_colour(pattern),
          f = std::vector<double>(n), moved = std::vector<double>(n),
          f_moved = std::vector<double>(n)](double t, const double* y, double* values) mutable {
    rhs(t, y, f.data());
    const DifferenceIncrements increment(n, y, f.data(), weights);
    std::copy(y, y + n, moved.begin());
    for (const std::vector<Entry>& entries : colours) {
      for (const Entry& e : entries) moved[e.column] = y[e.column] + increment(e.column);
      rhs(t, moved.data(), f_moved.data());
      for (const Entry& e : entries)
        values[e.at] = (f_moved[e.row] - f[e.row]) / (moved[e.column] - y[e.column]);
      for (const Entry& e : entries) moved[e.column] = y[e.column];
    }
  };
}

}  // namespace odeum
