// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <complex>
#include <vector>

#include "odeum/tableau/tableau.hpp"

namespace odeum {

/// The eigenvalues of the inverse of A, which decouple the stages of a fully implicit method
/// (Hairer, Wanner, Solving ODEs II, IV.8, (8.5)-(8.7)): with A^-1 = T diag(mu) T^-1 and
/// Z = (T x I) W the Newton equations fall into one real system where S is odd, and one complex
/// system for each pair of conjugate eigenvalues.
struct StageTransform {
  using Complex = std::complex<double>;
  /// One of each pair of conjugates; the real one, where there is one, comes first.
  std::vector<Complex> inverse_mu;       ///< 1 / mu
  std::vector<std::vector<Complex>> t;   ///< t[k][i]: column k of T, doubled for a pair
  std::vector<std::vector<Complex>> ti;  ///< ti[k][j]: row k of T^-1
  std::vector<double> weights;           ///< b^T A^-1: of the stages z_i in the new state
  /// With a real eigenvalue, the error estimate gamma0 h f(t, y) + sum_i e_i z_i, gamma0 = 1 / mu:
  /// the difference to a quadrature formula of order S that has the weight gamma0 at the left end.
  std::vector<double> estimate;
};

/// `a` is S x S, row-major. Computed in long double.
StageTransform make_stage_transform(const std::vector<double>& a, const std::vector<double>& b);

template <const auto& T>
const StageTransform& stage_transform() {
  static const StageTransform transform = [] {
    std::vector<double> a;
    for (const auto& row : T.a) a.insert(a.end(), row.begin(), row.end());
    return make_stage_transform(a, {T.b.begin(), T.b.end()});
  }();
  return transform;
}

}  // namespace odeum
