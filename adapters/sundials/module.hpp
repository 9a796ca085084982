// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_matrix.h>
#include <sundials/sundials_nonlinearsolver.h>
#include <sundials/sundials_nvector.h>

#include <string>

#include "odeum/core/outcome.hpp"

/// CVODE, ERKStep and ARKStep have one interface under three prefixes. A Module is that interface
/// as a table, so that the common code is written once.
namespace odeum::adapters::sundials {

struct Module {
  using ErrorHandler = void (*)(int code, const char* module, const char* function, char* message,
                                void* data);
  using Jacobian = int (*)(double t, N_Vector y, N_Vector f, SUNMatrix jacobian, void* data,
                           N_Vector, N_Vector, N_Vector);
  using JacobianTimesSetup = int (*)(double t, N_Vector y, N_Vector f, void* data);
  using JacobianTimes = int (*)(N_Vector x, N_Vector product, double t, N_Vector y, N_Vector f,
                                void* data, N_Vector);
  /// State of Newton's iteration: its matrix is I - gamma df/dy at (t, y).
  struct NewtonPoint {
    double t = 0, gamma = 0;
    N_Vector y = nullptr;
  };

  int (*set_error_handler)(void*, ErrorHandler, void* data);
  int (*set_user_data)(void*, void* data);
  int (*set_tolerances)(void*, double relative, double absolute);
  int (*set_tolerances_by_component)(void*, double relative, N_Vector absolute);
  int (*set_max_steps)(void*, long steps);
  int (*set_stop_time)(void*, double t);
  int (*set_fixed_step)(void*, double h);  ///< null: the module has no fixed-step mode
  int (*evolve)(void*, double t_out, N_Vector y, double* t, int task);
  int (*current_time)(void*, double* t);
  int (*steps)(void*, long*);
  int (*error_test_failures)(void*, long*);
  int (*solve_failures)(void*, long*);  ///< null: explicit, without an iteration
  /// Whether a stop before the last is best interpolated where errors are measured: CVODE has the
  /// polynomial of its step at hand. ARKODE would pay evaluations for one, or interpolate at a
  /// lower order than it steps; explicit tables do so for output (Request::over_stops).
  bool interpolates_stops;
  char* (*flag_name)(long flag);
  void (*free)(void**);

  // Null for explicit modules.
  int (*set_nonlinear_solver)(void*, SUNNonlinearSolver);
  int (*set_linear_solver)(void*, SUNLinearSolver, SUNMatrix);
  int (*set_jacobian)(void*, Jacobian);
  int (*set_jacobian_times)(void*, JacobianTimesSetup, JacobianTimes);
  int (*newton_point)(void*, NewtonPoint&);
  int (*set_convergence_coefficient)(void*, double);
  int (*set_max_iterations)(void*, int);
  int (*jacobians)(void*, long*);  ///< formed so far, by the library's own differences too
};

extern const Module cvode_module, erkstep_module, arkstep_module;

/// A library call that failed; never leaves the adapter.
struct Failure {
  int flag;
  const char* what;  ///< the operation that failed
};

/// Throws Failure where the flag says that a set-up call did not succeed.
inline void check(int flag, const char* what) {
  if (flag < 0) throw Failure{flag, what};
}

/// The outcome's status for a failure flag of any of the modules.
Status status_of(int flag);

/// The library's own name of a flag, such as CV_ERR_FAILURE.
std::string name_of(const Module& module, int flag);

}  // namespace odeum::adapters::sundials
