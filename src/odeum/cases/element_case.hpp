// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>

#include "odeum/fem/semi_discrete.hpp"
#include "odeum/solvers/case.hpp"

namespace odeum::cases {

/// Sets the problem of `c`, whose y0 is set, to M u' = -K u + f (heat) or M u'' = -K u (wave, u and
/// then u'), and enrols every solver. The Jacobian is sparse where M is lumped.
void set_heat_stage(Case& c, std::shared_ptr<const fem::SemiDiscrete> system);
void set_wave_stage(Case& c, std::shared_ptr<const fem::SemiDiscrete> system);

}  // namespace odeum::cases
