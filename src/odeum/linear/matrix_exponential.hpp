// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "odeum/linear/dense_lu.hpp"

namespace odeum::linear {

/// e^A for a small dense row-major n x n matrix, by scaling to |A| <= 5.37, the Pade approximant of
/// degree 13 and squaring (Higham, SIAM J. Matrix Anal. Appl. 26 (2005) 1179-1193, algorithm 2.3).
/// Empty where an entry is not finite or overflows.
inline std::vector<double> matrix_exponential(std::vector<double> a, std::size_t n) {
  using Matrix = std::vector<double>;
  const auto times = [n](const Matrix& x, const Matrix& y) {
    Matrix z(n * n);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t k = 0; k < n; ++k)
        for (std::size_t j = 0; j < n; ++j) z[i * n + j] += x[i * n + k] * y[k * n + j];
    return z;
  };
  double norm = 0;  // the largest column sum
  for (std::size_t j = 0; j < n; ++j) {
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) sum += std::abs(a[i * n + j]);
    if (!std::isfinite(sum)) return {};
    norm = std::max(norm, sum);
  }
  constexpr double theta = 5.371920351148152;
  const int squarings = norm > theta ? static_cast<int>(std::ceil(std::log2(norm / theta))) : 0;
  for (double& x : a) x = std::ldexp(x, -squarings);

  // Odd powers make U, even ones V: e^A = (V - U)^-1 (V + U).
  constexpr std::array<double, 14> b{64764752532480000,
                                     32382376266240000,
                                     7771770303897600,
                                     1187353796428800,
                                     129060195264000,
                                     10559470521600,
                                     670442572800,
                                     33522128640,
                                     1323241920,
                                     40840800,
                                     960960,
                                     16380,
                                     182,
                                     1};
  const Matrix a2 = times(a, a), a4 = times(a2, a2), a6 = times(a2, a4);
  const auto even = [&](std::size_t first) {  // sum over k of b[first + 2 k] a2^k
    Matrix high(n * n), low(n * n);
    for (std::size_t i = 0; i < n * n; ++i) {
      high[i] = b[first + 12] * a6[i] + b[first + 10] * a4[i] + b[first + 8] * a2[i];
      low[i] = b[first + 6] * a6[i] + b[first + 4] * a4[i] + b[first + 2] * a2[i];
    }
    Matrix sum = times(a6, high);
    for (std::size_t i = 0; i < n * n; ++i) sum[i] += low[i] + (i % (n + 1) == 0 ? b[first] : 0);
    return sum;
  };
  const Matrix v = even(0), u = times(a, even(1));
  DenseLu lu(n);
  for (std::size_t i = 0; i < n * n; ++i) lu.data()[i] = v[i] - u[i];
  if (!lu.factorise()) return {};
  Matrix e(n * n), column(n);
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = 0; i < n; ++i) column[i] = v[i * n + j] + u[i * n + j];
    lu.solve(column.data());
    for (std::size_t i = 0; i < n; ++i) e[i * n + j] = column[i];
  }
  for (int k = 0; k < squarings; ++k) e = times(e, e);
  for (const double x : e)
    if (!std::isfinite(x)) return {};
  return e;
}

}  // namespace odeum::linear
