// SPDX-License-Identifier: BSD-3-Clause
// The linear algebra of implicit methods on a scene; apart from scene_problem.cpp since Eigen's
// sparse headers are heavy.
//
// With J = [0 I; M^-1 K, M^-1 D] and g = gamma h, the system (I - g J)(x_q, x_v) = (r_q, r_v) has
// x_q = r_q + g x_v and
//
//     A x_v = M r_v + g K r_q,   A = M - g D - g^2 K.
//
// Particles without a force, fixed or not there, have x_v = r_v; their columns are on the right.
#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <algorithm>

#include "odeum/scene/problem/scene_problem.hpp"
#include "odeum/scene/springs/grid_matrix.hpp"
#include "odeum/scene/surface/surface_term.hpp"

namespace odeum::scene {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Entries = std::vector<Eigen::Triplet<double>>;

bool finite(const double* y, std::size_t n) {
  return Eigen::Map<const Eigen::VectorXd>(y, static_cast<Eigen::Index>(n)).allFinite();
}

/// A multiple of the identity above the derivative of an elastic force; on the diagonal, where that
/// is negative, below it. With such a bound of all its derivatives, k I instead of k u u^T + ...,
/// the energy of a spring lies below the quadratic that touches it at the present state.
Mat3 bound_of(const Mat3& x, bool diagonal) {
  const Eigen::Matrix3d m = Eigen::Map<const Eigen::Matrix3d>(x.data());
  const Eigen::Vector3d values =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(m + m.transpose(), Eigen::EigenvaluesOnly)
          .eigenvalues();
  const double bound =
      (diagonal ? std::min(values.minCoeff(), 0.0) : std::max(values.maxCoeff(), 0.0)) / 2;
  return {bound, 0, 0, 0, bound, 0, 0, 0, bound};
}

class EntrySink final : public BlockSink {
 public:
  EntrySink(Entries& by_position, Entries& by_velocity, bool bounded)
      : by_position_(by_position), by_velocity_(by_velocity), bounded_(bounded) {}
  void add(std::size_t i, std::size_t j, const Mat3& exact, const Mat3& v) override {
    const Mat3 x = bounded_ ? bound_of(exact, i == j) : exact;
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t c = 0; c < 3; ++c) {
        const int row = static_cast<int>(3 * i + r), column = static_cast<int>(3 * j + c);
        if (x[3 * r + c] != 0) by_position_.emplace_back(row, column, x[3 * r + c]);
        if (v[3 * r + c] != 0) by_velocity_.emplace_back(row, column, v[3 * r + c]);
      }
  }

 private:
  Entries &by_position_, &by_velocity_;
  bool bounded_;
};

/// A sparse L D L^T where the terms are symmetric, else a sparse LU. Of surfaces that meet without
/// friction the derivatives are symmetric to rounding: L D L^T takes them where A is positive
/// definite.
class SparseShiftedSolver final : public ShiftedSolver {
 public:
  SparseShiftedSolver(const SceneProblem& problem, bool surfaces)
      : problem_(problem),
        surfaces_(surfaces),
        n_(static_cast<Eigen::Index>(problem.size() / 2)),
        k_(n_, n_),
        known_(n_, n_),
        right_(n_) {}

  bool factorise(double t, const double* y, double gamma_h) override {
    t_ = t;
    g_ = gamma_h;
    if (!finite(y, problem_.size())) return false;
    Entries position, velocity, all, known;
    EntrySink sink(position, velocity, bounded_);
    problem_.blocks(y, y + n_, sink);
    for (int i = 0; i < n_; ++i) all.emplace_back(i, i, moves(i) ? mass(i) : 1);
    const auto add = [&](const Entries& entries, double factor) {
      for (const auto& e : entries)
        if (moves(e.row()))
          (moves(e.col()) ? all : known).emplace_back(e.row(), e.col(), factor * e.value());
    };
    add(velocity, -g_);
    add(position, -g_ * g_);
    k_.setFromTriplets(position.begin(), position.end());
    known_.setFromTriplets(known.begin(), known.end());
    Matrix matrix(n_, n_);
    matrix.setFromTriplets(all.begin(), all.end());
    const bool analysed = has_pattern_of(matrix);
    pattern_.swap(matrix);
    by_ldlt_ = problem_.symmetric() || surfaces_;
    if (by_ldlt_) {
      const bool done = factorise(ldlt_, analysed);
      if (!surfaces_) return done;
      if (done && ldlt_.vectorD().minCoeff() > 0) return true;
      by_ldlt_ = false;
    }
    return factorise(lu_, analysed && !surfaces_);
  }

  bool bound() override { return bounded_ = true; }

  bool solve(double* x, double) override {
    Eigen::Map<Eigen::VectorXd> xq(x, n_), xv(x + n_, n_);
    right_.noalias() = g_ * (k_ * xq);
    right_.noalias() -= known_ * xv;
    for (Eigen::Index i = 0; i < n_; ++i)
      right_[i] = moves(i) ? right_[i] + mass(i) * xv[i] : xv[i];
    xv = by_ldlt_ ? Eigen::VectorXd(ldlt_.solve(right_)) : Eigen::VectorXd(lu_.solve(right_));
    xq += g_ * xv;
    return true;
  }
  std::uint64_t products() const override { return products_; }

 private:
  bool moves(Eigen::Index row) const {
    const std::size_t i = static_cast<std::size_t>(row) / 3;
    return problem_.bodies().free(i) && problem_.acts(i, t_);
  }
  double mass(Eigen::Index row) const {
    return problem_.bodies().mass[static_cast<std::size_t>(row) / 3];
  }
  /// Whether that is the pattern analysed last.
  bool has_pattern_of(const Matrix& matrix) const {
    const auto same = [](const int* a, const int* b, Eigen::Index n) {
      return std::equal(a, a + n, b);
    };
    return pattern_.nonZeros() == matrix.nonZeros() && pattern_.rows() == n_ &&
           same(pattern_.outerIndexPtr(), matrix.outerIndexPtr(), n_) &&
           same(pattern_.innerIndexPtr(), matrix.innerIndexPtr(), matrix.nonZeros());
  }
  /// The analysis takes as long as the factors.
  template <class Solver>
  bool factorise(Solver& solver, bool analysed) {
    if (!analysed) solver.analyzePattern(pattern_);
    solver.factorize(pattern_);
    if (solver.info() != Eigen::Success) return false;
    // Multiplications and additions of the factors' columns over the multiplications of a product
    // (the flag's 741 unknowns: 279; a step takes the time of 244 evaluations).
    const auto size = static_cast<double>(n_), own = static_cast<double>(pattern_.nonZeros());
    products_ += static_cast<std::uint64_t>(2 * entries_of_factors(solver) / size / own) + 1;
    return true;
  }
  static double entries_of_factors(const Eigen::SparseLU<Matrix>& lu) {
    return static_cast<double>(lu.nnzL()) * static_cast<double>(lu.nnzU());
  }
  static double entries_of_factors(const Eigen::SimplicialLDLT<Matrix>& ldlt) {
    const auto entries = static_cast<double>(ldlt.matrixL().nestedExpression().nonZeros());
    return entries * entries;
  }

  const SceneProblem& problem_;
  bool surfaces_, by_ldlt_ = false;
  Eigen::Index n_;
  Matrix pattern_;    ///< the last A
  Matrix k_, known_;  // K; the columns of A that belong to fixed particles
  Eigen::VectorXd right_;
  Eigen::SimplicialLDLT<Matrix> ldlt_;
  Eigen::SparseLU<Matrix> lu_;
  double t_ = 0, g_ = 0;
  std::uint64_t products_ = 0;
  bool bounded_ = false;
};

/// On a regular grid, by conjugate gradients in the grid's layout; where compressed springs make A
/// indefinite, the sparse solver takes over.
class SceneGridSolver final : public ShiftedSolver {
 public:
  SceneGridSolver(const SceneProblem& problem, std::unique_ptr<ShiftedSolver> on_grid,
                  bool surfaces)
      : problem_(problem), on_grid_(std::move(on_grid)), surfaces_(surfaces) {}

  bool factorise(double t, const double* y, double gamma_h) override {
    t_ = t;
    y_.assign(y, y + problem_.size());
    gamma_h_ = gamma_h;
    direct_ = false;
    if (bounded_) return factorise_directly();
    return on_grid_->factorise(t, problem_.grid()->scattered(y_).data(), gamma_h);
  }
  bool solve(double* x, double relative) override {
    if (!direct_) {
      std::vector<double> state = problem_.grid()->scattered({x, x + problem_.size()});
      if (on_grid_->solve(state.data(), relative)) {
        const std::vector<double> solution = problem_.grid()->gathered(state);
        std::ranges::copy(solution, x);
        return true;
      }
      if (!factorise_directly()) return false;
    }
    return directly_->solve(x, relative);
  }
  void solve_once_a_step() override { on_grid_->solve_once_a_step(); }
  bool bound() override { return bounded_ = true; }
  std::uint64_t products() const override {
    return on_grid_->products() + (directly_ ? directly_->products() : 0);
  }

 private:
  bool factorise_directly() {
    if (!directly_) directly_ = std::make_unique<SparseShiftedSolver>(problem_, surfaces_);
    if (bounded_) directly_->bound();
    direct_ = true;
    return directly_->factorise(t_, y_.data(), gamma_h_);
  }

  const SceneProblem& problem_;
  std::unique_ptr<ShiftedSolver> on_grid_;
  std::unique_ptr<SparseShiftedSolver> directly_;  ///< with its analysis, from its first use on
  std::vector<double> y_;
  double t_ = 0, gamma_h_ = 0;
  bool bounded_ = false, direct_ = false, surfaces_;  ///< direct: the last factors are
};

std::unique_ptr<ShiftedSolver> with_surfaces(const SceneProblem& problem,
                                             const Surfaces& surfaces) {
  const GridSprings<double>& springs = problem.grid()->springs();
  const Bodies& bodies = problem.bodies();
  std::vector<double> masses(3 * bodies.size()), by_place(3 * springs.layout().size);
  for (std::size_t i = 0; i < masses.size(); ++i)
    masses[i] = bodies.free(i / 3) ? bodies.mass[i / 3] : 0;
  springs.layout().scatter(masses.data(), by_place.data());
  return std::make_unique<GridShiftedSolver>(springs, by_place.data(), &surfaces);
}

}  // namespace

std::unique_ptr<ShiftedSolver> SceneProblem::shifted_solver() const {
  const Surfaces* const surfaces = terms_.size() == 1 ? frictionless_surfaces(*terms_[0]) : nullptr;
  if (grid_ && (symmetric() || surfaces)) {
    std::unique_ptr<ShiftedSolver> on_grid = grid_->shifted_solver();
    if (on_grid && surfaces) on_grid = with_surfaces(*this, *surfaces);
    if (on_grid)
      return std::make_unique<SceneGridSolver>(*this, std::move(on_grid), surfaces != nullptr);
  }
  return std::make_unique<SparseShiftedSolver>(*this, surfaces != nullptr);
}

}  // namespace odeum::scene
