// SPDX-License-Identifier: BSD-3-Clause
#include "gsl/linear.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_spblas.h>
#include <gsl/gsl_splinalg.h>
#include <gsl/gsl_spmatrix.h>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace odeum::adapters::gsl {
namespace {

/// gsl_splinalg_itersolve_gmres. It has no preconditioner. Each call of its iteration is a cycle
/// between two restarts.
class Gmres final : public linear::LinearPeer {
 public:
  explicit Gmres(const linear::SparseMatrix& a) : n_(static_cast<std::size_t>(a.rows)) {
    gsl_spmatrix* const triplets =
        gsl_spmatrix_alloc_nzmax(n_, n_, a.value.size(), GSL_SPMATRIX_COO);
    for (int i = 0; i < a.rows; ++i)
      for (int k = a.start[i]; k < a.start[i + 1]; ++k)
        gsl_spmatrix_set(triplets, static_cast<std::size_t>(i),
                         static_cast<std::size_t>(a.column[k]), a.value[k]);
    // Symmetric: columns are rows, and gsl_spblas_dgemv has the better loop for columns of none.
    matrix_ = gsl_spmatrix_compress(triplets, GSL_SPMATRIX_CSR);
    gsl_spmatrix_free(triplets);
  }
  ~Gmres() override { gsl_spmatrix_free(matrix_); }
  Gmres(const Gmres&) = delete;
  Gmres& operator=(const Gmres&) = delete;

  std::size_t solve(const std::vector<double>& b, std::vector<double>& x, double tolerance,
                    std::size_t most_iterations) override {
    const std::size_t vectors = std::min({most_iterations, most_vectors, n_});
    gsl_splinalg_itersolve* const work =
        gsl_splinalg_itersolve_alloc(gsl_splinalg_itersolve_gmres, n_, vectors);
    x.assign(n_, 0);
    const gsl_vector_const_view right = gsl_vector_const_view_array(b.data(), n_);
    gsl_vector_view solution = gsl_vector_view_array(x.data(), n_);
    std::size_t done = 0;
    int status = GSL_CONTINUE;
    while (status == GSL_CONTINUE && done < most_iterations) {
      status =
          gsl_splinalg_itersolve_iterate(matrix_, &right.vector, tolerance, &solution.vector, work);
      done += vectors;
    }
    gsl_splinalg_itersolve_free(work);
    if (status != GSL_SUCCESS && status != GSL_CONTINUE)
      throw std::runtime_error(std::string("GSL: ") + gsl_strerror(status));
    return done;
  }

 private:
  /// Vectors between restarts. GSL's default of 10 takes many times the products: on the 5-point
  /// star of 64 x 64 it does not end. More than this cost more in orthogonalisation than they save.
  static constexpr std::size_t most_vectors = 200;
  std::size_t n_;
  gsl_spmatrix* matrix_ = nullptr;
};

}  // namespace

void add_linear_peers(std::vector<linear::LinearPeerInfo>& peers) {
  peers.push_back({"gsl/gmres", false,
                   [](const linear::SparseMatrix& a) { return std::make_unique<Gmres>(a); }});
}

}  // namespace odeum::adapters::gsl
