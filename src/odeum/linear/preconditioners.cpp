// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/linear/preconditioners.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace odeum::linear {
namespace {

// Divisions would bound the speed of the sweeps, in which every row waits for the one before.
std::vector<double> inverse_diagonal(const SparseMatrix& a) {
  std::vector<double> diagonal = a.diagonal();
  for (double& entry : diagonal) {
    if (!(entry > 0)) throw std::invalid_argument("a diagonal entry is not positive");
    entry = 1 / entry;
  }
  return diagonal;
}

}  // namespace

void NoPreconditioner::apply(const double* r, double* z) const { std::copy(r, r + n_, z); }

JacobiPreconditioner::JacobiPreconditioner(const SparseMatrix& a) : inverse_(inverse_diagonal(a)) {}

void JacobiPreconditioner::apply(const double* r, double* z) const {
  for (std::size_t i = 0; i < inverse_.size(); ++i) z[i] = inverse_[i] * r[i];
}

SsorPreconditioner::SsorPreconditioner(const SparseMatrix& a, double relaxation)
    : a_(a), relaxation_(relaxation), inverse_(inverse_diagonal(a)) {
  if (!(relaxation > 0 && relaxation < 2))
    throw std::invalid_argument("the relaxation factor is not between 0 and 2");
}

void SsorPreconditioner::apply(const double* r, double* z) const {
  const double w = relaxation_;
  for (int i = 0; i < a_.rows; ++i) {
    double sum = r[i];
    for (int k = a_.start[i]; a_.column[k] < i; ++k) sum -= a_.value[k] * z[a_.column[k]];
    z[i] = sum * w * inverse_[i];
  }
  for (int i = a_.rows - 1; i >= 0; --i) {
    double sum = (2 - w) / w * z[i] / inverse_[i];
    for (int k = a_.start[i + 1] - 1; a_.column[k] > i; --k) sum -= a_.value[k] * z[a_.column[k]];
    z[i] = sum * w * inverse_[i];
  }
}

IncompleteCholesky::IncompleteCholesky(const SparseMatrix& a) {
  inverse_diagonal(a);  // or it throws
  lower_.rows = lower_.columns = a.rows;
  for (int i = 0; i < a.rows; ++i) {
    for (int k = a.start[i]; k < a.start[i + 1] && a.column[k] <= i; ++k)
      lower_.column.push_back(a.column[k]);
    lower_.start.push_back(static_cast<int>(lower_.column.size()));
  }
  lower_.value.resize(lower_.column.size());
  // A shift that is large enough makes any matrix of finite entries diagonally dominant.
  while (!factorise(a)) {
    shift_ = shift_ > 0 ? 2 * shift_ : 1e-3;
    if (!(shift_ < 1e15)) throw std::invalid_argument("the matrix has entries that are not finite");
  }
}

bool IncompleteCholesky::factorise(const SparseMatrix& a) {
  for (int i = 0; i < a.rows; ++i) {
    const int first = lower_.start[i], end = lower_.start[i + 1];
    for (int k = first; k < end; ++k) {
      const int j = lower_.column[k];
      double sum = a.value[a.start[i] + (k - first)];
      if (j == i) sum *= 1 + shift_;
      // The product of what rows i and j have in common before column j.
      for (int p = first, q = lower_.start[j]; p < k && lower_.column[q] < j;) {
        const int left = lower_.column[p], right = lower_.column[q];
        if (left == right) sum -= lower_.value[p] * lower_.value[q];
        p += left <= right, q += right <= left;
      }
      if (j < i) {
        lower_.value[k] = sum * lower_.value[lower_.start[j + 1] - 1];
      } else {
        if (!(sum > 0)) return false;
        lower_.value[k] = 1 / std::sqrt(sum);
      }
    }
  }
  return true;
}

void IncompleteCholesky::apply(const double* r, double* z) const {
  for (int i = 0; i < lower_.rows; ++i) {
    const int last = lower_.start[i + 1] - 1;
    double sum = r[i];
    for (int k = lower_.start[i]; k < last; ++k) sum -= lower_.value[k] * z[lower_.column[k]];
    z[i] = sum * lower_.value[last];
  }
  for (int i = lower_.rows - 1; i >= 0; --i) {
    const int last = lower_.start[i + 1] - 1;
    z[i] *= lower_.value[last];
    for (int k = lower_.start[i]; k < last; ++k) z[lower_.column[k]] -= lower_.value[k] * z[i];
  }
}

}  // namespace odeum::linear
