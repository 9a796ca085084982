// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/report/manifest.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "odeum/report/page.hpp"
#include "odeum/report/summary.hpp"
#include "odeum_build_info.hpp"

namespace odeum::report {
namespace {

using nlohmann::ordered_json;

ordered_json libraries_json(const ReportData& data) {
  ordered_json list = ordered_json::array();
  for (const LibraryInfo& info : data.libraries) {
    ordered_json entry{{"name", info.name}, {"solvers", info.libraries}, {"built", info.built}};
    entry["version"] = info.built ? ordered_json(info.version) : ordered_json(nullptr);
    if (!info.built) entry["option"] = info.option;
    list.push_back(entry);
  }
  return list;
}

// Pairs that were not run, by the reason that they gave; runs that ended early, by their status.
ordered_json skipped_json(const ReportData& data) {
  std::map<std::string, std::size_t> reasons;
  for (const auto& row : data.convergence.rows)
    if (row.status == "not_applicable") ++reasons[row.detail];
  ordered_json not_applicable = ordered_json::array();
  for (const auto& [reason, pairs] : reasons)
    not_applicable.push_back({{"reason", reason}, {"pairs", pairs}});
  return {{"not_applicable", not_applicable}, {"rows_by_status", status_counts(data)}};
}

ordered_json verdicts_json(const ReportData& data) {
  ordered_json list = ordered_json::array();
  for (const LibrarySummary& summary : summarise(data)) {
    ordered_json entry{
        {"library", summary.library}, {"solvers", summary.solvers}, {"pairs", summary.pairs}};
    for (const VerdictStyle& style : verdict_styles)
      entry[to_string(style.verdict)] = summary.count(style.verdict);
    list.push_back(entry);
  }
  return list;
}

ordered_json libraries_of(const std::vector<LibraryInfo>& libraries) {
  ordered_json list = ordered_json::array();
  for (const LibraryInfo& info : libraries) {
    ordered_json entry{{"name", info.name}, {"solvers", info.libraries}, {"built", info.built}};
    entry["version"] = info.built ? ordered_json(info.version) : ordered_json(nullptr);
    if (!info.built) entry["option"] = info.option;
    list.push_back(entry);
  }
  return list;
}

}  // namespace

std::string Page::manifest_text(const RunFacts& run) const {
  ordered_json manifest{
      {"schema", 2},
      {"odeum", {{"version", build::version}, {"revision", build::revision}}},
      {"date", utc_text(run.finished)},
      {"command_line", run.command_line},
      {"options", {{"quick", run.quick}}},
      {"seconds", run.seconds},
      {"build", {{"compiler", build::compiler}, {"type", build::type}, {"flags", build::flags}}},
      {"cpu", cpu_model()},
      {"libraries", libraries_of(facts_.libraries)}};
  for (const auto& [key, value] : manifest_) manifest[key] = ordered_json::parse(value);
  // Pairs that were not run, by the reason that they gave; rows by how their run ended.
  ordered_json reasons = ordered_json::array();
  for (const auto& [reason, pairs] : reasons_)
    reasons.push_back({{"reason", reason}, {"pairs", pairs}});
  manifest["skipped"] = {{"not_applicable", reasons}, {"rows_by_status", statuses_}};
  // Text of others may be no UTF-8; the file is valid all the same.
  return manifest.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

std::string manifest_json(const ReportData& data, const std::string& plots) {
  const ordered_json manifest{
      {"schema", 1},
      {"odeum", {{"version", build::version}, {"revision", build::revision}}},
      {"date", utc_text(data.finished)},
      {"command_line", data.command_line},
      {"options", {{"quick", data.quick}}},
      {"seconds", data.seconds},
      {"build", {{"compiler", build::compiler}, {"type", build::type}, {"flags", build::flags}}},
      {"cpu", cpu_model()},
      {"libraries", libraries_json(data)},
      {"plots", plots},
      {"verdicts", verdicts_json(data)},
      {"skipped", skipped_json(data)}};
  // Text of others may be no UTF-8; the file is valid all the same.
  return manifest.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

std::string cpu_model() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name"))
      if (const auto colon = line.find(": "); colon != std::string::npos)
        return line.substr(colon + 2);
  return "unknown";
}

std::string utc_text(std::chrono::system_clock::time_point time) {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}",
                     fmt::gmtime(std::chrono::system_clock::to_time_t(time)));
}

}  // namespace odeum::report
