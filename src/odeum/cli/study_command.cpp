// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>

#include "odeum/cases/catalogue.hpp"
#include "odeum/cli/kept_results.hpp"
#include "odeum/cli/problems.hpp"
#include "odeum/cli/session.hpp"
#include "odeum/core/glob.hpp"
#include "odeum/report/report.hpp"
#include "odeum/solvers/runtime_library.hpp"
#include "odeum/studies/elements/problems.hpp"

namespace odeum::cli {
namespace {

void add_own_option(CLI::App& command, const study::Option& option, study::Options& into) {
  CLI::Option* added = command.add_option(
      "--" + option.name, into.own[option.name],
      option.otherwise ? fmt::format("{}; default: {:g}", option.help, *option.otherwise)
                       : option.help);
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

/// Makes the folder a report of this study, beside the studies that it was one of before.
void show(const Session& session, const study::Study& study, const study::Options& options,
          const record::OutputFolder& folder, unsigned jobs) {
  const bool on_cases = !study.declaration().cases_help.empty();
  report::Report report(
      facts_for(session, on_cases ? study::select_cases(options.cases) : std::vector<const Case*>(),
                jobs),
      folder, jobs);
  for (const auto& other : study::make_studies())
    report.study(other->folder() == study.folder() ? study.facts() : other->facts());
  study.show(report);
  remark_on_page(report.write(
      {.command_line = "odeum " + study.declaration().name, .quick = options.quick}, true));
}

void run_study(const Session& session, study::Study& study, study::Options options,
               const StudyOptions& common) {
  std::erase_if(options.own, [](const auto& option) { return option.second.empty(); });
  const study::Declaration& declaration = study.declaration();
  if (common.resume && !declaration.no_resume.empty())
    throw UsageError("--resume: " + declaration.no_resume);
  check_case_globs(options.cases);
  options.solvers = common.solvers;
  shards::require_planned_content(session.assignment, session.content);
  std::optional<record::OutputFolder> out;
  if (const std::string path = session.assignment.output(common.out); !path.empty())
    out.emplace(path);
  const auto store = declaration.no_resume.empty() || !session.assignment.is_alone()
                         ? open_store(session, common)
                         : nullptr;
  try {
    study.measure(options, study::Runner(common.jobs_or_cores(),
                                         result_cache_of(session, store.get(), options)));
  } catch (const Interrupted&) {
    throw Stopped(resume_hint(store.get()));
  }
  shards::require_kept(session.assignment, store.get());
  if (!out) return;
  const record::OutputFolder& folder = *out;
  study.write(folder, common.jobs_or_cores());
  show(session, study, options, folder, common.jobs_or_cores());
  print(common.format == "json"  ? study.json()
        : common.format == "csv" ? study.csv()
                                 : study.table());
  if (session.assignment.is_alone()) remark_on(store.get());
  std::vector<std::string> files;
  for (const auto& [file, columns] : study.files())  // without rows a file is not written
    if (std::filesystem::exists(folder.path() / file)) files.push_back(file);
  if (files.empty())
    remark("no file is in {}: there are no rows", folder.path().string());
  else
    remark("{} {} in {}", fmt::join(files, ", "), files.size() == 1 ? "is" : "are",
           folder.path().string());
}

/// Takes the globs that match problems of the study `elements` and no case out of `globs`.
std::vector<std::string> take_elements(std::vector<std::string>& globs) {
  const std::vector<std::string> cases = known_ids();
  const auto is_of_cases = [&](const std::string& glob) {
    return glob.starts_with('!') ||
           std::ranges::any_of(cases, [&](const auto& id) { return glob_matches(glob, id); });
  };
  // Model problems have meshes: they are made only where a glob may mean one.
  if (std::ranges::all_of(globs, is_of_cases)) return {};
  const auto models = study::model_problems();
  const auto first_taken = std::stable_partition(globs.begin(), globs.end(), [&](const auto& glob) {
    return is_of_cases(glob) || std::ranges::none_of(models, [&](const auto& model) {
             return glob_matches(glob, model.id);
           });
  });
  std::vector<std::string> taken(first_taken, globs.end());
  globs.erase(first_taken, globs.end());
  return taken;
}

/// Orders in the mesh size for `odeum converge`; other studies refuse such problems. True where
/// there is nothing else to do.
bool run_elements(const Session& session, const study::Study& study, study::Options& options,
                  ProblemOptions& words, const StudyOptions& common) {
  std::vector<std::string> problems = take_elements(options.cases);
  for (std::string& word : take_elements(words.words)) problems.push_back(std::move(word));
  if (problems.empty()) return false;
  if (study.declaration().name != "converge") refuse_in_space(problems.front());
  for (const auto& other : study::make_studies())
    if (other->declaration().name == "elements")
      run_study(session, *other,
                {.own = {{"problems", fmt::format("{}", fmt::join(problems, " "))}}}, common);
  return options.cases.empty() && words.words.empty();
}

}  // namespace

void add_study(CLI::App& app, Session& session, study::Study& study) {
  struct Arguments {
    StudyOptions common;
    study::Options study;
    ProblemOptions problems;
  };
  const auto given = std::make_shared<Arguments>();
  const study::Declaration& declaration = study.declaration();
  CLI::App* command = app.add_subcommand(declaration.name, declaration.help);
  if (!declaration.cases_help.empty()) {
    add_option(*command, "--case GLOB", given->study.cases, declaration.cases_help);
    add_problem_options(*command, given->problems);
  }
  if (!declaration.quick_help.empty())
    command->add_flag("--quick", given->study.quick, declaration.quick_help);
  for (const study::Option& option : declaration.options)
    add_own_option(*command, option, given->study);
  add_study_options(*command, given->common);
  add_format(*command, given->common.format);
  command->callback([given, &session, &study] {
    check_solver_globs(given->common.solvers);  // before truths are computed
    if (run_elements(session, study, given->study, given->problems, given->common)) return;
    given->study.cases = load_problems(session, given->problems, given->study.cases);
    run_study(session, study, given->study, given->common);
  });
}

}  // namespace odeum::cli
