// SPDX-License-Identifier: BSD-3-Clause
#include <arkode/arkode_arkstep.h>
#include <cvode/cvode.h>
#include <cvode/cvode_ls.h>

#include "bench/peers/peers.hpp"
#include "support/sundials_parts.hpp"

namespace odeum::peers {
namespace {

int rhs(double t, N_Vector y, N_Vector f, void* data) {
  return static_cast<Counted*>(data)->rhs(t, NV_DATA_S(y), NV_DATA_S(f)) ? 0 : -1;
}

int jacobian(double t, N_Vector y, N_Vector, SUNMatrix matrix, void* data, N_Vector, N_Vector,
             N_Vector) {
  const OdeView& ode = static_cast<Counted*>(data)->view;
  double rows[64];
  ode.jacobian(ode.problem, t, NV_DATA_S(y), rows);
  const std::size_t n = ode.dimension;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) SUNDenseMatrix_Data(matrix)[j * n + i] = rows[i * n + j];
  return 0;
}

void silent(int, const char*, const char*, char*, void*) {}

using Set = std::function<void(void* integrator)>;

/// lands: on each stop of the case, as where a stop time is set for it; otherwise those before the
/// last are interpolated.
Alternative cvode(const char* setting, const Set& set, bool taken = false, bool lands = false) {
  return {setting, taken, [set, lands](const Case& c, double tolerance, Counted& counted) {
            Run run{.y = c.y0};
            tests::SundialsParts parts(run.y);
            void* memory = CVodeCreate(CV_BDF, parts.context);
            CVodeInit(memory, rhs, c.t0, parts.y);
            CVodeSetErrHandlerFn(memory, silent, nullptr);
            CVodeSetUserData(memory, &counted);
            CVodeSStolerances(memory, tolerance, tolerance);
            CVodeSetLinearSolver(memory, parts.solver, parts.matrix);
            CVodeSetJacFn(memory, jacobian);
            CVodeSetMaxNumSteps(memory, -1);
            CVodeSetStopTime(memory, c.stops.back());
            set(memory);
            int flag = 0;
            double t = c.t0;
            for (std::size_t k = 0; k < c.stops.size() && flag >= 0; ++k) {
              if (lands) CVodeSetStopTime(memory, c.stops[k]);
              flag = CVode(memory, c.stops[k], parts.y, &t, CV_NORMAL);
            }
            CVodeGetNumSteps(memory, &run.steps);
            CVodeFree(&memory);
            run.ok = flag >= 0;
            return run;
          }};
}

Alternative arkstep(ARKODE_DIRKTableID table, const char* setting, const Set& set,
                    bool taken = false) {
  return {setting, taken, [table, set](const Case& c, double tolerance, Counted& counted) {
            Run run{.y = c.y0};
            tests::SundialsParts parts(run.y);
            void* memory = ARKStepCreate(nullptr, rhs, c.t0, parts.y, parts.context);
            ARKStepSetErrHandlerFn(memory, silent, nullptr);
            ARKStepSetUserData(memory, &counted);
            ARKStepSetInterpolantType(memory, ARK_INTERP_LAGRANGE);
            ARKStepSetInterpolantDegree(memory, 1);
            ARKStepSetTableNum(memory, table, ARKODE_ERK_NONE);
            ARKStepSStolerances(memory, tolerance, tolerance);
            ARKStepSetLinearSolver(memory, parts.solver, parts.matrix);
            ARKStepSetJacFn(memory, jacobian);
            ARKStepSetMaxNumSteps(memory, -1);
            set(memory);
            int flag = 0;
            double t = c.t0;
            for (std::size_t k = 0; k < c.stops.size() && flag >= 0; ++k) {
              ARKStepSetStopTime(memory, c.stops[k]);
              flag = ARKStepEvolve(memory, c.stops[k], parts.y, &t, ARK_NORMAL);
            }
            ARKStepGetNumSteps(memory, &run.steps);
            ARKStepFree(&memory);
            run.ok = flag >= 0;
            return run;
          }};
}

void nothing(void*) {}

Choice cvode_newton() {
  return {"CVODE, BDF",
          "Newton's iteration",
          "CVODE 6.4.1 user guide, Optional input functions, Linear solver interface: "
          "CVodeSetLSetupFrequency has the default 20, CVodeSetJacEvalFrequency 51, "
          "CVodeSetNonlinConvCoef 0.1. It recommends no other values.",
          {cvode("defaults", nothing),
           cvode(
               "SetJacEvalFrequency(1): Jacobian at each setup",
               [](void* m) { CVodeSetJacEvalFrequency(m, 1); }, true),
           cvode("SetJacEvalFrequency(10)", [](void* m) { CVodeSetJacEvalFrequency(m, 10); }),
           cvode("SetLSetupFrequency(5), SetJacEvalFrequency(1)",
                 [](void* m) {
                   CVodeSetLSetupFrequency(m, 5);
                   CVodeSetJacEvalFrequency(m, 1);
                 }),
           cvode("SetLSetupFrequency(1), SetJacEvalFrequency(1)",
                 [](void* m) {
                   CVodeSetLSetupFrequency(m, 1);
                   CVodeSetJacEvalFrequency(m, 1);
                 }),
           cvode("SetNonlinConvCoef(0.01)", [](void* m) { CVodeSetNonlinConvCoef(m, 0.01); }),
           cvode("SetNonlinConvCoef(0.3)", [](void* m) { CVodeSetNonlinConvCoef(m, 0.3); }),
           cvode("SetMaxOrd(4)", [](void* m) { CVodeSetMaxOrd(m, 4); }),
           cvode("a stop time at each stop", nothing, false, true)}};
}

Choice arkstep_newton(const char* name, ARKODE_DIRKTableID table) {
  const auto each_stage = [](void* m) { ARKStepSetLSetupFrequency(m, -1); };
  const auto deduced = [](void* m) { ARKStepSetDeduceImplicitRhs(m, 1); };
  const auto predicted = [](void* m) { ARKStepSetPredictorMethod(m, 1); };
  return {
      std::string("ARKODE, ARKStep ") + name,
      "Newton's iteration",
      "ARKODE 5.4.1 user guide, ARKStep User-callable functions, Optional inputs: "
      "ARKStepSetLSetupFrequency has the default 20 (a negative value: a setup at each stage), "
      "ARKStepSetDeduceImplicitRhs is off, ARKStepSetPredictorMethod is 0 (trivial). It recommends "
      "no other values.",
      {arkstep(table, "defaults", nothing),
       arkstep(table, "SetLSetupFrequency(-1): a matrix at each stage", each_stage),
       arkstep(table, "SetDeduceImplicitRhs(1)", deduced),
       arkstep(table, "matrix at each stage, deduced", [=](void* m) { each_stage(m), deduced(m); }),
       arkstep(
           table, "matrix at each stage, deduced, predictor 1",
           [=](void* m) { each_stage(m), deduced(m), predicted(m); }, true),
       arkstep(table, "the same with SetNonlinConvCoef(0.03)",
               [=](void* m) {
                 each_stage(m), deduced(m), predicted(m);
                 ARKStepSetNonlinConvCoef(m, 0.03);
               }),
       arkstep(table, "the same with a matrix and Jacobian at each step instead", [=](void* m) {
         deduced(m), predicted(m);
         ARKStepSetLSetupFrequency(m, 1);
         ARKStepSetJacEvalFrequency(m, 1);
       })}};
}

}  // namespace

std::vector<Choice> sundials_choices() {
  return {cvode_newton(), arkstep_newton("ARK324L2SA_DIRK_4_2_3", ARKODE_ARK324L2SA_DIRK_4_2_3),
          arkstep_newton("KVAERNO_5_3_4", ARKODE_KVAERNO_5_3_4),
          arkstep_newton("ESDIRK547L2SA2_7_4_5", ARKODE_ESDIRK547L2SA2_7_4_5)};
}

}  // namespace odeum::peers
