// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <vector>

namespace odeum::tests {

/// What CVODE and ARKODE are given in programs that use them alone: a state, a dense matrix and its
/// solver, of the size of `state`, which must outlive them.
struct SundialsParts {
  explicit SundialsParts(std::vector<double>& state)
      : n(static_cast<sunindextype>(state.size())),
        context(make_context()),
        y(N_VMake_Serial(n, state.data(), context)),
        matrix(SUNDenseMatrix(n, n, context)),
        solver(SUNLinSol_Dense(y, matrix, context)) {}
  ~SundialsParts() {
    SUNLinSolFree(solver);
    SUNMatDestroy(matrix);
    N_VDestroy(y);
    SUNContext_Free(&context);
  }
  SundialsParts(const SundialsParts&) = delete;
  SundialsParts& operator=(const SundialsParts&) = delete;

  static SUNContext make_context() {
    SUNContext made = nullptr;
    SUNContext_Create(nullptr, &made);
    return made;
  }

  sunindextype n;
  SUNContext context;
  N_Vector y;
  SUNMatrix matrix;
  SUNLinearSolver solver;
};

}  // namespace odeum::tests
