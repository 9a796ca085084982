// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "odeum/solvers/case.hpp"

namespace odeum::sweep {

/// A number of a member's solution.
struct Quantity {
  /// error: at the end, in the units of the case's errors, where each member's truth is exact
  enum class Kind { end, least, greatest, energy, measured, error };
  std::string name;
  Kind kind = Kind::end;
  std::size_t component = 0;  ///< of the state, or of what a study measured; none of an energy

  /// Whether it needs the solution between the start and the end.
  bool over_time() const { return kind == Kind::least || kind == Kind::greatest; }
  /// The value from `count` states as long as y0, the last of which is at the end.
  double of(const std::function<double(const double*)>& energy, const std::vector<double>& y0,
            const double* states, std::size_t count) const;
};

/// The error, where the truth of each member is a closed form; else nothing.
std::optional<Quantity> error_of_members(const Case& c);

/// `max(x)`, `min(x)`, `x(end)`, `energy` (at the end), separated by commas; without text all
/// components at the end. Throws std::invalid_argument.
std::vector<Quantity> quantities_of(const std::string& text, const Case& c);

}  // namespace odeum::sweep
