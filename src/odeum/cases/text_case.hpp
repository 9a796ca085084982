// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "odeum/formula/problem.hpp"
#include "odeum/formula/text_ode.hpp"
#include "odeum/solvers/case.hpp"

namespace odeum::cases {

/// A case made of a problem file, and what is said about it: name of the fact and text.
struct TextCase {
  Case c;
  std::vector<std::pair<std::string, std::string>> facts;
};

/// Makes the case `id` of a problem: compiles it, analyses it, takes its closed form for truth or
/// computes a reference (kept in the cache folder, keyed by content), chooses steps for the studies
/// and enrols all solvers. Throws InputError where an invariant changes along the solution, and
/// std::length_error where the problem is too large.
TextCase text_case(const std::string& id, formula::Problem problem,
                   formula::TextOde::Code code = formula::TextOde::Code::compiled);

}  // namespace odeum::cases
