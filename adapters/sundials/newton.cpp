// SPDX-License-Identifier: BSD-3-Clause
#include "sundials/newton.hpp"

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunlinsol/sunlinsol_spgmr.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <utility>

#include "odeum/kernel/newton.hpp"
#include "sundials/structured.hpp"

namespace odeum::adapters::sundials {
namespace {

// The problem's Jacobian is row-major, the library's matrix column-major.
int dense_jacobian(double t, N_Vector y, N_Vector, SUNMatrix jacobian, void* data, N_Vector,
                   N_Vector, N_Vector) {
  auto& session = *static_cast<Session*>(data);
  const std::size_t n = session.dimension();
  double* const columns = SUNDenseMatrix_Data(jacobian);
  if (session.problem().jacobian(t, NV_DATA_S(y), columns) != 0) return -1;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < i; ++j) std::swap(columns[i * n + j], columns[j * n + i]);
  return 0;
}

int jacobian_times(N_Vector x, N_Vector product, double t, N_Vector y, N_Vector, void* data,
                   N_Vector) {
  auto& session = *static_cast<Session*>(data);
  return -session.problem().jacobian_times(t, NV_DATA_S(y), NV_DATA_S(x), NV_DATA_S(product));
}

Session& session_of(SUNLinearSolver solver) { return *static_cast<Session*>(solver->content); }

int solve_embedded(SUNLinearSolver solver, SUNMatrix, N_Vector x, N_Vector b, double) {
  Session& session = session_of(solver);
  Module::NewtonPoint at;
  if (session.module().newton_point(session.integrator(), at) < 0) return SUNLS_MEM_NULL;
  N_VScale(1, b, x);
  ShiftedSolver& own = *session.shifted_solver();
  const bool solved = own.factorise(at.t, NV_DATA_S(at.y), at.gamma) &&
                      own.solve(NV_DATA_S(x), correction_accuracy);
  if (session.problem().guard().tripped()) return SUNLS_PACKAGE_FAIL_UNREC;
  return solved ? SUNLS_SUCCESS : SUNLS_LUFACT_FAIL;  // the latter requests a smaller step
}

/// A linear solver of the library's interface that calls the problem's own.
SUNLinearSolver embedded(Session& session) {
  SUNLinearSolver const solver = SUNLinSolNewEmpty(session.context());
  if (!solver) return nullptr;
  solver->content = &session;
  solver->ops->gettype = [](SUNLinearSolver) { return SUNLINEARSOLVER_MATRIX_EMBEDDED; };
  solver->ops->solve = solve_embedded;
  solver->ops->free = [](SUNLinearSolver self) {
    self->content = nullptr;  // owned by the session
    SUNLinSolFreeEmpty(self);
    return 0;
  };
  return solver;
}

bool is_structured(const Session& session) { return session.view().sparsity != nullptr; }

bool uses_dense_matrix(const Session& session) {
  return !is_structured(session) && session.dimension() <= dense_dimension_limit;
}

}  // namespace

bool factorises(const Session& session) {
  return is_structured(session) || uses_dense_matrix(session);
}

void attach_linear_solver(Session& session) {
  const Module& module = session.module();
  const OdeView& view = session.problem().view();
  Matrix matrix;
  LinearSolver solver;
  Module::Jacobian jacobian = view.jacobian ? dense_jacobian : nullptr;
  if (is_structured(session)) {
    StructuredSolver structured = make_structured_solver(session);
    matrix = std::move(structured.matrix);
    solver = std::move(structured.solver);
    jacobian = structured.jacobian;
  } else if (uses_dense_matrix(session)) {
    const auto n = static_cast<sunindextype>(session.dimension());
    matrix.reset(SUNDenseMatrix(n, n, session.context()));
    solver.reset(SUNLinSol_Dense(session.y(), matrix.get(), session.context()));
  } else if (view.shifted_solver) {
    session.keep(session.problem().shifted_solver());
    solver.reset(embedded(session));
  } else {
    // Up to 60 directions: the default, 5, is meant for use with a preconditioner.
    constexpr int directions = 60, restarts = 2;
    solver.reset(SUNLinSol_SPGMR(session.y(), SUN_PREC_NONE, directions, session.context()));
    if (solver) SUNLinSol_SPGMRSetMaxRestarts(solver.get(), restarts);
  }
  if (!solver) throw Failure{CV_MEM_FAIL, "creating the linear solver"};
  void* const integrator = session.integrator();
  check(module.set_linear_solver(integrator, solver.get(), matrix.get()),
        "attaching the linear solver");
  if (factorises(session) && jacobian)
    check(module.set_jacobian(integrator, jacobian), "setting the Jacobian");
  if (!factorises(session) && !session.shifted_solver() && view.jacobian_times)
    check(module.set_jacobian_times(integrator, nullptr, jacobian_times),
          "setting the Jacobian-vector product");
  session.keep(std::move(solver), std::move(matrix));
}

double exact_solve_tolerance(const Session& session) {
  // Fifty times rounding for the direct solvers. Iterative solvers are given tolerances two hundred
  // times smaller than this, which must stay above rounding.
  return factorises(session) ? 1e-14 : 1e-11;
}

}  // namespace odeum::adapters::sundials
