// SPDX-License-Identifier: BSD-3-Clause
// ERKStep of SUNDIALS 6.4.1 loses the order of explicit tables whose last node is 1 but whose last
// row is not b; ARKStep keeps it. The library alone; exits 0 while that stands, 1 when not.
//   g++ -std=c++20 sundials_erkstep_fsal.cpp -lsundials_arkode -lsundials_nvecserial
#include <arkode/arkode_arkstep.h>
#include <arkode/arkode_erkstep.h>
#include <nvector/nvector_serial.h>

#include <cmath>
#include <cstdio>

// y' = (-0.5 + 2i) y on (Re, Im), from (1, 0), up to t = 4.
static int rhs(double, N_Vector y, N_Vector dydt, void*) {
  NV_Ith_S(dydt, 0) = -0.5 * NV_Ith_S(y, 0) - 2 * NV_Ith_S(y, 1);
  NV_Ith_S(dydt, 1) = 2 * NV_Ith_S(y, 0) - 0.5 * NV_Ith_S(y, 1);
  return 0;
}

// The classical method of order 4, which the library does not have.
static ARKodeButcherTable rk4() {
  double c[] = {0, 0.5, 0.5, 1}, b[] = {1 / 6., 1 / 3., 1 / 3., 1 / 6.},
         A[] = {0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 1, 0};
  return ARKodeButcherTable_Create(4, 4, 0, c, A, b, nullptr);
}

static double error(ARKodeButcherTable table, bool erkstep, int steps) {
  SUNContext context = nullptr;
  SUNContext_Create(nullptr, &context);
  N_Vector y = N_VNew_Serial(2, context);
  NV_Ith_S(y, 0) = 1;
  NV_Ith_S(y, 1) = 0;
  void* memory =
      erkstep ? ERKStepCreate(rhs, 0, y, context) : ARKStepCreate(rhs, nullptr, 0, y, context);
  if (erkstep) {
    ERKStepSetTable(memory, table);
    ERKStepSetFixedStep(memory, 4.0 / steps);
  } else {
    ARKStepSetTables(memory, table->q, table->p, nullptr, table);
    ARKStepSetFixedStep(memory, 4.0 / steps);
  }
  double t = 0;
  for (int i = 0; i < steps; ++i)
    erkstep ? ERKStepEvolve(memory, 9, y, &t, ARK_ONE_STEP)
            : ARKStepEvolve(memory, 9, y, &t, ARK_ONE_STEP);
  const double result = std::hypot(NV_Ith_S(y, 0) - std::exp(-2) * std::cos(8),
                                   NV_Ith_S(y, 1) - std::exp(-2) * std::sin(8));
  erkstep ? ERKStepFree(&memory) : ARKStepFree(&memory);
  N_VDestroy(y);
  SUNContext_Free(&context);
  return result;
}

int main() {
  const struct {
    ARKodeButcherTable table;
    const char* name;
    int steps;
  } tables[] = {
      {ARKodeButcherTable_LoadERK(ARKODE_ARK324L2SA_ERK_4_2_3), "ARK324L2SA_ERK_4_2_3", 256},
      {ARKodeButcherTable_LoadERK(ARKODE_ARK436L2SA_ERK_6_3_4), "ARK436L2SA_ERK_6_3_4", 256},
      {ARKodeButcherTable_LoadERK(ARKODE_SAYFY_ABURUB_6_3_4), "SAYFY_ABURUB_6_3_4", 256},
      {ARKodeButcherTable_LoadERK(ARKODE_ARK548L2SA_ERK_8_4_5), "ARK548L2SA_ERK_8_4_5", 128},
      {ARKodeButcherTable_LoadERK(ARKODE_VERNER_8_5_6), "VERNER_8_5_6", 64},
      {rk4(), "the classical method", 256}};
  bool stands = true;
  for (const auto& [table, name, steps] : tables) {
    double order[2] = {};
    for (const bool erkstep : {false, true})
      order[erkstep] = std::log2(error(table, erkstep, steps) / error(table, erkstep, 2 * steps));
    std::printf("%-22s claims %d, ARKStep %.2f, ERKStep %.2f\n", name, table->q, order[0],
                order[1]);
    stands = stands && order[0] > table->q - 0.5 && order[1] < table->q - 0.5;
  }
  return stands ? 0 : 1;
}
