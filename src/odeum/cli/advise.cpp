// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <stdexcept>

#include "odeum/advise/answer.hpp"
#include "odeum/cli/run.hpp"
#include "odeum/truth/computed_truth.hpp"

namespace odeum::cli {
namespace {

struct AdviseOptions {
  std::string what, format = "text";
  advise::Wishes wishes;
  ProblemOptions problems;
};

int advise_on(const AdviseOptions& options, const CLI::App& command) {
  require_positive("--error", options.wishes.error);
  require_positive("--seconds", options.wishes.seconds);
  check_solver_globs(options.wishes.solvers);
  for (const std::string& library : options.wishes.libraries) check_solver_globs({library + "/*"});
  Case c = case_of(options.what, options.problems.sets);
  std::vector<double> state(c.y0.size());
  if (!c.truth.at || !c.truth.at(c.stops.back(), state.data()))
    c.truth = cases::truth_at(c, c.stops);
  advise::Asked asked{quoted(options.what), words_of(options.problems.sets, command)};
  // The truth is known up to there.
  if (c.end() > c.stops.back()) asked.more += fmt::format(" --until {}", c.stops.back());
  advise::Advice advice;
  try {
    advice = advise::advise(c, options.wishes);
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
  print(options.format == "json" ? advise::json_of(advice, c, asked).dump(2) + "\n"
                                 : advise::text_of(advice, c, asked));
  return advice.failure.empty() ? success : check_failed;
}

}  // namespace

void add_advise(CLI::App& app, int& result) {
  const auto options = std::make_shared<AdviseOptions>();
  CLI::App* command = app.add_subcommand(
      "advise", "which solver, at which setting, has an error on a problem in the least time");
  command->add_option("problem", options->what, "a case, a scene, a problem's file, or an FMU")
      ->required()
      ->type_name("CASE|SCENE.yaml|PROBLEM.yaml|MODEL.fmu");
  command
      ->add_option("--error", options->wishes.error,
                   "the largest error at the problem's stops, in the units of its errors")
      ->required()
      ->type_name("E");
  command->add_option("--library", options->wishes.libraries, "only solvers of these: cvode,gsl")
      ->type_name("NAME,...")
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_option("--solver", options->wishes.solvers, "solvers, with * and ?")
      ->type_name("GLOB...");
  command->add_option("--seconds", options->wishes.seconds, "for the answer; default: 20")
      ->type_name("S");
  command->add_option("--format", options->format, "text or json; default: text")
      ->check(CLI::IsMember({"text", "json"}))
      ->type_name("FORMAT");
  add_problem_options(*command, options->problems, false);
  command->callback([options, command, &result] { result = advise_on(*options, *command); });
}

}  // namespace odeum::cli
