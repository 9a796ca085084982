// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/compare/result_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "odeum/input/text_file.hpp"
#include "odeum/record/output_folder.hpp"
#include "odeum/record/records.hpp"
#include "odeum/record/rows.hpp"

namespace odeum::compare {
namespace {

constexpr std::string_view table_end = ".csv", packed_end = ".csv.gz";

std::string schema_of(const record::Records& records) {
  const auto found = std::ranges::find(records.columns, "schema");
  if (found == records.columns.end()) return "none";
  if (records.rows.empty()) return {};
  return record::cell_text(
      records.rows.front()[static_cast<std::size_t>(found - records.columns.begin())]);
}

}  // namespace

ResultSet::ResultSet(const std::filesystem::path& path) : path_(path), name_(path.string()) {
  std::optional<std::string> manifest;
  if (std::filesystem::is_regular_file(path)) {
    archive_ = record::read_archive(path);
    manifest = archive_->at("manifest.json");
    for (const auto& [table, text] : *archive_)
      if (table.ends_with(table_end)) tables_.insert(table);
  } else if (std::filesystem::is_directory(path)) {
    manifest = text_of_file(path / "manifest.json");
    for (const auto& entry : std::filesystem::directory_iterator(path)) {
      std::string table = entry.path().filename().string();
      if (table.ends_with(packed_end))
        table.resize(table.size() - packed_end.size() + table_end.size());
      if (table.ends_with(table_end)) tables_.insert(table);
    }
  }
  manifest_ = manifest ? nlohmann::json::parse(*manifest, nullptr, false) : nlohmann::json();
  if (!manifest_.is_object())
    throw std::invalid_argument(
        fmt::format("{}: got no manifest.json, expected a folder that a command of Odeum wrote "
                    "with --out, or the archive of a report",
                    name_));
}

record::Records ResultSet::table(const std::string& table) const {
  if (archive_) try {
      return record::records_of(archive_->at(table), name_ + ": " + table);
    } catch (const record::FileError& error) {
      throw record::ArchiveError(error.what());
    }
  const bool plain = std::filesystem::exists(path_ / table);
  return record::read_records(path_, plain ? table : table + ".gz");
}

void require_same_schema(const std::string& table, const record::Records& before,
                         const record::Records& after) {
  const std::string was = schema_of(before), is = schema_of(after);
  if (was != is && !was.empty() && !is.empty())
    throw std::invalid_argument(
        fmt::format("{} can't be compared: its format has version {} in the first and {} in the "
                    "second; measure the older one again, or compare it by a program of its time",
                    table, was, is));
}

}  // namespace odeum::compare
