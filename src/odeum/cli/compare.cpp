// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/compare/folders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <sstream>

#include "odeum/cli/session.hpp"
#include "odeum/compare/overlay.hpp"
#include "odeum/compare/times.hpp"
#include "odeum/input/text_file.hpp"
#include "odeum/record/output_folder.hpp"
#include "odeum/record/table.hpp"

namespace odeum::cli {
namespace {

struct CompareOptions {
  std::string before, after, format = "table", allow, out;
  bool commands = false, overlay = false;
  std::size_t pairs = 25;
  double slower = 0.03, within = 0;
};

std::vector<std::string> lines_of(const std::string& path) {
  std::vector<std::string> lines;
  if (path.empty()) return lines;
  constexpr std::size_t most_bytes = 1'000'000;
  std::istringstream text(read_text_file(path, "list of what is allowed", most_bytes));
  for (std::string line; std::getline(text, line);)
    if (const std::size_t first = line.find_first_not_of(" \t\r");
        first != std::string::npos && line[first] != '#')
      lines.push_back(line.substr(first));
  return lines;
}

std::string text_of(const compare::Differences& differences) {
  std::string text;
  for (const std::string& version : differences.versions) text += "version " + version + "\n";
  text += fmt::format("compared {} rows of {} tables: {} values differ{}\n", differences.compared,
                      differences.tables, differences.rows.size(),
                      differences.rows.empty() ? "" : "; times are not compared, see --commands");
  if (!differences.rows.empty())
    text += record::table_of(differences.rows, compare::DifferenceRow::shown).text();
  return text;
}

int compare_results(const CompareOptions& options) {
  if (!(options.within >= 0 && options.within < 1))
    throw UsageError("--within: got {}, expected a part from 0 to 1", options.within);
  std::optional<record::OutputFolder> folder;
  if (!options.out.empty()) folder.emplace(options.out);
  compare::Differences differences;
  try {
    differences = compare::compare_folders(options.before, options.after, lines_of(options.allow),
                                           options.within);
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
  print(options.format == "json"  ? record::json_of(differences)
        : options.format == "csv" ? record::csv_text(differences.rows)
                                  : text_of(differences));
  if (folder) record::write(differences, *folder);
  return differences.has_regression() ? check_failed : success;
}

/// Lays solvers over results that lack them, and compares exactly what both have.
int lay_over(const CompareOptions& options) {
  std::optional<record::OutputFolder> folder;
  if (!options.out.empty()) folder.emplace(options.out);
  compare::Overlay overlay;
  compare::Differences differences;
  try {
    const compare::ResultSet before(options.before), after(options.after);
    overlay = compare::overlay_of(before, after);
    differences = compare::compare_common(before, after, lines_of(options.allow), options.within);
    overlay.differences = differences.rows;
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
  print(options.format == "json" ? record::json_of(overlay)
        : options.format == "csv"
            ? record::csv_text(overlay.rows)
            : text_of(differences) + fmt::format("speed   {}\n", overlay.speed) +
                  record::table_of(overlay.rows, compare::OverlayRow::shown).text());
  if (folder) record::write(overlay, *folder);
  return differences.has_regression() ? check_failed : success;
}

int compare_commands(const CompareOptions& options) {
  constexpr std::size_t fewest = 11, most = 1000;
  if (options.pairs < fewest || options.pairs > most)
    throw UsageError("--pairs: got {}, expected {} to {}", options.pairs, fewest, most);
  if (!(options.slower >= 0))
    throw UsageError("--slower: got {}, expected 0 or more", options.slower);
  compare::Times times;
  try {
    times.rows.push_back(compare::compare_times(options.before, options.after, options.pairs));
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
  const compare::TimesRow& row = times.rows.front();
  const bool slower = row.is_slower(options.slower);
  const std::string verdict = fmt::format(
      "{} takes {:.4f} times the processor time, between {:.4f} and {:.4f}: {}\n", row.after,
      row.ratio, row.ratio_low, row.ratio_high,
      slower               ? "slower"
      : row.ratio_high < 1 ? "faster"
      : row.ratio_low > 1  ? fmt::format("slower by less than {:g} %", 100 * options.slower)
                           : "no difference is seen");
  print(options.format == "table"
            ? verdict + record::table_of(times.rows, compare::TimesRow::shown).text()
        : options.format == "csv" ? record::csv_text(times.rows)
                                  : record::json_of(times));
  return slower ? check_failed : success;
}

}  // namespace

void add_compare(CLI::App& app, int& result) {
  const auto options = std::make_shared<CompareOptions>();
  CLI::App* command = app.add_subcommand(
      "compare",
      "what has changed between two folders of results, exactly; or, with --commands, which of two "
      "commands takes less time");
  add_option(*command, "before OLD", options->before,
             "a folder that a command wrote with --out, or the results.tar.gz of a report")
      ->required();
  add_option(*command, "after NEW", options->after, "that of the newer version")->required();
  command->add_flag("--commands", options->commands,
                    "OLD and NEW are command lines: both are run in turn, and their processor time "
                    "is compared in pairs");
  add_option(*command, "--pairs N", options->pairs, "of runs, with --commands; default: {}");
  add_option(*command, "--slower PART", options->slower,
             "with --commands: exit code 1 where the newer takes more by this part at least; "
             "default: {}");
  add_option(*command, "--within PART", options->within,
             "numbers may differ by that part, and folders of another machine are compared; "
             "default: {}");
  command->add_flag("--overlay", options->overlay,
                    "lay the solvers that NEW alone has over those of OLD, at equal errors, and "
                    "compare what both have, whatever their machines: times are a hint");
  add_option(*command, "--allow FILE", options->allow,
             "lines of globs on table, run, column and change (trailing ones may be left out) of "
             "differences that are not regressions");
  add_format(*command, options->format);
  add_option(*command, "--out DIR", options->out,
             "folder for differences.csv, and with --overlay for overlay.csv");
  command->callback([options, &result] {
    result = options->commands  ? compare_commands(*options)
             : options->overlay ? lay_over(*options)
                                : compare_results(*options);
  });
}

}  // namespace odeum::cli
