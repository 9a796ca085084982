// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "odeum/problem/difference_jacobian.hpp"
#include "odeum/problem/sparsity.hpp"

/// Derivatives of a text at a point where an operation has none, or an infinite one: the root of 0,
/// 0 to a power below 1, a length of 0.
namespace odeum::formula {

/// Whether each of `count` numbers is finite.
template <class Real>
bool all_finite(const Real* values, std::size_t count) {
  Real sum = 0;
  for (std::size_t k = 0; k < count; ++k) sum += 0 * values[k];
  return sum == 0;
}

/// Replaces what is not finite in a Jacobian at (t, y). An entry that is 0/0 gets its limit from
/// the side to which y moves, from the other one where f ends on that side: the entry a little
/// away. One that is infinite, or has no such limit, gets the difference quotient to that side,
/// with the increment of every other Jacobian by differences. `rhs` fills f, `entries` the values
/// in the order of `pattern`. Where f is not finite, nothing is done.
template <class Real>
class FiniteEntries {
 public:
  using Function = void (*)(const void* problem, Real t, const Real* y, Real* out);
  FiniteEntries(const Sparsity& pattern, const void* problem, Function rhs, Function entries)
      : pattern_(pattern), problem_(problem), rhs_(rhs), entries_(entries) {}

  void mend(Real t, const Real* y, Real* values) {
    const std::size_t n = pattern_.unknowns();
    f_.resize(n);
    rhs_(problem_, t, y, f_.data());
    if (!all_finite(f_.data(), n)) return;
    f_moved_ = moved_ = f_;
    limits_.resize(pattern_.entries());
    find_columns(values);
    const std::vector<double> at(y, y + n), slope(f_.begin(), f_.end());
    const DifferenceIncrements increment(n, at.data(), slope.data());
    by_.resize(n);
    for (std::size_t j = 0; j < n; ++j)
      by_[j] = static_cast<Real>(f_[j] < 0 ? -increment(j) : increment(j));
    for (int side = 0; side < 2; ++side) {
      std::vector<std::size_t> left = columns_, group;
      while (take_group(left, group)) mend_columns(t, y, group, values);
      for (Real& by : by_) by = -by;
      // What had an end of f on the first side.
      std::erase_if(columns_, [&](std::size_t j) {
        return std::ranges::all_of(places_[j], [&](const Place& p) { return !is_bad(p, values); });
      });
    }
  }

 private:
  struct Place {
    std::size_t row, entry;
  };

  static bool is_bad(const Place& place, const Real* values) {
    return !std::isfinite(values[place.entry]);
  }
  /// The columns with entries that are not finite, and the places of all entries of each column.
  void find_columns(const Real* values) {
    places_.assign(pattern_.unknowns(), {});
    columns_.clear();
    for (std::size_t row = 0; row < pattern_.unknowns(); ++row)
      for (int k = pattern_.start[row]; k < pattern_.start[row + 1]; ++k)
        places_[pattern_.column[k]].push_back({row, static_cast<std::size_t>(k)});
    for (std::size_t j = 0; j < places_.size(); ++j)
      if (std::ranges::any_of(places_[j], [&](const Place& p) { return is_bad(p, values); }))
        columns_.push_back(j);
  }
  /// Takes columns that share no row from `left`: they are moved together. False: none is left.
  bool take_group(std::vector<std::size_t>& left, std::vector<std::size_t>& group) const {
    std::vector<bool> used(pattern_.unknowns(), false);
    group.clear();
    std::erase_if(left, [&](std::size_t j) {
      for (const Place& place : places_[j])
        if (used[place.row]) return false;
      for (const Place& place : places_[j]) used[place.row] = true;
      group.push_back(j);
      return true;
    });
    return !group.empty();
  }
  void mend_columns(Real t, const Real* y, const std::vector<std::size_t>& group, Real* values) {
    constexpr Real little = 0x1p-12;  // of the increment of a difference: nothing cancels
    std::copy(y, y + moved_.size(), moved_.begin());
    for (const std::size_t j : group) moved_[j] = y[j] + little * by_[j];
    entries_(problem_, t, moved_.data(), limits_.data());
    for (const std::size_t j : group) moved_[j] = y[j] + by_[j];
    rhs_(problem_, t, moved_.data(), f_moved_.data());
    for (const std::size_t j : group)
      for (const Place& place : places_[j]) {
        Real& value = values[place.entry];
        const Real limit = limits_[place.entry];
        if (!is_bad(place, values) || !std::isfinite(f_moved_[place.row])) continue;
        value = std::isnan(value) && std::isfinite(limit)
                    ? limit
                    : (f_moved_[place.row] - f_[place.row]) / (moved_[j] - y[j]);
      }
  }

  const Sparsity& pattern_;
  const void* problem_;
  Function rhs_, entries_;
  std::vector<Real> f_, f_moved_, moved_, limits_, by_;
  std::vector<std::size_t> columns_;
  std::vector<std::vector<Place>> places_;  ///< by column
};

/// The same of df/dt, by differences over a time after t; `rhs(t, f)` is that of the state.
template <class Rhs>
void mend_time_derivative(Rhs rhs, double t, double span, std::size_t n, double* dfdt) {
  std::vector<double> f(n), later(n);
  const double root_epsilon = std::sqrt(std::numeric_limits<double>::epsilon());
  const double after = t + root_epsilon * std::max(std::abs(t), 1e-3 * std::abs(span));
  rhs(t, f.data());
  rhs(after, later.data());
  for (std::size_t i = 0; i < n; ++i)
    if (!std::isfinite(dfdt[i])) dfdt[i] = (later[i] - f[i]) / (after - t);
}

}  // namespace odeum::formula
