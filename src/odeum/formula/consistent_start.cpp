// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/formula/consistent_start.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "odeum/formula/evaluator.hpp"

namespace odeum::formula {
namespace {

using Real = long double;

/// x of a x = b by elimination; false where a is singular.
bool solve(std::vector<std::vector<Real>> a, std::vector<Real>& b) {
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k; i < n; ++i)
      if (std::abs(a[i][k]) > std::abs(a[pivot][k])) pivot = i;
    if (!(std::abs(a[pivot][k]) > 0)) return false;
    std::swap(a[k], a[pivot]);
    std::swap(b[k], b[pivot]);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const Real factor = a[i][k] / a[k][k];
      for (std::size_t j = k; j < n; ++j) a[i][j] -= factor * a[k][j];
      b[i] -= factor * b[k];
    }
  }
  for (std::size_t k = 0; k < n; ++k) b[k] /= a[k][k];
  return true;
}

}  // namespace

Linearised linearise(Graph& graph, const std::vector<Id>& roots, Real t, const std::vector<Real>& y,
                     const std::vector<std::size_t>& by) {
  const auto n = static_cast<std::uint32_t>(y.size());
  const auto entries = gradients(graph, roots, n);
  std::vector<Id> all = roots;
  for (const auto& row : entries)
    for (const Entry& entry : row) all.push_back(entry.value);
  std::vector<Real> values(all.size());
  Evaluator<Real>(graph, all)(t, y.data(), values.data());
  Linearised found;
  std::size_t at = roots.size();
  for (std::size_t i = 0; i < roots.size(); ++i) {
    found.values.push_back(values[i]);
    found.sizes.push_back(0);
    std::vector<Real> slopes(by.size(), 0);
    for (const Entry& entry : entries[i]) {
      const Real slope = values[at++];
      if (entry.by == n) continue;
      found.sizes.back() += std::abs(slope * y[entry.by]);
      for (std::size_t k = 0; k < by.size(); ++k)
        if (by[k] == entry.by) slopes[k] = slope;
    }
    found.slopes.push_back(std::move(slopes));
  }
  return found;
}

bool find_roots(Graph& graph, const std::vector<Id>& roots, Real t, std::vector<Real>& y,
                const std::vector<std::size_t>& unknown) {
  for (int iteration = 0; iteration < 100; ++iteration) {
    const Linearised at = linearise(graph, roots, t, y, unknown);
    std::vector<Real> change = at.values;
    if (!solve(at.slopes, change)) return false;
    Real largest = 0;
    for (std::size_t k = 0; k < unknown.size(); ++k) {
      Real& value = y[unknown[k]];
      value -= change[k];
      if (!std::isfinite(value)) return false;
      largest = std::max(largest, std::abs(change[k]) / std::max(std::abs(value), 1e-300L));
    }
    if (largest < 1e-17L) return true;
    // At rounding the changes no longer fall.
    if (iteration > 30 && largest < 1e-14L) return true;
  }
  return false;
}

}  // namespace odeum::formula
