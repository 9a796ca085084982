// SPDX-License-Identifier: BSD-3-Clause
// The linear algebra of implicit methods on a scene; apart from scene_problem.cpp since Eigen's
// sparse headers are heavy.
//
// With J = [0 I; M^-1 K, M^-1 D] and g = gamma h, the system (I - g J)(x_q, x_v) = (r_q, r_v) has
// x_q = r_q + g x_v and
//
//     A x_v = M r_v + g K r_q,   A = M - g D - g^2 K.
//
// Fixed particles have x_v = r_v; their columns are on the right side.
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <algorithm>

#include "odeum/scene/problem/scene_problem.hpp"
#include "odeum/scene/springs/grid_matrix.hpp"

namespace odeum::scene {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Entries = std::vector<Eigen::Triplet<double>>;

bool finite(const double* y, std::size_t n) {
  return Eigen::Map<const Eigen::VectorXd>(y, static_cast<Eigen::Index>(n)).allFinite();
}

class EntrySink final : public BlockSink {
 public:
  EntrySink(Entries& by_position, Entries& by_velocity)
      : by_position_(by_position), by_velocity_(by_velocity) {}
  void add(std::size_t i, std::size_t j, const Mat3& x, const Mat3& v) override {
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t c = 0; c < 3; ++c) {
        const int row = static_cast<int>(3 * i + r), column = static_cast<int>(3 * j + c);
        if (x[3 * r + c] != 0) by_position_.emplace_back(row, column, x[3 * r + c]);
        if (v[3 * r + c] != 0) by_velocity_.emplace_back(row, column, v[3 * r + c]);
      }
  }

 private:
  Entries &by_position_, &by_velocity_;
};

/// A sparse L D L^T where the terms are symmetric, else a sparse LU.
class SparseShiftedSolver final : public ShiftedSolver {
 public:
  explicit SparseShiftedSolver(const SceneProblem& problem)
      : problem_(problem),
        n_(static_cast<Eigen::Index>(problem.size() / 2)),
        k_(n_, n_),
        known_(n_, n_),
        right_(n_) {}

  bool factorise(double, const double* y, double gamma_h) override {
    g_ = gamma_h;
    if (!finite(y, problem_.size())) return false;
    Entries position, velocity, all, known;
    EntrySink sink(position, velocity);
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
    if (problem_.symmetric()) return ldlt_.compute(matrix).info() == Eigen::Success;
    lu_.compute(matrix);
    return lu_.info() == Eigen::Success;
  }

  bool solve(double* x, double) override {
    Eigen::Map<Eigen::VectorXd> xq(x, n_), xv(x + n_, n_);
    right_.noalias() = g_ * (k_ * xq);
    right_.noalias() -= known_ * xv;
    for (Eigen::Index i = 0; i < n_; ++i)
      right_[i] = moves(i) ? right_[i] + mass(i) * xv[i] : xv[i];
    xv = problem_.symmetric() ? Eigen::VectorXd(ldlt_.solve(right_))
                              : Eigen::VectorXd(lu_.solve(right_));
    xq += g_ * xv;
    return true;
  }

 private:
  bool moves(Eigen::Index row) const {
    return problem_.bodies().free(static_cast<std::size_t>(row) / 3);
  }
  double mass(Eigen::Index row) const {
    return problem_.bodies().mass[static_cast<std::size_t>(row) / 3];
  }

  const SceneProblem& problem_;
  Eigen::Index n_;
  Matrix k_, known_;  // K; the columns of A that belong to fixed particles
  Eigen::VectorXd right_;
  Eigen::SimplicialLDLT<Matrix> ldlt_;
  Eigen::SparseLU<Matrix> lu_;
  double g_ = 0;
};

/// On a regular grid, in the grid's layout: conjugate gradients, since A is positive definite
/// unless compressed springs outweigh the masses; then the sparse solver takes over.
class GridShiftedSolver final : public ShiftedSolver {
 public:
  explicit GridShiftedSolver(const SceneProblem& problem)
      : problem_(problem),
        layout_(problem.grid()->layout()),
        matrix_(*problem.grid(), free_masses(problem.bodies()).data()),
        xq_(3 * layout_.size),
        xv_(xq_),
        b_(xq_),
        scratch_(xq_) {}

  bool factorise(double t, const double* y, double gamma_h) override {
    t_ = t;
    y_.assign(y, y + problem_.size());
    gamma_h_ = gamma_h;
    directly_.reset();
    layout_.scatter(y, scratch_.data());
    matrix_.assemble(scratch_.data(), gamma_h);
    return finite(y, problem_.size() / 2);
  }

  bool solve(double* x, double relative) override {
    double* const v = x + problem_.size() / 2;
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
      directly_ = std::make_unique<SparseShiftedSolver>(problem_);
      return directly_->factorise(t_, y_.data(), gamma_h_) && directly_->solve(x, relative);
    }
    for (std::size_t i = 0; i < xq_.size(); ++i) xq_[i] += gamma_h_ * xv_[i];
    layout_.gather(xq_.data(), x);
    layout_.gather(xv_.data(), v);
    return true;
  }

  std::uint64_t products() const override { return matrix_.products(); }

 private:
  static std::vector<double> free_masses(const Bodies& bodies) {
    std::vector<double> masses;
    for (std::size_t i = 0; i < bodies.size(); ++i)
      masses.push_back(bodies.free(i) ? bodies.mass[i] : 0);
    return masses;
  }

  const SceneProblem& problem_;
  GridLayout layout_;
  GridMatrix matrix_;
  std::vector<double> xq_, xv_, b_, scratch_;
  std::unique_ptr<SparseShiftedSolver> directly_;
  std::vector<double> y_;
  double t_ = 0, gamma_h_ = 0;
};

}  // namespace

std::unique_ptr<ShiftedSolver> SceneProblem::shifted_solver() const {
  const auto negative = [](const Spring& spring) {
    return spring.stiffness * spring.rest_length < 0;
  };
  if (grid_ && symmetric() && std::none_of(springs().begin(), springs().end(), negative))
    return std::make_unique<GridShiftedSolver>(*this);
  return std::make_unique<SparseShiftedSolver>(*this);
}

}  // namespace odeum::scene
