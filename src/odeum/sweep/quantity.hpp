// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "odeum/solvers/case.hpp"

namespace odeum::sweep {

/// A number of a member's solution.
struct Quantity {
  /// error: at the end, in the units of the case's errors, where each member's truth is exact;
  /// error_of: likewise of one component or output, in its own unit
  enum class Kind { end, least, greatest, energy, measured, error, error_of };
  std::string name;
  Kind kind = Kind::end;
  std::size_t component = 0;  ///< of the state, or of what a study measured; none of an energy
  bool is_output = false;     ///< the component is one of Case::outputs

  /// Whether it needs the solution between the start and the end.
  bool over_time() const { return kind == Kind::least || kind == Kind::greatest; }
};

/// The error, where the truth of each member is a closed form; else nothing.
std::optional<Quantity> error_of_members(const Case& c);

/// `max(x)`, `min(x)`, `x(end)`, `error(x)` of a component or an output x, `energy` (at the end),
/// separated by commas; without text all components at the end. Throws std::invalid_argument.
std::vector<Quantity> quantities_of(const std::string& text, const Case& c);

}  // namespace odeum::sweep
