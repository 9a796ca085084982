// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "odeum/cases/kinds/sbml/sbml.hpp"

/// What the module exports. No exception leaves it: `fault` is the text of an InputError, or empty.
extern "C" {
[[gnu::visibility("default")]] void odeum_sbml_text(const std::string& file, const std::string& xml,
                                                    double end, odeum::cases::SbmlText& result,
                                                    std::string& fault);
/// See odeum::cases::sbml_support.
[[gnu::visibility("default")]] void odeum_sbml_support(std::string& words);
}
