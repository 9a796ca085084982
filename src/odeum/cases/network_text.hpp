// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace odeum::cases {

/// A network that BioNetGen generated (.net) as the text of a problem (formula/problem.hpp): its
/// parameters, functions, species and reactions, and its groups as outputs. `end` is that of the
/// problem, since a network names none. Throws InputError with the place for what is not read, and
/// for kinds of rates other than mass action, Sat and MM.
std::string text_of_network(const std::string& file, const std::string& text, double end);

}  // namespace odeum::cases
