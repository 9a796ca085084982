// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Plain C++17: shared with the translation unit of the uBLAS steppers.
#include "odeum/core/outcome.hpp"

/// The parts of every run that need no template.
namespace odeum::adapters::odeint {

/// A step below this is lost in the rounding of times from t to stop.
double smallest_step(double t, double stop);

/// False, with the outcome filled in, where a controller has reduced its step to the rounding of t.
bool step_is_large_enough(double h, double t, Outcome& outcome);

/// Turns the exception in flight into an outcome.
void explain_exception(Outcome& outcome);

Outcome refuse_adaptive();
Outcome refuse_fixed();
/// Scaled problems are run behind pointers alone, see scaled.hpp.
Outcome refuse_by_component();

}  // namespace odeum::adapters::odeint
