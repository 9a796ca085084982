// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "odeum/formula/analysis.hpp"
#include "odeum/formula/case_section.hpp"

/// Prints problem files that are built-in cases as C++, when Odeum is built.
namespace odeum::print {

/// The name of the type: VanDerPol for van_der_pol.
std::string type_name(const std::string& stem);

/// A struct of the problem, of that name: as print_problem() has it, to stand in any C++17 program.
std::string print_struct(const std::string& name, const formula::Problem& problem,
                         const formula::Analysis& analysis, const formula::Offers& offers);

/// A header with a struct of the problem (problem/concepts.hpp), in plain C++17: parameters are its
/// members, constants that follow from them are computed once. An invariant x is the function
/// kept_x, `energy` and `H` are `energy`. The problem was read with the names of its parameters.
std::string print_problem(const std::string& stem, const formula::Problem& problem,
                          const formula::Analysis& analysis, const formula::Offers& offers);

/// Whether an invariant of that name is the energy.
inline bool is_energy(const std::string& name) { return name == "energy" || name == "H"; }

}  // namespace odeum::print
