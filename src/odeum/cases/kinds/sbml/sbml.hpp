// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace odeum::cases {

/// A model in SBML as the text of a problem (formula/problem.hpp).
struct SbmlText {
  std::string text;
  std::vector<std::string> warnings;
};

/// Translates a model in SBML level 2 or 3 (adapters/sbml); `end` is that of the problem, since a
/// model has none. Throws InputError, with the place where there is one, for a file that is not
/// SBML, and for what is not supported, by its name.
SbmlText text_of_sbml(const std::string& file, const std::string& xml, double end);

/// Which levels are read and by which library; empty: nothing.
std::string sbml_support();

}  // namespace odeum::cases
