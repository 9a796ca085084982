// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <map>
#include <stdexcept>

#include "odeum/advise/answer.hpp"
#include "odeum/cli/run.hpp"
#include "odeum/input/yaml_tree.hpp"
#include "odeum/truth/computed_truth.hpp"

namespace odeum::cli {
namespace {

struct AdviseOptions {
  std::string what, format = "text", time, frame;
  advise::Wishes wishes;
  ProblemOptions problems;
};

/// A number with what may follow it: `4ms`, `1/60`. Throws UsageError.
double number_of(const char* option, const std::string& text,
                 const std::map<std::string, double>& units) {
  const char *at = text.data(), *const end = at + text.size();
  double value = 0;
  const auto read = [&](double& number) {
    const auto [stop, error] = std::from_chars(at, end, number);
    at = stop;
    return error == std::errc{} && number > 0 && std::isfinite(number);
  };
  double below = 1;
  bool sound = read(value);
  if (sound && at != end && *at == '/') {
    ++at;
    sound = read(below);
  }
  const auto unit = units.find(std::string(at, end));
  if (!sound || unit == units.end())
    throw UsageError("{}: got {}, expected a positive number or a fraction{}", option, shown(text),
                     units.size() > 1 ? ", in s, ms, us or ns" : "");
  return value / below * unit->second;
}

void read_times(AdviseOptions& options) {
  const bool error = options.wishes.error != 0, time = !options.time.empty();
  if (error == time) throw UsageError("advise needs --error or --time, and not both");
  if (!options.frame.empty() && !time) throw UsageError("--frame: a frame needs --time");
  if (error) require_positive("--error", options.wishes.error);
  if (time)
    options.wishes.time_ns = number_of(
        "--time", options.time, {{"", 1e9}, {"s", 1e9}, {"ms", 1e6}, {"us", 1e3}, {"ns", 1}});
  if (!options.frame.empty()) options.wishes.frame = number_of("--frame", options.frame, {{"", 1}});
}

int advise_on(AdviseOptions& options, const CLI::App& command) {
  read_times(options);
  if (command.count("--seconds") > 0) require_positive("--seconds", options.wishes.seconds);
  check_solver_globs(options.wishes.solvers);
  for (const std::string& library : options.wishes.libraries) check_solver_globs({library + "/*"});
  Case c = case_of(options.what, options.problems.sets);
  std::vector<double> state(c.y0.size());
  if (!c.truth.at || !c.truth.at(c.stops.back(), state.data()))
    c.truth = cases::truth_at(c, c.stops);
  advise::Asked asked{shell_word(options.what), words_of(options.problems.sets, command)};
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
      "advise",
      "which solver, at which setting, has an error on a problem in the least time, or the least "
      "error within a time");
  command->add_option("problem", options->what, "a case, a scene, a problem's file, or an FMU")
      ->required()
      ->type_name("CASE|SCENE.yaml|PROBLEM.yaml|MODEL.fmu");
  command
      ->add_option("--error", options->wishes.error,
                   "the largest error at the problem's stops, in the units of its errors: the "
                   "least time to it")
      ->type_name("E");
  command
      ->add_option("--time", options->time,
                   "the processor time of a run, as 5ms: the least error within it")
      ->type_name("T");
  command
      ->add_option(
          "--frame", options->frame,
          "with --time, which is then that of a frame: fixed steps that divide it, as 1/60")
      ->type_name("DT");
  command->add_option("--library", options->wishes.libraries, "only solvers of these: cvode,gsl")
      ->type_name("NAME,...")
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_option("--solver", options->wishes.solvers, "solvers, with * and ?")
      ->type_name("GLOB...");
  command->add_option("--seconds", options->wishes.seconds, "for the answer; default: 20, and 60 where a run takes over 2 ms")
      ->type_name("S");
  command->add_option("--format", options->format, "text or json; default: text")
      ->check(CLI::IsMember({"text", "json"}))
      ->type_name("FORMAT");
  add_problem_options(*command, options->problems, false);
  command->callback([options, command, &result] { result = advise_on(*options, *command); });
}

}  // namespace odeum::cli
