// SPDX-License-Identifier: BSD-3-Clause
#include "sundials/linear.hpp"

#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunlinsol/sunlinsol_pcg.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "odeum/linear/preconditioners.hpp"
#include "sundials/handles.hpp"

namespace odeum::adapters::sundials {
namespace {

/// SUNLinSol_PCG. The library leaves the preconditioner to its user: `pcg_ic0` has the own
/// incomplete Cholesky factor.
class Gradients final : public linear::LinearPeer {
 public:
  Gradients(const linear::SparseMatrix& a, std::unique_ptr<linear::Preconditioner> m)
      : a_(a), m_(std::move(m)) {
    if (SUNContext_Create(nullptr, &context_) != 0)
      throw std::runtime_error("SUNDIALS: no context");
    x_.reset(N_VNew_Serial(a.rows, context_));
    b_.reset(N_VNew_Serial(a.rows, context_));
    solver_.reset(SUNLinSol_PCG(x_.get(), m_ ? SUN_PREC_LEFT : SUN_PREC_NONE, 0, context_));
    SUNLinSolSetATimes(solver_.get(), this, [](void* self, N_Vector v, N_Vector z) {
      static_cast<Gradients*>(self)->a_.multiply(NV_DATA_S(v), NV_DATA_S(z));
      return 0;
    });
    if (m_)
      SUNLinSolSetPreconditioner(
          solver_.get(), this, nullptr, [](void* self, N_Vector r, N_Vector z, realtype, int) {
            static_cast<Gradients*>(self)->m_->apply(NV_DATA_S(r), NV_DATA_S(z));
            return 0;
          });
    SUNLinSolInitialize(solver_.get());
  }
  ~Gradients() override {
    solver_.reset(), x_.reset(), b_.reset();
    SUNContext_Free(&context_);
  }
  Gradients(const Gradients&) = delete;
  Gradients& operator=(const Gradients&) = delete;

  std::size_t solve(const std::vector<double>& b, std::vector<double>& x, double tolerance,
                    std::size_t most_iterations) override {
    std::ranges::copy(b, NV_DATA_S(b_.get()));
    N_VConst(0, x_.get());
    SUNLinSol_PCGSetMaxl(solver_.get(), static_cast<int>(std::min<std::size_t>(
                                            most_iterations, std::numeric_limits<int>::max())));
    SUNLinSolSetZeroGuess(solver_.get(), 1);
    if (SUNLinSolSetup(solver_.get(), nullptr) != 0)
      throw std::runtime_error("SUNDIALS: no set-up");
    const double size = std::sqrt(N_VDotProd(b_.get(), b_.get()));
    const int flag = SUNLinSolSolve(solver_.get(), nullptr, x_.get(), b_.get(), tolerance * size);
    // What did not reach the tolerance is told by the residual.
    if (flag != SUNLS_SUCCESS && flag != SUNLS_RES_REDUCED && flag != SUNLS_CONV_FAIL)
      throw std::runtime_error("SUNDIALS' PCG ended with flag " + std::to_string(flag));
    x.assign(NV_DATA_S(x_.get()), NV_DATA_S(x_.get()) + b.size());
    return static_cast<std::size_t>(SUNLinSolNumIters(solver_.get()));
  }

 private:
  const linear::SparseMatrix& a_;
  std::unique_ptr<linear::Preconditioner> m_;
  SUNContext context_ = nullptr;
  Vector x_, b_;
  LinearSolver solver_;
};

}  // namespace

void add_linear_peers(std::vector<linear::LinearPeerInfo>& peers) {
  peers.push_back({"sundials/pcg", false, [](const linear::SparseMatrix& a) {
                     return std::make_unique<Gradients>(a, nullptr);
                   }});
  peers.push_back({"sundials/pcg_ic0", false, [](const linear::SparseMatrix& a) {
                     return std::make_unique<Gradients>(
                         a, std::make_unique<linear::IncompleteCholesky>(a));
                   }});
}

}  // namespace odeum::adapters::sundials
