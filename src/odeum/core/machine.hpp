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

/// A time as ISO 8601, UTC, to the second.
std::string utc_text(std::chrono::system_clock::time_point time);

}  // namespace odeum
