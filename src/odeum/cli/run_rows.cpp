// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cli/run_rows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <tuple>

#include "odeum/cli/run.hpp"
#include "odeum/judge/errors.hpp"
#include "odeum/record/csv.hpp"
#include "odeum/record/table.hpp"
#include "odeum/solvers/settings.hpp"

namespace odeum::cli {
namespace {

struct PrintedRow : RunRow {
  static constexpr const char* file = "runs";
};
struct PrintedRows {
  std::vector<PrintedRow> rows;
  static auto lists(auto& result) { return std::tie(result.rows); }
};

/// The error of each component in its own unit, beside its value; of many components only those
/// with the largest errors in the units of the case.
std::string errors_by_state(const Case& c, const trajectories::CaseRun& run, double time) {
  constexpr std::size_t few = 8;
  std::vector<double> exact(c.y0.size());
  if (!c.truth.at(time, exact.data())) return "";
  const double* const y = run.state_at(time, c.y0.size());
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

std::string error_of_run(const Case& c, const trajectories::CaseRun& run, const RunRow& row) {
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
  return text;
}

/// The processor's time, by steps and by frames, and what a cost in evaluations does not tell.
std::string text_of_cost(const Request& request, const scene::RunResult& run, double seconds) {
  const Counters& counters = run.counters;
  std::string text = "cost       " + cost_text(counters);
  const std::uint64_t steps = request.mode == Mode::fixed ? request.steps : counters.steps;
  text += fmt::format("\ntime       {:.3g} s of the processor", seconds);
  if (steps > 0)
    text += fmt::format(", {:.3g} ms a step", 1e3 * seconds / static_cast<double>(steps));
  if (run.frames.size() > 1)
    text += fmt::format(", {:.3g} ms a frame of {:.4g} s",
                        1e3 * seconds / static_cast<double>(run.frames.size() - 1),
                        run.frames[1].t - run.frames[0].t);
  return text;
}

}  // namespace

void print_rows(const std::vector<RunRow>& rows, const std::string& format, const Case* c,
                const std::vector<trajectories::CaseRun>& runs) {
  if (format == "csv") return print(record::csv_text(rows));
  PrintedRows all;
  for (const RunRow& row : rows) all.rows.push_back({row});
  auto json = nlohmann::ordered_json::parse(record::json_of(all));
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const std::vector<std::string> names = component_names(*c);
    auto& states = json["runs"][k]["states"] = nlohmann::ordered_json::array();
    for (std::size_t stop = 0; stop < runs[k].reached(names.size()); ++stop) {
      const double t = runs[k].request.stops[stop], *const y = runs[k].state_at(t, names.size());
      auto& state = states.emplace_back();
      state["time"] = t;
      for (std::size_t i = 0; i < names.size(); ++i) state["y"][names[i]] = y[i];
    }
  }
  print(json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

std::string answer_text(const RunRow& row) {
  const judge::JudgedAnswer& judged = row.judged;
  if (judged.answer == judge::Answer::none) return "";
  if (judged.answer == judge::Answer::not_applicable) return judged.reason;
  if (!judged.reason.empty()) return fmt::format("{}: {}", to_string(judged.answer), judged.reason);
  if (std::isnan(judged.explained)) return "";
  return fmt::format("{}: tolerance, steps and amplification explain up to {:.2g}",
                     to_string(judged.answer), judged.explained);
}

std::vector<std::pair<std::string, std::string>> answer_and_remarks(const RunRow& row) {
  std::vector<std::pair<std::string, std::string>> all;
  if (const std::string answer = answer_text(row); !answer.empty())
    all.emplace_back("answer", answer);
  for (const std::string& remark : row.remarks) all.emplace_back("remark", remark);
  return all;
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
  std::string text = error_of_run(c, run, row);
  for (const auto& [name, said] : answer_and_remarks(row))
    text += fmt::format("{:<6}  {}\n", name, said);
  return text;
}

std::vector<std::string> describe_run(const trajectories::SceneRun& one, double seconds) {
  const Request& request = one.request;
  const scene::RunResult& run = one.outcome;
  std::vector<std::string> lines{"solver     " + one.entrant->info.id()};
  const double end = request.stops.back();
  lines.push_back(request.mode == Mode::fixed
                      ? fmt::format("step       {:.12g}, {} steps to t = {:.12g}",
                                    end / static_cast<double>(request.steps), request.steps, end)
                      : fmt::format("tol        {}, {} steps and {} rejected to t = {:.12g}",
                                    text_of_tolerance(request), run.counters.steps,
                                    run.counters.rejected_steps, run.t));
  lines.push_back(fmt::format("status     {}{}{}", to_string(run.status),
                              run.detail.empty() ? "" : ": ", run.detail));
  lines.push_back(text_of_cost(request, run, seconds));
  if (run.solves > 1)
    lines.push_back(
        fmt::format("solves     {}: {} births, {} deaths", run.solves, run.births, run.deaths));
  const scene::Frame &first = run.frames.front(), &last = run.frames.back();
  lines.push_back(fmt::format("energy     {:.9g} J at t = {}, {:.9g} J at t = {:.9g}",
                              first.kinetic + first.potential, first.t,
                              last.kinetic + last.potential, last.t));
  lines.push_back(fmt::format("momentum   ({:.6g}, {:.6g}, {:.6g}) kg m/s at the end",
                              last.momentum[0], last.momentum[1], last.momentum[2]));
  if (run.contacts.apart > 0) lines.push_back(trajectories::text_of_contacts(run.contacts));
  return lines;
}

std::string text_of_answer(const trajectories::SceneRun& run,
                           const trajectories::SceneErrors* errors, const RunRow& row) {
  const std::string id = run.entrant->info.id();
  std::string text;
  if (errors && errors->until == 0) text = fmt::format("error      {}: unknown\n", id);
  if (errors && errors->until > 0)
    text = fmt::format(
        "error      {}: {:.3g} m at most, at t = {:.4g}; {:.3g} m at most and {:.3g} m on average "
        "at t = {:.4g}{}\n",
        id, errors->largest, errors->largest_at, errors->end_largest, errors->end_mean,
        errors->until,
        errors->until < run.outcome.t ? ", the last time at which the motion is known" : "");
  if (const std::string answer = answer_text(row); !answer.empty())
    text += fmt::format("answer     {}: {}\n", id, answer);
  return text;
}

}  // namespace odeum::cli
