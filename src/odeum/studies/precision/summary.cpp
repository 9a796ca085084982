// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <compare>
#include <limits>
#include <map>
#include <string>

#include "odeum/studies/precision/precision.hpp"

namespace odeum::study {
namespace {

using record::nan;
constexpr double infinity = std::numeric_limits<double>::infinity();

bool timed(const PrecisionRow& row) { return row.repetitions > 0 && !std::isnan(row.error); }

/// A time in which a solver reaches an error.
struct Least {
  double min = infinity, median = infinity;
  const PrecisionRow* run = nullptr;  ///< the run that is accurate enough
};

/// The time in which a solver reaches `error`, from its rows from coarse to fine: the least time of
/// a setting that is accurate enough, or interpolated between two neighbouring settings.
Least time_at(const std::vector<const PrecisionRow*>& rows, double error) {
  Least best;
  for (const PrecisionRow* row : rows)
    if (row->error <= error && row->wall_ns_min < best.min)
      best = {row->wall_ns_min, row->wall_ns_median, row};
  for (std::size_t k = 0; k + 1 < rows.size(); ++k) {
    const PrecisionRow &coarse = *rows[k], &fine = *rows[k + 1];
    if (!(coarse.error > error && fine.error < error && fine.error > 0)) continue;
    const double part = std::log(coarse.error / error) / std::log(coarse.error / fine.error);
    const auto between = [&](double from, double to) {
      return std::exp((1 - part) * std::log(from) + part * std::log(to));
    };
    const Least found{between(coarse.wall_ns_min, fine.wall_ns_min),
                      between(coarse.wall_ns_median, fine.wall_ns_median), &fine};
    if (found.min < best.min) best = found;
  }
  return best;
}

std::string name_of(const FastestRow& row) {
  std::string how = row.mode == Mode::fixed ? "fixed step" : "";
  if (!row.options.empty()) how += (how.empty() ? "" : ", ") + row.options;
  return row.library + "/" + row.solver + (how.empty() ? "" : " (" + how + ")");
}

/// The compared errors.
std::vector<double> errors() {
  std::vector<double> list;
  for (int exponent = 2; exponent <= 12; ++exponent) list.push_back(std::pow(10.0, -exponent));
  return list;
}

}  // namespace

void mark_pareto(std::vector<PrecisionRow>& rows) {
  std::vector<PrecisionRow*> by_time;
  for (PrecisionRow& row : rows)
    if (timed(row)) by_time.push_back(&row);
  std::stable_sort(by_time.begin(), by_time.end(), [](const auto* a, const auto* b) {
    return a->wall_ns_min != b->wall_ns_min ? a->wall_ns_min < b->wall_ns_min : a->error < b->error;
  });
  double least = infinity;
  for (PrecisionRow* row : by_time) {
    row->pareto = row->error < least;
    least = std::min(least, row->error);
  }
}

std::vector<FastestRow> fastest(const std::vector<PrecisionRow>& rows, double floor) {
  struct Name {
    std::string library, solver, options;
    Mode mode;
    auto operator<=>(const Name&) const = default;
  };
  std::map<Name, std::vector<const PrecisionRow*>> solvers;
  for (const PrecisionRow& row : rows)
    if (timed(row)) solvers[{row.library, row.solver, row.options, row.mode}].push_back(&row);
  std::vector<FastestRow> list;
  for (const double error : errors()) {
    if (!(error > floor)) continue;
    std::map<std::string, Least> best;  // by library
    for (const auto& [name, settings] : solvers)
      if (const Least time = time_at(settings, error);
          time.run && time.min < best[name.library].min)
        best[name.library] = time;
    for (const auto& [library, time] : best)
      if (time.run)
        list.push_back({time.run->case_id, error, library, time.run->solver, time.run->mode,
                        time.run->setting, time.run->options, time.min, time.median});
  }
  return list;
}

std::vector<PrecisionSummary> summarise(const std::vector<PrecisionRow>& rows, double floor) {
  std::vector<PrecisionSummary> lines;
  if (rows.empty()) return lines;
  const std::vector<FastestRow> best = fastest(rows, floor);
  const auto ran = [&](bool own) {
    return std::any_of(rows.begin(), rows.end(), [&](const PrecisionRow& row) {
      return (row.library == "odeum") == own && row.status != "not_applicable";
    });
  };
  const char* const no_peer = ran(false) ? "no peer reaches it" : "no peer was run";
  const char* const no_own = ran(true) ? "no own solver reaches it" : "no own solver was run";
  for (const double error : errors()) {
    PrecisionSummary line;
    line.case_id = rows.front().case_id;
    line.error = error;
    const FastestRow *own = nullptr, *peer = nullptr;
    for (const FastestRow& row : best) {
      if (row.error != error) continue;
      const FastestRow*& side = row.library == "odeum" ? own : peer;
      if (!side || row.wall_ns_min < side->wall_ns_min) side = &row;
    }
    line.own = own ? name_of(*own) : "";
    line.peer = peer ? name_of(*peer) : "";
    line.own_ns = own ? own->wall_ns_min : nan;
    line.peer_ns = peer ? peer->wall_ns_min : nan;
    line.ratio = line.peer_ns / line.own_ns;
    line.ratio_low = line.ratio_high = nan;
    if (own && peer) {
      line.ratio_low = peer->wall_ns_min / own->wall_ns_median;
      line.ratio_high = peer->wall_ns_median / own->wall_ns_min;
    } else if (!(error > floor)) {
      line.reason = "at the truth's floor";
    } else {
      line.reason = own ? no_peer : peer ? no_own : "no solver reaches it";
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace odeum::study
