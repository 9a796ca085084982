// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Plain C++17: shared with the translation unit of the uBLAS steppers.
#include "odeum/core/outcome.hpp"

/// The parts of every run that need no template.
namespace odeum::adapters::odeint {

/// odeint has no rule for the first step; its controllers enlarge a small one quickly.
double first_step(double t0, const Request& request);

/// A step below this is lost in the rounding of t.
double smallest_step(double t, double stop);

/// False, with the outcome filled in, where a controller has reduced its step below that.
bool step_is_large_enough(double h, double t, double stop, Outcome& outcome);

/// Turns the exception in flight into an outcome.
void explain_exception(Outcome& outcome);

Outcome refuse_adaptive();
Outcome refuse_fixed();

}  // namespace odeum::adapters::odeint
