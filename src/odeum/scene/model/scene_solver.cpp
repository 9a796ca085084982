// SPDX-License-Identifier: BSD-3-Clause
// The linear algebra of implicit methods on any scene: a sparse LU of its blocks.
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>

#include "odeum/scene/model/scene_problem.hpp"

namespace odeum::scene {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Entries = std::vector<Eigen::Triplet<double>>;

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

// With J = [0 I; M^-1 K, M^-1 D] and g = gamma h, the system (I - g J)(x_q, x_v) = (r_q, r_v) has
// x_q = r_q + g x_v and (M - g D - g^2 K) x_v = M r_v + g K r_q. Fixed particles have x_v = r_v.
class SceneShiftedSolver final : public ShiftedSolver {
 public:
  explicit SceneShiftedSolver(const SceneProblem& problem)
      : problem_(problem),
        n_(static_cast<Eigen::Index>(3 * problem.particles())),
        k_(n_, n_),
        right_(n_) {}

  bool factorise(double, const double* y, double gamma_h) override {
    g_ = gamma_h;
    if (!Eigen::Map<const Eigen::VectorXd>(y, 2 * n_).allFinite()) return false;
    Entries position, velocity, all;
    EntrySink sink(position, velocity);
    problem_.blocks(y, y + n_, sink);
    const auto moves = [&](int row) {
      return problem_.bodies().free(static_cast<std::size_t>(row) / 3);
    };
    for (int i = 0; i < n_; ++i)
      all.emplace_back(i, i,
                       moves(i) ? problem_.bodies().mass[static_cast<std::size_t>(i) / 3] : 1);
    for (const auto& e : velocity)
      if (moves(e.row())) all.emplace_back(e.row(), e.col(), -g_ * e.value());
    for (const auto& e : position)
      if (moves(e.row())) all.emplace_back(e.row(), e.col(), -g_ * g_ * e.value());
    k_.setFromTriplets(position.begin(), position.end());
    Matrix matrix(n_, n_);
    matrix.setFromTriplets(all.begin(), all.end());
    matrix.makeCompressed();
    lu_.compute(matrix);
    return lu_.info() == Eigen::Success;
  }

  bool solve(double* x, double) override {
    Eigen::Map<Eigen::VectorXd> xq(x, n_), xv(x + n_, n_);
    right_.noalias() = g_ * (k_ * xq);
    for (Eigen::Index i = 0; i < n_; ++i) {
      const auto particle = static_cast<std::size_t>(i) / 3;
      right_[i] = problem_.bodies().free(particle)
                      ? right_[i] + problem_.bodies().mass[particle] * xv[i]
                      : xv[i];
    }
    const Eigen::VectorXd solution = lu_.solve(right_);
    if (lu_.info() != Eigen::Success) return false;
    xv = solution;
    xq += g_ * xv;
    return true;
  }

 private:
  const SceneProblem& problem_;
  Eigen::Index n_;
  Matrix k_;
  Eigen::VectorXd right_;
  Eigen::SparseLU<Matrix> lu_;
  double g_ = 0;
};

}  // namespace

std::unique_ptr<ShiftedSolver> SceneProblem::shifted_solver() const {
  if (springs_ && terms_.empty()) return springs_->shifted_solver();
  return std::make_unique<SceneShiftedSolver>(*this);
}

}  // namespace odeum::scene
