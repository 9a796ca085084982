// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/fem/semi_discrete.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "odeum/linear/eigen_solvers.hpp"

namespace odeum::fem {
namespace {

using linear::SparseMatrix;

SparseMatrix sum_of(const SparseMatrix& m, double factor, const SparseMatrix& k) {
  std::vector<linear::Triplet> entries;
  for (const auto& [a, scale] : {std::pair{&m, 1.}, {&k, factor}})
    for (int i = 0; i < a->rows; ++i)
      for (int e = a->start[i]; e < a->start[i + 1]; ++e)
        entries.push_back({i, a->column[e], scale * a->value[e]});
  return linear::from_triplets(m.rows, m.columns, entries);
}

/// The part of the mass matrix that belongs to unknowns, or its row sums.
SparseMatrix mass_of(const TriangleMesh& mesh, const EllipticSystem& system, Mass kind) {
  const SparseMatrix whole = mass_matrix(mesh);
  std::vector<linear::Triplet> entries;
  for (int i = 0; i < whole.rows; ++i)
    for (int k = whole.start[i]; k < whole.start[i + 1]; ++k) {
      const int row = system.unknown[i];
      const int column = kind == Mass::lumped ? row : system.unknown[whole.column[k]];
      if (row >= 0 && column >= 0) entries.push_back({row, column, whole.value[k]});
    }
  const auto n = static_cast<int>(system.right.size());
  return linear::from_triplets(n, n, entries);
}

void count(const SemiDiscrete& system, double multiplications) {
  if (system.multiplications) *system.multiplications += multiplications;
}

class Solver final : public ShiftedSolver {
 public:
  Solver(const SemiDiscrete& system, bool wave) : system_(system), wave_(wave) {}

  bool factorise(double, const double*, double gamma_h) override {
    if (ldlt_ && gamma_h == gamma_h_) return true;
    gamma_h_ = gamma_h;
    ldlt_.reset();
    const double factor = wave_ ? gamma_h * gamma_h : gamma_h;
    if (!std::isfinite(factor)) return false;
    try {
      ldlt_ = std::make_unique<linear::SparseLdlt>(sum_of(system_.mass, factor, system_.stiffness));
    } catch (const std::invalid_argument&) {
      return false;
    }
    count(system_, ldlt_->multiplications_to_factorise());
    return true;
  }
  bool solve(double* x, double) override {
    const std::size_t n = system_.size();
    right_.assign(x, x + n), product_.resize(n);
    double* const v = x + n;
    count(system_, ldlt_->multiplications_to_solve());
    if (wave_)
      for (std::size_t i = 0; i < n; ++i) right_[i] += gamma_h_ * v[i];
    system_.mass.multiply(right_.data(), product_.data());
    ldlt_->solve(product_.data(), x);
    if (!wave_) return true;
    // The rate gives v: the difference of positions cancels for small steps.
    system_.rate(x, product_.data());
    for (std::size_t i = 0; i < n; ++i) v[i] += gamma_h_ * (product_[i] - system_.source[i]);
    return true;
  }

 private:
  const SemiDiscrete& system_;
  bool wave_;
  double gamma_h_ = 0;
  std::unique_ptr<linear::SparseLdlt> ldlt_;
  std::vector<double> right_, product_;
};

void set_operator(SemiDiscrete& system) {
  const std::size_t n = system.size();
  const SparseMatrix& k = system.stiffness;
  system.source.resize(n);
  if (system.lumped) {
    system.pattern.start = k.start, system.pattern.column = k.column;
    system.entries.resize(k.value.size());
    for (std::size_t i = 0; i < n; ++i) {
      system.source[i] = system.load[i] / system.mass.value[i];
      for (int e = k.start[i]; e < k.start[i + 1]; ++e)
        system.entries[e] = -k.value[e] / system.mass.value[i];
    }
    return;
  }
  const linear::SparseLdlt ldlt(system.mass);
  ldlt.solve(system.load.data(), system.source.data());
  system.operator_matrix.resize(n * n);
  std::vector<double> column(n), solved(n);
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = 0; i < n; ++i) column[i] = -k.at(static_cast<int>(i), static_cast<int>(j));
    ldlt.solve(column.data(), solved.data());
    for (std::size_t i = 0; i < n; ++i) system.operator_matrix[i * n + j] = solved[i];
  }
}

}  // namespace

void SemiDiscrete::rate(const double* u, double* dudt) const {
  const std::size_t n = size();
  count(*this, static_cast<double>(lumped ? stiffness.value.size() : n * n));
  if (lumped) {
    stiffness.multiply(u, dudt);
    for (std::size_t i = 0; i < n; ++i) dudt[i] = (load[i] - dudt[i]) / mass.value[i];
    return;
  }
  for (std::size_t i = 0; i < n; ++i) {
    double sum = source[i];
    for (std::size_t j = 0; j < n; ++j) sum += operator_matrix[i * n + j] * u[j];
    dudt[i] = sum;
  }
}

SemiDiscrete semi_discrete(const TriangleMesh& mesh, const EllipticProblem& problem, Mass mass,
                           bool with_modes) {
  EllipticSystem system = assemble(mesh, problem, vertex_rule());
  SemiDiscrete result;
  result.lumped = mass == Mass::lumped;
  result.mass = mass_of(mesh, system, mass);
  result.stiffness = std::move(system.matrix), result.load = std::move(system.right);
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    if (system.unknown[i] >= 0) result.nodes.push_back(mesh.nodes[i]);
  set_operator(result);
  if (with_modes)
    result.modes = std::make_shared<const linear::Modes>(
        linear::generalized_modes(result.stiffness, result.mass));
  return result;
}

std::unique_ptr<ShiftedSolver> heat_solver(const SemiDiscrete& system) {
  return std::make_unique<Solver>(system, false);
}
std::unique_ptr<ShiftedSolver> wave_solver(const SemiDiscrete& system) {
  return std::make_unique<Solver>(system, true);
}

}  // namespace odeum::fem
