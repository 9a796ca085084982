// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace odeum::foreign {

/// What is wrong with a name that goes into ids, files and pages; empty where nothing is.
std::string fault_of_name(const char* what, const char* name);
/// A text for people on one line, without control characters, of at most 300 characters.
std::string cleaned(const char* text);

}  // namespace odeum::foreign
