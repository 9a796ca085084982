// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Plain C++17, see ode_view.hpp.

namespace odeum {

/// What a solver is commonly used for in simulations of particles and cloth, as its own file says.
/// Studies that compare few solvers there take those that are not `none`.
enum class CommonUse {
  none,
  engine,      ///< the step of physics engines and of simulators of cloth
  fixed_step,  ///< a common choice of its library at fixed steps
  tolerance    ///< a common choice of its library to a tolerance
};

}  // namespace odeum
