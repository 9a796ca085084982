// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/solvers/solver.hpp"

namespace odeum {

/// Adds the option `projection` to an own method on an ordinary problem with constraints: after
/// each step, and at outputs between steps, the state moves onto all of them, those that are given
/// and hidden ones, by as little as it can in units of the tolerances (at a fixed step of 1 + |y|),
/// as in Hairer, Lubich, Wanner, Geometric Numerical Integration, IV.4. The iterations of Newton's
/// method count as products.
void offer_projection(const Solver& solver, const ErasedContest& contest, Entrant& entrant);

}  // namespace odeum
