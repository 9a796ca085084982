// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "odeum/record/output_folder.hpp"
#include "odeum/sweep/sweep.hpp"

namespace odeum::sweep {

/// The words of the command, for those that repeat a member.
struct Asked {
  std::string what, more;  ///< the problem; --set and --plugin, each after a space
};

/// The command that runs a member alone.
std::string command_of(const Plan& plan, const Asked& asked, std::uint64_t member);
/// The summary, for people and for programs.
std::string text_of(const Plan& plan, const Result& result, const Asked& asked);
nlohmann::ordered_json json_of(const Plan& plan, const Result& result, const Asked& asked);

/// Several solvers on the same members: a plan with the quantities of each by name, and its result.
struct Joined {
  Plan plan;
  Result result;
};
Joined join(const std::vector<Plan>& plans, std::vector<Result> results);

/// Writes members.csv, `answers` as sweep.json and the page, which tells `text`; false where there
/// is no page, see Report::write. Throws FileError.
bool write_page(const record::OutputFolder& folder, const Joined& all, const std::string& text,
                const nlohmann::ordered_json& answers, const Asked& asked);

}  // namespace odeum::sweep
