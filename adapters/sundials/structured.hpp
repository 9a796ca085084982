// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "sundials/session.hpp"

namespace odeum::adapters::sundials {

/// The matrix and the direct solver of the library for the problem's sparse Jacobian: a band where
/// that is narrow in the order of the unknowns, and KLU otherwise. Throws Failure.
struct StructuredSolver {
  Matrix matrix;
  LinearSolver solver;
  Module::Jacobian jacobian = nullptr;  ///< null: the library's own differences
};
StructuredSolver make_structured_solver(Session& session);

}  // namespace odeum::adapters::sundials
