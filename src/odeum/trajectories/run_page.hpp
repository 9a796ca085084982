// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "odeum/record/csv.hpp"
#include "odeum/record/output_folder.hpp"
#include "odeum/scene/problem/scene_problem.hpp"
#include "odeum/scene/run/run.hpp"
#include "odeum/solvers/case.hpp"
#include "odeum/trajectories/case_runs.hpp"

/// The page of one problem (odeum run, advise, sweep, classify and poisson with --out): rows and
/// facts, see reports/viewer/runs.js.
namespace odeum::trajectories {

/// A solver's run of a scene.
struct SceneRun {
  const Entrant* entrant = nullptr;
  Request request;
  scene::RunResult outcome;
  std::string folder;  ///< of its files, with a slash at the end; empty: that of all files
};

/// What stands above the figures: names and texts.
struct RunTexts {
  std::string title, lead;
  std::vector<std::pair<std::string, std::string>> facts;
  record::Records bounds = {};        ///< what bounds the steps of the first run, see why.csv
  std::string command = "odeum run";  ///< that made it
};

/// Adds the lines of an answer for a terminal, `name  text`, as facts; one that begins with a space
/// goes on with the one before.
void add_lines(RunTexts& texts, const std::string& lines);

/// The fact "runs" of page.json; what is drawn depends on `kind`.
nlohmann::ordered_json page_facts(const std::string& kind, const RunTexts& texts);

/// Writes the tables of the runs of a case (trajectory.csv, steps.csv, solution.csv, runs.csv) and
/// their page; false where there is no page, see Report::write. Throws FileError.
bool write_case_page(const record::OutputFolder& folder, const Case& c,
                     const std::vector<CaseRun>& runs, const RunTexts& texts);

/// The page of the runs of a scene, whose files are written already; runs.csv is written here.
bool write_scene_page(const record::OutputFolder& folder, const scene::Scene& scene,
                      const scene::SceneProblem& problem, const std::vector<SceneRun>& runs,
                      const RunTexts& texts);

}  // namespace odeum::trajectories
