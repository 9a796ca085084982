// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <string>

#include "fuzz/has_place.hpp"
#include "odeum/formula/analysis.hpp"

namespace odeum::fuzz {

/// Whether the reader of problem files returns a problem of finite numbers, whose derivatives
/// exist, or an error that begins with the place.
inline bool read_any_problem(const std::string& text) {
  try {
    formula::Problem problem = formula::read_problem("f", text);
    if (problem.states.size() > 50 || problem.graph.size() > 5000) return true;
    for (const long double y : problem.y0)
      if (!std::isfinite(y)) return false;
    if (problem.equations.size() != problem.states.size() || problem.stops.empty()) return false;
    formula::analyse(problem);
    return true;
  } catch (const InputError& error) {
    return has_place(error.what());
  }
}

}  // namespace odeum::fuzz
