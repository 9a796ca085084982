// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <compare>
#include <limits>
#include <map>

#include "odeum/studies/precision/precision.hpp"

namespace odeum::study {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

bool timed(const PrecisionRow& row) { return row.repetitions > 0 && !std::isnan(row.error); }

struct Least {
  double min = infinity, median = infinity;
};

/// The time in which a solver reaches `error`, from its rows from coarse to fine: the least time of
/// a setting that is accurate enough, or interpolated between two neighbouring settings.
Least time_at(const std::vector<const PrecisionRow*>& rows, double error) {
  Least best;
  for (const PrecisionRow* row : rows)
    if (row->error <= error && row->wall_ns_min < best.min)
      best = {row->wall_ns_min, row->wall_ns_median};
  for (std::size_t k = 0; k + 1 < rows.size(); ++k) {
    const PrecisionRow &coarse = *rows[k], &fine = *rows[k + 1];
    if (!(coarse.error > error && fine.error < error && fine.error > 0)) continue;
    const double part = std::log(coarse.error / error) / std::log(coarse.error / fine.error);
    const auto between = [&](double from, double to) {
      return std::exp((1 - part) * std::log(from) + part * std::log(to));
    };
    const Least found{between(coarse.wall_ns_min, fine.wall_ns_min),
                      between(coarse.wall_ns_median, fine.wall_ns_median)};
    if (found.min < best.min) best = found;
  }
  return best;
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

std::vector<PrecisionSummary> summarise(const std::vector<PrecisionRow>& rows, double floor) {
  std::vector<PrecisionSummary> lines;
  if (rows.empty()) return lines;
  struct Name {
    std::string library, solver;
    Mode mode;
    auto operator<=>(const Name&) const = default;
  };
  std::map<Name, std::vector<const PrecisionRow*>> solvers;
  for (const PrecisionRow& row : rows)
    if (timed(row)) solvers[{row.library, row.solver, row.mode}].push_back(&row);
  for (int exponent = 2; exponent <= 12; ++exponent) {
    PrecisionSummary line;
    line.case_id = rows.front().case_id;
    line.error = std::pow(10.0, -exponent);
    Least own, peer;
    if (line.error > floor) {
      for (const auto& [name, settings] : solvers) {
        const Least time = time_at(settings, line.error);
        const bool is_own = name.library == "odeum";
        Least& best = is_own ? own : peer;
        if (!(time.min < best.min)) continue;
        best = time;
        (is_own ? line.own : line.peer) =
            name.library + "/" + name.solver + (name.mode == Mode::fixed ? " (fixed step)" : "");
      }
    }
    line.own_ns = line.own.empty() ? nan : own.min;
    line.peer_ns = line.peer.empty() ? nan : peer.min;
    line.ratio = line.peer_ns / line.own_ns;
    line.ratio_low = line.ratio_high = nan;
    if (!line.own.empty() && !line.peer.empty()) {
      line.ratio_low = peer.min / own.median;
      line.ratio_high = peer.median / own.min;
    } else if (!(line.error > floor)) {
      line.reason = "at the truth's floor";
    } else if (line.own.empty() && line.peer.empty()) {
      line.reason = "no solver reaches it";
    } else {
      line.reason = line.own.empty() ? "no own solver reaches it" : "no peer reaches it";
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace odeum::study
