// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <nlohmann/json.hpp>
#include <string>

#include "odeum/advise/race.hpp"
#include "odeum/record/output_folder.hpp"

/// An advice for people and for programs.
namespace odeum::advise {

/// What a user wrote, for the command that repeats the run.
struct Asked {
  std::string problem;
  std::string more;  ///< the words of --set and --plugin, each after a space
  /// By case the parameters that vary, as `k=2 d=1`; empty: there is one case.
  std::vector<std::string> points = {};
};

/// Lines; the first names solver, setting, error and time.
std::string text_of(const Advice& advice, const Case& c, const Asked& asked);

/// With the keys `solver`, `setting_kind`, `setting`, `absolute`, `error`, `error_low`,
/// `error_high`, `time_ns`, `time_low`, `time_high`, `limited_by`, `runners_up`, `not_tried`,
/// `command` and more. Without an answer: `failure` and `not_tried`.
nlohmann::ordered_json json_of(const Advice& advice, const Case& c, const Asked& asked);

/// Writes the runs of the race (race.csv), the answer (advice.json) and their page; false where
/// there is no page, see Report::write. Throws FileError.
bool write_page(const record::OutputFolder& folder, const Advice& advice, const Case& c,
                const Asked& asked);

}  // namespace odeum::advise
