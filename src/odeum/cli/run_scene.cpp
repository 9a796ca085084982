// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <functional>
#include <stdexcept>

#include "odeum/cases/scene_case.hpp"
#include "odeum/cli/run.hpp"
#include "odeum/cli/run_rows.hpp"
#include "odeum/core/interrupt.hpp"
#include "odeum/core/standard_streams.hpp"
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
using Say = std::function<void(const std::string&)>;

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

/// The exact motion at the frames of the runs that ended well, as far as it is known. Says what it
/// is, or why it is not known.
trajectories::SceneTruth truth_of(const std::vector<SceneRun>& runs, const Scene& scene,
                                  const std::string& text, const Say& say) {
  std::vector<const scene::RunResult*> ended;
  for (const SceneRun& run : runs)
    if (run.outcome.status == Status::ok) ended.push_back(&run.outcome);
  const std::vector<double> times = trajectories::times_to_judge(ended);
  if (times.empty()) return {};
  try {
    const auto problem = cases::whole_problem(scene, times.back(), scene.name);
    const cases::TextTruth known = cases::scene_truth(problem, times, text, scene.name);
    say(fmt::format("truth      {}\n", known.words));
    return {problem, known.truth};
  } catch (const InputError& error) {
    say(fmt::format("error      unknown: {}\n", error.what()));
    return {};
  }
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
               const Lines& facts, std::size_t frames, const Say& say) {
  trajectories::write_scene_files(folder, run.folder, scene, run.outcome, facts);
  say(fmt::format("files      {}\n", (folder.path() / (run.folder + "replay.html")).string()));
  if (frames == 0) return;
  say(fmt::format("film       {}\n",
                  trajectories::write_film(folder, scene, run.outcome, frames, run.folder)));
}

/// Sets the interval that was asked for; pictures are equally far apart in time.
void set_frame_interval(Scene& scene, const RunOptions& options, const RunSettings& settings) {
  if (options.settings.every) scene.frame_interval = options.settings.every;
  if (options.frames == 0) return;
  if (options.out.empty())
    throw UsageError("--frames: expected --out DIR too, where the pictures are written");
  if (options.settings.every) return;
  // Curves have the usual frames too, of which each picture is one.
  const double until = settings.until.value_or(*scene.duration),
               apart = until / static_cast<double>(options.frames - 1);
  scene.frame_interval = apart / std::ceil(apart / scene::frame_interval(scene, until));
}

/// The command that says why a run failed.
std::string text_of_why(const Scene& scene, const SceneRun& run, const RunOptions& options) {
  Case whole;
  whole.stops = {*scene.duration};
  return fmt::format("more       odeum why {}{} --solver {} {}\n", shell_word(options.what),
                     options.more, run.entrant->info.id(), why::setting_of(run.request, whole));
}

/// What is said of the model before any run.
Lines model_of(const scene::ReadScene& read, const Scene& scene, const SceneProblem& whole,
               const RunSettings& settings) {
  Lines model = describe_model(scene, whole);
  model.insert(model.begin(), "scene      " + scene.name);
  if (const std::string damping = scene::describe_damping(read); !damping.empty())
    model.push_back("damping    " + damping);
  if (!read.duration_given && !settings.until)
    model.push_back(fmt::format("duration   {} s: the scene gives none; --until sets another",
                                scene::default_duration));
  return model;
}

/// The runs of a scene, and what is known of them.
struct Runs {
  std::string name;        ///< of the scene's file
  bool has_files = false;  ///< whether those of each run are written
  std::vector<SceneRun> runs = {};
  std::vector<std::string> excess = {};  ///< of the energy of each, see excess_of_energy
  std::vector<RunRow> rows = {};

  /// Fills the rows; returns the lines of the errors and answers.
  std::string judge(const trajectories::SceneTruth& truth);
};

std::string Runs::judge(const trajectories::SceneTruth& truth) {
  std::string text;
  rows.clear();
  for (std::size_t k = 0; k < runs.size(); ++k) {
    std::optional<trajectories::SceneErrors> errors;
    if (truth.problem && runs[k].outcome.status == Status::ok)
      errors = trajectories::scene_errors(*truth.problem, runs[k].outcome, truth.truth);
    rows.push_back(
        trajectories::row_of(runs[k], excess[k], errors ? &*errors : nullptr, truth.truth));
    rows.back().case_id = name;
    if (has_files) rows.back().replay = runs[k].folder + "replay.html";
    text += text_of_answer(runs[k], errors ? &*errors : nullptr, rows.back());
  }
  return text;
}

void write_page(const record::OutputFolder& folder, const Scene& scene, const Runs& all,
                const trajectories::SceneTruth& truth, const Lines& model, const Say& say) {
  trajectories::RunTexts texts{.title = scene.name, .lead = {}, .facts = {}};
  for (const std::string& line : model) texts.facts.emplace_back("", line);
  if (!truth.truth.source.empty()) texts.facts.emplace_back("", "truth      " + truth.truth.source);
  const bool page = trajectories::write_scene_page(folder, scene, all.runs, all.rows, truth, texts);
  remark_on_page(page);
  say(fmt::format("files      {}\n",
                  (page ? folder.path() / "index.html" : folder.path()).string()));
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
  const bool rows = options.format != "table";
  // Beside rows, what people read goes where remarks go.
  const Say say = [&](const std::string& text) { rows ? tell(text) : print(text); };
  const Lines model = model_of(read, scene, *whole, settings);
  say(text_of(model) + text_of(describe_fits(entrants, options.verbose)));

  Runs all{.name = std::filesystem::path(source.word()).stem().string(),
           .has_files = folder.has_value()};
  for (const Entrant* entrant : chosen) {
    const std::clock_t begin = std::clock();
    all.runs.push_back(run_one(scene, *entrant, settings));
    if (interrupted) return interrupted_code;
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    SceneRun& one = all.runs.back();
    const bool ok = one.outcome.status == Status::ok;
    all.excess.push_back(ok ? trajectories::excess_of_energy(scene, one.outcome) : "");
    const Lines result = describe_run(one, seconds);
    say(text_of(result) + (ok ? "" : text_of_why(scene, one, options)));
    if (!folder) continue;
    Lines facts = model;
    facts.insert(facts.end(), result.begin(), result.end());
    if (!all.excess.back().empty())
      facts.push_back("answer     wrong: it has blown up: " + all.excess.back());
    if (chosen.size() > 1) one.folder = entrant->info.library + "_" + entrant->info.method + "/";
    write_run(*folder, one, scene, facts, options.frames, say);
  }
  std::string answers = all.judge({});
  trajectories::SceneTruth truth;
  if (folder) write_page(*folder, scene, all, truth, model, say);
  // After the files, since it may take longer than the runs.
  if (options.truth) truth = truth_of(all.runs, scene, source_text, say);
  if (truth.problem) {
    answers = all.judge(truth);
    if (folder) write_page(*folder, scene, all, truth, model, [](const std::string&) {});
  }
  say(answers);
  if (rows) print_rows(all.rows, options.format);
  return std::ranges::any_of(all.rows, &RunRow::stands) ? success : solver_failed;
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
