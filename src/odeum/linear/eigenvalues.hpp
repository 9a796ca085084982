// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <complex>
#include <cstddef>
#include <vector>

namespace odeum {

/// The eigenvalues of a real n x n matrix, dense, by rows or by columns. Throws std::runtime_error
/// where the QR iteration does not converge.
std::vector<std::complex<double>> eigenvalues(const std::vector<double>& matrix, std::size_t n);

/// An eigenvalue with the absolute values of its eigenvector's components.
struct Eigenpair {
  std::complex<double> value;
  std::vector<double> sizes;
};
/// The same of a matrix by rows, with eigenvectors of length 1.
std::vector<Eigenpair> eigenpairs(const std::vector<double>& matrix, std::size_t n);

}  // namespace odeum
