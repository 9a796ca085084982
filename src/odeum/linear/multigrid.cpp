// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/linear/multigrid.hpp"

#include <algorithm>

namespace odeum::linear {
namespace {

std::vector<SparseMatrix> coarser_of(const SparseMatrix& finest,
                                     const std::vector<SparseMatrix>& prolongations) {
  std::vector<SparseMatrix> coarser;
  for (const SparseMatrix& p : prolongations)
    coarser.push_back(galerkin_product(coarser.empty() ? finest : coarser.back(), p));
  return coarser;
}

SparseMatrix transposed(const SparseMatrix& p) {
  std::vector<Triplet> entries;
  for (int i = 0; i < p.rows; ++i)
    for (int k = p.start[i]; k < p.start[i + 1]; ++k)
      entries.push_back({p.column[k], i, p.value[k]});
  return from_triplets(p.columns, p.rows, entries);
}

/// The value of unknown i by its own equation, with the others as they are.
double relaxed(const SparseMatrix& a, const double* r, const double* z, int i, double inverse) {
  double sum = r[i];
  for (int k = a.start[i]; k < a.start[i + 1]; ++k) sum -= a.value[k] * z[a.column[k]];
  return z[i] + sum * inverse;
}

}  // namespace

Multigrid::Multigrid(const SparseMatrix& finest, std::vector<SparseMatrix> prolongations)
    : finest_(finest),
      prolongations_(std::move(prolongations)),
      coarser_(coarser_of(finest, prolongations_)),
      coarsest_(coarser_.empty() ? finest : coarser_.back()) {
  for (const SparseMatrix& p : prolongations_) restrictions_.push_back(transposed(p));
  for (std::size_t level = 0; level < levels(); ++level) {
    const auto n = static_cast<std::size_t>(matrix(level).rows);
    inverses_.push_back(matrix(level).diagonal());
    for (double& entry : inverses_.back()) entry = 1 / entry;
    residual_.emplace_back(n), right_.emplace_back(n), correction_.emplace_back(n);
  }
}

double Multigrid::complexity() const {
  double entries = 0;
  for (std::size_t level = 0; level < levels(); ++level)
    entries += static_cast<double>(matrix(level).value.size());
  return entries / static_cast<double>(finest_.value.size());
}

void Multigrid::apply(const double* r, double* z) const { cycle(0, r, z); }

void Multigrid::cycle(std::size_t level, const double* r, double* z) const {
  if (level == prolongations_.size()) return coarsest_.solve(r, z);
  const SparseMatrix& a = matrix(level);
  const std::vector<double>& inverse = inverses_[level];
  // Forward from z = 0: the entries right of the diagonal meet zeros.
  for (int i = 0; i < a.rows; ++i) {
    double sum = r[i];
    for (int k = a.start[i]; a.column[k] < i; ++k) sum -= a.value[k] * z[a.column[k]];
    z[i] = sum * inverse[i];
  }
  double* residual = residual_[level].data();
  a.multiply(z, residual);
  for (int i = 0; i < a.rows; ++i) residual[i] = r[i] - residual[i];
  double *right = right_[level + 1].data(), *correction = correction_[level + 1].data();
  restrictions_[level].multiply(residual, right);
  cycle(level + 1, right, correction);
  prolongations_[level].multiply(correction, residual);
  for (int i = 0; i < a.rows; ++i) z[i] += residual[i];
  for (int i = a.rows - 1; i >= 0; --i) z[i] = relaxed(a, r, z, i, inverse[i]);
}

}  // namespace odeum::linear
