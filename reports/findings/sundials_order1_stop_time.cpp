// SPDX-License-Identifier: BSD-3-Clause
// ERKStep of SUNDIALS 6.4.1 with a table of order 1 returns the mean of the last two states at a
// stop time. The library alone; exits 0 while that stands, 1 when not.
//   g++ -std=c++20 sundials_order1_stop_time.cpp -lsundials_arkode -lsundials_nvecserial
#include <arkode/arkode_erkstep.h>
#include <nvector/nvector_serial.h>

#include <cmath>
#include <cstdio>

static int one(double, N_Vector, N_Vector dydt, void*) {
  NV_Ith_S(dydt, 0) = 1;  // y = t, which Euler's method follows without error
  return 0;
}

int main() {
  SUNContext context = nullptr;
  SUNContext_Create(nullptr, &context);
  N_Vector y = N_VNew_Serial(1, context);
  NV_Ith_S(y, 0) = 0;
  double c = 0, a = 0, b = 1;
  ARKodeButcherTable euler = ARKodeButcherTable_Create(1, 1, 0, &c, &a, &b, nullptr);
  void* memory = ERKStepCreate(one, 0, y, context);
  ERKStepSetTable(memory, euler);
  ERKStepSetFixedStep(memory, 0.25);
  ERKStepSetStopTime(memory, 1);
  double t = 0;
  while (t < 1 && ERKStepEvolve(memory, 1, y, &t, ARK_ONE_STEP) >= 0)
    std::printf("y(%g) = %g\n", t, NV_Ith_S(y, 0));
  const bool stands = std::abs(NV_Ith_S(y, 0) - 0.875) < 1e-12;
  ERKStepFree(&memory);
  ARKodeButcherTable_Free(euler);
  N_VDestroy(y);
  SUNContext_Free(&context);
  return stands ? 0 : 1;
}
