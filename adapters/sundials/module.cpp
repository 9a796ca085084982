// SPDX-License-Identifier: BSD-3-Clause
#include "sundials/module.hpp"

#include <arkode/arkode_arkstep.h>
#include <arkode/arkode_erkstep.h>
#include <cvode/cvode.h>
#include <cvode/cvode_ls.h>

#include <cstdlib>
#include <memory>

namespace odeum::adapters::sundials {
namespace {

int cvode_newton_point(void* memory, Module::NewtonPoint& point) {
  N_Vector predicted = nullptr, f = nullptr, zn1 = nullptr;
  double rl1 = 0;
  void* data = nullptr;
  return CVodeGetNonlinearSystemData(memory, &point.t, &predicted, &point.y, &f, &point.gamma, &rl1,
                                     &zn1, &data);
}

int arkstep_newton_point(void* memory, Module::NewtonPoint& point) {
  N_Vector predicted = nullptr, f = nullptr, rest = nullptr;
  void* data = nullptr;
  return ARKStepGetNonlinearSystemData(memory, &point.t, &predicted, &point.y, &f, &point.gamma,
                                       &rest, &data);
}

}  // namespace

const Module cvode_module{
    .set_error_handler = CVodeSetErrHandlerFn,
    .set_user_data = CVodeSetUserData,
    .set_tolerances = CVodeSStolerances,
    .set_tolerances_by_component = CVodeSVtolerances,
    .set_max_steps = CVodeSetMaxNumSteps,
    .set_stop_time = CVodeSetStopTime,
    .set_fixed_step = nullptr,
    .evolve = CVode,
    .current_time = CVodeGetCurrentTime,
    .steps = CVodeGetNumSteps,
    .error_test_failures = CVodeGetNumErrTestFails,
    .solve_failures = CVodeGetNumStepSolveFails,
    .interpolates_stops = true,
    .flag_name = CVodeGetReturnFlagName,
    .free = CVodeFree,
    .set_nonlinear_solver = CVodeSetNonlinearSolver,
    .set_linear_solver = CVodeSetLinearSolver,
    .set_jacobian = CVodeSetJacFn,
    .set_jacobian_times = CVodeSetJacTimes,
    .newton_point = cvode_newton_point,
    .set_convergence_coefficient = CVodeSetNonlinConvCoef,
    .set_max_iterations = CVodeSetMaxNonlinIters,
    .jacobians = CVodeGetNumJacEvals,
};

const Module erkstep_module{
    .set_error_handler = ERKStepSetErrHandlerFn,
    .set_user_data = ERKStepSetUserData,
    .set_tolerances = ERKStepSStolerances,
    .set_tolerances_by_component = ERKStepSVtolerances,
    .set_max_steps = ERKStepSetMaxNumSteps,
    .set_stop_time = ERKStepSetStopTime,
    .set_fixed_step = ERKStepSetFixedStep,
    .evolve = ERKStepEvolve,
    .current_time = ERKStepGetCurrentTime,
    .steps = ERKStepGetNumSteps,
    .error_test_failures = ERKStepGetNumErrTestFails,
    .solve_failures = nullptr,
    .interpolates_stops = false,
    .flag_name = ERKStepGetReturnFlagName,
    .free = ERKStepFree,
    .set_nonlinear_solver = nullptr,
    .set_linear_solver = nullptr,
    .set_jacobian = nullptr,
    .set_jacobian_times = nullptr,
    .newton_point = nullptr,
    .set_convergence_coefficient = nullptr,
    .set_max_iterations = nullptr,
    .jacobians = nullptr,
};

const Module arkstep_module{
    .set_error_handler = ARKStepSetErrHandlerFn,
    .set_user_data = ARKStepSetUserData,
    .set_tolerances = ARKStepSStolerances,
    .set_tolerances_by_component = ARKStepSVtolerances,
    .set_max_steps = ARKStepSetMaxNumSteps,
    .set_stop_time = ARKStepSetStopTime,
    .set_fixed_step = ARKStepSetFixedStep,
    .evolve = ARKStepEvolve,
    .current_time = ARKStepGetCurrentTime,
    .steps = ARKStepGetNumSteps,
    .error_test_failures = ARKStepGetNumErrTestFails,
    .solve_failures = ARKStepGetNumStepSolveFails,
    .interpolates_stops = false,
    .flag_name = ARKStepGetReturnFlagName,
    .free = ARKStepFree,
    .set_nonlinear_solver = ARKStepSetNonlinearSolver,
    .set_linear_solver = ARKStepSetLinearSolver,
    .set_jacobian = ARKStepSetJacFn,
    .set_jacobian_times = ARKStepSetJacTimes,
    .newton_point = arkstep_newton_point,
    .set_convergence_coefficient = ARKStepSetNonlinConvCoef,
    .set_max_iterations = ARKStepSetMaxNonlinIters,
    .jacobians = ARKStepGetNumJacEvals,
};

// CVODE and ARKODE share the flags down to -11; the others that can occur here (no mass matrix, no
// projection, no roots) do not overlap.
Status status_of(int flag) {
  switch (flag) {
    case CV_TOO_MUCH_WORK:
      return Status::over_budget;
    case CV_ERR_FAILURE:
      return Status::step_too_small;
    case CV_CONV_FAILURE:
    case CV_LINIT_FAIL:
    case CV_LSETUP_FAIL:
    case CV_LSOLVE_FAIL:
    case CV_NLS_INIT_FAIL:
    case CV_NLS_SETUP_FAIL:
    case CV_NLS_FAIL:
    case ARK_NLS_INIT_FAIL:
    case ARK_NLS_SETUP_FAIL:
    case ARK_NLS_SETUP_RECVR:
    case ARK_NLS_OP_ERR:
      return Status::newton_failed;
    case CV_RHSFUNC_FAIL:
    case CV_FIRST_RHSFUNC_ERR:
    case CV_REPTD_RHSFUNC_ERR:
    case CV_UNREC_RHSFUNC_ERR:
      return Status::non_finite;  // the right-hand side fails for that reason, or over budget
    default:
      return Status::refused;
  }
}

std::string name_of(const Module& module, int flag) {
  const std::unique_ptr<char, decltype(&std::free)> text(module.flag_name(flag), std::free);
  return text ? text.get() : "flag " + std::to_string(flag);
}

}  // namespace odeum::adapters::sundials
