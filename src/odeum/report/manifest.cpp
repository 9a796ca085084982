// SPDX-License-Identifier: BSD-3-Clause
#include <nlohmann/json.hpp>

#include "odeum/core/machine.hpp"
#include "odeum/report/page.hpp"
#include "odeum_build_info.hpp"

namespace odeum::report {
namespace {

using nlohmann::ordered_json;

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

}  // namespace odeum::report
