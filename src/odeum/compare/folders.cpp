// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/compare/folders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "odeum/compare/result_set.hpp"
#include "odeum/core/glob.hpp"

namespace odeum::compare {
namespace {

using record::Records;
using Json = nlohmann::json;

/// Columns that tell runs apart, wherever they stand.
bool names_a_run(const std::string& column) {
  static const std::set<std::string> names{
      "case",   "library", "solver",    "mode",      "setting_kind", "setting", "tol",
      "step",   "time",    "component", "invariant", "stop",         "path",    "series",
      "level",  "plane",   "name",      "parameter", "member",       "problem", "decade",
      "target", "method",  "index",     "width",     "stages"};
  return names.contains(column);
}

/// Times are of a day, and sentences say again what numbers do.
bool is_left_out(const std::string& column) {
  static const std::set<std::string> names{"schema",   "detail",      "reason", "answer_reason",
                                           "remarks",  "repetitions", "drift",  "processor_share",
                                           "measured", "replay"};
  for (const char* part : {"_ns", "ns_", "seconds", "wall", "speed", "time_"})
    if (column.find(part) != std::string::npos) return true;
  return names.contains(column);
}

/// What a run is by itself, whatever else was measured.
bool is_of_one_run(const std::string& column) {
  static const std::set<std::string> names{
      "status",          "verdict",   "claim",          "answer",
      "error",           "error_max", "error_rms",      "energy_error",
      "achieved",        "steps",     "rejected_steps", "measured_order",
      "rhs_evaluations", "order_low", "order_high",     "jacobian_evaluations"};
  return names.contains(column);
}

/// Numbers of which less is better, and of which more is.
bool is_cost(const std::string& column) {
  for (const char* part : {"error", "evaluations", "rejected", "steps", "floor", "products"})
    if (column.find(part) != std::string::npos) return true;
  return false;
}
bool is_worth(const std::string& column) {
  return column == "measured_order" || column == "horizon" || column == "limit";
}

/// The worth of a status, a verdict or an answer; nothing for another text.
std::optional<int> worth_of(const std::string& text) {
  static const std::map<std::string, int> worth{
      {"ok", 3},           {"confirmed", 3},      {"higher", 3},
      {"explained", 3},    {"held", 3},           {"open", 2},
      {"undetermined", 2}, {"not_applicable", 2}, {"over_budget", 1},
      {"floors", 1},       {"lower", 0},          {"denied", 0},
      {"failed", 0},       {"wrong", 0},          {"none", 1},
      {"non_finite", 0},   {"newton_failed", 0},  {"step_too_small", 0},
      {"refused", 0}};
  const auto found = worth.find(text);
  return found == worth.end() ? std::nullopt : std::optional(found->second);
}

std::optional<double> number_in(const std::string& text) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || rest != end) return {};
  return value;
}

Change change_of(const std::string& column, const std::string& before, const std::string& after) {
  if (column == "status" || column == "verdict" || column == "answer" || column == "claim") {
    const std::optional<int> was = worth_of(before), is = worth_of(after);
    if (!was || !is || *was == *is) return Change::changed;
    return *is > *was ? Change::better : Change::worse;
  }
  const std::optional<double> was = number_in(before), is = number_in(after);
  if (!was || !is || (!is_cost(column) && !is_worth(column))) return Change::changed;
  // A number that is not known any more is a loss.
  if (std::isnan(*was) != std::isnan(*is)) return std::isnan(*is) ? Change::worse : Change::better;
  return (*is > *was) == is_worth(column) ? Change::better : Change::worse;
}

std::string text_of(const Json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

/// Sentences on what differs of all that decides the bits of results, the options first.
std::vector<std::string> other_conditions(const Json& before, const Json& after) {
  std::vector<std::string> others;
  for (const char* key : {"/options", "/cpu", "/build/compiler", "/build/type", "/build/flags"}) {
    const Json::json_pointer at(key);
    const Json was = before.value(at, Json()), is = after.value(at, Json());
    if (was != is)
      others.push_back(fmt::format("{} is {} in the first and {} in the second",
                                   std::string(key).substr(1), text_of(was), text_of(is)));
  }
  return others;
}

void require_same_conditions(const Json& before, const Json& after, bool any_machine) {
  const std::vector<std::string> others = other_conditions(before, after);
  if (!others.empty() && (!any_machine || others.front().starts_with("options")))
    throw std::invalid_argument("the folders can't be compared: " + others.front());
}

void note_versions(const Json& before, const Json& after, std::vector<std::string>& versions) {
  const auto add = [&](const std::string& what, const Json& was, const Json& is) {
    if (was != is)
      versions.push_back(
          fmt::format("{} is {} before and {} after", what, text_of(was), text_of(is)));
  };
  const Json::json_pointer version("/odeum/version"), revision("/odeum/revision");
  add("odeum", before.value(version, Json()), after.value(version, Json()));
  add("its revision", before.value(revision, Json()), after.value(revision, Json()));
  std::map<std::string, std::pair<Json, Json>> libraries;
  const auto take = [&](const Json& manifest, auto version_of) {
    for (const Json& each : manifest.value("libraries", Json()))
      if (each.is_object() && each.value("name", Json()).is_string())
        libraries[each["name"]].*version_of = each.value("version", Json());
  };
  take(before, &std::pair<Json, Json>::first);
  take(after, &std::pair<Json, Json>::second);
  for (const auto& [name, both] : libraries) add(name, both.first, both.second);
}

/// The rows of a table by the cells that name their run; the number of its kind is added to those
/// that are named alike.
std::map<std::string, std::map<std::string, std::string>> runs_of(const Records& records) {
  std::map<std::string, std::map<std::string, std::string>> runs;
  for (const std::vector<record::Cell>& row : records.rows) {
    std::string name;
    std::map<std::string, std::string> cells;
    for (std::size_t k = 0; k < row.size(); ++k) {
      const std::string& column = records.columns[k];
      const std::string cell = record::cell_text(row[k]);
      if (!names_a_run(column))
        cells[column] = cell;
      else if (column == "solver" && !name.empty())
        name += "/" + cell;  // after its library
      else if (!cell.empty() && cell != "nan")
        name += (name.empty() ? "" : " ") + cell;
    }
    std::string unused = name;
    for (int number = 2; runs.contains(unused); ++number)
      unused = fmt::format("{} #{}", name, number);
    runs[unused] = std::move(cells);
  }
  return runs;
}

/// Whether both are numbers that differ by that part at most.
bool is_within(const std::string& before, const std::string& after, double part) {
  const std::optional<double> was = number_in(before), is = number_in(after);
  return part > 0 && was && is &&
         std::abs(*is - *was) <= part * std::max(std::abs(*was), std::abs(*is));
}

void compare_tables(const std::string& table, const Records& before, const Records& after,
                    double within, Differences& differences) {
  const auto was = runs_of(before), is = runs_of(after);
  const auto add = [&](const std::string& run, const std::string& quantity, Change change,
                       const std::string& old_value, const std::string& value) {
    DifferenceRow row;
    row.table = table, row.run = run, row.quantity = quantity, row.change = change;
    row.before = old_value, row.after = value;
    if (const auto x = number_in(old_value), y = number_in(value); x && y) row.ratio = *y / *x;
    differences.rows.push_back(row);
  };
  for (const auto& [run, cells] : was) {
    const auto same = is.find(run);
    if (same == is.end()) {
      add(run, "", Change::missing, "", "");
      continue;
    }
    ++differences.compared;
    for (const auto& [column, cell] : cells) {
      const auto now = same->second.find(column);
      if (is_left_out(column) || now == same->second.end() || now->second == cell ||
          is_within(cell, now->second, within))
        continue;
      add(run, column, change_of(column, cell, now->second), cell, now->second);
    }
  }
  for (const auto& [run, cells] : is)
    if (!was.contains(run)) add(run, "", Change::added, "", "");
}

bool allows(const std::string& line, const DifferenceRow& row) {
  std::istringstream words(line);
  std::string glob;
  for (const std::string& value :
       {row.table, row.run, row.quantity, std::string(to_string(row.change))})
    if (words >> glob && !glob_matches(glob, value)) return false;
  return true;
}

}  // namespace

const char* to_string(Change change) {
  switch (change) {
    case Change::better:
      return "better";
    case Change::worse:
      return "worse";
    case Change::missing:
      return "missing";
    case Change::added:
      return "added";
    case Change::changed:
      break;
  }
  return "changed";
}

bool Differences::has_regression() const {
  return std::ranges::any_of(rows, [](const DifferenceRow& row) {
    return row.allowed.empty() && (row.change == Change::worse || row.change == Change::missing);
  });
}

namespace {

Differences compare_tables_of(const ResultSet& older, const ResultSet& newer,
                              const std::vector<std::string>& allowed, double within) {
  Differences differences;
  note_versions(older.manifest(), newer.manifest(), differences.versions);
  for (const std::string& table : older.tables()) {
    if (!newer.tables().contains(table)) continue;
    const Records was = older.table(table), is = newer.table(table);
    require_same_schema(table, was, is);
    ++differences.tables;
    compare_tables(table, was, is, within, differences);
  }
  if (differences.tables == 0)
    throw std::invalid_argument(
        fmt::format("{} and {} have no table in common", older.name(), newer.name()));
  for (DifferenceRow& row : differences.rows)
    for (const std::string& line : allowed)
      if (row.allowed.empty() && allows(line, row)) row.allowed = line;
  return differences;
}

}  // namespace

Differences compare_folders(const std::filesystem::path& before, const std::filesystem::path& after,
                            const std::vector<std::string>& allowed, double within) {
  const ResultSet older(before), newer(after);
  require_same_conditions(older.manifest(), newer.manifest(), within > 0);
  return compare_tables_of(older, newer, allowed, within);
}

Differences compare_common(const ResultSet& before, const ResultSet& after,
                           const std::vector<std::string>& allowed, double within) {
  Differences differences = compare_tables_of(before, after, allowed, within);
  std::erase_if(differences.rows, [](const DifferenceRow& row) {
    return row.quantity.empty() || !is_of_one_run(row.quantity);
  });
  for (const std::string& other : other_conditions(before.manifest(), after.manifest()))
    differences.versions.push_back(other);
  return differences;
}

}  // namespace odeum::compare
