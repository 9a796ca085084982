// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Plain C++17, see ode_view.hpp.
#include <cstddef>
#include <string>

#include "odeum/core/outcome.hpp"

namespace odeum {

/// Largest dimension for which a dense Jacobian is factorised; beyond it a solver that knows only
/// dense matrices is over budget (726 unknowns: 0.1 s and more for each factorisation).
inline constexpr std::size_t dense_dimension_limit = 128;

/// The outcome of a solver that would have to factorise a dense matrix beyond the limit.
inline Outcome dense_over_budget(std::size_t dimension) {
  Outcome outcome;
  outcome.status = Status::over_budget;
  outcome.detail = "needs a dense Jacobian of " + std::to_string(dimension) + " unknowns (limit " +
                   std::to_string(dense_dimension_limit) + ")";
  return outcome;
}

}  // namespace odeum
