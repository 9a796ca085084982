// SPDX-License-Identifier: BSD-3-Clause
// ARKStep's implicit methods of SUNDIALS 6.4.1, with every setting at its default, miss the
// tolerance by orders of magnitude on a linear problem; the same steps with one setting changed do
// not. The library alone; exits 0 while that stands, 1 when not.
//   g++ -std=c++20 sundials_linear_error_control.cpp -lsundials_arkode -lsundials_nvecserial
//       -lsundials_sunlinsoldense -lsundials_sunmatrixdense
#include <arkode/arkode_arkstep.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <cmath>
#include <cstdio>

// y' = (-0.5 + 2i) y on (Re, Im), from (1, 0).
static int rhs(double, N_Vector y, N_Vector dydt, void*) {
  NV_Ith_S(dydt, 0) = -0.5 * NV_Ith_S(y, 0) - 2 * NV_Ith_S(y, 1);
  NV_Ith_S(dydt, 1) = 2 * NV_Ith_S(y, 0) - 0.5 * NV_Ith_S(y, 1);
  return 0;
}
static int jacobian(double, N_Vector, N_Vector, SUNMatrix j, void*, N_Vector, N_Vector, N_Vector) {
  SM_ELEMENT_D(j, 0, 0) = SM_ELEMENT_D(j, 1, 1) = -0.5;
  SM_ELEMENT_D(j, 0, 1) = -2;
  SM_ELEMENT_D(j, 1, 0) = 2;
  return 0;
}

enum Setting { all_default, linear, matrix_each_stage, constant_rate };

// The largest error at any step's end up to t = 4; no interpolation, one stop time.
static double error(ARKODE_DIRKTableID id, double tolerance, Setting setting, long* steps) {
  SUNContext context = nullptr;
  SUNContext_Create(nullptr, &context);
  N_Vector y = N_VNew_Serial(2, context);
  NV_Ith_S(y, 0) = 1;
  NV_Ith_S(y, 1) = 0;
  void* memory = ARKStepCreate(nullptr, rhs, 0, y, context);
  SUNMatrix matrix = SUNDenseMatrix(2, 2, context);
  SUNLinearSolver solver = SUNLinSol_Dense(y, matrix, context);
  ARKStepSStolerances(memory, tolerance, tolerance);
  ARKStepSetTableNum(memory, id, ARKODE_ERK_NONE);
  ARKStepSetLinearSolver(memory, solver, matrix);
  ARKStepSetJacFn(memory, jacobian);
  if (setting == linear) ARKStepSetLinear(memory, 0);
  if (setting == matrix_each_stage) ARKStepSetLSetupFrequency(memory, -1);
  if (setting == constant_rate) ARKStepSetNonlinCRDown(memory, 1);
  ARKStepSetStopTime(memory, 4);
  double t = 0, largest = 0;
  while (t < 4 && ARKStepEvolve(memory, 4, y, &t, ARK_ONE_STEP) >= 0)
    largest = std::fmax(largest, std::hypot(NV_Ith_S(y, 0) - std::exp(-0.5 * t) * std::cos(2 * t),
                                            NV_Ith_S(y, 1) - std::exp(-0.5 * t) * std::sin(2 * t)));
  ARKStepGetNumSteps(memory, steps);
  ARKStepFree(&memory);
  SUNLinSolFree(solver);
  SUNMatDestroy(matrix);
  N_VDestroy(y);
  SUNContext_Free(&context);
  return largest;
}

int main() {
  const struct {
    ARKODE_DIRKTableID id;
    const char* name;
    double tolerance;
  } runs[] = {{ARKODE_ARK436L2SA_DIRK_6_3_4, "ARK436L2SA_DIRK_6_3_4", 1e-6},
              {ARKODE_SDIRK_5_3_4, "SDIRK_5_3_4", 1e-9},
              {ARKODE_ESDIRK547L2SA2_7_4_5, "ESDIRK547L2SA2_7_4_5", 1e-7}};
  bool stands = true;
  for (const auto& run : runs) {
    double e[4] = {};
    long steps[4] = {};
    for (const Setting s : {all_default, linear, matrix_each_stage, constant_rate})
      e[s] = error(run.id, run.tolerance, s, &steps[s]);
    std::printf(
        "%-22s tol %.0e: default %.1e (%ld steps), SetLinear %.1e (%ld), "
        "SetLSetupFrequency(-1) %.1e (%ld), SetNonlinCRDown(1) %.1e (%ld)\n",
        run.name, run.tolerance, e[0], steps[0], e[1], steps[1], e[2], steps[2], e[3], steps[3]);
    stands = stands && e[all_default] > 20 * e[linear] && e[linear] < 10 * run.tolerance &&
             e[matrix_each_stage] < 2 * e[linear] && e[constant_rate] < 2 * e[linear];
  }
  return stands ? 0 : 1;
}
