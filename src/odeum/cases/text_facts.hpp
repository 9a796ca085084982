// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "odeum/cases/text_truth.hpp"
#include "odeum/formula/text_ode.hpp"

namespace odeum::cases {

/// What was found in a problem file, for people. `ode` is null where its code is a built-in text's.
Facts text_facts(const formula::Problem& problem, const formula::Analysis& analysis,
                 const formula::TextOde* ode, const TextTruth& truth, const Case& c);

/// Gives a case of a text's equations the invariants that the text states.
void add_invariants(const formula::Problem& problem, Case& c);
/// Gives a case the quantities that the text names for columns.
void add_outputs(const formula::Problem& problem, Case& c);

/// Whether a state has the name of another column of the files, which would then stand there twice.
bool has_name_of_column(const std::vector<std::string>& states);

}  // namespace odeum::cases
