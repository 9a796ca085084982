// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/kernel/stage_transform.hpp"

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <algorithm>

namespace odeum {
namespace {

using Real = long double;
using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

std::vector<double> as_doubles(const Vector& x) {
  std::vector<double> rounded;
  for (const Real entry : x) rounded.push_back(static_cast<double>(entry));
  return rounded;
}

/// e^T = (b_hat - b)^T A^-1, where sum_i b_hat_i c_i^(k-1) = 1/k - (gamma0 for k = 1), k = 1..S.
Vector error_weights(const Matrix& a, const Vector& b, Real gamma0) {
  const Vector c = a.rowwise().sum();
  Matrix vandermonde = Matrix::Ones(a.rows(), a.cols());
  Vector right(a.rows());
  for (Eigen::Index k = 0; k < a.rows(); ++k) {
    if (k > 0) vandermonde.row(k) = vandermonde.row(k - 1).cwiseProduct(c.transpose());
    right[k] = 1 / static_cast<Real>(k + 1) - (k == 0 ? gamma0 : 0);
  }
  return a.transpose().partialPivLu().solve(vandermonde.partialPivLu().solve(right) - b);
}

}  // namespace

StageTransform make_stage_transform(const std::vector<double>& a, const std::vector<double>& b) {
  const auto s = static_cast<Eigen::Index>(b.size());
  const Matrix matrix = Eigen::Map<const Eigen::MatrixXd>(a.data(), s, s).transpose().cast<Real>();
  const Vector row = Eigen::Map<const Eigen::VectorXd>(b.data(), s).cast<Real>();
  const Eigen::EigenSolver<Matrix> eigen(matrix.inverse());
  const auto mu = eigen.eigenvalues();
  auto t = eigen.eigenvectors();
  for (Eigen::Index k = 0; k < s; ++k) t.col(k) /= std::complex<Real>(t(s - 1, k));
  const auto ti = t.inverse().eval();
  // One of each pair of conjugates; the real one first.
  std::vector<Eigen::Index> chosen;
  for (Eigen::Index k = 0; k < s; ++k)
    if (mu[k].imag() >= 0) chosen.push_back(k);
  std::sort(chosen.begin(), chosen.end(),
            [&](Eigen::Index x, Eigen::Index y) { return mu[x].imag() < mu[y].imag(); });

  StageTransform transform;
  transform.weights = as_doubles(matrix.transpose().partialPivLu().solve(row));
  for (const Eigen::Index k : chosen) {
    transform.inverse_mu.emplace_back(Real(1) / mu[k]);
    auto& column = transform.t.emplace_back();
    auto& inverse_row = transform.ti.emplace_back();
    for (Eigen::Index i = 0; i < s; ++i) {
      column.emplace_back(t(i, k) * Real(mu[k].imag() == 0 ? 1 : 2));
      inverse_row.emplace_back(ti(k, i));
    }
  }
  if (s % 2 == 1)
    transform.estimate = as_doubles(error_weights(matrix, row, 1 / mu[chosen.front()].real()));
  return transform;
}

}  // namespace odeum
