// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "odeum/contest/case.hpp"

namespace odeum::cli {

/// A C++ program that makes one run of an own method on a case with the installed package and
/// prints the state at its end. Throws UsageError for a solver of another library.
std::string code_of(const Case& c, const Entrant& entrant, const Request& request);

}  // namespace odeum::cli
