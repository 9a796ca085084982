// SPDX-License-Identifier: BSD-3-Clause
#include <arkode/arkode_arkstep.h>
#include <cvode/cvode.h>

#include "adapters/alone.hpp"
#include "support/sundials_parts.hpp"

namespace odeum::test::sundials_alone_test {
namespace {

int rhs(double t, N_Vector y, N_Vector f, void* view) {
  const auto& ode = *static_cast<const OdeView*>(view);
  ode.rhs(ode.problem, t, NV_DATA_S(y), NV_DATA_S(f));
  return 0;
}

int jacobian(double t, N_Vector y, N_Vector, SUNMatrix matrix, void* view, N_Vector, N_Vector,
             N_Vector) {
  const auto& ode = *static_cast<const OdeView*>(view);
  const auto n = static_cast<sunindextype>(ode.dimension);
  std::vector<double> rows(ode.dimension * ode.dimension);
  ode.jacobian(ode.problem, t, NV_DATA_S(y), rows.data());
  for (sunindextype i = 0; i < n; ++i)
    for (sunindextype j = 0; j < n; ++j)
      SM_ELEMENT_D(matrix, i, j) = rows[static_cast<std::size_t>(i * n + j)];
  return 0;
}

void silent(int, const char*, const char*, char*, void*) {}

constexpr long most_steps = 5'000;

bool cvode_bdf(const Case& c, double tolerance, std::vector<double>& state) {
  tests::SundialsParts parts(state);
  OdeView view = c.problem.view;
  void* memory = CVodeCreate(CV_BDF, parts.context);
  CVodeInit(memory, rhs, c.t0, parts.y);
  CVodeSetErrHandlerFn(memory, silent, nullptr);
  CVodeSetUserData(memory, &view);
  CVodeSStolerances(memory, tolerance, tolerance);
  CVodeSetLinearSolver(memory, parts.solver, parts.matrix);
  CVodeSetJacFn(memory, jacobian);
  CVodeSetMaxNumSteps(memory, most_steps);
  CVodeSetStopTime(memory, c.stops.back());
  double t = c.t0;
  int flag = 0;
  for (std::size_t k = 0; k < c.stops.size() && flag >= 0; ++k)
    flag = CVode(memory, c.stops[k], parts.y, &t, CV_NORMAL);
  CVodeFree(&memory);
  return flag >= 0;
}

/// With the settings that the adapter uses, written again here: the defaults solve little.
bool arkode_kvaerno(const Case& c, double tolerance, std::vector<double>& state) {
  tests::SundialsParts parts(state);
  OdeView view = c.problem.view;
  void* memory = ARKStepCreate(nullptr, rhs, c.t0, parts.y, parts.context);
  ARKStepSetErrHandlerFn(memory, silent, nullptr);
  ARKStepSetUserData(memory, &view);
  ARKStepSetTableNum(memory, ARKODE_KVAERNO_5_3_4, ARKODE_ERK_NONE);
  ARKStepSStolerances(memory, tolerance, tolerance);
  ARKStepSetLinearSolver(memory, parts.solver, parts.matrix);
  ARKStepSetJacFn(memory, jacobian);
  ARKStepSetLSetupFrequency(memory, -1);
  ARKStepSetDeduceImplicitRhs(memory, 1);
  ARKStepSetMaxNumSteps(memory, most_steps);
  double t = c.t0;
  int flag = 0;
  for (std::size_t k = 0; k < c.stops.size() && flag >= 0; ++k) {
    ARKStepSetStopTime(memory, c.stops[k]);
    flag = ARKStepEvolve(memory, c.stops[k], parts.y, &t, ARK_NORMAL);
  }
  ARKStepFree(&memory);
  return flag >= 0;
}

TEST(SundialsAlone, CvodeFailsNowhereElse) { expect_no_worse_than_alone("cvode/bdf", cvode_bdf); }

TEST(SundialsAlone, ArkodeFailsNowhereElse) {
  expect_no_worse_than_alone("arkode/arkstep_kvaerno_5_3_4", arkode_kvaerno);
}

TEST(SundialsAlone, EachHardCaseIsSolved) {
  expect_each_case_solved("cvode");
  expect_each_case_solved("arkode");
}

}  // namespace
}  // namespace odeum::test::sundials_alone_test
