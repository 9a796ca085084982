// SPDX-License-Identifier: BSD-3-Clause
// IDA on the transistor amplifier of the Test Set for IVP Solvers: from a tolerance of 1e-7 down
// nearly every second step fails the error test. The library alone, its own difference quotients.
//   g++ sundials_ida_transistor.cpp -lsundials_ida -lsundials_nvecserial -lsundials_sunmatrixdense
//       -lsundials_sunlinsoldense
#include <ida/ida.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <cmath>
#include <cstdio>
#include <initializer_list>

namespace {

int residual(double t, N_Vector state, N_Vector rates, N_Vector values, void*) {
  const double *y = NV_DATA_S(state), *p = NV_DATA_S(rates);
  double* r = NV_DATA_S(values);
  const double c = 1e-6, u = 6, k = 9000, a = 0.99, ue = 0.1 * std::sin(200 * M_PI * t);
  const double g1 = 1e-6 * (std::exp((y[1] - y[2]) / 0.026) - 1),
               g2 = 1e-6 * (std::exp((y[4] - y[5]) / 0.026) - 1);
  r[0] = c * (p[1] - p[0]) + ue / 1000 - y[0] / 1000;
  r[1] = c * (p[0] - p[1]) + u / k - 2 * y[1] / k + (a - 1) * g1;
  r[2] = -2 * c * p[2] + g1 - y[2] / k;
  r[3] = 3 * c * (p[4] - p[3]) + u / k - y[3] / k - a * g1;
  r[4] = 3 * c * (p[3] - p[4]) + u / k - 2 * y[4] / k + (a - 1) * g2;
  r[5] = -4 * c * p[5] + g2 - y[5] / k;
  r[6] = 5 * c * (p[7] - p[6]) + u / k - y[6] / k - a * g2;
  r[7] = 5 * c * (p[6] - p[7]) - y[7] / k;
  return 0;
}

}  // namespace

int main() {
  bool holds = true;
  for (const double tolerance : {1e-6, 1e-7, 1e-8}) {
    SUNContext context = nullptr;
    SUNContext_Create(nullptr, &context);
    N_Vector y = N_VNew_Serial(8, context), p = N_VNew_Serial(8, context);
    const double y0[] = {0, 3, 3, 6, 3, 3, 6, 0};
    const double p0[] = {51.3392765,  51.3392765,  -166.666667, -24.9703285,
                         -24.9703285, -83.3333333, -10.0002764, -10.0002764};
    for (int i = 0; i < 8; ++i) NV_Ith_S(y, i) = y0[i], NV_Ith_S(p, i) = p0[i];
    void* ida = IDACreate(context);
    IDAInit(ida, residual, 0, y, p);
    IDASStolerances(ida, tolerance, tolerance);
    SUNMatrix matrix = SUNDenseMatrix(8, 8, context);
    SUNLinearSolver solver = SUNLinSol_Dense(y, matrix, context);
    IDASetLinearSolver(ida, solver, matrix);
    IDASetMaxNumSteps(ida, -1);
    IDASetStopTime(ida, 0.2);
    double t = 0;
    const int flag = IDASolve(ida, 0.2, &t, y, p, IDA_NORMAL);
    long steps = 0, failures = 0;
    IDAGetNumSteps(ida, &steps);
    IDAGetNumErrTestFails(ida, &failures);
    std::printf("tolerance %g: flag %d, %ld steps, %ld failed the error test\n", tolerance, flag,
                steps, failures);
    if (tolerance < 1e-6) holds = holds && 2 * failures > steps;
    IDAFree(&ida);
    SUNLinSolFree(solver);
    SUNMatDestroy(matrix);
    N_VDestroy(y);
    N_VDestroy(p);
    SUNContext_Free(&context);
  }
  return holds ? 0 : 1;
}
