// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/linear/sparse_matrix.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "odeum/core/team.hpp"
#include "odeum/linear/sparse_eigen.hpp"

namespace odeum::linear {
namespace {

SparseMatrix from_eigen(const EigenRows& m) {
  const auto entries = m.nonZeros();
  SparseMatrix a;
  a.rows = static_cast<int>(m.rows()), a.columns = static_cast<int>(m.cols());
  a.start.assign(m.outerIndexPtr(), m.outerIndexPtr() + m.rows() + 1);
  a.column.assign(m.innerIndexPtr(), m.innerIndexPtr() + entries);
  a.value.assign(m.valuePtr(), m.valuePtr() + entries);
  return a;
}

}  // namespace

void SparseMatrix::multiply(const double* x, double* y, Team* team) const {
  const auto multiply_rows = [&, x, y](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) {
      double sum = 0;
      for (int k = start[i]; k < start[i + 1]; ++k) sum += value[k] * x[column[k]];
      y[i] = sum;
    }
  };
  if (team)
    team->run(static_cast<std::size_t>(rows), multiply_rows);
  else
    multiply_rows(0, static_cast<std::size_t>(rows));
}

double SparseMatrix::at(int row, int col) const {
  const auto first = column.begin() + start[row], last = column.begin() + start[row + 1];
  const auto found = std::lower_bound(first, last, col);
  return found == last || *found != col ? 0 : value[found - column.begin()];
}

std::vector<double> SparseMatrix::diagonal() const {
  std::vector<double> entries(rows);
  for (int i = 0; i < rows; ++i) entries[i] = at(i, i);
  return entries;
}

SparseMatrix from_triplets(int rows, int columns, const std::vector<Triplet>& triplets) {
  std::vector<Eigen::Triplet<double, int>> entries;
  entries.reserve(triplets.size());
  for (const Triplet& t : triplets) {
    if (t.row < 0 || t.row >= rows || t.column < 0 || t.column >= columns)
      throw std::out_of_range("an entry lies outside of the matrix");
    entries.emplace_back(t.row, t.column, t.value);
  }
  EigenRows m(rows, columns);
  m.setFromTriplets(entries.begin(), entries.end());
  return from_eigen(m);
}

SparseMatrix galerkin_product(const SparseMatrix& a, const SparseMatrix& p) {
  if (a.rows != a.columns || a.rows != p.rows)
    throw std::invalid_argument("the prolongation does not fit the matrix");
  const EigenRows prolongation = eigen_map(p);
  const EigenRows restriction = prolongation.transpose();
  const EigenRows half = eigen_map(a) * prolongation;
  return from_eigen(restriction * half);
}

double residual_norm(const SparseMatrix& a, const std::vector<double>& x,
                     const std::vector<double>& b) {
  std::vector<double> ax(b.size());
  a.multiply(x.data(), ax.data());
  double sum = 0;
  for (std::size_t i = 0; i < b.size(); ++i) sum += (b[i] - ax[i]) * (b[i] - ax[i]);
  return std::sqrt(sum);
}

double energy_norm(const SparseMatrix& a, const std::vector<double>& x) {
  std::vector<double> ax(x.size());
  a.multiply(x.data(), ax.data());
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += x[i] * ax[i];
  return std::sqrt(std::max(0.0, sum));
}

}  // namespace odeum::linear
