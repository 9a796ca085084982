// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <stdexcept>

#include "odeum/cli/run.hpp"
#include "odeum/core/interrupt.hpp"
#include "odeum/record/output_folder.hpp"
#include "odeum/report/html.hpp"
#include "odeum/report/scene_files.hpp"
#include "odeum/scene/run/emission.hpp"
#include "odeum/scene/run/run.hpp"
#include "support/scene_stage.hpp"

namespace odeum::cli {
namespace {

using scene::Scene;
using scene::SceneProblem;
using Lines = std::vector<std::string>;

// Limit of the numbers kept in memory, at 8 bytes each.
constexpr double most_numbers = 2e8;

Lines describe_model(const Scene& scene, const SceneProblem& problem) {
  const scene::Structure& s = problem.structure();
  Lines lines;
  lines.push_back(fmt::format("particles  {}, {} of them fixed", s.particles, s.fixed));
  for (const scene::Emitter& emitter : scene.emitters)
    lines.push_back(
        fmt::format("emitter    {} a second, each for {} s", emitter.rate, emitter.lifetime));
  for (const scene::TermInfo& term : s.terms)
    lines.push_back(fmt::format("term       {:<18} {:>6} {:<10} {}", term.name, term.count,
                                term.unit, term.law));
  if (s.terms.empty()) lines.emplace_back("term       none: no force");
  lines.push_back(
      fmt::format("structure  {}, {}, autonomous, {}",
                  s.separable ? "separable" : "not separable (depends on velocities)",
                  s.linear ? "linear" : "nonlinear",
                  s.smooth ? "smooth" : "with kinks (no order above 2 can be expected)"));
  lines.push_back("kernel     " + s.kernel);
  if (s.closed_form)
    lines.emplace_back("exact      free particles under a constant force: odeum/closed_form");
  return lines;
}

// The number of fitting solvers, and the others by reason.
Lines describe_fits(const std::vector<Entrant>& entrants) {
  std::map<std::string, Lines> reasons;
  Lines fitting;
  for (const Entrant& entrant : entrants)
    (entrant.unfit.empty() ? fitting : reasons[entrant.unfit]).push_back(entrant.info.id());
  Lines lines{fmt::format("fits       {} of {} solvers: {}", fitting.size(), entrants.size(),
                          fmt::join(fitting, " "))};
  for (const auto& [reason, ids] : reasons)
    lines.push_back(fmt::format("unfit      {}: {}", fmt::join(ids, " "), reason));
  return lines;
}

Lines describe_result(const Entrant& entrant, const Request& request, const scene::RunResult& run) {
  Lines lines{"solver     " + entrant.info.id()};
  const double end = request.stops.back();
  lines.push_back(request.mode == Mode::fixed
                      ? fmt::format("step       {}, {} steps to t = {}",
                                    end / static_cast<double>(request.steps), request.steps, end)
                      : fmt::format("tol        {}, {} steps and {} rejected to t = {}",
                                    request.tolerance, run.counters.steps,
                                    run.counters.rejected_steps, run.t));
  lines.push_back(fmt::format("status     {}{}{}", to_string(run.status),
                              run.detail.empty() ? "" : ": ", run.detail));
  lines.push_back(fmt::format("cost       {} evaluations, {} Jacobians",
                              run.counters.rhs_evaluations, run.counters.jacobian_evaluations));
  if (run.solves > 1)
    lines.push_back(
        fmt::format("solves     {}: {} births, {} deaths", run.solves, run.births, run.deaths));
  const scene::Frame &first = run.frames.front(), &last = run.frames.back();
  const double before = first.kinetic + first.potential, after = last.kinetic + last.potential;
  lines.push_back(fmt::format("energy     {:.9g} J at t = {}, {:.9g} J at t = {:.9g}", before,
                              first.t, after, last.t));
  lines.push_back(fmt::format("momentum   ({:.6g}, {:.6g}, {:.6g}) kg m/s at the end",
                              last.momentum[0], last.momentum[1], last.momentum[2]));
  return lines;
}

std::string text_of(const Lines& lines) { return fmt::format("{}\n", fmt::join(lines, "\n")); }

RunSettings settings_of(const RunOptions& options, const Scene& scene) {
  RunSettings settings = options.settings;
  if (!settings.step && !settings.tolerance && scene.solver) {
    settings.step = scene.solver->step;
    settings.tolerance = scene.solver->tolerance;
  }
  return settings;
}

const Entrant& choose(const std::vector<Entrant>& entrants, const RunOptions& options,
                      const Scene& scene) {
  if (!options.solver.empty()) return find_entrant(entrants, "this scene", options.solver);
  try {
    return find_entrant(entrants, "this scene", scene.solver->type);
  } catch (const UsageError& error) {
    throw UsageError(fmt::format("{}: {}; got {}, expected a solver that fits", scene.solver->where,
                                 error.what(), shown(scene.solver->type)));
  }
}

void write_files(const record::OutputFolder& folder, const Scene& scene,
                 const scene::RunResult& run, const Lines& facts) {
  if (run.status == Status::ok) folder.write("final.csv", report::final_csv(run));
  folder.write("trajectory.csv", report::trajectory_csv(run));
  folder.write("energy.csv", report::energy_csv(run));
  folder.write("replay.html", report::replay_page(scene, run, facts));
  report::write_vtk_series(folder, scene, run);
}

int run_read(const scene::ReadScene& read, const RunOptions& options) {
  const Scene& scene = read.scene;
  for (const std::string& warning : read.warnings) remark(warning + " (warning)");
  const auto whole = std::make_shared<const SceneProblem>(scene::at_start(scene));
  const auto entrants = cases::enroll_scene(whole);
  const Entrant& entrant = choose(entrants, options, scene);
  const Request request =
      make_request(settings_of(options, scene), 0, scene.duration.value_or(0), entrant.info);
  scene::RunSetting setting;
  setting.mode = request.mode;
  setting.steps = request.steps;
  setting.tolerance = request.tolerance;
  setting.until = request.stops.back();
  setting.budget = request.budget;
  setting.frame_interval = scene::frame_interval(scene, setting.until);

  std::optional<record::OutputFolder> folder;
  if (!options.out.empty()) folder.emplace(options.out);
  const std::string name = scene.name.empty() ? "" : report::plain(scene.name);
  Lines model = describe_model(scene, *whole);
  model.insert(model.begin(), "scene      " + name);
  print(text_of(model) + text_of(describe_fits(entrants)));

  const scene::RunResult run = scene::run_scene(
      scene, setting, [&](const std::shared_ptr<const SceneProblem>& problem, const Request& part) {
        return cases::enroll_scene(problem, entrant.info.id()).solve(part);
      });
  if (interrupted) return interrupted_code;
  const Lines result = describe_result(entrant, request, run);
  print(text_of(result));
  if (folder) {
    Lines facts = model;
    facts.insert(facts.end(), result.begin(), result.end());
    write_files(*folder, scene, run, facts);
    print(fmt::format("files      {}\n", (folder->path() / "replay.html").string()));
  }
  return run.status == Status::ok ? success : solver_failed;
}

}  // namespace

std::optional<SceneSource> find_scene(const std::string& what) {
  std::error_code ignored;
  const SceneSource file{what, std::nullopt};
  if (what.ends_with(".yaml") || what.ends_with(".yml")) return file;
  for (const Case& c : all_cases())
    if (c.id == what) return std::nullopt;
  for (const cases::SceneText& scene : cases::all_scenes())
    if (scene.name == what) return SceneSource{what, std::string(scene.text)};
  if (std::filesystem::exists(what, ignored)) return file;
  return std::nullopt;
}

int run_scene(const SceneSource& source, const RunOptions& options) {
  scene::ReadOptions read_options = options.limits;
  const bool has_setting = options.settings.step || options.settings.tolerance;
  read_options.need_solver = options.solver.empty() || !has_setting;
  read_options.need_duration = !options.settings.until;
  try {
    return run_read(source.text ? scene::read_scene(source.file, *source.text, read_options)
                                : scene::read_scene_file(source.file, read_options),
                    options);
  } catch (const std::length_error& error) {
    throw UsageError(error.what());
  } catch (const InputError& error) {
    remark(error.what());
    return usage;
  }
}

}  // namespace odeum::cli
