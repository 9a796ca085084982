// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "odeum/formula/analysis.hpp"
#include "odeum/formula/case_section.hpp"

/// Prints problems as C++.
namespace odeum::print {

/// The name of each definition of the graph as a member of a struct named `of`: its own, but where
/// C++, its library or the struct has another use for it.
std::vector<std::string> member_names(const std::string& of, const formula::Graph& graph);

/// A struct of the problem (problem/concepts.hpp), of that name, in plain C++17: parameters are its
/// members, constants that follow from them are computed once. An invariant x is the function
/// kept_x, `energy` and `H` are `energy`. event_functions(t, y, g) has the functions of which a
/// zero is an event, happen(event, t, y, after) sets what it sets. The problem was read with the
/// names of its parameters.
std::string print_struct(const std::string& name, const formula::Problem& problem,
                         const formula::Analysis& analysis, const formula::Offers& offers);

}  // namespace odeum::print
