// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cli/run_rows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "odeum/cli/run.hpp"
#include "odeum/judge/errors.hpp"
#include "odeum/judge/remarks.hpp"
#include "odeum/record/csv.hpp"
#include "odeum/solvers/settings.hpp"

namespace odeum::cli {
namespace {

/// The run's state at a stop.
const double* state_at(const Case& c, const trajectories::CaseRun& run, double time) {
  const auto stop = std::ranges::find(run.request.stops, time) - run.request.stops.begin();
  return run.outcome.states.data() + static_cast<std::size_t>(stop) * c.y0.size();
}

/// The error of each component in its own unit, beside its value; of many components only those
/// with the largest errors in the units of the case.
std::string errors_by_state(const Case& c, const trajectories::CaseRun& run, double time) {
  constexpr std::size_t few = 8;
  std::vector<double> exact(c.y0.size());
  if (!c.truth.at(time, exact.data())) return "";
  const double* const y = state_at(c, run, time);
  const auto in_units = [&](std::size_t i) {
    return std::abs(y[i] - exact[i]) / c.units.of(i, exact[i]);
  };
  std::vector<std::size_t> shown = judge::measured_components(c);
  const std::string more =
      shown.size() > few ? fmt::format("; {} others are nearer", shown.size() - few) : "";
  if (shown.size() > few) {
    std::ranges::partial_sort(shown, shown.begin() + few, std::greater(), in_units);
    shown.resize(few);
  }
  const std::vector<std::string> names = component_names(c);
  std::vector<std::string> parts;
  for (const std::size_t i : shown)
    parts.push_back(
        fmt::format("{} {:.3g} of {:.6g}", names[i], std::abs(y[i] - exact[i]), exact[i]));
  return fmt::format("errors  at t = {:.6g}, of each state in its own unit: {}{}\n", time,
                     fmt::join(parts, ", "), more);
}

std::string error_and_answer(const Case& c, const trajectories::CaseRun& run, const RunRow& row) {
  const double end = run.request.stops.back();
  if (std::isnan(row.error_time))
    return fmt::format("error   unknown: no truth at t = {}: {}\n", end, c.truth.source);
  std::string text = fmt::format("error   {:.6g} (rms {:.6g}) ", row.error, row.error_rms);
  if (!run.request.over_stops && run.request.stops.size() > 1)
    text += fmt::format("at {} stops to t = {}, ", run.request.stops.size(), row.error_time);
  else if (row.error_time < end)
    text += fmt::format("at t = {}; no truth is known from there to t = {}; ", row.error_time, end);
  if (!c.units.scale.empty()) text += judge::unit_text(c) + ", ";
  text += fmt::format("against {}\n", c.truth.source);
  if (!c.units.scale.empty()) text += errors_by_state(c, run, row.error_time);
  const judge::JudgedAnswer& judged = row.judged;
  if (judged.answer == judge::Answer::not_applicable) return text;
  text += fmt::format("answer  {}", to_string(judged.answer));
  if (!judged.reason.empty())
    text += ": " + judged.reason;
  else
    text +=
        fmt::format(": tolerance, steps and amplification explain up to {:.2g}", judged.explained);
  return text + "\n";
}

}  // namespace

RunRow row_of(const Case& c, const trajectories::CaseRun& run) {
  const Request& request = run.request;
  const std::size_t reached = run.reached(c.y0.size());
  RunRow row;
  row.take(c, run.entrant->info, request, run.outcome);
  row.end = request.stops.back();
  row.reached = reached > 0 ? request.stops[reached - 1] : c.t0;
  row.truth = c.truth.source;
  row.floor = c.truth.floor;
  if (!row.ok()) return row;
  const judge::Judge judge(c, request.stops);
  std::vector<judge::StopError> errors = judge.errors(run.outcome);
  while (!errors.empty() && std::isnan(errors.back().error_max)) errors.pop_back();
  if (errors.empty()) return row;
  // Outputs are not judged, so that a run with them is answered as one without; the amplification
  // up to each of hundreds would take a hundred times as long as the run.
  if (request.over_stops) errors = {errors.back()};
  std::vector<double> stops;
  for (const judge::StopError& error : errors) stops.push_back(error.time);
  row.take_errors(errors);
  row.error_time = stops.back();
  if (row.error_time > c.stops.back()) row.floor = c.timed_floor();
  const judge::StopError& worst =
      *std::ranges::max_element(errors, [](const auto& a, const auto& b) {
        return a.error_max < b.error_max || (std::isnan(a.error_max) && !std::isnan(b.error_max));
      });
  std::vector<double> exact(c.y0.size());
  c.truth.at(worst.time, exact.data());
  const std::size_t component =
      judge::worst_component(c, state_at(c, run, worst.time), exact.data());
  row.error_component = component_names(c)[component];
  row.error_unit = c.units.of(component, exact[component]);
  judge::Amplification amplification;
  if (request.mode == Mode::adaptive)
    amplification = judge::measure_amplification(c, stops, request.tolerance);
  row.judged =
      measure::answer_of(request, run.outcome, errors, amplification, row.floor, judge.scale());
  row.diverged = judge::has_diverged(errors, judge.scale());
  return row;
}

std::string cost_text(const Counters& counters) {
  const bool unknown = counters.rhs_evaluations == 0 && counters.work > 0;
  std::string text = unknown ? "evaluations within the library (not counted)"
                             : fmt::format("{} evaluations, {} Jacobians", counters.rhs_evaluations,
                                           counters.jacobian_evaluations);
  if (counters.products > 0)
    text += fmt::format(", {} products in linear solvers", counters.products);
  return text;
}

std::string first_text(const trajectories::CaseRun& run, std::size_t numbers, double seconds) {
  const Outcome& outcome = run.outcome;
  constexpr std::size_t few = 8;
  std::string state;
  if (outcome.status == Status::ok && numbers <= few) {
    state = "; state";
    for (std::size_t i = 0; i < numbers; ++i)
      state +=
          " " + record::format_number(outcome.states[(run.reached(numbers) - 1) * numbers + i]);
  }
  return fmt::format(
      "first      {}: {} at t = {:.6g} after {} evaluations, {:.3g} s of the processor, {}{}; the "
      "truth is computed now",
      run.entrant->info.id(), to_string(outcome.status), outcome.t,
      outcome.counters.rhs_evaluations, seconds,
      run.request.mode == Mode::fixed ? fmt::format("{} steps", run.request.steps)
                                      : "tol " + text_of_tolerance(run.request),
      state);
}

std::string error_text(const Case& c, const trajectories::CaseRun& run, const RunRow& row) {
  std::string text = error_and_answer(c, run, row);
  for (const std::string& remark : judge::remarks(c, run.request, run.outcome))
    text += fmt::format("remark  {}\n", remark);
  return text;
}

}  // namespace odeum::cli
