// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <chrono>
#include <string>
#include <vector>

namespace odeum {

/// The model of this machine's processor; "unknown" where the system does not tell.
std::string cpu_model();

/// The files of the shared libraries that this program has loaded; none where the system does not
/// tell.
std::vector<std::string> loaded_libraries();

inline constexpr const char* unoptimised = "without optimisation";

/// Whether a shared library was compiled `with optimisation` or `without optimisation`, by the
/// machine code of its functions; empty where that cannot be told: another processor than x86-64,
/// or no such file.
std::string how_compiled(const std::string& path);

/// The positive number that a variable of the environment gives, at most 86,400, the seconds of a
/// day; without it `otherwise`.
double number_of_environment(const char* variable, double otherwise);

/// A time as ISO 8601, UTC, to the second.
std::string utc_text(std::chrono::system_clock::time_point time);

}  // namespace odeum
