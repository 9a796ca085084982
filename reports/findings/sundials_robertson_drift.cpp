// SPDX-License-Identifier: BSD-3-Clause
// CVODE alone, set up as in its example cvRoberts_dns: Robertson's reactions to t = 4e11, BDF,
// dense matrix, exact Jacobian, one tolerance for all or an absolute one a millionth of it for the
// second component. Exits 0 while some run returns success with a concentration below -1e7.
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <cstdio>
#include <initializer_list>

namespace {

int rhs(double, N_Vector state, N_Vector dydt, void*) {
  const double* const y = NV_DATA_S(state);
  const double first = 0.04 * y[0], second = 3e7 * y[1] * y[1], third = 1e4 * y[1] * y[2];
  NV_Ith_S(dydt, 0) = -first + third;
  NV_Ith_S(dydt, 1) = first - third - second;
  NV_Ith_S(dydt, 2) = second;
  return 0;
}

int jacobian(double, N_Vector state, N_Vector, SUNMatrix j, void*, N_Vector, N_Vector, N_Vector) {
  const double* const y = NV_DATA_S(state);
  const double rows[3][3] = {{-0.04, 1e4 * y[2], 1e4 * y[1]},
                             {0.04, -1e4 * y[2] - 6e7 * y[1], -1e4 * y[1]},
                             {0, 6e7 * y[1], 0}};
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) SM_ELEMENT_D(j, row, column) = rows[row][column];
  return 0;
}

void silent(int, const char*, const char*, char*, void*) {}

}  // namespace

int main() {
  SUNContext context = nullptr;
  SUNContext_Create(nullptr, &context);
  bool stands = false;
  for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10}) {
    for (const bool scaled : {false, true}) {
      N_Vector y = N_VNew_Serial(3, context), absolute = N_VNew_Serial(3, context);
      for (int i = 0; i < 3; ++i) {
        NV_Ith_S(y, i) = i == 0;
        NV_Ith_S(absolute, i) = scaled && i == 1 ? 1e-6 * tolerance : tolerance;
      }
      SUNMatrix matrix = SUNDenseMatrix(3, 3, context);
      SUNLinearSolver solver = SUNLinSol_Dense(y, matrix, context);
      void* memory = CVodeCreate(CV_BDF, context);
      CVodeInit(memory, rhs, 0, y);
      CVodeSetErrHandlerFn(memory, silent, nullptr);
      CVodeSVtolerances(memory, tolerance, absolute);
      CVodeSetLinearSolver(memory, solver, matrix);
      CVodeSetJacFn(memory, jacobian);
      CVodeSetMaxNumSteps(memory, 10'000);
      CVodeSetStopTime(memory, 4e11);
      double t = 0;
      int flag = 0;
      for (double stop = 0.4; stop < 5e11 && flag >= 0; stop *= 10)
        flag = CVode(memory, stop, y, &t, CV_NORMAL);
      long steps = 0;
      CVodeGetNumSteps(memory, &steps);
      std::printf("%.0e %-6s flag %2d at t = %.3g, %5ld steps, y1 = %10.3g (exact 5.2e-9)\n",
                  tolerance, scaled ? "scaled" : "", flag, t, steps, NV_Ith_S(y, 0));
      stands = stands || (flag >= 0 && NV_Ith_S(y, 0) < -1e7);
      CVodeFree(&memory);
      SUNLinSolFree(solver);
      SUNMatDestroy(matrix);
      N_VDestroy(absolute);
      N_VDestroy(y);
    }
  }
  SUNContext_Free(&context);
  return stands ? 0 : 1;
}
