// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/formula/consistent_start.hpp"

#include <algorithm>
#include <cmath>

#include "odeum/formula/evaluator.hpp"
#include "odeum/linear/dense_lu.hpp"

namespace odeum::formula {

using Real = long double;

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
    const std::size_t n = unknown.size();
    std::vector<Real> change = at.values;
    linear::Lu<Real> slopes(n);
    if (roots.size() == n) {
      for (std::size_t k = 0; k < n; ++k) std::ranges::copy(at.slopes[k], slopes.data() + k * n);
    } else {
      std::fill(slopes.data(), slopes.data() + n * n, 0);
      change.assign(n, 0);
      for (std::size_t row = 0; row < roots.size(); ++row)
        for (std::size_t i = 0; i < n; ++i) {
          change[i] += at.slopes[row][i] * at.values[row];
          for (std::size_t j = 0; j < n; ++j)
            slopes.data()[i * n + j] += at.slopes[row][i] * at.slopes[row][j];
        }
    }
    if (!slopes.factorise()) return false;
    slopes.solve(change.data());
    Real largest = 0;
    for (std::size_t k = 0; k < unknown.size(); ++k) {
      Real& value = y[unknown[k]];
      value -= change[k];
      if (!std::isfinite(value)) return false;
      largest = std::max(largest, std::abs(change[k]) / std::max(std::abs(value), 1e-300L));
    }
    if (largest < 1e-17L) return true;
    // A component that cancels out of large terms keeps changing; its equations are met to
    // rounding.
    bool met = iteration > 0;
    for (std::size_t i = 0; i < roots.size(); ++i)
      met = met && std::abs(at.values[i]) <= 1e-18L * at.sizes[i];
    if (met) return true;
    // At rounding the changes no longer fall.
    if (iteration > 30 && largest < 1e-14L) return true;
  }
  return false;
}

}  // namespace odeum::formula
