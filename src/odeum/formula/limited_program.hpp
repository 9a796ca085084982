// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace odeum::formula {

/// The seconds of the processor that a compiler may take: $ODEUM_COMPILER_SECONDS, else 60.
double compiler_seconds();

/// Runs a program with arguments without a shell, within `seconds` of the processor and 2 GiB of
/// memory for each of its processes, and within eight times as many of wall time: a machine that
/// others use, or a program that waits. Its output goes to `log`. All that it started ends with it,
/// and with this process, however that ends. Empty: it succeeded; else how it did not, `failed` or
/// a clause.
std::string run_limited(const std::vector<std::string>& command, const std::filesystem::path& log,
                        double seconds);

}  // namespace odeum::formula
