// SPDX-License-Identifier: BSD-3-Clause
// ARKODE alone: Van der Pol's oscillator, mu = 1000, by ARKODE_KVAERNO_5_3_4 with the exact
// Jacobian, with the default settings of Newton's iteration and with a matrix at each stage, stage
// derivatives deduced and an extrapolated first iterate. Exits 0 while the defaults take over five
// times the steps of the other settings or fail, at each tolerance.
#include <arkode/arkode_arkstep.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <cstdio>

namespace {

constexpr double mu = 1000;
long evaluations = 0;

int rhs(double, N_Vector y, N_Vector f, void*) {
  const double* const x = NV_DATA_S(y);
  ++evaluations;
  NV_Ith_S(f, 0) = x[1];
  NV_Ith_S(f, 1) = mu * (1 - x[0] * x[0]) * x[1] - x[0];
  return 0;
}

int jacobian(double, N_Vector y, N_Vector, SUNMatrix j, void*, N_Vector, N_Vector, N_Vector) {
  const double* const x = NV_DATA_S(y);
  SM_ELEMENT_D(j, 0, 0) = 0;
  SM_ELEMENT_D(j, 0, 1) = 1;
  SM_ELEMENT_D(j, 1, 0) = -2 * mu * x[0] * x[1] - 1;
  SM_ELEMENT_D(j, 1, 1) = mu * (1 - x[0] * x[0]);
  return 0;
}

void silent(int, const char*, const char*, char*, void*) {}

struct Run {
  int flag;
  long steps;
};

Run solve(double tolerance, bool defaults, SUNContext context) {
  N_Vector y = N_VNew_Serial(2, context), absolute = N_VNew_Serial(2, context);
  NV_Ith_S(y, 0) = 2;
  NV_Ith_S(y, 1) = 0;
  NV_Ith_S(absolute, 0) = tolerance;
  NV_Ith_S(absolute, 1) = 1e-3 * tolerance;
  void* memory = ARKStepCreate(nullptr, rhs, 0, y, context);
  SUNMatrix matrix = SUNDenseMatrix(2, 2, context);
  SUNLinearSolver solver = SUNLinSol_Dense(y, matrix, context);
  ARKStepSetErrHandlerFn(memory, silent, nullptr);
  ARKStepSetTableNum(memory, ARKODE_KVAERNO_5_3_4, ARKODE_ERK_NONE);
  ARKStepSVtolerances(memory, tolerance, absolute);
  ARKStepSetLinearSolver(memory, solver, matrix);
  ARKStepSetJacFn(memory, jacobian);
  ARKStepSetMaxNumSteps(memory, 100'000);
  ARKStepSetStopTime(memory, 2000);
  if (!defaults) {
    ARKStepSetLSetupFrequency(memory, -1);
    ARKStepSetDeduceImplicitRhs(memory, 1);
    ARKStepSetPredictorMethod(memory, 1);
  }
  evaluations = 0;
  double t = 0;
  Run run{};
  run.flag = ARKStepEvolve(memory, 2000, y, &t, ARK_NORMAL);
  ARKStepGetNumSteps(memory, &run.steps);
  std::printf("%.0e %-9s flag %2d, t = %6.1f, %6ld steps, %7ld evaluations\n", tolerance,
              defaults ? "defaults" : "set", run.flag, t, run.steps, evaluations);
  ARKStepFree(&memory);
  SUNLinSolFree(solver);
  SUNMatDestroy(matrix);
  N_VDestroy(y);
  N_VDestroy(absolute);
  return run;
}

}  // namespace

int main() {
  SUNContext context = nullptr;
  SUNContext_Create(nullptr, &context);
  bool stands = true;
  for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6}) {
    const Run as_it_comes = solve(tolerance, true, context);
    const Run set = solve(tolerance, false, context);
    const bool slower = as_it_comes.flag < 0 || as_it_comes.steps > 5 * set.steps;
    stands = stands && set.flag >= 0 && slower;
  }
  SUNContext_Free(&context);
  return stands ? 0 : 1;
}
