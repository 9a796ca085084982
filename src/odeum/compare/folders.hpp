// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <tuple>
#include <vector>

#include "odeum/compare/result_set.hpp"
#include "odeum/core/numbers.hpp"
#include "odeum/record/row.hpp"

/// What has changed between two folders of results, and which of two programs takes less time.
namespace odeum::compare {

/// How a value of the newer folder stands to that of the older one.
enum class Change { better, worse, changed, missing, added };
const char* to_string(Change change);

/// A value that differs between two folders.
struct DifferenceRow {
  std::string table;     ///< the file's name in both folders
  std::string run;       ///< the cells that tell its row from others: case, solver, setting
  std::string quantity;  ///< the column; empty: the whole row is missing, or was added
  Change change = Change::changed;
  std::string before, after;
  double ratio = nan;   ///< of numbers, after over before
  std::string allowed;  ///< the line of the list that allows it; empty: none does

  static constexpr const char* file = "differences.csv";
  static constexpr const char* shown = "table run quantity change before after ratio:.4g allowed";
  ODEUM_COLUMNS(table, run, quantity, change, before, after, ratio, allowed)
};

struct Differences {
  std::vector<DifferenceRow> rows = {};
  std::size_t tables = 0, compared = 0;  ///< files in both folders; rows of these that are in both
  std::vector<std::string> versions = {};  ///< sentences: which version was which
  static auto lists(auto& result) { return std::tie(result.rows); }
  /// Whether a value is worse, or a row missing, that is not allowed.
  bool has_regression() const;
};

/// Compares every table that both folders have. Rows are those of one run where the cells that name
/// it agree (case, solver, setting, ...). Texts and numbers are compared exactly: the runs of one
/// program on one machine give the same bits. Times, and sentences, are not compared. Larger
/// errors, counts and floors, lower orders, and statuses, verdicts and answers of less worth are
/// `worse`. With `within` above 0 numbers may differ by that part of the larger one, and folders of
/// other machines and compilers are compared. `allowed`: lines of four globs, `table run quantity
/// change`, of which trailing ones may be left out. Throws std::invalid_argument where the folders
/// can't be compared: no manifest.json, other options, another processor or other flags of the
/// compiler, another version of a table, or no table in both; and record::FileError for a file that
/// can't be read. Each may be the archive of a folder (record/archive.hpp).
Differences compare_folders(const std::filesystem::path& before, const std::filesystem::path& after,
                            const std::vector<std::string>& allowed, double within = 0);

/// The same of what runs that both have are by themselves, errors, counts and verdicts, whatever
/// machine and options they are of: `versions` names these where they differ.
Differences compare_common(const ResultSet& before, const ResultSet& after,
                           const std::vector<std::string>& allowed, double within);

}  // namespace odeum::compare
