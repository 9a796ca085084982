// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "odeum/advise/race.hpp"
#include "odeum/record/output_folder.hpp"

/// An advice for people and for programs.
namespace odeum::advise {

/// What a user wrote, for the command that repeats the run.
struct Asked {
  std::string problem;
  std::string more;  ///< the words of --set and --plugin, each after a space
  /// The parameters that vary, each as `k=2`, for each case; empty: there is one case.
  std::vector<std::vector<std::string>> points = {};
  std::optional<double> until = {};  ///< where the run ends, if not at the problem's end
};

/// Whether there is an answer for all of the time that was asked for.
bool is_whole(const Advice& advice, const Case& c);

/// Lines; the first names solver, setting, error and time, and says what was not answered.
std::string text_of(const Advice& advice, const Case& c, const Asked& asked);

/// With the keys `solver`, `setting_kind`, `setting`, `absolute`, `error`, `error_low`,
/// `error_high`, `time_ns`, `time_low`, `time_high`, `limited_by`, `runners_up`, `not_tried`,
/// `command` and more. Without an answer: `failure` and `not_tried`.
nlohmann::ordered_json json_of(const Advice& advice, const Case& c, const Asked& asked);

/// The runs of the race: the text of race.csv.
std::string csv_of(const Advice& advice);

/// Writes the runs of the race (race.csv), the answer (advice.json) and their page; false where
/// there is no page, see Report::write. Throws FileError.
bool write_page(const record::OutputFolder& folder, const Advice& advice, const Case& c,
                const Asked& asked);

}  // namespace odeum::advise
