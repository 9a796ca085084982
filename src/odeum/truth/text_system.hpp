// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>

#include "odeum/formula/text_ode.hpp"
#include "odeum/truth/system.hpp"

namespace odeum::truth {

/// The equations of a text: with their series, and with inspection of steps. Where they have kinks,
/// they are solved in smooth parts, if those can be analysed.
System system_of(const std::shared_ptr<const formula::TextOde>& ode);

}  // namespace odeum::truth
