// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cli/run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <memory>

namespace odeum::cli {

void add_step_and_tolerances(CLI::App& command, RunSettings& settings) {
  CLI::Option* step = add_option(command, "--step H", settings.step, "fixed step: 0.01, or 1/60")
                          ->transform([](const std::string& text) {
                            return text.find('/') == std::string::npos
                                       ? text
                                       : fmt::format("{}", number_of("--step", text, {{"", 1}}));
                          });
  CLI::Option* tol = command
                         .add_option_function<double>(
                             "--tol", [&](double both) { settings.tolerance = both; },
                             "relative and absolute tolerance, or with a case's own "
                             "absolute ones in proportion")
                         ->type_name("R")
                         ->excludes(step);
  struct Arguments {
    double relative = 0;
    std::vector<std::string> absolute;
  };
  const auto given = std::make_shared<Arguments>();
  CLI::Option* rtol =
      add_option(command, "--rtol R", given->relative, "relative tolerance, with --atol")
          ->excludes(step)
          ->excludes(tol);
  CLI::Option* atol =
      add_option(command, "--atol A", given->absolute,
                 "absolute tolerance: a number, one a component (1e-8,1e-14,1e-6), or by name, of "
                 "others a number before: 1e-8,x=1e-14")
          ->delimiter(',')
          ->allow_extra_args(false)
          ->needs(rtol);
  rtol->needs(atol);
  command.parse_complete_callback([&settings, given] {
    if (given->absolute.empty()) return;
    std::vector<double> numbers;
    std::vector<std::string> names;
    for (const std::string& word : given->absolute) {
      double number = 0;
      if (word.find('=') != std::string::npos)
        names.push_back(word);
      else if (CLI::detail::lexical_cast(word, number))
        numbers.push_back(number);
      else
        throw UsageError("--atol: got {}, expected a number or NAME=NUMBER", shown(word));
    }
    settings.named_absolute = assignments("--atol", names);
    settings.absolute_given = !numbers.empty();
    settings.tolerance =
        numbers.empty() ? Tolerance(given->relative) : Tolerance(given->relative, numbers);
  });
}

std::vector<std::string> describe_fits(const Entrants& entrants, bool verbose) {
  std::map<std::string, std::vector<std::string>> unfit;  // by reason
  std::vector<std::string> fitting;
  for (const Entrant& entrant : entrants)
    (entrant.unfit.empty() ? fitting : unfit[entrant.unfit]).push_back(entrant.info.id());
  std::vector<std::string> lines{fmt::format("fits       {} of {} solvers{}", fitting.size(),
                                             entrants.size(),
                                             verbose ? "" : ", which odeum list solvers names")};
  if (!verbose) return lines;
  lines.push_back(fmt::format("  {}", fmt::join(fitting, " ")));
  for (const auto& [reason, ids] : unfit)
    lines.push_back(fmt::format("unfit      {}: {}", fmt::join(ids, " "), reason));
  return lines;
}

std::vector<std::string> those_that_fit(const Entrants& entrants, const RunOptions& options,
                                        bool say) {
  const bool step = options.settings.step || options.settings.steps;
  std::vector<std::string> fitting, lines;
  for (const std::string& id : options.solvers) {
    const Entrant* const entrant =
        entrants.find(id.find('/') == std::string::npos ? "odeum/" + id : id);
    if (!entrant) {  // the run says that there is none
      fitting.push_back(id);
      continue;
    }
    std::string reason = entrant->unfit;
    if (reason.empty() && step && !entrant->info.fixed) reason = "runs to a tolerance only";
    if (reason.empty() && options.settings.tolerance && !entrant->info.adaptive)
      reason = "runs at a fixed step only";
    if (reason.empty())
      fitting.push_back(id);
    else
      lines.push_back(fmt::format("unfit      {}: {}", entrant->info.id(), reason));
  }
  if (fitting.empty()) return options.solvers;
  if (say)
    for (const std::string& line : lines) remark(line);
  return fitting;
}

namespace {

/// Adds the options of the setting, the end and the output.
void add_what_to_run(CLI::App& command, RunOptions& options) {
  add_problem_options(command, options.problems, false);
  add_step_and_tolerances(command, options.settings);
  CLI::Option* step = command.get_option("--step");
  CLI::Option* steps =
      add_option(command, "--steps N", options.settings.steps, "number of equal fixed steps")
          ->excludes(step);
  for (const char* other : {"--tol", "--rtol"}) steps->excludes(command.get_option(other));
  add_option(command, "--option NAME=VALUE ...", options.library_options,
             "a value for an option that the solver's library has: constraints=1");
  CLI::Option* until =
      add_option(command, "--until T", options.settings.until, "end time; default: the horizon");
  CLI::Option* every =
      add_option(command, "--every DT", options.settings.every,
                 "time between outputs; it does not change the steps of own solvers");
  CLI::Option* out = add_option(command, "--out DIR", options.out,
                                "folder for the files: index.html, trajectory.csv, ...");
  add_option(command, "--stops STUDY", options.stops,
             "the run of a study, speed or orders: to its end, with steps that end where it "
             "measures the error, which is the largest there")
      ->check(CLI::IsMember({"speed", "orders"}))
      ->excludes(until)
      ->excludes(every)
      ->excludes(out);
}

}  // namespace

void add_run(CLI::App& app, Session& session, int& result) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* command =
      app.add_subcommand("run", "one case, scene, problem file or FMU with one or more solvers");
  add_option(*command, "case CASE|SCENE.yaml|PROBLEM.yaml|MODEL.fmu", options->what,
             "a case, a scene (its file, or a name of odeum list), a problem's file, or an FMU")
      ->required();
  add_option(*command, "--solver ID...", options->solvers,
             "a solver; several are compared; default: the scene's own");
  add_what_to_run(*command, *options);
  command->add_flag("--verbose", options->verbose,
                    "name every solver that fits a scene or problem file, and that does not");
  command->add_flag_callback(
      "--no-truth", [options] { options->truth = false; },
      "compute no truth where none is known: the run alone, without its error");
  command->add_flag("--code", options->code,
                    "print a C++ program that makes this run, by the solver's own interface");
  add_format(*command, options->format);
  add_option(*command, "--frames N", options->frames,
             "of a scene's run with --out: so many pictures, film/0001.png, ...")
      ->check(CLI::Range(2, 9999));
  add_option(*command, "--max-particles N", options->limits.most_particles, "of a scene")
      ->capture_default_str();
  add_option(*command, "--max-megabytes N", options->megabytes, "of a scene's file")
      ->check(CLI::Range(1, 4096))
      ->capture_default_str();
  command->callback([options, command, &session, &result] {
    options->more = words_of(options->problems.sets, *command);
    options->limits.most_bytes = options->megabytes * 1'000'000;
    const cases::Named what(options->what);
    const cases::Kind* const kind = cases::kind_of(what);
    const bool scene = kind && kind->has_frames;
    if (!scene && options->frames > 0)
      throw UsageError("--frames: pictures are of a scene's run, and {} is none", options->what);
    if (scene) require_no_choice(options->what, options->problems.chosen);
    if (scene && options->code) throw UsageError("--code takes a case, not a scene");
    const bool as_case = !options->stops.empty();  // as studies run it
    if (scene && as_case)
      for (const char* of_frames : {"--frames", "--max-particles", "--max-megabytes"})
        if (command->count(of_frames) > 0)
          throw UsageError("{}: expected no --stops, with which a scene is run as studies run it",
                           of_frames);
    result = scene && !as_case ? run_scene(what, *options) : run_case(session, what, *options);
  });
}

}  // namespace odeum::cli
