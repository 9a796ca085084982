// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/formula/reader.hpp"

/// Checks of a problem that was read, against its equations.
namespace odeum::formula::check {

/// Throws InputError where an equation is not finite at the start, or an invariant changes there.
void require_start(Problem& problem, const reading::Source& source);
/// Throws InputError where `exact` does not fulfil the initial values, or the equations at times
/// from the start to the end.
void require_exact(Problem& problem, const reading::Source& source);

}  // namespace odeum::formula::check
