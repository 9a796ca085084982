// SPDX-License-Identifier: BSD-3-Clause
// CVODE alone: a right-hand side that is NaN after t = 0.5, integrated to t = 1. No NaN is
// returned, but no error test can pass either: every step allowed is taken at t = 0.5. Exits 0
// while both families end with CV_TOO_MUCH_WORK there.
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <limits>

namespace {

long evaluations = 0;

int rhs(double t, N_Vector y, N_Vector dydt, void*) {
  ++evaluations;
  NV_Ith_S(dydt, 0) = t > 0.5 ? std::numeric_limits<double>::quiet_NaN() : -NV_Ith_S(y, 0);
  return 0;
}

void silent(int, const char*, const char*, char*, void*) {}

}  // namespace

int main() {
  SUNContext context = nullptr;
  SUNContext_Create(nullptr, &context);
  bool stands = true;
  for (const int family : {CV_ADAMS, CV_BDF}) {
    N_Vector y = N_VNew_Serial(1, context);
    NV_Ith_S(y, 0) = 1;
    SUNMatrix matrix = SUNDenseMatrix(1, 1, context);
    SUNLinearSolver solver = SUNLinSol_Dense(y, matrix, context);
    void* memory = CVodeCreate(family, context);
    CVodeInit(memory, rhs, 0, y);
    CVodeSetErrHandlerFn(memory, silent, nullptr);
    CVodeSStolerances(memory, 1e-6, 1e-6);
    CVodeSetLinearSolver(memory, solver, matrix);
    CVodeSetMaxNumSteps(memory, 10'000);
    evaluations = 0;
    double t = 0;
    const int flag = CVode(memory, 1, y, &t, CV_NORMAL);
    std::printf("%s flag %d at t = %g with y = %g, %ld evaluations\n",
                family == CV_BDF ? "BDF  " : "Adams", flag, t, NV_Ith_S(y, 0), evaluations);
    stands = stands && flag == CV_TOO_MUCH_WORK && std::abs(t - 0.5) < 1e-3;
    CVodeFree(&memory);
    SUNLinSolFree(solver);
    SUNMatDestroy(matrix);
    N_VDestroy(y);
  }
  SUNContext_Free(&context);
  return stands ? 0 : 1;
}
