// SPDX-License-Identifier: BSD-3-Clause
// ERKStep and ARKStep alone with ARKODE_HEUN_EULER_2_1_2 at a fixed step on y' = -z y, h = 1: the
// largest z at which 400 steps do not grow. The method's limit on the real axis is 2. Exits 0 while
// ARKStep has it and ERKStep has half of it.
#include <arkode/arkode_arkstep.h>
#include <arkode/arkode_erkstep.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>

#include <cmath>
#include <cstdio>

namespace {

int rhs(double, N_Vector y, N_Vector dydt, void* z) {
  NV_Ith_S(dydt, 0) = -*static_cast<double*>(z) * NV_Ith_S(y, 0);
  return 0;
}

bool grows(bool erkstep, double z, SUNContext context) {
  N_Vector y = N_VNew_Serial(1, context);
  NV_Ith_S(y, 0) = 1;
  void* memory =
      erkstep ? ERKStepCreate(rhs, 0, y, context) : ARKStepCreate(rhs, nullptr, 0, y, context);
  if (erkstep) {
    ERKStepSetTableNum(memory, ARKODE_HEUN_EULER_2_1_2);
    ERKStepSetFixedStep(memory, 1);
    ERKStepSetUserData(memory, &z);
  } else {
    ARKStepSetTableNum(memory, ARKODE_DIRK_NONE, ARKODE_HEUN_EULER_2_1_2);
    ARKStepSetFixedStep(memory, 1);
    ARKStepSetUserData(memory, &z);
  }
  double t = 0;
  for (int i = 0; i < 400; ++i)
    erkstep ? ERKStepEvolve(memory, 1000, y, &t, ARK_ONE_STEP)
            : ARKStepEvolve(memory, 1000, y, &t, ARK_ONE_STEP);
  const bool grown = !(std::abs(NV_Ith_S(y, 0)) <= 1);
  erkstep ? ERKStepFree(&memory) : ARKStepFree(&memory);
  N_VDestroy(y);
  return grown;
}

double limit(bool erkstep, SUNContext context) {
  double stable = 0.1, unstable = 4;
  while (unstable - stable > 1e-4) {
    const double middle = (stable + unstable) / 2;
    (grows(erkstep, middle, context) ? unstable : stable) = middle;
  }
  return stable;
}

}  // namespace

int main() {
  SUNContext context = nullptr;
  SUNContext_Create(nullptr, &context);
  const double by_arkstep = limit(false, context), by_erkstep = limit(true, context);
  std::printf("limit on the real axis: ARKStep %.3f, ERKStep %.3f\n", by_arkstep, by_erkstep);
  SUNContext_Free(&context);
  // A start that grows before it decays is within 400 steps for the last per cent of the range.
  return std::abs(by_arkstep - 2) < 0.02 && std::abs(by_erkstep - 1) < 0.02 ? 0 : 1;
}
