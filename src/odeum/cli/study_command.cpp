// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cli/study_command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <filesystem>
#include <memory>

#include "odeum/cli/kept_results.hpp"
#include "odeum/cli/problems.hpp"
#include "odeum/cli/session.hpp"

namespace odeum::cli {
namespace {

void add_own_option(CLI::App& command, const study::Option& option, study::Options& into) {
  CLI::Option* added = command.add_option("--" + option.name, into.own[option.name], option.help);
  if (!option.words.empty())
    added->check(CLI::IsMember(option.words));
  else
    added->type_name("N")->check([option](const std::string& text) {
      double value = 0;
      if (CLI::detail::lexical_cast(text, value) && value >= option.least && value <= option.most &&
          (!option.whole || value == std::floor(value)))
        return std::string();
      return fmt::format("got {}, expected a{} number from {:g} to {:g}", text,
                         option.whole ? " whole" : "", option.least, option.most);
    });
}

void run_study(study::Study& study, study::Options options, const StudyOptions& common) {
  std::erase_if(options.own, [](const auto& option) { return option.second.empty(); });
  const study::Declaration& declaration = study.declaration();
  if (common.resume && !declaration.no_resume.empty())
    throw UsageError("--resume: " + declaration.no_resume);
  check_case_globs(options.cases);
  options.solvers = common.solvers;
  check_solver_globs(options.solvers);
  const record::OutputFolder folder(common.out);
  const auto store = declaration.no_resume.empty() ? open_store(common) : nullptr;
  try {
    study.measure(options, study::Runner(common.jobs_or_cores(), keeping_of(store.get(), options)));
  } catch (const Interrupted&) {
    throw Stopped(what_continues(store.get()));
  }
  study.write(folder);
  print(study.table());
  remark_on(store.get());
  std::vector<std::string> files = study.files();
  // Without rows a file is not written.
  std::erase_if(files, [&](const std::string& file) {
    return !std::filesystem::exists(folder.path() / file);
  });
  if (files.empty())
    remark(fmt::format("no file is in {}: there are no rows", common.out));
  else
    remark(fmt::format("{} {} in {}", fmt::join(files, ", "), files.size() == 1 ? "is" : "are",
                       common.out));
}

}  // namespace

void add_study(CLI::App& app, study::Study& study, int& result) {
  struct Given {
    StudyOptions common;
    study::Options study;
    ProblemOptions problems;
  };
  const auto given = std::make_shared<Given>();
  const study::Declaration& declaration = study.declaration();
  CLI::App* command = app.add_subcommand(declaration.name, declaration.help);
  if (!declaration.cases_help.empty()) {
    command->add_option("--case", given->study.cases, declaration.cases_help)->type_name("GLOB");
    add_problem_options(*command, given->problems);
  }
  if (!declaration.quick_help.empty())
    command->add_flag("--quick", given->study.quick, declaration.quick_help);
  for (const study::Option& option : declaration.options)
    add_own_option(*command, option, given->study);
  add_study_options(*command, given->common);
  command->callback([given, &study, &result] {
    given->study.cases = load_problems(given->problems, given->study.cases);
    run_study(study, given->study, given->common);
    result = success;
  });
}

}  // namespace odeum::cli
