// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/brought/errors_of_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "odeum/judge/errors.hpp"
#include "odeum/measure/local.hpp"

namespace odeum::brought {
namespace {

constexpr std::size_t most_times = 200;

/// The row of a run at a time, to a thousandth of its distance from the next; rows(): there is
/// none.
std::size_t row_at(const Trajectory& run, double t) {
  constexpr double near = 1e-3;
  const auto after = std::ranges::lower_bound(run.times, t);
  std::size_t row = static_cast<std::size_t>(after - run.times.begin());
  if (row == run.rows() || (row > 0 && t - run.times[row - 1] < run.times[row] - t)) --row;
  const double apart = row > 0 ? run.times[row] - run.times[row - 1] : run.times[1] - run.times[0];
  return std::abs(run.times[row] - t) <= near * apart ? row : run.rows();
}

/// At most `most` of them, evenly, with the last.
std::vector<std::size_t> thinned(const std::vector<std::size_t>& rows, std::size_t most) {
  if (rows.size() <= most) return rows;
  std::vector<std::size_t> some;
  for (std::size_t k = 1; k <= most; ++k) some.push_back(rows[k * rows.size() / most - 1]);
  return some;
}

void find_rows(Series& series) {
  const auto fewest =
      std::ranges::min_element(series.runs, {}, [](const Trajectory* run) { return run->rows(); });
  std::vector<std::size_t> common;
  for (std::size_t row = 1; row < (*fewest)->rows(); ++row)
    if (std::ranges::all_of(series.runs, [&](const Trajectory* run) {
          return row_at(*run, (*fewest)->times[row]) < run->rows();
        }))
      common.push_back(row);
  series.common = !common.empty();
  common = thinned(common, most_times);
  for (const Trajectory* run : series.runs) {
    std::vector<std::size_t>& rows = series.rows.emplace_back();
    for (const std::size_t row : common) rows.push_back(row_at(*run, (*fewest)->times[row]));
    if (!series.common) rows = {run->rows() - 1};
  }
}

/// How far a state is behind the exact one along its path, in time, and the error that is left.
void find_lag(const Case& c, double t, const double* y, const std::vector<double>& exact,
              FileRow& row) {
  const std::vector<double> f = measure::slope(c, t, exact);
  double along = 0, square = 0;
  for (const std::size_t i : judge::measured_components(c)) {
    const double unit = c.units.of(i, exact[i]);
    along += (y[i] - exact[i]) * f[i] / (unit * unit);
    square += f[i] * f[i] / (unit * unit);
  }
  if (!(square > 0)) return;
  row.lag = -along / square;
  std::vector<double> shifted = exact;
  for (std::size_t i = 0; i < shifted.size(); ++i) shifted[i] -= row.lag * f[i];
  row.aside = judge::error_of(c, y, shifted.data());
}

/// Whether a state lies outside of the tube: of the truth within `tube_time` of a time, widened by
/// `tube`.
bool is_outside(const Case& c, double t, const double* y, const Claim& claim) {
  const std::size_t n = c.y0.size();
  std::vector<double> low(n, infinity), high(n, -infinity), exact(n);
  for (const double part : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
    const double at = t + part * claim.tube_time;
    if (at < c.t0 || !c.truth.at(at, exact.data())) continue;
    for (std::size_t i = 0; i < n; ++i) {
      const double width = claim.tube * c.units.of(i, exact[i]);
      low[i] = std::min(low[i], exact[i] - width);
      high[i] = std::max(high[i], exact[i] + width);
    }
  }
  return std::ranges::any_of(judge::measured_components(c),
                             [&](std::size_t i) { return !(y[i] >= low[i] && y[i] <= high[i]); });
}

}  // namespace

std::vector<Series> series_of(const std::vector<Trajectory>& runs) {
  std::vector<Series> all;
  for (const Trajectory& run : runs) {
    const auto same =
        std::ranges::find(all, run.series, [](const Series& each) { return each.runs[0]->series; });
    Series& series = same == all.end() ? all.emplace_back() : *same;
    series.runs.push_back(&run);
  }
  for (Series& series : all) {
    std::ranges::stable_sort(series.runs, std::ranges::greater(),
                             [](const Trajectory* run) { return run->step; });
    find_rows(series);
  }
  return all;
}

Case seen_by(const Case& c, const Trajectory& run) {
  Case seen = c;
  if (run.is_whole(c)) return seen;
  seen.measured.clear();
  seen.measures_particles = false;
  const std::vector<std::size_t> measured = judge::measured_components(c);
  for (const std::size_t i : run.components)
    if (std::ranges::find(measured, i) != measured.end()) seen.measured.push_back(i);
  if (seen.measured.empty()) seen.measured = run.components;
  return seen;
}

FileRow row_of_file(const Case& c, const Trajectory& run, const std::vector<std::size_t>& rows,
                    const Claim& claim, double scale) {
  const Case seen = seen_by(c, run);
  const std::size_t n = c.y0.size();
  FileRow row;
  row.series = run.series;
  row.path = run.file;
  row.status = "unknown";
  row.step = run.step > 0
                 ? run.step
                 : (run.times.back() - run.times.front()) / static_cast<double>(run.rows() - 1);
  row.remarks = fmt::format("{}", fmt::join(run.remarks, "; "));
  double energy_size = 0, energy_off = nan, outside = 0;
  std::vector<double> exact(n), moved(n);
  for (const std::size_t k : rows) {
    const double t = run.times[k];
    const double* const y = run.state(k);
    if (std::ranges::any_of(seen.measured.empty() ? run.components : seen.measured,
                            [&](std::size_t i) { return !std::isfinite(y[i]); })) {
      row.status = "diverged";
      row.error = infinity;
      row.error_time = row.end = t;
      break;
    }
    if (!c.truth.at(t, exact.data())) continue;
    row.status = "ok";
    row.end = t;
    ++row.rows;
    const double error = judge::error_of(seen, y, exact.data());
    for (std::size_t i = 0; i < n; ++i)
      moved[i] = exact[i] + (std::isnan(y[i]) ? 0 : run.half_place(k)[i]);
    row.written = std::fmax(row.written, judge::error_of(seen, moved.data(), exact.data()));
    if (!(error <= row.error)) {
      row.error = error;
      row.error_time = t;
      row.component = component_names(c)[judge::worst_component(seen, y, exact.data())];
    }
    if (std::isnan(row.leaves_at) && error > 0.01 * scale) row.leaves_at = t;
    if (run.is_whole(c) && c.energy) {
      const double energy = c.energy(exact.data());
      energy_size = std::max(energy_size, std::abs(energy));
      energy_off = std::fmax(energy_off, std::abs(c.energy(y) - energy));
    }
    if (claim.tube > 0 && is_outside(seen, t, y, claim)) ++outside;
    row.lag = row.aside = nan;
    if (run.is_whole(c) && error > 10 * row.written && error < 0.3 * scale)
      find_lag(seen, t, y, exact, row);
  }
  if (energy_size > 0) row.energy_error = energy_off / energy_size;
  if (claim.tube > 0 && row.rows > 0) row.outside = outside / row.rows;
  return row;
}

}  // namespace odeum::brought
