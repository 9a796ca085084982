// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>

#include "odeum/formula/text_ode.hpp"
#include "odeum/truth/system.hpp"

namespace odeum::truth {

/// A text without kinks, and its derivatives.
System smooth_system(const std::shared_ptr<const formula::TextOde>& ode);

}  // namespace odeum::truth
