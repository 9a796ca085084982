// SPDX-License-Identifier: BSD-3-Clause
// CVODE 6.4.1 at a constant step (init = min = max step) never leaves order 1, for any maximal
// order. The library alone; exits 0 while that stands, 1 when not.
//   g++ -std=c++20 sundials_cvode_held_order.cpp -lsundials_cvode -lsundials_nvecserial
//       -lsundials_sunlinsoldense -lsundials_sunmatrixdense
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

// y' = -2 t y^2, y(0) = 1: y(2) = 1/5.
static int rhs(double t, N_Vector y, N_Vector dydt, void*) {
  NV_Ith_S(dydt, 0) = -2 * t * NV_Ith_S(y, 0) * NV_Ith_S(y, 0);
  return 0;
}

// Returns the error at t = 2, and the highest order that CVODE says it chose and that it used.
static double error(int steps, double tolerance, int* chosen, int* used) {
  SUNContext context = nullptr;
  SUNContext_Create(nullptr, &context);
  N_Vector y = N_VNew_Serial(1, context);
  NV_Ith_S(y, 0) = 1;
  void* memory = CVodeCreate(CV_BDF, context);
  CVodeInit(memory, rhs, 0, y);
  SUNMatrix matrix = SUNDenseMatrix(1, 1, context);
  SUNLinearSolver solver = SUNLinSol_Dense(y, matrix, context);
  CVodeSetLinearSolver(memory, solver, matrix);
  const double h = 2.0 / steps;
  CVodeSStolerances(memory, tolerance, tolerance);
  CVodeSetNonlinConvCoef(memory, 1e-13 / tolerance);
  CVodeSetMaxNonlinIters(memory, 50);
  CVodeSetInitStep(memory, h);
  CVodeSetMaxStep(memory, h);
  CVodeSetMinStep(memory, h * (1 - 1e-12));
  CVodeSetMaxOrd(memory, 5);
  double t = 0;
  *chosen = *used = 0;
  int flag = 0, order = 0;
  for (int i = 0; i < steps && flag >= 0; ++i) {
    flag = CVode(memory, 9, y, &t, CV_ONE_STEP);
    CVodeGetLastOrder(memory, &order);
    *used = std::max(*used, order);
    CVodeGetCurrentOrder(memory, &order);
    *chosen = std::max(*chosen, order);
  }
  const double result = std::abs(NV_Ith_S(y, 0) - 0.2);
  CVodeFree(&memory);
  SUNLinSolFree(solver);
  SUNMatDestroy(matrix);
  N_VDestroy(y);
  SUNContext_Free(&context);
  return result;
}

int main() {
  bool stands = true;
  for (const double tolerance :
       {1e6, 1e-2}) {  // one that every step meets by far, one that is just met
    int chosen = 0, used = 0;
    const double coarse = error(400, tolerance, &chosen, &used);
    const double fine = error(800, tolerance, &chosen, &used);
    const double measured = std::log2(coarse / fine);
    std::printf("tolerance %.0e, maximal order 5: order chosen up to %d, order %.2f measured\n",
                tolerance, chosen, measured);
    stands = stands && measured > 0.9 && measured < 1.1;
  }
  return stands ? 0 : 1;
}
