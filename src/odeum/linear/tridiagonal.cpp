// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/linear/tridiagonal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace odeum::linear {
namespace {

/// How many eigenvalues lie below x.
std::size_t below(const std::vector<double>& diagonal, const std::vector<double>& off, double x) {
  std::size_t count = 0;
  double q = 1;
  for (std::size_t i = 0; i < diagonal.size(); ++i) {
    q = diagonal[i] - x - (i > 0 ? off[i - 1] * off[i - 1] / q : 0);
    if (q == 0) q = std::numeric_limits<double>::min();
    count += q < 0;
  }
  return count;
}

}  // namespace

std::pair<double, double> extreme_eigenvalues(const std::vector<double>& diagonal,
                                              const std::vector<double>& off) {
  // All lie within Gershgorin's discs.
  double low = diagonal[0], high = diagonal[0];
  for (std::size_t i = 0; i < diagonal.size(); ++i) {
    const double radius =
        (i > 0 ? std::abs(off[i - 1]) : 0) + (i < off.size() ? std::abs(off[i]) : 0);
    low = std::min(low, diagonal[i] - radius), high = std::max(high, diagonal[i] + radius);
  }
  const auto bisect = [&](std::size_t at_most_below) {
    double a = low, b = high;
    for (int halving = 0; halving < 100; ++halving) {
      const double middle = a + (b - a) / 2;
      (below(diagonal, off, middle) <= at_most_below ? a : b) = middle;
    }
    return a + (b - a) / 2;
  };
  return {bisect(0), bisect(diagonal.size() - 1)};
}

}  // namespace odeum::linear
