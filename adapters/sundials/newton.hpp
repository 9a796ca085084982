// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "sundials/session.hpp"

namespace odeum::adapters::sundials {

/// Gives the session's integrator a linear solver for the library's own Newton iteration: dense LU
/// with the problem's Jacobian (the library's difference quotient where it offers none); beyond
/// dense_dimension_limit the problem's own solver of such systems, which own methods use too (a
/// matrix-embedded linear solver in the library's words), or restarted GMRES with the problem's
/// Jacobian-vector product where it has none.
void attach_linear_solver(Session& session);

/// What a step held by us is solved to, relative to max(1, |y|) in effect: far below the error of
/// the method, so that an order measured is that of the method.
double exact_solve_tolerance(const Session& session);

/// Iterations allowed where nothing can be done about a failure, since the step is given.
inline constexpr int max_exact_iterations = 50;

}  // namespace odeum::adapters::sundials
