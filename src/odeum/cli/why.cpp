// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/advise/why_answer.hpp"
#include "odeum/cli/run.hpp"
#include "odeum/record/output_folder.hpp"

namespace odeum::cli {
namespace {

struct WhyOptions {
  std::string what, solver, format = "text", out;
  double seconds = 20;
  RunSettings settings;
  ProblemOptions problems;
};

int why_on(const WhyOptions& options, const CLI::App& command) {
  require_positive("--seconds", options.seconds);
  const Case c = case_of(options.what, options.problems.sets);
  const RunSettings settings = settings_for(c, options.settings);
  if (!has_setting(settings)) throw UsageError("why needs --step or --tol, or --rtol and --atol");
  const Entrant& entrant = find_entrant(c.entrants, c.id, options.solver);
  const Request request = make_request(settings, c.t0, c.end(), c.y0.size(), entrant.info);
  const advise::Why why = advise::why(c, entrant.info.id(), request, options.seconds);
  const advise::Asked asked{shell_word(options.what), words_of(options.problems.sets, command)};
  const std::string text = advise::text_of(why, c, asked),
                    json = advise::json_of(why, c, asked).dump(2) + "\n";
  print(options.format == "json" ? json : text);
  if (!options.out.empty()) {
    const record::OutputFolder folder(options.out);
    folder.write("why.txt", text);
    folder.write("why.json", json);
  }
  return success;
}

}  // namespace

void add_why(CLI::App& app, int& result) {
  const auto options = std::make_shared<WhyOptions>();
  CLI::App* command = app.add_subcommand(
      "why", "what a run spends its steps on, why it failed or crawls, and what does better");
  command->add_option("problem", options->what, "a case, a scene, a problem's file, or an FMU")
      ->required()
      ->type_name("CASE|SCENE.yaml|PROBLEM.yaml|MODEL.fmu");
  command->add_option("--solver", options->solver, "the solver of the run")
      ->required()
      ->type_name("ID");
  add_problem_options(*command, options->problems, false);
  add_step_and_tolerances(*command, options->settings);
  command->add_option("--until", options->settings.until, "end time; default: the horizon")
      ->type_name("T");
  command->add_option("--seconds", options->seconds, "for the answer; default: 20")->type_name("S");
  command->add_option("--format", options->format, "text or json; default: text")
      ->check(CLI::IsMember({"text", "json"}))
      ->type_name("FORMAT");
  command->add_option("--out", options->out, "folder for why.txt and why.json")->type_name("DIR");
  command->callback([options, command, &result] { result = why_on(*options, *command); });
}

}  // namespace odeum::cli
