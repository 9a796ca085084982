// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/trajectories/run_page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "odeum/judge/constraint_drift.hpp"
#include "odeum/judge/remarks.hpp"
#include "odeum/record/rows.hpp"
#include "odeum/report/report.hpp"
#include "odeum/report/text.hpp"
#include "odeum/solvers/settings.hpp"

namespace odeum::trajectories {
namespace {

using nlohmann::ordered_json;

report::Facts facts_of(const auto& runs) {
  report::Facts facts{.cases = {}, .solvers = {}, .libraries = all_libraries()};
  for (const auto& run : runs) facts.solvers.push_back(run.entrant->info);
  return facts;
}

/// The time, position and velocity that are plotted, of each run and exact where that is known.
record::Records plotted(const std::vector<SceneRun>& runs, const SceneTruth& exact,
                        const scene::Plot& plot) {
  record::Records table{{"library", "solver", "time", "position", "velocity"}};
  const std::size_t at = 3 * plot.particle + plot.coordinate;
  const auto add = [&](const std::string& library, const std::string& solver, double t,
                       const std::vector<double>& y) {
    table.rows.push_back({library, solver, t, y[at], y[y.size() / 2 + at]});
  };
  for (const SceneRun& run : runs)
    for (const scene::Frame& frame : run.outcome.frames)
      add(run.entrant->info.library, run.entrant->info.method, frame.t, frame.y);
  if (!exact.problem) return table;
  std::vector<double> y = exact.problem->start();
  for (const scene::Frame& frame : runs.front().outcome.frames)
    if (!(frame.t > 0) || exact.truth.at(frame.t, y.data())) add("truth", "exact", frame.t, y);
  return table;
}

/// What is drawn: the scene's plot, or the height of its first free particle.
std::optional<scene::Plot> plot_of(const scene::Scene& scene) {
  if (scene.plot) return scene.plot;
  for (std::size_t i = 0; i < scene.particles.size(); ++i)
    if (!scene.particles[i].fixed)
      return scene::Plot{
          .particle = i, .coordinate = static_cast<std::size_t>(scene.up - 'x'), .y_range = {}};
  return std::nullopt;
}

}  // namespace

void add_lines(RunTexts& texts, const std::string& lines) {
  std::istringstream stream(lines);
  for (std::string line; std::getline(stream, line);) {
    // A name takes ten columns with the spaces behind it, unless it is longer.
    constexpr std::size_t column = 9;
    const bool short_name = line.size() > column && line[column] == ' ';
    std::string name = line.substr(0, short_name ? column : line.find(' '));
    name.erase(name.find_last_not_of(' ') + 1);
    const std::string rest =
        line.substr(std::min(line.size(), line.find_first_not_of(' ', name.size())));
    if (name.empty() && !texts.facts.empty())
      texts.facts.back().second += "; " + rest;
    else
      texts.facts.emplace_back(name, rest);
  }
}

nlohmann::ordered_json page_facts(const std::string& kind, const RunTexts& texts) {
  ordered_json facts = ordered_json::array();
  for (const auto& [name, text] : texts.facts)
    facts.push_back({report::plain(name), report::plain(text)});
  return {{"kind", kind},
          {"title", report::plain(texts.title)},
          {"lead", report::plain(texts.lead)},
          {"facts", facts}};
}

std::string RunRow::joined(const std::vector<std::string>& remarks) {
  return fmt::format("{}", fmt::join(remarks, "; "));
}

RunRow row_of(const Case& c, const CaseRun& run) {
  const Request& request = run.request;
  const std::size_t reached = run.reached(c.y0.size());
  RunRow row;
  row.take(c, run.entrant->info, request, run.outcome);
  row.end = request.stops.back();
  row.reached = reached > 0 ? request.stops[reached - 1] : c.t0;
  row.truth = c.truth.source;
  row.floor = c.truth.floor;
  if (const auto below = judge::below_zero(c, request, run.outcome); !below.empty()) {
    row.negative_state = component_names(c)[below.front().component];
    row.negative_value = below.front().value;
    row.negative_time = below.front().time;
  }
  const judge::ConstraintDrift drift = judge::drift_off_constraints(c, request, run.outcome);
  row.constraint_drift = drift.given.size;
  row.hidden_drift = drift.hidden.size;
  if (!row.ok()) {
    row.judged.answer = judge::Answer::none;
    return row;
  }
  row.remarks = judge::remarks(c, request, run.outcome);
  if (std::string said = judge::remark_on_drift(c, run.entrant->info, request, drift);
      !said.empty())
    row.remarks.push_back(std::move(said));
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
      judge::worst_component(c, run.state_at(worst.time, c.y0.size()), exact.data());
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

RunRow row_of(const SceneRun& run, const std::string& excess, const SceneErrors* errors,
              const Truth& truth) {
  RunRow row;
  row.take(run.entrant->info, 0, run.request, run.outcome);
  row.end = run.request.stops.back();
  row.reached = run.outcome.t;
  row.truth = truth.source;
  row.floor = truth.floor;
  const scene::Frame &first = run.outcome.frames.front(), &last = run.outcome.frames.back();
  row.energy_change = last.kinetic + last.potential - first.kinetic - first.potential;
  row.judged = scene_answer(run.outcome, run.request.mode, excess, errors);
  if (!errors || errors->until == 0) return row;
  row.error = errors->largest;
  row.error_time = errors->until;
  row.error_unit = 1;
  return row;
}

bool write_case_page(const record::OutputFolder& folder, const Case& c,
                     const std::vector<CaseRun>& runs, const std::vector<RunRow>& rows,
                     const RunTexts& texts) {
  report::Report page(facts_of(runs), folder);
  const ExactStates exact = exact_states(c, runs);
  const record::Records trajectory = case_trajectory(c, runs, exact), steps = case_steps(c, runs);
  folder.write("solution.csv", case_solution(c, runs).csv());
  folder.write("trajectory.csv", trajectory.csv());
  folder.write("steps.csv", steps.csv());
  page.table("runs", "trajectory.csv", trajectory);
  page.table("runs", "steps.csv", steps);
  page.table("runs", "schemes", case_schemes(c, runs));
  page.table("runs", "curves", case_curves(c, runs));
  page.table("runs", "why.csv", texts.bounds);
  record::write_rows(rows, folder);
  page.rows("runs", rows);
  ordered_json json = page_facts("case", texts);
  json["components"] = component_names(c);
  json["measured"] = judge::measured_components(c);
  json["unit"] = judge::unit_text(c);
  json["second_order"] = c.problem.view.second_order();
  json["energy"] = static_cast<bool>(c.energy);
  json["exact_everywhere"] = exact.everywhere;
  page.fact("runs", json);
  return page.write({.command_line = texts.command + " " + c.id});
}

bool write_scene_page(const record::OutputFolder& folder, const scene::Scene& scene,
                      const std::vector<SceneRun>& runs, const std::vector<RunRow>& rows,
                      const SceneTruth& truth, const RunTexts& texts) {
  report::Report page(facts_of(runs), folder);
  record::Records energies{{"library", "solver", "time", "kinetic", "potential", "total"}};
  for (const SceneRun& run : runs) {
    const SolverInfo& info = run.entrant->info;
    for (const scene::Frame& frame : run.outcome.frames)
      energies.rows.push_back({info.library, info.method, frame.t, frame.kinetic, frame.potential,
                               frame.kinetic + frame.potential});
  }
  record::write_rows(rows, folder);
  page.rows("runs", rows);
  page.table("runs", "energies", energies);
  ordered_json json = page_facts("scene", texts);
  json["unit"] = "in m, of the particle that is farthest from its place, at any frame";
  if (const auto plot = plot_of(scene)) {
    page.table("runs", "plotted", plotted(runs, truth, *plot));
    json["plot"] = {{"particle", plot->particle},
                    {"coordinate", std::string(1, "xyz"[plot->coordinate])}};
    if (plot->y_range) json["plot"]["range"] = *plot->y_range;
  }
  page.fact("runs", json);
  return page.write({.command_line = "odeum run " + scene.name});
}

}  // namespace odeum::trajectories
