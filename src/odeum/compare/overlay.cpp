// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/compare/overlay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

namespace odeum::compare {
namespace {

constexpr const char* table = "precision.csv";

/// A run of precision.csv that ended well.
struct Run {
  std::string case_id, library, solver, setting;
  double error, evaluations, ns;
  std::string id() const { return library + "/" + solver; }
  std::string key() const { return case_id + " " + id() + " " + setting; }
};

double number_of(const std::string& text) {
  double value = nan;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

std::vector<Run> runs_of(const ResultSet& results) {
  if (!results.tables().contains(table))
    throw std::invalid_argument(
        fmt::format("{}: got no {}, expected the results of odeum precision or odeum report",
                    results.name(), table));
  const record::Records records = results.table(table);
  std::map<std::string, std::size_t> at;
  for (std::size_t k = 0; k < records.columns.size(); ++k) at[records.columns[k]] = k;
  for (const char* column : {"case", "library", "solver", "status", "setting_kind", "setting",
                             "error", "wall_ns_min", "rhs_evaluations"})
    if (!at.contains(column))
      throw std::invalid_argument(
          fmt::format("{}: {} has no column {}", results.name(), table, column));
  std::vector<Run> runs;
  for (const std::vector<record::Cell>& row : records.rows) {
    const auto cell = [&](const char* column) {
      const auto found = at.find(column);
      return found == at.end() ? std::string() : record::cell_text(row[found->second]);
    };
    if (cell("status") != "ok") continue;
    runs.push_back({cell("case"), cell("library"), cell("solver"),
                    cell("setting_kind") + " " + cell("setting") + " " + cell("options"),
                    number_of(cell("error")), number_of(cell("rhs_evaluations")),
                    number_of(cell("wall_ns_min"))});
  }
  return runs;
}

/// The factor that lets times of the newer results stand beside the older ones: the median over
/// runs that both have; NaN: too few.
double scale_of(const std::vector<Run>& before, const std::vector<Run>& after,
                std::size_t& common) {
  constexpr std::size_t fewest = 3;
  std::map<std::string, double> times;
  for (const Run& run : before) times[run.key()] = run.ns;
  std::vector<double> ratios;
  for (const Run& run : after)
    if (const auto same = times.find(run.key()); same != times.end())
      if (const double ratio = same->second / run.ns; std::isfinite(ratio) && ratio > 0)
        ratios.push_back(ratio);
  common = ratios.size();
  if (common < fewest) return nan;
  std::ranges::nth_element(ratios, ratios.begin() + static_cast<std::ptrdiff_t>(common / 2));
  return ratios[common / 2];
}

/// The least of a number, by solver, over its runs with an error of at most that.
std::map<std::string, double> least(const std::vector<const Run*>& runs, double error,
                                    double Run::*number) {
  std::map<std::string, double> found;
  for (const Run* run : runs) {
    if (!(run->error <= error) || !(run->*number > 0)) continue;
    const auto [at, added] = found.emplace(run->id(), run->*number);
    if (!added) at->second = std::min(at->second, run->*number);
  }
  return found;
}

using ByCase = std::map<std::string, std::vector<const Run*>>;

ByCase by_case(const std::vector<Run>& runs) {
  ByCase cases;
  for (const Run& run : runs) cases[run.case_id].push_back(&run);
  return cases;
}

std::map<std::string, double>::const_iterator first_of(const std::map<std::string, double>& all) {
  return std::ranges::min_element(all, {}, [](const auto& each) { return each.second; });
}

void add_rows(const std::string& case_id, const std::vector<const Run*>& older,
              const std::vector<const Run*>& newer, double scale, std::vector<OverlayRow>& rows) {
  std::set<std::string> known;
  for (const Run* run : older) known.insert(run->id());
  std::map<std::string, const Run*> added;
  for (const Run* run : newer)
    if (!known.contains(run->id())) added[run->id()] = run;
  for (const double error : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10}) {
    const auto before = least(older, error, &Run::evaluations),
               now = least(newer, error, &Run::evaluations);
    const auto times = least(older, error, &Run::ns), own_times = least(newer, error, &Run::ns);
    for (const auto& [id, run] : added) {
      OverlayRow row{case_id, run->library, run->solver, error};
      row.of = static_cast<double>(before.size());
      const auto own = now.find(id);
      if (own == now.end() && before.empty()) continue;  // nobody reaches it
      if (!before.empty()) {
        row.best = first_of(before)->first;
        row.best_evaluations = first_of(before)->second;
      }
      if (own != now.end()) {
        row.evaluations = own->second;
        row.ratio = row.evaluations / row.best_evaluations;
        row.place = 1 + static_cast<double>(std::ranges::count_if(before, [&](const auto& each) {
                      return each.second < row.evaluations;
                    }));
        if (const auto time = own_times.find(id); time != own_times.end() && !times.empty())
          row.time_hint = scale * time->second / first_of(times)->second;
      }
      rows.push_back(std::move(row));
    }
  }
}

std::string processor_of(const ResultSet& results) {
  const nlohmann::json cpu = results.manifest().value("cpu", nlohmann::json());
  return cpu.is_string() ? cpu.get<std::string>() : cpu.dump();
}

}  // namespace

Overlay overlay_of(const ResultSet& before, const ResultSet& after) {
  const std::vector<Run> was = runs_of(before), is = runs_of(after);
  Overlay overlay;
  std::size_t common = 0;
  const double scale = scale_of(was, is, common);
  const ByCase older = by_case(was), newer = by_case(is);
  for (const auto& [case_id, runs] : newer)
    if (const auto same = older.find(case_id); same != older.end())
      add_rows(case_id, same->second, runs, scale, overlay.rows);
  if (overlay.rows.empty())
    throw std::invalid_argument(
        fmt::format("{} has no solver on a case of {} that is not there, too: without --overlay "
                    "both are compared row by row",
                    after.name(), before.name()));
  overlay.speed =
      std::isnan(scale)
          ? fmt::format("not compared: {} runs are in both, and a hint takes three", common)
          : fmt::format(
                "a hint: the first was measured on {}, the second on {}; times are scaled "
                "by {:.3g}, the median over {} runs that both have",
                processor_of(before), processor_of(after), scale, common);
  return overlay;
}

}  // namespace odeum::compare
