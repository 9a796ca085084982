// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "odeum/core/build_info.hpp"
#include "odeum/core/machine.hpp"
#include "odeum/report/html.hpp"
#include "odeum/report/page.hpp"

namespace odeum::report {
namespace {

std::string fact(const char* name, const std::string& value) {
  return fmt::format("<dt>{}</dt><dd>{}</dd>\n", name, escape(value));
}

std::string libraries_text(const std::vector<LibraryInfo>& libraries, bool built) {
  std::string text;
  for (const LibraryInfo& info : libraries) {
    if (info.built != built) continue;
    text += text.empty() ? "" : ", ";
    text += built ? info.name + " " + info.version : info.name + " (" + info.option + ")";
  }
  return text;
}

std::string facts_of(const RunFacts& run, const std::vector<LibraryInfo>& libraries) {
  std::string html = "<dl class=\"facts\">\n";
  html += fact("Written", utc_text(run.finished));
  html += fact("Command",
               run.command_line +
                   (run.quick ? "  (quick: nine cases, without the orders on the cloth)" : ""));
  html += fact("Took", fmt::format("{:.0f} s", run.seconds));
  html += fact("Odeum", fmt::format("{} {}", build::version, build::revision));
  html += fact("Libraries", libraries_text(libraries, true));
  if (const std::string missing = libraries_text(libraries, false); !missing.empty())
    html += fact("Not built in", missing);
  html += fact("Compiler", fmt::format("{}, {}, {}", build::compiler, build::type, build::flags));
  html += fact("Processor", cpu_model());
  return html + "</dl>\n";
}

std::string statuses_text(const std::map<std::string, std::size_t>& statuses) {
  std::string text;
  std::size_t all = 0;
  for (const auto& [status, count] : statuses) {
    text += fmt::format("{}{} <code>{}</code>", text.empty() ? "" : ", ", count, escape(status));
    all += count;
  }
  return all == 0 ? "" : fmt::format("<p>{}: {}.</p>\n", show_count(all, "row"), text);
}

// The data files of a folder, as links relative to the page.
std::string links(const std::filesystem::path& folder, const std::string& prefix) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    if (const auto name = entry.path().filename().string();
        name.ends_with(".csv") || name.ends_with(".csv.gz") || name == "manifest.json")
      names.push_back(name);
  std::sort(names.begin(), names.end());
  std::string html;
  for (const std::string& name : names)
    html +=
        fmt::format("<li><a href=\"{}\">{}</a></li>\n", as_address(prefix + name), escape(name));
  return html.empty() ? html : "<ul class=\"files\">\n" + html + "</ul>\n";
}

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

std::string Page::data_page(const RunFacts& run) const {
  return document(
      "Data – Odeum report", navigation("", "data.html"),
      "<section id=\"data\">\n<h2>Data</h2>\n<div class=\"columns\">\n<div><h3>The files</h3>\n"
      "<p>Everything in this report comes from the files beside it, one observation a row; "
      "<a href=\"columns.html\">what each column is</a>, with an example for pandas and one for "
      "gnuplot.</p>\n" +
          links(folder_.path(), "./") +
          details("Data of the stability regions",
                  links(folder_.path() / "stability", "stability/")) +
          "</div>\n<div><h3>This run</h3>\n" + facts_of(run, facts_.libraries) +
          "</div>\n</div>\n<h3>How many pairs got which verdict</h3>\n" + headline_ +
          statuses_text(statuses_) + "<h3>How to read the verdicts</h3>\n" + guide_ +
          "</section>\n");
}

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
