// SPDX-License-Identifier: BSD-3-Clause
// The linear algebra of implicit methods on a mass-spring scene; apart from mass_spring.cpp since
// Eigen's sparse headers are heavy.
#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>

#include "odeum/linear/conjugate_gradients.hpp"
#include "odeum/scene/model/mass_spring.hpp"
#include "odeum/scene/springs/grid_matrix.hpp"

namespace odeum::scene {
namespace {

using Block = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
using BlockMap = Eigen::Map<const Block>;
using Segment = Eigen::Map<Eigen::Vector3d>;
using ConstSegment = Eigen::Map<const Eigen::Vector3d>;

// With J = [0 I; M^-1 K, M^-1 D] and g = gamma h, the system (I - g J)(x_q, x_v) = (r_q, r_v)
// has x_q = r_q + g x_v and
//
//     A x_v = M r_v + g K r_q,   A = M - g D - g^2 K,
//
// symmetric, and positive definite unless compressed springs outweigh the mass: conjugate
// gradients first, a sparse LDL^T where they meet negative curvature. Each spring adds the block
// B = g d I + g^2 k(...) to A at aa and bb, and -B at ab and ba. Fixed particles have x_v = r_v.
class MassSpringShiftedSolver final : public ShiftedSolver {
 public:
  explicit MassSpringShiftedSolver(const MassSpring& problem)
      : problem_(problem),
        n_(3 * problem.particles()),
        stiffness_(problem.springs().size()),
        a_blocks_(problem.springs().size()),
        preconditioner_(problem.particles()),
        cg_(n_),
        right_side_(n_) {}

  bool factorise(double, const double* y, double gamma_h) override {
    gamma_h_ = gamma_h;
    for (std::size_t i = 0; i < problem_.particles(); ++i)
      preconditioner_[i] = Block::Identity() * mass(i);
    for (std::size_t s = 0; s < a_blocks_.size(); ++s) {
      const Spring& spring = problem_.springs()[s];
      stiffness_[s] = BlockMap(spring_stiffness_block(spring, y).data());
      a_blocks_[s] =
          gamma_h * gamma_h * stiffness_[s] + gamma_h * spring.damping * Block::Identity();
      preconditioner_[spring.a] += a_blocks_[s];
      preconditioner_[spring.b] += a_blocks_[s];
    }
    for (Block& block : preconditioner_) block = block.inverse().eval();
    return Eigen::Map<const Eigen::VectorXd>(y, static_cast<Eigen::Index>(n_)).allFinite();
  }

  bool solve(double* x, double relative) override {
    double *const xq = x, *const xv = x + n_;
    form_right_side(xq, xv);
    const auto apply = [this](const double* p, double* ap) { multiply(p, ap); };
    const auto precondition = [this](const double* r, double* z) {
      for (std::size_t i = 0; i < problem_.particles(); ++i)
        Segment(z + 3 * i).noalias() = preconditioner_[i] * ConstSegment(r + 3 * i);
    };
    for (std::size_t i = 0; i < n_; ++i)
      if (free(i / 3)) xv[i] = 0;
    if (!cg_.solve(apply, precondition, right_side_.data(), xv, relative) && !solve_directly(xv))
      return false;
    for (std::size_t i = 0; i < n_; ++i) xq[i] += gamma_h_ * xv[i];
    return true;
  }

  std::uint64_t products() const override { return cg_.products(); }

 private:
  bool free(std::size_t particle) const { return problem_.inverse_masses()[particle] != 0; }
  double mass(std::size_t particle) const {
    return free(particle) ? 1 / problem_.inverse_masses()[particle] : 1;
  }

  // M r_v + g K r_q, with the known columns of fixed particles moved to the right.
  void form_right_side(const double* rq, const double* rv) {
    for (std::size_t i = 0; i < n_; ++i) right_side_[i] = mass(i / 3) * rv[i];
    for (std::size_t s = 0; s < stiffness_.size(); ++s) {
      const auto [a, b] = ends(s);
      Eigen::Vector3d force =
          gamma_h_ * (stiffness_[s] * (ConstSegment(rq + 3 * b) - ConstSegment(rq + 3 * a)));
      if (!free(a)) force -= a_blocks_[s] * ConstSegment(rv + 3 * a);
      if (!free(b)) force += a_blocks_[s] * ConstSegment(rv + 3 * b);
      if (free(a)) Segment(right_side_.data() + 3 * a) += force;
      if (free(b)) Segment(right_side_.data() + 3 * b) -= force;
    }
  }

  // ap = A p on free particles, the identity on fixed ones (whose columns are on the right side).
  void multiply(const double* p, double* ap) const {
    for (std::size_t i = 0; i < n_; ++i) ap[i] = mass(i / 3) * p[i];
    for (std::size_t s = 0; s < a_blocks_.size(); ++s) {
      const auto [a, b] = ends(s);
      Eigen::Vector3d difference = Eigen::Vector3d::Zero();
      if (free(a)) difference += ConstSegment(p + 3 * a);
      if (free(b)) difference -= ConstSegment(p + 3 * b);
      const Eigen::Vector3d force = a_blocks_[s] * difference;
      if (free(a)) Segment(ap + 3 * a) += force;
      if (free(b)) Segment(ap + 3 * b) -= force;
    }
  }

  bool solve_directly(double* xv) const {
    std::vector<Eigen::Triplet<double>> entries;
    const auto add = [&](std::size_t row, std::size_t column, const Block& block) {
      if (!free(row) || !free(column)) return;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          entries.emplace_back(static_cast<int>(3 * row) + i, static_cast<int>(3 * column) + j,
                               block(i, j));
    };
    for (std::size_t i = 0; i < n_; ++i)
      entries.emplace_back(static_cast<int>(i), static_cast<int>(i), mass(i / 3));
    for (std::size_t s = 0; s < a_blocks_.size(); ++s) {
      const auto [a, b] = ends(s);
      add(a, a, a_blocks_[s]);
      add(b, b, a_blocks_[s]);
      add(a, b, -a_blocks_[s]);
      add(b, a, -a_blocks_[s]);
    }
    const auto n = static_cast<Eigen::Index>(n_);
    Eigen::SparseMatrix<double> matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(matrix);
    if (factors.info() != Eigen::Success) return false;
    Eigen::Map<Eigen::VectorXd>(xv, n) =
        factors.solve(Eigen::Map<const Eigen::VectorXd>(right_side_.data(), n));
    return true;
  }

  std::pair<std::size_t, std::size_t> ends(std::size_t s) const {
    return {problem_.springs()[s].a, problem_.springs()[s].b};
  }

  const MassSpring& problem_;
  std::size_t n_;
  std::vector<Block> stiffness_;       // of each spring, dF_a/dx_b
  std::vector<Block> a_blocks_;        // of each spring, its block of A
  std::vector<Block> preconditioner_;  // inverses of A's diagonal blocks
  linear::ConjugateGradients cg_;
  std::vector<double> right_side_;
  double gamma_h_ = 0;
};

/// The same on a regular grid, in the grid's layout; what is indefinite is left to the other.
class GridShiftedSolver final : public ShiftedSolver {
 public:
  explicit GridShiftedSolver(const MassSpring& problem)
      : problem_(problem),
        layout_(problem.grid()->layout()),
        matrix_(*problem.grid(), masses(problem).data()),
        xq_(3 * layout_.size),
        xv_(xq_),
        b_(xq_),
        scratch_(xq_) {}

  bool factorise(double t, const double* y, double gamma_h) override {
    const std::size_t n = 6 * problem_.particles();
    t_ = t;
    y_.assign(y, y + n);
    gamma_h_ = gamma_h;
    directly_.reset();
    layout_.scatter(y, scratch_.data());
    matrix_.assemble(scratch_.data(), gamma_h);
    return Eigen::Map<const Eigen::VectorXd>(y, static_cast<Eigen::Index>(n / 2)).allFinite();
  }

  bool solve(double* x, double relative) override {
    double* const v = x + 3 * problem_.particles();
    if (directly_) return directly_->solve(x, relative);
    layout_.scatter(x, xq_.data());
    layout_.scatter(v, xv_.data());
    matrix_.mass_times(xv_.data(), b_.data());
    if (gamma_h_ != 0) {
      matrix_.stiffness_times(xq_.data(), scratch_.data());
      for (std::size_t i = 0; i < b_.size(); ++i) b_[i] += scratch_[i];
    }
    matrix_.clear_free(xv_.data());
    if (!matrix_.solve(b_.data(), xv_.data(), relative)) {
      directly_ = std::make_unique<MassSpringShiftedSolver>(problem_);
      return directly_->factorise(t_, y_.data(), gamma_h_) && directly_->solve(x, relative);
    }
    for (std::size_t i = 0; i < xq_.size(); ++i) xq_[i] += gamma_h_ * xv_[i];
    layout_.gather(xq_.data(), x);
    layout_.gather(xv_.data(), v);
    return true;
  }

  std::uint64_t products() const override {
    return matrix_.products() + (directly_ ? directly_->products() : 0);
  }

 private:
  static std::vector<double> masses(const MassSpring& problem) {
    std::vector<double> masses;
    for (const double inverse : problem.inverse_masses())
      masses.push_back(inverse != 0 ? 1 / inverse : 0);
    return masses;
  }

  const MassSpring& problem_;
  GridLayout layout_;
  GridMatrix matrix_;
  std::vector<double> xq_, xv_, b_, scratch_;
  std::unique_ptr<MassSpringShiftedSolver> directly_;
  std::vector<double> y_;
  double t_ = 0, gamma_h_ = 0;
};

}  // namespace

std::unique_ptr<ShiftedSolver> MassSpring::shifted_solver() const {
  const auto negative = [](const Spring& spring) {
    return spring.stiffness * spring.rest_length < 0;
  };
  if (grid_ && std::none_of(springs_.begin(), springs_.end(), negative))
    return std::make_unique<GridShiftedSolver>(*this);
  return std::make_unique<MassSpringShiftedSolver>(*this);
}

}  // namespace odeum::scene
