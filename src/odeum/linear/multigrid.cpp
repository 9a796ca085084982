// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/linear/multigrid.hpp"

#include <algorithm>
#include <cmath>

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

/// Rows of a block: of blocks apart the sweeps are positive definite where every diagonal entry
/// outweighs what its row has in other blocks (Saad, section 4.2); all rows where it does not.
int block_of(const SparseMatrix& a) {
  constexpr int rows = 16384;
  for (int i = 0; i < a.rows; ++i) {
    double apart = 0, diagonal = 0;
    for (int k = a.start[i]; k < a.start[i + 1]; ++k)
      if (a.column[k] == i)
        diagonal = a.value[k];
      else if (a.column[k] / rows != i / rows)
        apart += std::abs(a.value[k]);
    if (!(diagonal > apart)) return std::max(a.rows, 1);
  }
  return rows;
}

}  // namespace

Multigrid::Multigrid(const SparseMatrix& finest, std::vector<SparseMatrix> prolongations,
                     std::size_t threads)
    : finest_(finest),
      prolongations_(std::move(prolongations)),
      coarser_(coarser_of(finest, prolongations_)),
      coarsest_(coarser_.empty() ? finest : coarser_.back()),
      team_(std::make_unique<Team>(threads)) {
  for (const SparseMatrix& p : prolongations_) restrictions_.push_back(transposed(p));
  for (std::size_t level = 0; level < levels(); ++level) {
    const auto n = static_cast<std::size_t>(matrix(level).rows);
    inverses_.push_back(matrix(level).diagonal());
    for (double& entry : inverses_.back()) entry = 1 / entry;
    block_.push_back(block_of(matrix(level)));
    residual_.emplace_back(n), right_.emplace_back(n), correction_.emplace_back(n);
  }
}

void Multigrid::apply(const double* r, double* z) const { cycle(0, r, z); }

template <class Work>
void Multigrid::each_block(std::size_t level, Work&& work) const {
  const int rows = matrix(level).rows, block = block_[level];
  const auto blocks = static_cast<std::size_t>((rows + block - 1) / block);
  team_->run(blocks, [&](std::size_t first, std::size_t end) {
    for (auto k = static_cast<int>(first); k < static_cast<int>(end); ++k)
      work(k * block, std::min(rows, (k + 1) * block));
  });
}

void Multigrid::sweep_forward(std::size_t level, const double* r, double* z) const {
  const SparseMatrix& a = matrix(level);
  const double* const inverse = inverses_[level].data();
  // The entries right of the diagonal and in other blocks meet zeros.
  each_block(level, [&, r, z](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      double sum = r[i];
      int k = a.start[i];
      while (a.column[k] < begin) ++k;
      for (; a.column[k] < i; ++k) sum -= a.value[k] * z[a.column[k]];
      z[i] = sum * inverse[i];
    }
  });
}

void Multigrid::sweep_backward(std::size_t level, const double* r, double* z) const {
  const SparseMatrix& a = matrix(level);
  const double* const inverse = inverses_[level].data();
  double* const right = residual_[level].data();
  const bool apart = block_[level] < a.rows;
  if (apart)
    each_block(level, [&, r, z](int begin, int end) {
      for (int i = begin; i < end; ++i) {
        right[i] = r[i];
        for (int k = a.start[i]; a.column[k] < begin; ++k) right[i] -= a.value[k] * z[a.column[k]];
        for (int k = a.start[i + 1] - 1; a.column[k] >= end; --k)
          right[i] -= a.value[k] * z[a.column[k]];
      }
    });
  each_block(level, [&, r, z](int begin, int end) {
    for (int i = end - 1; i >= begin; --i) {
      double sum = apart ? right[i] : r[i];
      int k = a.start[i], last = a.start[i + 1];
      while (a.column[k] < begin) ++k;
      while (a.column[last - 1] >= end) --last;
      for (; k < last; ++k) sum -= a.value[k] * z[a.column[k]];
      z[i] += sum * inverse[i];
    }
  });
}

void Multigrid::cycle(std::size_t level, const double* r, double* z) const {
  if (level == prolongations_.size()) return coarsest_.solve(r, z);
  const SparseMatrix& a = matrix(level);
  sweep_forward(level, r, z);
  double* const residual = residual_[level].data();
  a.multiply(z, residual, team_.get());
  for (int i = 0; i < a.rows; ++i) residual[i] = r[i] - residual[i];
  double *right = right_[level + 1].data(), *correction = correction_[level + 1].data();
  restrictions_[level].multiply(residual, right, team_.get());
  cycle(level + 1, right, correction);
  prolongations_[level].multiply(correction, residual, team_.get());
  for (int i = 0; i < a.rows; ++i) z[i] += residual[i];
  sweep_backward(level, r, z);
}

}  // namespace odeum::linear
