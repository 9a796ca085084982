// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "odeum/linear/sparse_matrix.hpp"

/// Solvers of other libraries for a symmetric positive definite sparse system.
namespace odeum::linear {

/// One of them, set up for a matrix.
class LinearPeer {
 public:
  virtual ~LinearPeer() = default;
  /// Solves from a guess of 0 to |b - A x| <= tolerance |b|, or, where that is 0 or not reached,
  /// with most_iterations. How many iterations were done; 0 of a direct solver. Throws
  /// std::runtime_error with the library's reason where it fails.
  virtual std::size_t solve(const std::vector<double>& b, std::vector<double>& x, double tolerance,
                            std::size_t most_iterations) = 0;
};

struct LinearPeerInfo {
  std::string id;  ///< library/method
  bool direct = false;
  /// Throws std::invalid_argument where the library refuses the matrix, which must outlive the
  /// result.
  std::function<std::unique_ptr<LinearPeer>(const SparseMatrix&)> set_up;
};

/// Eigen's, and those of the libraries in this build.
const std::vector<LinearPeerInfo>& linear_peers();

}  // namespace odeum::linear
