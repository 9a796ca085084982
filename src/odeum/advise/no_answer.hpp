// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "odeum/advise/race.hpp"

/// Why an advice can't be given.
namespace odeum::advise {

/// Throws std::invalid_argument for wishes about an energy that does not serve.
void check_wishes(const Case& c, const Wishes& wishes);

/// What is known of the solution, and why no more.
std::string words_of_truth(const Case& c);

/// Why there is no answer, before any run; empty: there may be one.
std::string unknown(const Case& c, const Wishes& wishes);

/// Why there is none after a race.
std::string nobody(const Advice& advice);

}  // namespace odeum::advise
