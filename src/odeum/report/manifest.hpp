// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "odeum/report/report_data.hpp"

namespace odeum::report {

/// manifest.json: what was run, with what, on what, and what was skipped and why. Text, indented.
/// `plots` says how the page's pictures were made, or why there are none.
std::string manifest_json(const ReportData& data, const std::string& plots);

/// The model of this machine's processor; "unknown" where the system does not tell.
std::string cpu_model();

/// A time as ISO 8601, UTC, to the second.
std::string utc_text(std::chrono::system_clock::time_point time);

}  // namespace odeum::report
