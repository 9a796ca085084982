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

struct EigenConjugateGradients::Solver {
  virtual ~Solver() = default;
  virtual int solve(const std::vector<double>& b, std::vector<double>& x, double tolerance,
                    int most_iterations) = 0;
};

template <class Ordering>
struct EigenConjugateGradients::SolverWith final : Solver {
  // Both triangles of rows: its documentation's advice for the fastest products.
  EigenRows matrix;
  Eigen::ConjugateGradient<EigenRows, Eigen::Lower | Eigen::Upper,
                           Eigen::IncompleteCholesky<double, Eigen::Lower, Ordering>>
      cg;

  explicit SolverWith(const SparseMatrix& a) : matrix(eigen_map(a)) {
    cg.compute(matrix);
    if (cg.info() != Eigen::Success)
      throw std::invalid_argument("Eigen's incomplete Cholesky factorisation failed");
  }
  int solve(const std::vector<double>& b, std::vector<double>& x, double tolerance,
            int most_iterations) override {
    cg.setTolerance(tolerance);
    cg.setMaxIterations(most_iterations);
    const auto n = static_cast<Eigen::Index>(b.size());
    x.resize(b.size());
    Eigen::Map<Eigen::VectorXd>(x.data(), n) = cg.solve(as_vector(b.data(), n));
    return static_cast<int>(cg.iterations());
  }
};

EigenConjugateGradients::EigenConjugateGradients(const SparseMatrix& a,
                                                 const std::string& ordering) {
  if (ordering == "natural")
    solver_ = std::make_unique<SolverWith<Eigen::NaturalOrdering<int>>>(a);
  else if (ordering == "amd")
    solver_ = std::make_unique<SolverWith<Eigen::AMDOrdering<int>>>(a);
  else
    throw std::invalid_argument("no such ordering: " + ordering);
}
EigenConjugateGradients::~EigenConjugateGradients() = default;

int EigenConjugateGradients::solve(const std::vector<double>& b, std::vector<double>& x,
                                   double tolerance, int most_iterations) {
  return solver_->solve(b, x, tolerance, most_iterations);
}

}  // namespace odeum::linear
