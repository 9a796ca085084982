// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "odeum/core/numbers.hpp"
#include "odeum/studies/precision/precision.hpp"

namespace odeum::study {
namespace {

std::string name_of(const FastestRow& row) {
  std::string how = row.mode == Mode::fixed ? "fixed step" : "";
  if (!row.options.empty()) how += (how.empty() ? "" : ", ") + row.options;
  return row.library + "/" + row.solver + (how.empty() ? "" : " (" + how + ")");
}

}  // namespace

std::vector<double> compared_errors() {
  std::vector<double> list;
  for (int exponent = 2; exponent <= 12; ++exponent) list.push_back(std::pow(10.0, -exponent));
  return list;
}

bool keeps_error(double own, double near, double error) {
  constexpr double twice = 2, several = 4;
  return own <= error && (near <= error || near <= std::min(twice * error, several * own));
}

bool reaches(const PrecisionRow& row, double error) {
  return row.timed() && keeps_error(row.error, row.near_error, error);
}

void mark_pareto(std::vector<PrecisionRow>& rows) {
  std::vector<PrecisionRow*> by_time;
  for (PrecisionRow& row : rows)
    if (row.timed()) by_time.push_back(&row);
  std::ranges::stable_sort(by_time, [](const auto* a, const auto* b) {
    return a->wall_ns_min != b->wall_ns_min ? a->wall_ns_min < b->wall_ns_min : a->error < b->error;
  });
  double least = infinity;
  for (PrecisionRow* row : by_time) {
    row->pareto = row->error < least;
    least = std::min(least, row->error);
  }
}

std::vector<FastestRow> fastest(const std::vector<PrecisionRow>& rows, double floor) {
  std::vector<FastestRow> list;
  for (const double error : compared_errors()) {
    if (!(error > floor)) continue;
    std::map<std::string, const PrecisionRow*> best;  // by library
    for (const PrecisionRow& row : rows)
      if (reaches(row, error))
        if (const PrecisionRow*& known = best[row.library];
            !known || row.wall_ns_min < known->wall_ns_min)
          known = &row;
    for (const auto& [library, row] : best)
      list.push_back({*row, *row, error, row->options, row->near_error});
  }
  return list;
}

std::vector<PrecisionSummary> summarise(const std::vector<PrecisionRow>& rows, double floor) {
  std::vector<PrecisionSummary> lines;
  if (rows.empty()) return lines;
  const std::vector<FastestRow> best = fastest(rows, floor);
  const auto ran = [&](bool own) {
    return std::ranges::any_of(rows, [&](const PrecisionRow& row) {
      return (row.library == "odeum") == own && row.status != "not_applicable";
    });
  };
  const char* const no_peer = ran(false) ? "no peer reaches it" : "no peer was run";
  const char* const no_own = ran(true) ? "no own solver reaches it" : "no own solver was run";
  for (const double error : compared_errors()) {
    PrecisionSummary line;
    line.case_id = rows.front().case_id;
    line.error = error;
    const FastestRow *own = nullptr, *peer = nullptr;
    for (const FastestRow& row : best) {
      if (row.compared != error) continue;
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
