// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/linear/eigen_solvers.hpp"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>
#include <stdexcept>

#include "odeum/linear/sparse_eigen.hpp"

namespace odeum::linear {
namespace {

Eigen::Map<const Eigen::VectorXd> as_vector(const double* data, Eigen::Index n) {
  return {data, n};
}

}  // namespace

struct SparseLdlt::Factors {
  Eigen::SimplicialLDLT<EigenColumns> ldlt;
};

SparseLdlt::SparseLdlt(const SparseMatrix& a) : factors_(std::make_unique<Factors>()) {
  const EigenColumns columns = eigen_map(a);
  factors_->ldlt.compute(columns);
  // A pivot that is rounding of a singular matrix is tiny, and has either sign.
  const double tiny = 1e-14 * columns.diagonal().cwiseAbs().maxCoeff();
  if (factors_->ldlt.info() != Eigen::Success || !(factors_->ldlt.vectorD().minCoeff() > tiny))
    throw std::invalid_argument("the matrix is singular or not positive definite");
}
SparseLdlt::~SparseLdlt() = default;
SparseLdlt::SparseLdlt(SparseLdlt&&) noexcept = default;

void SparseLdlt::solve(const double* b, double* x) const {
  const Eigen::Index n = factors_->ldlt.rows();
  Eigen::Map<Eigen::VectorXd>(x, n) = factors_->ldlt.solve(as_vector(b, n));
}

double SparseLdlt::multiplications_to_factorise() const {
  const auto& lower = factors_->ldlt.matrixL().nestedExpression();
  double sum = 0;
  for (Eigen::Index j = 0; j < lower.cols(); ++j) {
    const double below = lower.outerIndexPtr()[j + 1] - lower.outerIndexPtr()[j];
    sum += below * (below + 3) / 2;  // what the column adds to later ones, and its division
  }
  return sum;
}

double SparseLdlt::multiplications_to_solve() const {
  const auto& lower = factors_->ldlt.matrixL().nestedExpression();
  return 2 * static_cast<double>(lower.nonZeros()) + static_cast<double>(lower.cols());
}

namespace {

template <class Ordering>
class Gradients final : public LinearPeer {
 public:
  explicit Gradients(const SparseMatrix& a) : matrix_(eigen_map(a)) {
    cg_.compute(matrix_);
    if (cg_.info() != Eigen::Success)
      throw std::invalid_argument("Eigen's incomplete Cholesky factorisation failed");
  }
  std::size_t solve(const std::vector<double>& b, std::vector<double>& x, double tolerance,
                    std::size_t most_iterations) override {
    cg_.setTolerance(tolerance);
    cg_.setMaxIterations(static_cast<Eigen::Index>(most_iterations));
    const auto n = static_cast<Eigen::Index>(b.size());
    x.resize(b.size());
    Eigen::Map<Eigen::VectorXd>(x.data(), n) = cg_.solve(as_vector(b.data(), n));
    return static_cast<std::size_t>(cg_.iterations());
  }

 private:
  // Both triangles of rows: its documentation's advice for the fastest products.
  EigenRows matrix_;
  Eigen::ConjugateGradient<EigenRows, Eigen::Lower | Eigen::Upper,
                           Eigen::IncompleteCholesky<double, Eigen::Lower, Ordering>>
      cg_;
};

class Ldlt final : public LinearPeer {
 public:
  explicit Ldlt(const SparseMatrix& a) : ldlt_(a) {}
  std::size_t solve(const std::vector<double>& b, std::vector<double>& x, double,
                    std::size_t) override {
    x.resize(b.size());
    ldlt_.solve(b.data(), x.data());
    return 0;
  }

 private:
  SparseLdlt ldlt_;
};

template <class Solver>
std::unique_ptr<LinearPeer> make(const SparseMatrix& a) {
  return std::make_unique<Solver>(a);
}

}  // namespace

void add_eigen_peers(std::vector<LinearPeerInfo>& peers) {
  peers.push_back({"eigen/cg_ic_amd", false, make<Gradients<Eigen::AMDOrdering<int>>>});
  peers.push_back({"eigen/cg_ic_natural", false, make<Gradients<Eigen::NaturalOrdering<int>>>});
  peers.push_back({"eigen/simplicial_ldlt", true, make<Ldlt>});
}

}  // namespace odeum::linear
