// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <stdexcept>

#include "odeum/cases/catalogue.hpp"
#include "odeum/cases/scene_case.hpp"
#include "odeum/cli/run.hpp"
#include "odeum/core/interrupt.hpp"
#include "odeum/record/output_folder.hpp"
#include "odeum/scene/run/run.hpp"
#include "odeum/trajectories/run_page.hpp"
#include "odeum/trajectories/scene_files.hpp"

namespace odeum::cli {
namespace {

using scene::Scene;
using scene::SceneProblem;
using trajectories::SceneRun;
using Lines = std::vector<std::string>;

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

Lines describe_result(const Entrant& entrant, const Request& request, const scene::RunResult& run) {
  Lines lines{"solver     " + entrant.info.id()};
  const double end = request.stops.back();
  lines.push_back(request.mode == Mode::fixed
                      ? fmt::format("step       {}, {} steps to t = {}",
                                    end / static_cast<double>(request.steps), request.steps, end)
                      : fmt::format("tol        {}, {} steps and {} rejected to t = {}",
                                    text_of_tolerance(request), run.counters.steps,
                                    run.counters.rejected_steps, run.t));
  lines.push_back(fmt::format("status     {}{}{}", to_string(run.status),
                              run.detail.empty() ? "" : ": ", run.detail));
  lines.push_back(fmt::format("cost       {} evaluations, {} Jacobians",
                              run.counters.rhs_evaluations, run.counters.jacobian_evaluations));
  if (run.solves > 1)
    lines.push_back(
        fmt::format("solves     {}: {} births, {} deaths", run.solves, run.births, run.deaths));
  const scene::Frame &first = run.frames.front(), &last = run.frames.back();
  lines.push_back(fmt::format("energy     {:.9g} J at t = {}, {:.9g} J at t = {:.9g}",
                              first.kinetic + first.potential, first.t,
                              last.kinetic + last.potential, last.t));
  lines.push_back(fmt::format("momentum   ({:.6g}, {:.6g}, {:.6g}) kg m/s at the end",
                              last.momentum[0], last.momentum[1], last.momentum[2]));
  return lines;
}

std::string text_of(const Lines& lines) { return fmt::format("{}\n", fmt::join(lines, "\n")); }

RunSettings settings_of(const RunOptions& options, const Scene& scene) {
  RunSettings settings = options.settings;
  if (settings.tolerance && settings.tolerance->by_component())
    throw UsageError(
        "--atol: got {} numbers, expected one for a scene, whose particles may change in number",
        settings.tolerance->absolutes().size());
  if (!has_setting(settings) && scene.solver) {
    settings.step = scene.solver->step;
    settings.tolerance = scene.solver->tolerance;
  }
  return settings;
}

const Entrant& choose(const Entrants& entrants, const std::string& solver, const Scene& scene) {
  if (!solver.empty()) return find_entrant(entrants, "this scene", solver);
  try {
    return find_entrant(entrants, "this scene", scene.solver->type);
  } catch (const UsageError& error) {
    throw UsageError("{}: {}; got {}, expected a solver that fits", scene.solver->where,
                     error.what(), shown(scene.solver->type));
  }
}

// The stem of a file's name, for a scene without a name.
std::string name_of(const Scene& scene, const std::string& file) {
  const std::string name = report::plain(scene.name);
  return name.empty() ? report::plain(std::filesystem::path(file).stem().string()) : name;
}

SceneRun run_one(const Scene& scene, const Entrant& entrant, const RunSettings& settings) {
  SceneRun one{&entrant, make_request(settings, 0, *scene.duration, 0, entrant.info), {}, ""};
  scene::RunSetting setting;
  setting.mode = one.request.mode;
  setting.steps = one.request.steps;
  setting.tolerance = one.request.tolerance;
  setting.until = one.request.stops.back();
  setting.budget = one.request.budget;
  setting.frame_interval = scene::frame_interval(scene, setting.until);
  one.outcome = scene::run_scene(
      scene, setting, [&](const std::shared_ptr<const SceneProblem>& problem, const Request& part) {
        return cases::enroll_scene(problem).find(entrant.info.id())->solve(part);
      });
  return one;
}

void write_files(const record::OutputFolder& folder, const std::string& in, const Scene& scene,
                 const scene::RunResult& run, const Lines& facts) {
  if (run.status == Status::ok) folder.write(in + "final.csv", trajectories::final_csv(run));
  folder.write(in + "trajectory.csv", trajectories::trajectory_csv(run));
  folder.write(in + "energy.csv", trajectories::energy_csv(run));
  folder.write(in + "replay.html", trajectories::replay_page(scene, run, facts));
  trajectories::write_vtk_series(folder, scene, run, in);
}

int run_read(const scene::ReadScene& read, const SceneSource& source, const RunOptions& options) {
  Scene scene = read.scene;
  for (const std::string& warning : read.warnings) remark(warning + " (warning)");
  scene.name = name_of(scene, source.file);
  if (options.settings.every) scene.frame_interval = options.settings.every;
  const auto whole = std::make_shared<const SceneProblem>(scene::at_start(scene));
  const auto entrants = cases::enroll_scene(whole);
  const RunSettings settings = settings_of(options, scene);
  std::vector<const Entrant*> chosen;
  for (const std::string& solver : options.solvers)
    chosen.push_back(&choose(entrants, solver, scene));
  if (chosen.empty()) chosen.push_back(&choose(entrants, "", scene));
  for (const Entrant* entrant : chosen)
    make_request(settings, 0, *scene.duration, 0, entrant->info);

  std::optional<record::OutputFolder> folder;
  if (!options.out.empty()) folder.emplace(options.out);
  Lines model = describe_model(scene, *whole);
  model.insert(model.begin(), "scene      " + scene.name);
  if (!read.duration_given && !settings.until)
    model.push_back(fmt::format("duration   {} s: the scene gives none; --until sets another",
                                scene::default_duration));
  print(text_of(model) + text_of(describe_fits(entrants, options.verbose)));

  std::vector<SceneRun> runs;
  bool any_ok = false;
  for (const Entrant* entrant : chosen) {
    runs.push_back(run_one(scene, *entrant, settings));
    if (interrupted) return interrupted_code;
    SceneRun& one = runs.back();
    const Lines result = describe_result(*entrant, one.request, one.outcome);
    print(text_of(result));
    any_ok = any_ok || one.outcome.status == Status::ok;
    if (!folder) continue;
    Lines facts = model;
    facts.insert(facts.end(), result.begin(), result.end());
    if (chosen.size() > 1) one.folder = entrant->info.library + "_" + entrant->info.method + "/";
    write_files(*folder, one.folder, scene, one.outcome, facts);
    print("files      {}\n", (folder->path() / (one.folder + "replay.html")).string());
  }
  if (folder) {
    trajectories::RunTexts texts{.title = scene.name, .lead = {}, .facts = {}};
    for (const std::string& line : model) texts.facts.emplace_back("", line);
    remark_on_page(trajectories::write_scene_page(*folder, scene, *whole, runs, texts));
    print("files      {}\n", (folder->path() / "index.html").string());
  }
  return any_ok ? success : solver_failed;
}

}  // namespace

Lines describe_fits(const Entrants& entrants, bool verbose) {
  using Counts = std::vector<std::pair<std::string, std::size_t>>;  // in the order of the solvers
  const auto count = [](Counts& counts, const std::string& name) {
    for (auto& [known, number] : counts)
      if (known == name) return void(++number);
    counts.emplace_back(name, 1);
  };
  const auto text_of_counts = [](const Counts& counts) {
    std::string text;
    for (const auto& [name, number] : counts)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", number, name);
    return text;
  };
  Counts libraries;
  std::map<std::string, Counts> families, reasons;
  std::map<std::string, Lines> unfit_ids;
  Lines fitting;
  for (const Entrant& entrant : entrants) {
    if (!entrant.unfit.empty()) {
      count(reasons[entrant.unfit], "of " + entrant.info.library);
      unfit_ids[entrant.unfit].push_back(entrant.info.id());
      continue;
    }
    count(libraries, entrant.info.library);
    count(families[entrant.info.library], entrant.info.family);
    fitting.push_back(entrant.info.id());
  }
  Lines lines{fmt::format("fits       {} of {} solvers{}", fitting.size(), entrants.size(),
                          verbose ? "" : ", which --verbose lists")};
  for (const auto& [library, number] : libraries)
    lines.push_back(
        fmt::format("  {:<8} {}: {}", library, number, text_of_counts(families[library])));
  if (verbose) lines.push_back(fmt::format("  {}", fmt::join(fitting, " ")));
  for (const auto& [reason, counts] : reasons)
    lines.push_back(fmt::format(
        "unfit      {}: {}",
        verbose ? fmt::format("{}", fmt::join(unfit_ids[reason], " ")) : text_of_counts(counts),
        reason));
  return lines;
}

std::optional<SceneSource> find_scene(const std::string& what) {
  std::error_code ignored;
  const SceneSource file{what, std::nullopt};
  if (what.ends_with(".yaml") || what.ends_with(".yml")) return file;
  for (const std::string& id : known_ids())
    if (id == what) return std::nullopt;
  for (const cases::SceneText& scene : cases::all_scenes())
    if (scene.name == what) return SceneSource{what, std::string(scene.text)};
  if (std::filesystem::exists(what, ignored)) return file;
  return std::nullopt;
}

int run_scene(const SceneSource& source, const RunOptions& options) {
  scene::ReadOptions read_options = options.limits;
  read_options.need_solver = options.solvers.empty() || !has_setting(options.settings);
  if (!options.problems.sets.empty())
    throw UsageError("--set: a scene has no parameters; change its file");
  if (options.settings.every) require_positive("--every", *options.settings.every);
  try {
    return run_read(source.text ? scene::read_scene(source.file, *source.text, read_options)
                                : scene::read_scene_file(source.file, read_options),
                    source, options);
  } catch (const std::length_error& error) {
    throw UsageError(error.what());
  } catch (const InputError& error) {
    remark(error.what());
    return usage;
  }
}

}  // namespace odeum::cli
