// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/trajectories/report_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "odeum/cases/catalogue.hpp"
#include "odeum/core/parallel.hpp"
#include "odeum/judge/errors.hpp"
#include "odeum/report/text.hpp"
#include "odeum/scene/run/run.hpp"
#include "odeum/studies/runner.hpp"
#include "odeum/trajectories/scene_files.hpp"
#include "odeum/trajectories/solutions.hpp"

namespace odeum::trajectories {
namespace {

constexpr std::uint64_t frame_count = 80;

struct Shown {
  const char* solver;
  std::uint64_t steps;  ///< 0: to the tolerance
  double tolerance;
  const char* why;
};
/// The first is taken for the exact motion where it succeeds: the truth is known at four times,
/// where it is held against it.
constexpr Shown shown_runs[] = {
    {"odeum/verner98", 0, 1e-12, "exact"},
    {"odeum/cash_karp54", 0, 1e-3, "an explicit pair with step control"},
    {"odeum/symplectic_euler", 320, 0, "one evaluation a step, as games do"},
    {"odeum/implicit_euler", 320, 0, "the classic of cloth: it damps"},
    {"bullet/soft_body_force", 320, 0, "Bullet, springs as forces"},
    {"bullet/deformable_implicit", 320, 0, "Bullet, implicit deformable body"}};

struct Run : CaseRun {
  const Shown* what;
};

Request request_of(const Case& c, const Shown& what) {
  const double end = c.stops.back();
  const Mode mode = what.steps ? Mode::fixed : Mode::adaptive;
  const double setting =
      what.steps ? (end - c.t0) / static_cast<double>(what.steps) : what.tolerance;
  return drawn_request(c, mode, setting, end, {.seconds = 20}, frame_count);
}

scene::RunResult frames_of(const Case& c, const scene::SceneProblem& problem, const Run& run) {
  scene::RunResult result;
  result.status = run.outcome.status;
  result.detail = run.outcome.detail;
  result.counters = run.outcome.counters;
  std::vector<std::size_t> ids(c.y0.size() / 6);
  for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = i;
  const auto keep = [&](double t, const double* y) {
    result.frames.push_back({.t = t,
                             .ids = ids,
                             .y = {y, y + c.y0.size()},
                             .kinetic = problem.kinetic(y),
                             .potential = problem.potential(y)});
    result.t = t;
  };
  keep(c.t0, c.y0.data());
  for (std::size_t k = 0; k < run.reached(c.y0.size()); ++k)
    keep(run.request.stops[k], run.outcome.states.data() + k * c.y0.size());
  return result;
}

std::vector<std::vector<double>> distances(const scene::RunResult& run,
                                           const scene::RunResult& exact) {
  std::vector<std::vector<double>> all;  // none where the exact motion has no frames
  for (std::size_t k = 0; k < std::min(run.frames.size(), exact.frames.size()); ++k) {
    const std::vector<double>&a = run.frames[k].y, &b = exact.frames[k].y;
    auto& frame = all.emplace_back();
    for (std::size_t i = 0; i + 2 < a.size() / 2; i += 3)
      frame.push_back(std::hypot(a[i] - b[i], a[i + 1] - b[i + 1], a[i + 2] - b[i + 2]));
  }
  return all;
}

/// The largest difference to the truth, of a coordinate at the times at which it is known.
double from_truth(const Case& c, const Run& run) {
  double largest = 0;
  std::vector<double> y(c.y0.size());
  for (std::size_t k = 0; k < run.reached(y.size()); ++k) {
    if (!c.truth.at(run.request.stops[k], y.data())) continue;
    for (const std::size_t i : judge::measured_components(c))
      largest = std::fmax(largest, std::abs(run.outcome.states[k * y.size() + i] - y[i]));
  }
  return largest;
}

std::string setting_of(const Case& c, const Run& run) {
  return run.what->steps ? fmt::format("step {:.4g} s", (c.stops.back() - c.t0) /
                                                            static_cast<double>(run.what->steps))
                         : fmt::format("tolerance {:.0e}", run.what->tolerance);
}

}  // namespace

std::vector<ReplayRow> write_replays(const Case& c, const record::OutputFolder& folder,
                                     unsigned jobs) {
  const scene::SceneProblem problem(*c.problem.scene);
  std::vector<Run> runs;
  for (const Shown& what : shown_runs)
    for (const Entrant& entrant : c.entrants)
      if (entrant.info.id() == what.solver && entrant.unfit.empty())
        runs.push_back({{&entrant, request_of(c, what), {}}, &what});
  parallel_for(runs.size(), jobs,
               [&](std::size_t i) { runs[i].outcome = runs[i].entrant->solve(runs[i].request); });
  scene::RunResult exact;
  for (const Run& run : runs)
    if (run.what == shown_runs && run.outcome.status == Status::ok)
      exact = frames_of(c, problem, run);
  std::vector<ReplayRow> rows;
  for (const Run& run : runs) {
    const scene::RunResult result = frames_of(c, problem, run);
    const auto errors = distances(result, exact);
    const std::string id = run.entrant->info.id(),
                      file = "replay/" + report::file_stem(id) + ".html";
    ReplayRow row{.case_id = c.id,
                  .library = run.entrant->info.library,
                  .solver = run.entrant->info.method,
                  .setting = setting_of(c, run),
                  .status = to_string(run.outcome.status),
                  .detail = run.outcome.detail,
                  .steps = run.outcome.counters.steps,
                  .rhs_evaluations = run.outcome.counters.rhs_evaluations,
                  .remark = run.what->why,
                  .replay = file};
    for (const auto& frame : errors)
      for (const double error : frame) row.error = std::fmax(row.error, error);
    // The run that is drawn as exact is held against the truth itself.
    if (run.what == shown_runs) row.error = from_truth(c, run);
    rows.push_back(std::move(row));
    folder.write(file, replay_page(*c.problem.scene, result, {id, setting_of(c, run)}, errors));
  }
  record::write_rows(rows, folder);
  return rows;
}

void add_replays(report::Report& report, const record::OutputFolder& folder, unsigned jobs) {
  const auto& cases = report.facts().cases;
  if (std::ranges::none_of(cases, [](const auto& c) { return c.id == replayed_case; })) return;
  const auto rows = write_replays(known_case(replayed_case), folder, jobs);
  report.study({.name = "replays",
                .command = "report",
                .help = "runs of the cloth, replayed in step",
                .place = 450});
  report.rows("replays", rows);
}

}  // namespace odeum::trajectories
