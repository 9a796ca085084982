// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/cases/text_truth.hpp"
#include "odeum/formula/text_ode.hpp"

namespace odeum::cases {

/// What was found in a problem file, for people. `ode` is null where its code is a built-in text's.
Facts text_facts(const formula::Problem& problem, const formula::Analysis& analysis,
                 const formula::TextOde* ode, const TextTruth& truth, const Case& c);

}  // namespace odeum::cases
