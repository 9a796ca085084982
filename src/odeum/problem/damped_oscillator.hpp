// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace odeum {

/// The exact solution of m y'' + d y' + k y = 0 (m, k > 0; d >= 0), to 13 digits at any distance
/// from critical damping: the roots are not subtracted from each other, and their difference comes
/// from a discriminant evaluated without cancellation. On return state[0] = y(t), state[1] = y'(t).
void damped_oscillator_solution(double m, double d, double k, double y0, double v0, double t,
                                double* state);

}  // namespace odeum
