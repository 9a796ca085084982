// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "sundials/session.hpp"

namespace odeum::adapters::sundials {

/// Gives the session's integrator a linear solver for the library's own Newton iteration: dense LU
/// with the problem's Jacobian (the library's difference quotient where it offers none); for a
/// sparse Jacobian its band or KLU solver; beyond dense_dimension_limit the problem's own solver of
/// such systems, which own methods use too (a matrix-embedded linear solver in the library's
/// terms), or restarted GMRES with the problem's Jacobian-vector product where it has none.
void attach_linear_solver(Session& session);

/// Whether that is a direct solver of a matrix: settings that rebuild it more often then pay.
bool factorises(const Session& session);

/// Accuracy of the iteration in a fixed step, in effect relative to max(1, |y|): far below the
/// error of the method, so that the measured order is that of the method.
double exact_solve_tolerance(const Session& session);

/// Limit of iterations at a fixed step, which cannot be retried with a smaller step.
inline constexpr int max_exact_iterations = 50;

}  // namespace odeum::adapters::sundials
