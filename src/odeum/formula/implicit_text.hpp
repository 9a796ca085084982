// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>

#include "odeum/formula/problem.hpp"
#include "odeum/problem/implicit_form.hpp"

namespace odeum::formula {

/// The residuals of a problem with their derivatives as compiled code, interpreted where there is
/// no compiler; null where the problem has none that stay implicit.
std::shared_ptr<const ImplicitForm> implicit_form(const Problem& problem);

}  // namespace odeum::formula
