// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace odeum::adapters::odeint {

/// Thrown out of a right-hand side to unwind odeint's loops once the guard has tripped.
struct Tripped {};

}  // namespace odeum::adapters::odeint
