// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/brought/judgement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "odeum/brought/errors_of_file.hpp"
#include "odeum/brought/row_to_row.hpp"
#include "odeum/judge/errors.hpp"

namespace odeum::brought {
namespace {

using judge::Verdict;

double slope_of(const judge::ErrorPoint& coarse, const judge::ErrorPoint& fine) {
  return std::log(coarse.error / fine.error) / std::log(coarse.step / fine.step);
}

/// The order of two or three steps, which fit_order() leaves open: the last slope, as sure as the
/// slope before it is near.
judge::OrderFit order_of_few(const std::vector<judge::ErrorPoint>& points, double claimed) {
  constexpr double unsure = 0.5, near = 0.3, sure = 0.1;
  judge::OrderFit fit;
  fit.points = points.size();
  fit.order = slope_of(points[points.size() - 2], points.back());
  const double half = points.size() > 2
                          ? std::max(sure, std::abs(fit.order - slope_of(points[0], points[1])))
                          : unsure;
  fit.low = fit.order - half;
  fit.high = fit.order + half;
  fit.step_coarsest = points.front().step;
  fit.step_finest = points.back().step;
  const std::string measured =
      fmt::format("converges with order {:.2f} over {} steps", fit.order, points.size());
  constexpr double falling = 0.3;
  if (fit.order < falling) {
    fit.verdict = Verdict::floors;
    fit.floor = points.back().error;
    fit.reason = fmt::format(
        "the error does not fall with the step: {:.2g} at {:.3g}, {:.2g} at {:.3g}",
        points.front().error, points.front().step, points.back().error, points.back().step);
  } else if (std::isnan(claimed)) {
    fit.reason = measured;
  } else if (std::abs(fit.order - claimed) <= near && fit.low <= claimed + near) {
    fit.verdict = points.size() > 2 ? Verdict::confirmed : Verdict::undetermined;
    fit.reason = points.size() > 2 ? "" : measured + ", which two steps do not settle";
  } else if (fit.high < claimed - near || fit.low > claimed + near) {
    fit.verdict = fit.order < claimed ? Verdict::lower : Verdict::higher;
    fit.reason = fmt::format("{} where {:g} is claimed", measured, claimed);
  } else {
    fit.reason = fmt::format("{}, which does not settle whether it is {:g}", measured, claimed);
  }
  return fit;
}

/// The order of the errors of a series. Without a claim it is held against the nearest whole one.
judge::OrderFit order_of(const std::vector<judge::ErrorPoint>& points, double claimed, bool equal) {
  std::vector<judge::ErrorPoint> clear;
  for (const judge::ErrorPoint& point : points)
    if (std::isfinite(point.error) && point.error > 3 * point.typical_rounding())
      clear.push_back(point);
  if (clear.size() < 2) {
    judge::OrderFit fit;
    fit.reason = points.size() < 2
                     ? "one run gives no order"
                     : fmt::format(
                           "{} of {} errors are clear of rounding and of the digits that are "
                           "written; an order takes two at least",
                           clear.size(), points.size());
    return fit;
  }
  constexpr std::size_t enough = 4;
  if (clear.size() < enough) return order_of_few(clear, claimed);
  const double order =
      std::isnan(claimed)
          ? std::max(1.0, std::round(slope_of(clear[clear.size() - 2], clear.back())))
          : claimed;
  judge::OrderFit fit = judge::fit_order(
      points, order, equal ? judge::fixed_step_tolerance(order) : judge::adaptive_tolerance(order));
  if (fit.verdict == Verdict::floors)
    fit.reason = fmt::format("the error stops falling at {:.2g}, from steps of {:.2g} on",
                             fit.floor, fit.floor_step);
  return fit;
}

/// The order with which the differences of neighbouring runs fall; NaN: fewer than three runs.
double own_order(const Case& c, const Series& series) {
  std::vector<judge::ErrorPoint> points;
  for (std::size_t r = 0; r + 1 < series.runs.size() && series.common; ++r) {
    const Case seen = seen_by(c, *series.runs[r]);
    double difference = 0;
    for (std::size_t k = 0; k < series.rows[r].size(); ++k)
      difference =
          std::max(difference, judge::error_of(seen, series.runs[r]->state(series.rows[r][k]),
                                               series.runs[r + 1]->state(series.rows[r + 1][k])));
    points.push_back({.step = series.runs[r]->step, .error = difference});
  }
  if (points.size() < 2 || !(points.back().step > 0)) return nan;
  const double order = slope_of(points[points.size() - 2], points.back());
  return std::isfinite(order) ? order : nan;
}

void decide(SeriesRow& row, const Claim& claim, const std::optional<Likeness>& likeness) {
  if (std::isnan(claim.order) && claim.method.empty()) return;
  row.claim = Claimed::open;
  const bool another = likeness && (!likeness->mistake.empty() ||
                                    (!claim.method.empty() && likeness->method != claim.method));
  if (row.verdict == Verdict::confirmed || row.verdict == Verdict::higher ||
      (likeness && !another && !claim.method.empty()))
    row.claim = Claimed::held;
  if (row.verdict == Verdict::lower || row.verdict == Verdict::floors ||
      row.verdict == Verdict::failed || another)
    row.claim = Claimed::denied;
}

void add_sentence(std::string& text, const std::string& sentence) {
  if (!sentence.empty()) text += (text.empty() ? "" : "; ") + sentence;
}

/// Where no truth is known: the order with which the errors fall that rows gain over the rows
/// before them. It says that the steps are the problem's, and nothing of where the run ends.
void judge_by_itself(const Case& c, const Series& series, std::vector<FileRow>& files,
                     const Claim& claim, SeriesRow& row) {
  std::vector<judge::ErrorPoint> points;
  std::string invariant;
  const std::vector<std::vector<std::size_t>> near = rows_of_near_states(c, series);
  for (std::size_t r = 0; r < files.size(); ++r) {
    const RowToRow found = row_to_row(c, *series.runs[r], near[r]);
    files[r].gain = found.gain;
    files[r].change = found.change;
    invariant = found.invariant;
    if (found.rows > 0)
      points.push_back({.step = files[r].step,
                        .error = found.gain,
                        .steps = static_cast<double>(series.runs[r]->rows() - 1),
                        .rounding_unit = found.written /
                                         std::sqrt(static_cast<double>(series.runs[r]->rows() - 1)),
                        .scale = 1});
  }
  row.verdict = Verdict::undetermined;
  row.reason = "no truth is known at the times of the files";
  if (points.empty()) return;
  const judge::OrderFit fit = order_of(points, claim.order, false);
  row.verdict = std::isnan(claim.order) ? Verdict::not_applicable : fit.verdict;
  row.measured_order = fit.order;
  row.order_low = fit.low;
  row.order_high = fit.high;
  row.reason +=
      "; each row is held against the solution from the row before, which shows whether the steps "
      "are the problem's, and not whether the end is right: the error gained by the unit of time ";
  row.reason += std::isnan(fit.order)
                    ? fmt::format("is {:.2g} ({})", points.back().error, fit.reason)
                    : fmt::format("falls with order {:.2f}", fit.order);
  if (std::isfinite(row.own_order))
    row.reason += fmt::format("; the files differ among themselves by what falls with order {:.2f}",
                              row.own_order);
  if (!invariant.empty())
    row.reason += fmt::format("; {} changes by {:.2g} of its size in the finest", invariant,
                              files.back().change);
}

SeriesRow row_of_series(const Case& c, const Series& series, std::vector<FileRow>& files,
                        const Claim& claim, double scale) {
  SeriesRow row;
  row.series = series.runs.front()->series;
  row.method = claim.method;
  row.claimed_order = claim.order;
  std::vector<judge::ErrorPoint> points;
  bool equal = true;
  for (std::size_t r = 0; r < files.size(); ++r) {
    if (files[r].status == "unknown") continue;
    const double steps = (files[r].end - c.t0) / files[r].step;
    points.push_back({.step = files[r].step,
                      .error = std::isfinite(files[r].error) ? files[r].error : nan,
                      .steps = steps,
                      .rounding_unit = std::max(std::fmax(files[r].written, 0),
                                                0x1p-53 * scale * std::sqrt(steps)) /
                                       std::sqrt(steps),
                      .floor = c.truth.floor,
                      .scale = scale});
    equal = equal && series.runs[r]->step > 0;
  }
  row.own_order = own_order(c, series);
  if (points.empty()) {
    judge_by_itself(c, series, files, claim, row);
  } else if (!series.common) {
    row.verdict = Verdict::undetermined;
    row.reason = "the files have no time in common, so that their errors give no order";
  } else {
    const judge::OrderFit fit = order_of(points, claim.order, equal);
    row.verdict = std::isnan(claim.order) ? Verdict::not_applicable : fit.verdict;
    row.measured_order = fit.order;
    row.order_low = fit.low;
    row.order_high = fit.high;
    row.reason = fit.reason;
  }
  std::optional<Likeness> likeness;
  for (const Trajectory* run : series.runs)
    if (likeness = likeness_of(c, *run, claim.method); likeness) break;
  if (likeness) {
    row.likeliest = likeness->method;
    row.mistake = likeness->mistake;
    add_sentence(row.reason, likeness->text());
  }
  decide(row, claim, likeness);
  if (row.verdict == Verdict::floors && !likeness && row.own_order > 0.5)
    add_sentence(
        row.reason,
        fmt::format("the files converge with order {:.2f} to another solution than that of "
                    "the problem: its equations, parameters or initial state differ",
                    row.own_order));
  return row;
}

/// A sentence where the first row is not the problem's initial state.
std::string remark_on_start(const Case& c, const Trajectory& run) {
  if (run.times.front() != c.t0) return {};
  for (const std::size_t i : run.components) {
    const double off = std::abs(run.state(0)[i] - c.y0[i]);
    if (off > 2 * run.half_place(0)[i] + 1e-12 * std::abs(c.y0[i]))
      return fmt::format("the first row has {} = {:.6g}, and the problem starts at {:.6g}",
                         component_names(c)[i], run.state(0)[i], c.y0[i]);
  }
  return {};
}

}  // namespace

const char* to_string(Claimed claimed) {
  switch (claimed) {
    case Claimed::held:
      return "held";
    case Claimed::denied:
      return "denied";
    case Claimed::open:
      return "open";
    case Claimed::not_applicable:
      break;
  }
  return "not_applicable";
}

bool Judgement::passes() const {
  return std::ranges::none_of(series,
                              [](const SeriesRow& row) { return row.claim == Claimed::denied; }) &&
         std::ranges::none_of(files, [](const FileRow& row) { return row.outside > 0; });
}

std::vector<double> times_of(const Case& c, const std::vector<Trajectory>& runs,
                             const Claim& claim) {
  std::vector<double> times;
  for (const Series& series : series_of(runs))
    for (std::size_t r = 0; r < series.runs.size(); ++r)
      for (const std::size_t row : series.rows[r])
        for (const double part : {-1.0, -0.5, 0.0, 0.5, 1.0})
          if (const double t = series.runs[r]->times[row] + part * claim.tube_time; t > c.t0)
            times.push_back(t);
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

Judgement judge_runs(const Case& c, const std::vector<Trajectory>& runs, const Claim& claim) {
  Judgement judgement;
  const double scale = judge::Judge(c, times_of(c, runs, {})).scale();
  for (const Series& series : series_of(runs)) {
    std::vector<FileRow> files;
    for (std::size_t r = 0; r < series.runs.size(); ++r) {
      files.push_back(row_of_file(c, *series.runs[r], series.rows[r], claim, scale));
      add_sentence(files.back().remarks, remark_on_start(c, *series.runs[r]));
    }
    judgement.series.push_back(row_of_series(c, series, files, claim, scale));
    judgement.files.insert(judgement.files.end(), files.begin(), files.end());
  }
  return judgement;
}

}  // namespace odeum::brought
