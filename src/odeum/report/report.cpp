// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/report/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>

#include "odeum/core/build_info.hpp"
#include "odeum/core/machine.hpp"
#include "odeum/core/parallel.hpp"
#include "odeum/input/text_file.hpp"
#include "odeum/report/columns.hpp"
#include "odeum/report/facts.hpp"
#include "odeum/report/shared_files.hpp"
#include "odeum/report/text.hpp"
#include "odeum/solvers/loaded.hpp"

namespace odeum::report {
namespace {

using nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr int schema = 2;  ///< of page.json and data/; 2: data is handed to odeum.receive

// Text of others may be no UTF-8; the file is valid all the same.
std::string text_of(const ordered_json& json, int indent = -1) {
  return json.dump(indent, ' ', false, ordered_json::error_handler_t::replace);
}

std::string stem_of(const std::string& file) { return file.substr(0, file.find('.')); }

/// The names in a folder of the shared one; none where it is not there.
std::set<fs::path> names_in(const fs::path& folder) {
  std::set<fs::path> names;
  std::error_code none;
  if (const auto shared = shared_folder())
    for (const auto& entry : fs::directory_iterator(*shared / folder, none))
      names.insert(entry.path().filename());
  return names;
}

/// The texts of a folder of pages, by the names of their files.
std::map<std::string, std::string> texts_of(const fs::path& folder) {
  std::map<std::string, std::string> texts;
  for (const fs::path& name : names_in(folder))
    if (name.extension() == ".md" || name.extension() == ".js")
      texts[name.string()] = shared_text(folder / name);
  return texts;
}

/// The documents by name: each with what lies in a folder of its name, the columns with those of
/// all studies.
std::map<std::string, std::string> documents() {
  std::map<std::string, std::string> all;
  for (const auto& [file, text] : texts_of("documents")) {
    std::string& document = all[stem_of(file)] = text;
    for (const auto& [part, more] : texts_of(fs::path("documents") / stem_of(file)))
      document += "\n" + more;
  }
  for (const fs::path& study : names_in("pages"))
    all["columns"] += "\n" + shared_text("pages" / study / "columns.md");
  return all;
}

ordered_json json_of(const StudyFacts& study) {
  ordered_json json{{"name", study.name},
                    {"command", study.command},
                    {"help", study.help},
                    {"place", study.place},
                    {"figures", study.figures},
                    {"problem", plain(study.problem)},
                    {"selection", plain(study.selection)},
                    {"measured", study.measured},
                    {"pages", ordered_json::array()},
                    {"case_page", ""},
                    {"summary", ""},
                    {"script", ""}};
  for (const auto& [file, text] : texts_of(fs::path("pages") / study.name)) {
    const std::string stem = stem_of(file);
    if (file == "view.js")
      json["script"] = "viewer/view-" + study.name + ".js";
    else if (stem == "case")
      json["case_page"] = text;
    else if (stem == "summary")
      json["summary"] = text;
    else if (stem != "columns")
      json["pages"].push_back({{"id", stem == "page" ? study.name : stem}, {"text", text}});
  }
  return json;
}

std::string key_of(const ordered_json& entry) {
  if (entry.contains("library"))
    return entry.value("library", "") + "/" + entry.value("method", "");
  return entry.contains("id") ? entry.value("id", "") : entry.value("name", "");
}

/// Appends the entries of an earlier list whose keys the new one has not.
void add_missing(ordered_json& list, const ordered_json& earlier) {
  std::set<std::string> known;
  for (const auto& entry : list) known.insert(key_of(entry));
  for (const auto& entry : earlier)
    if (!known.contains(key_of(entry))) list.push_back(entry);
}

/// What an earlier run said of a study that was not measured now.
void keep_origin(ordered_json& studies, const ordered_json& earlier) {
  for (auto& study : studies)
    for (const auto& before : earlier)
      if (!study.value("measured", true) && before.value("name", "") == study["name"])
        for (const char* key : {"problem", "selection", "measured"})
          if (before.contains(key)) study[key] = before[key];
}

}  // namespace

Report::Report(Facts facts, const record::OutputFolder& folder, unsigned jobs)
    : facts_(std::move(facts)), folder_(folder), jobs_(jobs) {}

void Report::table(const std::string& study, const std::string& file, const record::Fields& blank,
                   const std::vector<TablePart>& parts) {
  const std::string name = stem_of(file);
  std::vector<std::string> columns;
  for (const record::Field& field : blank) columns.push_back(field.column);
  const auto data_name = [&](std::size_t i) {
    return parts.size() == 1 ? name : fmt::format("{}-{}", name, i);
  };
  std::size_t rows = 0;
  ordered_json list = ordered_json::array();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    list.push_back({{"data", data_name(i)}, {"rows", parts[i].rows}});
    if (!parts[i].case_id.empty()) list.back()["case"] = plain(parts[i].case_id);
    rows += parts[i].rows;
  }
  std::mutex counting;
  std::set<std::string> cases;
  parallel_for(parts.size(), jobs_, [&](std::size_t i) {
    const std::vector<record::Fields> fields = parts[i].fields();
    folder_.write(fmt::format("data/{}.js", data_name(i)),
                  data_script(data_name(i), columns_json(fields, columns)));
    const std::lock_guard lock(counting);
    for (const record::Fields& row : fields)
      for (std::size_t k = 0; k < row.size(); ++k) {
        if (row[k].column == "case") cases.insert(record::cell_text(row[k].value));
        if (row[k].column != "status") continue;
        const std::string status = record::cell_text(row[k].value);
        ++statuses_[file][status];
        if (status == "not_applicable" && k + 1 < row.size() && row[k + 1].column == "detail")
          ++reasons_[record::cell_text(row[k + 1].value)];
      }
  });
  tables_.push_back(text_of({{"name", name},
                             {"file", file},
                             {"study", study},
                             {"rows", rows},
                             {"columns", columns},
                             {"parts", list},
                             {"cases", cases}}));
}

void Report::table(const std::string& study, const std::string& file, const record::Records& rows) {
  record::Fields blank;
  for (const std::string& column : rows.columns) blank.push_back({column, {}});
  std::vector<TablePart> parts;
  if (!rows.rows.empty())
    parts.push_back({"", rows.rows.size(), [&rows] { return rows.fields(); }});
  table(study, file, blank, parts);
}

void Report::data(const std::string& name, const std::string& json) {
  folder_.write("data/" + name + ".js", data_script(name, json));
}

void Report::fact(const std::string& key, const ordered_json& value) {
  facts_more_[key] = text_of(value);
}

void Report::manifest(const std::string& key, const ordered_json& value) {
  manifest_[key] = text_of(value);
}

ordered_json Report::page_json(const RunFacts& run, bool keep_earlier) const {
  ordered_json page{
      {"schema", schema},
      {"odeum", {{"version", build::version}, {"revision", build::revision}}},
      {"run",
       {{"command", run.command_line},
        {"quick", run.quick},
        {"seconds", run.seconds},
        {"date", utc_text(run.finished)},
        {"compiler", fmt::format("{}, {}, {}", build::compiler, build::type, build::flags)},
        {"processor", cpu_model()},
        {"loaded", ordered_json::array()}}},
      {"libraries", report::json_of(facts_.libraries)},
      {"cases", ordered_json::array()},
      {"solvers", ordered_json::array()},
      {"studies", ordered_json::array()},
      {"tables", ordered_json::array()},
      {"documents", ordered_json::array()}};
  for (const LoadedLibrary& each : loaded_of(facts_.libraries))
    page["run"]["loaded"].push_back(each.text());
  for (const CaseFacts& c : facts_.cases) page["cases"].push_back(report::json_of(c));
  for (const SolverInfo& solver : facts_.solvers)
    page["solvers"].push_back(report::json_of(solver));
  std::vector<StudyFacts> studies = studies_;
  std::ranges::stable_sort(studies, [](const auto& a, const auto& b) { return a.place < b.place; });
  for (const StudyFacts& study : studies) page["studies"].push_back(json_of(study));
  for (const std::string& table : tables_) page["tables"].push_back(ordered_json::parse(table));
  for (const auto& [name, text] : documents()) page["documents"].push_back(name);
  for (const auto& [key, value] : facts_more_) page[key] = ordered_json::parse(value);
  if (!keep_earlier) return page;
  const auto text = text_of_file((folder_.path() / "page.json").string());
  const auto earlier = ordered_json::parse(text.value_or(""), nullptr, false);
  if (!earlier.is_object() || earlier.value("schema", 0) != schema) return page;
  for (const char* list : {"cases", "solvers", "tables"})
    if (earlier.contains(list)) add_missing(page[list], earlier[list]);
  if (earlier.contains("studies")) keep_origin(page["studies"], earlier["studies"]);
  for (const auto& [key, value] : earlier.items())
    if (!page.contains(key)) page[key] = value;
  return page;
}

std::string Report::manifest_text(const RunFacts& run) const {
  ordered_json manifest{
      {"schema", 3},
      {"odeum", {{"version", build::version}, {"revision", build::revision}}},
      {"date", utc_text(run.finished)},
      {"command_line", run.command_line},
      {"options", {{"quick", run.quick}}},
      {"seconds", run.seconds},
      {"build", {{"compiler", build::compiler}, {"type", build::type}, {"flags", build::flags}}},
      {"cpu", cpu_model()},
      {"libraries", report::json_of(facts_.libraries)}};
  manifest.update(facts_of_process());
  for (const auto& [key, value] : manifest_) manifest[key] = ordered_json::parse(value);
  // Pairs that were not run, by the reason that they gave; rows by how their run ended.
  ordered_json reasons = ordered_json::array();
  for (const auto& [reason, rows] : reasons_)
    reasons.push_back({{"reason", reason}, {"rows", rows}});
  manifest["skipped"] = {{"not_applicable", reasons}, {"rows_by_status", statuses_}};
  return text_of(manifest, 2) + "\n";
}

bool Report::write(const RunFacts& run, bool keep_earlier) {
  const ordered_json page = page_json(run, keep_earlier);
  data("facts", text_of(page));
  folder_.write("page.json", text_of(page) + "\n");
  data("documents", text_of(ordered_json(documents())));
  for (const StudyFacts& study : studies_)
    if (const std::string view = shared_text(fs::path("pages") / study.name / "view.js");
        !view.empty())
      folder_.write("viewer/view-" + study.name + ".js", view);
  folder_.write("manifest.json", manifest_text(run));
  std::vector<std::string> files;
  for (const auto& table : page["tables"])
    if (const std::string file = table.value("file", "");
        table.value("rows", 0) > 0 && file.find('.') != std::string::npos)
      files.push_back(file);
  files.insert(files.end(), {"manifest.json", "page.json"});
  if (!shared_folder()) return false;
  write_viewer(folder_, files);
  return true;
}

}  // namespace odeum::report
