// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>

#include "odeum/record/archive.hpp"
#include "odeum/record/csv.hpp"

namespace odeum::compare {

/// The results of a command: a folder that it wrote with --out, or the archive of one.
class ResultSet {
 public:
  /// Throws std::invalid_argument where there is no manifest.json, and record::ArchiveError.
  explicit ResultSet(const std::filesystem::path& path);

  const std::string& name() const { return name_; }
  const nlohmann::json& manifest() const { return manifest_; }
  /// Names of tables, without the ending of those that are compressed.
  const std::set<std::string>& tables() const { return tables_; }
  /// Throws record::FileError for a table that is damaged.
  record::Records table(const std::string& table) const;

 private:
  std::filesystem::path path_;
  std::string name_;
  std::optional<record::Archive> archive_;
  nlohmann::json manifest_;
  std::set<std::string> tables_;
};

/// Throws std::invalid_argument where a table has another version (its column `schema`) in one of
/// the two, since a column may have another meaning there.
void require_same_schema(const std::string& table, const record::Records& before,
                         const record::Records& after);

}  // namespace odeum::compare
