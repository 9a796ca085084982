// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/trajectories/run_page.hpp"

#include <nlohmann/json.hpp>
#include <sstream>

#include "odeum/measure/run_record.hpp"
#include "odeum/record/rows.hpp"
#include "odeum/report/report.hpp"
#include "odeum/report/text.hpp"
#include "odeum/solvers/settings.hpp"

namespace odeum::trajectories {
namespace {

using nlohmann::ordered_json;

/// One run: a line of runs.csv.
struct RunRow : measure::RunRecord {  ///< of a case with its error at the end
  double energy_change = nan;         ///< of a scene, to the end
  std::string replay = {};            ///< the address of its page; empty: it has none

  static constexpr const char* file = "runs.csv";
  /// 2: error and energy_change, which were one column
  static constexpr int schema = 2;
  ODEUM_COLUMNS(library, solver, status, detail,
                column("setting_kind", PhraseColumn{mode, "step", "tol"}), setting, counters.steps,
                counters.rejected_steps, counters.rhs_evaluations, counters.jacobian_evaluations,
                error, energy_change, replay)
};

report::Facts facts_of(const auto& runs) {
  report::Facts facts{.cases = {}, .solvers = {}, .libraries = all_libraries()};
  for (const auto& run : runs) facts.solvers.push_back(run.entrant->info);
  return facts;
}

/// The time, position and velocity that are plotted, of each run and exact where that is known.
record::Records plotted(const scene::Scene& scene, const scene::SceneProblem& problem,
                        const std::vector<SceneRun>& runs, const scene::Plot& plot) {
  record::Records table{{"library", "solver", "time", "position", "velocity"}};
  const std::size_t at = 3 * plot.particle + plot.coordinate;
  const auto add = [&](const std::string& library, const std::string& solver, double t,
                       const std::vector<double>& y) {
    table.rows.push_back({library, solver, t, y[at], y[y.size() / 2 + at]});
  };
  for (const SceneRun& run : runs)
    for (const scene::Frame& frame : run.outcome.frames)
      add(run.entrant->info.library, run.entrant->info.method, frame.t, frame.y);
  const scene::RunResult& first = runs.front().outcome;
  if (!problem.structure().closed_form || first.births > 0 || !scene.emitters.empty()) return table;
  std::vector<double> y(problem.size());
  for (const scene::Frame& frame : first.frames) {
    if (frame.y.size() != y.size()) break;
    problem.closed_form(frame.t, problem.start().data(), y.data());
    add("truth", "exact", frame.t, y);
  }
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

bool write_case_page(const record::OutputFolder& folder, const Case& c,
                     const std::vector<CaseRun>& runs, const RunTexts& texts) {
  report::Report page(facts_of(runs), folder);
  const ExactStates exact = exact_states(c, runs);
  const record::Records trajectory = case_trajectory(c, runs, exact), steps = case_steps(c, runs);
  folder.write("solution.csv", case_solution(c, runs).csv());
  folder.write("trajectory.csv", trajectory.csv());
  folder.write("steps.csv", steps.csv());
  page.table("runs", "trajectory.csv", trajectory);
  page.table("runs", "steps.csv", steps);
  page.table("runs", "schemes", case_schemes(c, runs));
  page.table("runs", "why.csv", texts.bounds);
  std::vector<RunRow> rows;
  for (const CaseRun& run : runs) {
    RunRow& row = rows.emplace_back();
    row.take(c, run.entrant->info, run.request, run.outcome);
    if (row.ok()) row.take_errors({judge::Judge(c, run.request.stops).errors(run.outcome).back()});
  }
  record::write_rows(rows, folder);
  page.rows("runs", rows);
  ordered_json json = page_facts("case", texts);
  json["components"] = component_names(c);
  json["measured"] = judge::measured_components(c);
  json["second_order"] = c.problem.view.second_order();
  json["energy"] = static_cast<bool>(c.energy);
  json["exact_everywhere"] = exact.everywhere;
  page.fact("runs", json);
  return page.write({.command_line = texts.command + " " + c.id});
}

bool write_scene_page(const record::OutputFolder& folder, const scene::Scene& scene,
                      const scene::SceneProblem& problem, const std::vector<SceneRun>& runs,
                      const RunTexts& texts) {
  report::Report page(facts_of(runs), folder);
  record::Records energies{{"library", "solver", "time", "kinetic", "potential", "total"}};
  std::vector<RunRow> rows;
  for (const SceneRun& run : runs) {
    const SolverInfo& info = run.entrant->info;
    const auto& frames = run.outcome.frames;
    for (const scene::Frame& frame : frames)
      energies.rows.push_back({info.library, info.method, frame.t, frame.kinetic, frame.potential,
                               frame.kinetic + frame.potential});
    RunRow& row = rows.emplace_back();
    row.take(info, 0, run.request, run.outcome);
    row.energy_change = frames.back().kinetic + frames.back().potential - frames.front().kinetic -
                        frames.front().potential;
    row.replay = run.folder + "replay.html";
  }
  record::write_rows(rows, folder);
  page.rows("runs", rows);
  page.table("runs", "energies", energies);
  ordered_json json = page_facts("scene", texts);
  if (const auto plot = plot_of(scene)) {
    page.table("runs", "plotted", plotted(scene, problem, runs, *plot));
    json["plot"] = {{"particle", plot->particle},
                    {"coordinate", std::string(1, "xyz"[plot->coordinate])}};
    if (plot->y_range) json["plot"]["range"] = *plot->y_range;
  }
  page.fact("runs", json);
  return page.write({.command_line = "odeum run " + scene.name});
}

}  // namespace odeum::trajectories
