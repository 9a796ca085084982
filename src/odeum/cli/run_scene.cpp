// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <ctime>
#include <filesystem>
#include <stdexcept>

#include "odeum/cases/scene_case.hpp"
#include "odeum/cli/run.hpp"
#include "odeum/cli/run_rows.hpp"
#include "odeum/core/interrupt.hpp"
#include "odeum/record/output_folder.hpp"
#include "odeum/scene/run/run.hpp"
#include "odeum/trajectories/run_page.hpp"
#include "odeum/trajectories/scene_files.hpp"
#include "odeum/trajectories/scene_verdict.hpp"
#include "odeum/why/why_answer.hpp"

namespace odeum::cli {
namespace {

using scene::Scene, scene::SceneProblem, trajectories::SceneRun;
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
  lines.push_back(fmt::format(
      "structure  {}, {}, autonomous, {}",
      s.separable ? "separable" : "not separable (depends on velocities)",
      s.linear ? "linear" : "nonlinear",
      s.smooth() ? "smooth"
                 : fmt::format("with kinks (no order above {} can be expected)", s.order_kept)));
  lines.push_back("kernel     " + s.kernel);
  if (s.closed_form)
    lines.emplace_back("exact      free particles under a constant force: odeum/closed_form");
  return lines;
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

Lines describe_result(const Entrant& entrant, const Request& request, const scene::RunResult& run,
                      double seconds, const std::string& excess) {
  Lines lines{"solver     " + entrant.info.id()};
  const double end = request.stops.back();
  lines.push_back(request.mode == Mode::fixed
                      ? fmt::format("step       {}, {} steps to t = {}",
                                    end / static_cast<double>(request.steps), request.steps, end)
                      : fmt::format("tol        {}, {} steps and {} rejected to t = {}",
                                    text_of_tolerance(request), run.counters.steps,
                                    run.counters.rejected_steps, run.t));
  lines.push_back(fmt::format("status     {}{}{}{}", to_string(run.status),
                              run.detail.empty() ? "" : ": ", run.detail,
                              excess.empty() ? "" : ", but it has blown up: " + excess));
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

/// The errors of a run in m, and whether the run has diverged.
std::pair<std::string, bool> text_of_errors(const SceneRun& run, const SceneProblem& problem,
                                            const cases::TextTruth& known) {
  const trajectories::SceneErrors e = trajectories::scene_errors(problem, run.outcome, known.truth);
  const std::string id = run.entrant->info.id();
  if (e.until == 0) return {fmt::format("error      {}: unknown", id), false};
  std::string text = fmt::format(
      "error      {}: {:.3g} m at most, at t = {:.4g}; {:.3g} m at most and {:.3g} m on average at "
      "t = {:.4g}",
      id, e.largest, e.largest_at, e.end_largest, e.end_mean, e.until);
  if (e.until < run.outcome.t) text += ", the last time at which the motion is known";
  const double part = e.size > 0 ? e.largest / e.size : 0;
  constexpr double whole = 1, tenth = 0.1;
  if (part >= whole)
    return {
        text + fmt::format("\nanswer     wrong: {} has diverged, by more than the {:.3g} m that "
                           "the scene is large",
                           id, e.size),
        true};
  text += fmt::format("\nanswer     {}: {:.2g} % of the scene's size of {:.3g} m{}", id, 100 * part,
                      e.size, part > tenth ? ", which does not predict its motion" : "");
  return {text, false};
}

/// Prints the errors of the runs that ended well; false: each of them has diverged.
bool print_errors(const std::vector<SceneRun>& runs, const Scene& scene, const std::string& text) {
  std::vector<const scene::RunResult*> ended;
  for (const SceneRun& run : runs)
    if (run.outcome.status == Status::ok) ended.push_back(&run.outcome);
  const std::vector<double> times = trajectories::times_to_judge(ended);
  if (times.empty()) return true;
  std::shared_ptr<const SceneProblem> problem;
  try {
    problem = cases::whole_problem(scene, times.back(), scene.name);
  } catch (const InputError& error) {
    print("error      unknown: {}\n", error.what());
    return true;
  }
  const cases::TextTruth known = cases::scene_truth(problem, times, text, scene.name);
  print("truth      {}\n", known.words);
  bool any_close = false;
  for (const SceneRun& run : runs) {
    if (run.outcome.status != Status::ok) continue;
    const auto [line, wrong] = text_of_errors(run, *problem, known);
    print("{}\n", line);
    any_close = any_close || !wrong;
  }
  return any_close;
}

std::string text_of(const Lines& lines) { return fmt::format("{}\n", fmt::join(lines, "\n")); }

RunSettings settings_of(const RunOptions& options, const Scene& scene) {
  RunSettings settings = options.settings;
  if (!settings.named_absolute.empty())
    throw UsageError("--atol: got a name, expected a number for a scene, which has no names");
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

void write_run(const record::OutputFolder& folder, const SceneRun& run, const Scene& scene,
               const Lines& facts, std::size_t frames) {
  trajectories::write_scene_files(folder, run.folder, scene, run.outcome, facts);
  print("files      {}\n", (folder.path() / (run.folder + "replay.html")).string());
  if (frames == 0) return;
  print("film       {}\n",
        trajectories::write_film(folder, scene, run.outcome, frames, run.folder));
}

/// Sets the interval that was asked for; pictures are equally far apart in time.
void set_frame_interval(Scene& scene, const RunOptions& options, const RunSettings& settings) {
  if (options.settings.every) scene.frame_interval = options.settings.every;
  if (options.frames == 0) return;
  if (options.out.empty())
    throw UsageError("--frames: expected --out DIR too, where the pictures are written");
  if (!options.settings.every)
    scene.frame_interval =
        settings.until.value_or(*scene.duration) / static_cast<double>(options.frames - 1);
}

/// The command that says why a run failed.
void print_why(const Scene& scene, const SceneRun& run, const RunOptions& options) {
  Case whole;
  whole.stops = {*scene.duration};
  print("more       odeum why {}{} --solver {} {}\n", shell_word(options.what), options.more,
        run.entrant->info.id(), why::setting_of(run.request, whole));
}

int run_read(const scene::ReadScene& read, const cases::Named& source,
             const std::string& source_text, const RunOptions& options) {
  Scene scene = read.scene;
  for (const std::string& warning : read.warnings) remark(warning + " (warning)");
  scene.name = report::plain(scene.name);
  if (scene.name.empty())
    scene.name = report::plain(std::filesystem::path(source.word()).stem().string());
  const auto whole = std::make_shared<const SceneProblem>(scene::at_start(scene));
  const auto entrants = cases::enroll_scene(whole);
  const RunSettings settings = settings_of(options, scene);
  set_frame_interval(scene, options, settings);
  std::vector<const Entrant*> chosen;
  for (const std::string& solver : those_that_fit(entrants, options))
    chosen.push_back(&choose(entrants, solver, scene));
  if (chosen.empty()) chosen.push_back(&choose(entrants, "", scene));
  for (const Entrant* entrant : chosen)
    make_request(settings, 0, *scene.duration, 0, entrant->info);

  std::optional<record::OutputFolder> folder;
  if (!options.out.empty()) folder.emplace(options.out);
  Lines model = describe_model(scene, *whole);
  model.insert(model.begin(), "scene      " + scene.name);
  if (const std::string damping = scene::describe_damping(read); !damping.empty())
    model.push_back("damping    " + damping);
  if (!read.duration_given && !settings.until)
    model.push_back(fmt::format("duration   {} s: the scene gives none; --until sets another",
                                scene::default_duration));
  print(text_of(model) + text_of(describe_fits(entrants, options.verbose)));

  std::vector<SceneRun> runs;
  bool any_ok = false;
  for (const Entrant* entrant : chosen) {
    const std::clock_t begin = std::clock();
    runs.push_back(run_one(scene, *entrant, settings));
    if (interrupted) return interrupted_code;
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    SceneRun& one = runs.back();
    const bool ok = one.outcome.status == Status::ok;
    const std::string excess = ok ? trajectories::excess_of_energy(scene, one.outcome) : "";
    const Lines result = describe_result(*entrant, one.request, one.outcome, seconds, excess);
    print(text_of(result));
    if (!ok) print_why(scene, one, options);
    any_ok = any_ok || (ok && excess.empty() && one.outcome.contacts.passed == 0);
    if (!folder) continue;
    Lines facts = model;
    facts.insert(facts.end(), result.begin(), result.end());
    if (chosen.size() > 1) one.folder = entrant->info.library + "_" + entrant->info.method + "/";
    write_run(*folder, one, scene, facts, options.frames);
  }
  if (folder) {
    trajectories::RunTexts texts{.title = scene.name, .lead = {}, .facts = {}};
    for (const std::string& line : model) texts.facts.emplace_back("", line);
    const bool page = trajectories::write_scene_page(*folder, scene, *whole, runs, texts);
    remark_on_page(page);
    print("files      {}\n", (page ? folder->path() / "index.html" : folder->path()).string());
  }
  // After the files, since it may take longer than the runs.
  if (options.truth) any_ok = print_errors(runs, scene, source_text) && any_ok;
  return any_ok ? success : solver_failed;
}

}  // namespace

int run_scene(const cases::Named& source, const RunOptions& options) {
  scene::ReadOptions read_options = options.limits;
  read_options.need_solver = options.solvers.empty() || !has_setting(options.settings);
  if (!options.problems.sets.empty())
    throw UsageError("--set: a scene has no parameters; change its file");
  if (options.settings.every) require_positive("--every", *options.settings.every);
  try {
    const std::string& text =
        cases::scene_text(source, read_options.most_bytes, "--max-megabytes raises it");
    return run_read(scene::read_scene(source.word(), text, read_options), source, text, options);
  } catch (const std::length_error& error) {
    throw UsageError(error.what());
  }
}

}  // namespace odeum::cli
