// SPDX-License-Identifier: BSD-3-Clause
#include "cholmod/linear.hpp"

#include <cholmod.h>

#include <algorithm>
#include <stdexcept>

namespace odeum::adapters::cholmod {
namespace {

/// cholmod_solve with a factor by its own choice of ordering, and of supernodes or none, as its
/// user guide recommends.
class Factor final : public linear::LinearPeer {
 public:
  explicit Factor(const linear::SparseMatrix& a) {
    cholmod_start(&common_);
    common_.print = 0;
    // One that solves with L L^T and refuses what is not positive definite, also where the factor
    // is L D L^T.
    common_.final_ll = 1;
    // A symmetric matrix has the same arrays by rows and by columns.
    cholmod_sparse view{};
    view.nrow = view.ncol = static_cast<std::size_t>(a.rows);
    view.nzmax = a.value.size();
    view.p = const_cast<int*>(a.start.data());
    view.i = const_cast<int*>(a.column.data());
    view.x = const_cast<double*>(a.value.data());
    view.stype = 1;  // the upper triangle counts
    view.itype = CHOLMOD_INT, view.xtype = CHOLMOD_REAL, view.dtype = CHOLMOD_DOUBLE;
    view.sorted = view.packed = 1;
    factor_ = cholmod_analyze(&view, &common_);
    if (factor_) cholmod_factorize(&view, factor_, &common_);
    const int status = common_.status;
    if (!factor_ || status != CHOLMOD_OK) {
      release();
      throw std::invalid_argument(status == CHOLMOD_NOT_POSDEF
                                      ? "the matrix is not positive definite"
                                      : "CHOLMOD's status is " + std::to_string(status));
    }
  }
  ~Factor() override { release(); }
  Factor(const Factor&) = delete;
  Factor& operator=(const Factor&) = delete;

  std::size_t solve(const std::vector<double>& b, std::vector<double>& x, double,
                    std::size_t) override {
    cholmod_dense right{};
    right.nrow = right.nzmax = right.d = b.size(), right.ncol = 1;
    right.x = const_cast<double*>(b.data());
    right.xtype = CHOLMOD_REAL, right.dtype = CHOLMOD_DOUBLE;
    if (!cholmod_solve2(CHOLMOD_A, factor_, &right, nullptr, &solution_, nullptr, &work_, &more_,
                        &common_))
      throw std::runtime_error("CHOLMOD's status is " + std::to_string(common_.status));
    const auto* const found = static_cast<const double*>(solution_->x);
    x.assign(found, found + b.size());
    return 0;
  }

 private:
  void release() {
    cholmod_free_dense(&solution_, &common_);
    cholmod_free_dense(&work_, &common_);
    cholmod_free_dense(&more_, &common_);
    cholmod_free_factor(&factor_, &common_);
    cholmod_finish(&common_);
  }
  cholmod_common common_{};
  cholmod_factor* factor_ = nullptr;
  cholmod_dense *solution_ = nullptr, *work_ = nullptr, *more_ = nullptr;
};

}  // namespace

void add_linear_peers(std::vector<linear::LinearPeerInfo>& peers) {
  peers.push_back({"cholmod/cholesky", true,
                   [](const linear::SparseMatrix& a) { return std::make_unique<Factor>(a); }});
}

}  // namespace odeum::adapters::cholmod
