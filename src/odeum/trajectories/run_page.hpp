// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "odeum/measure/run_record.hpp"
#include "odeum/record/csv.hpp"
#include "odeum/record/output_folder.hpp"
#include "odeum/scene/problem/scene_problem.hpp"
#include "odeum/scene/run/run.hpp"
#include "odeum/solvers/case.hpp"
#include "odeum/trajectories/case_runs.hpp"
#include "odeum/trajectories/scene_verdict.hpp"

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

/// What is said of a run of one problem: a line of runs.csv and of `odeum run --format csv`, an
/// object of its JSON, a row of its page, and what the terminal's text is made of.
struct RunRow : measure::RunRecord {
  double end = nan, reached = nan;  ///< the last time, and that whose state was recorded
  /// The error at `error_time`, the last output at which the truth is known (NaN: at none); the
  /// largest at the stops of a run whose steps end on several, and at the frames of a scene.
  /// `error` times `error_unit` is the error of `error_component` in its own unit.
  double error_time = nan;
  std::string error_component;
  double error_unit = nan, floor = nan;
  std::string truth;
  /// The most negative value of a state that the solution has nowhere below zero, see
  /// judge::below_zero; an empty name: there is none, or nothing is known.
  std::string negative_state;
  double negative_value = nan, negative_time = nan;
  /// How far the run is off the constraints at most, see judge::drift_off_constraints; NaN: there
  /// are none.
  double constraint_drift = nan, hidden_drift = nan;
  bool diverged = false;             ///< the run ended ok and is not a solution of any accuracy
  std::vector<std::string> remarks;  ///< what else it shows, in sentences
  double energy_change = nan;        ///< of a scene, to the end
  std::string replay;                ///< the address of its page; empty: it has none

  /// Whether it is a solution; where no run of a command is, its exit code says so.
  bool stands() const { return ok() && !diverged && judged.answer != judge::Answer::wrong; }

  static constexpr const char* file = "runs.csv";
  /// 2: error and energy_change, which were one column; 3: all that is known of a run
  static constexpr int schema = 3;
  ODEUM_COLUMNS(case_id, library, solver, mode,
                column("step", ComputedColumn{mode == Mode::fixed ? setting : nan}),
                column("tolerance", ComputedColumn{mode == Mode::fixed ? nan : setting}), end,
                status, detail, reached, counters.steps, counters.rejected_steps,
                counters.rhs_evaluations, counters.jacobian_evaluations, error_time,
                error_component, error_unit, column("error_max", error), error_rms, floor, judged,
                negative_state, negative_value, negative_time, constraint_drift, hidden_drift,
                column("remarks", ComputedColumn{joined(remarks)}), truth, energy_change, replay)

 private:
  static std::string joined(const std::vector<std::string>& remarks);
};
struct RunRows {
  std::vector<RunRow> rows;
  static auto lists(auto& result) { return std::tie(result.rows); }
};

/// The row of a run of a case, with its error at the last stop at which the truth is known. For a
/// run to a tolerance it measures the amplification of errors, which may take longer than the run.
RunRow row_of(const Case& c, const CaseRun& run);

/// The row of a run of a scene. `excess`: see excess_of_energy; `errors`: null where no truth was
/// asked for or is known.
RunRow row_of(const SceneRun& run, const std::string& excess, const SceneErrors* errors,
              const Truth& truth);

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
/// their page; false where there is no page, see Report::write. `rows`: one a run. Throws
/// FileError.
bool write_case_page(const record::OutputFolder& folder, const Case& c,
                     const std::vector<CaseRun>& runs, const std::vector<RunRow>& rows,
                     const RunTexts& texts);

/// The page of the runs of a scene, whose files are written already; runs.csv is written here.
/// The truth is drawn where it is known.
bool write_scene_page(const record::OutputFolder& folder, const scene::Scene& scene,
                      const std::vector<SceneRun>& runs, const std::vector<RunRow>& rows,
                      const SceneTruth& truth, const RunTexts& texts);

}  // namespace odeum::trajectories
