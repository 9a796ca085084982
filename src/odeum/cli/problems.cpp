// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cli/problems.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>

#include "odeum/cases/case_text.hpp"
#include "odeum/cli/run.hpp"
#include "odeum/cli/session.hpp"
#include "odeum/input/near_words.hpp"
#include "odeum/report/text.hpp"
#include "odeum/solvers/runtime_library.hpp"

namespace odeum::cli {
namespace {

/// The id; with `otherwise` where a case has it, and a number where one of a file before has that.
std::string unused_id(const std::string& id, const std::string& otherwise) {
  std::string unused = id;
  for (int number = 1; knows_case(unused); ++number)
    unused = id + otherwise + (number == 1 ? "" : std::to_string(number));
  return unused;
}

/// Leaves the statement of the case that `chosen` names, or the only one. Throws UsageError.
void keep_chosen(const std::string& path, const std::string& chosen,
                 std::vector<Statement>& statements) {
  std::vector<std::string> ids;
  for (const Statement& each : statements) ids.push_back(each.id);
  if (chosen.empty() && ids.size() > 1)
    throw UsageError("{} has {} cases; got no --case, expected --case with {}", path, ids.size(),
                     one_of(ids));
  if (chosen.empty()) return;
  std::erase_if(statements, [&](const Statement& each) { return each.id != chosen; });
  if (statements.empty())
    throw UsageError("--case: {} has no such case; got {}, expected {}", path, shown(chosen),
                     one_of(ids, chosen));
}

/// What `work` on a problem that is named returns. Throws UsageError for a problem that is wrong.
template <class Work>
auto with_usage_errors(const cases::Named& named, const Work& work) {
  try {
    return work();
  } catch (const InputError& error) {
    throw UsageError(error.what());
  } catch (const LoadError& error) {
    throw UsageError(error.what());
  } catch (const std::invalid_argument& error) {
    const std::string what = error.what();  // of a value of --set, where it names no other option
    throw UsageError(what.starts_with("--") ? what : "--set: " + what);
  } catch (const std::length_error& error) {
    throw UsageError("{}:1:1: {}", named.word(), error.what());
  }
}

void require_no_inputs(const std::string& what, const ProblemOptions& options) {
  if (!options.inputs.empty())
    throw UsageError("--inputs: got {}, expected an FMU, whose inputs alone come from a file",
                     shown(what));
}

/// The statements of a problem of that kind, or the chosen one, with ids that no other case has.
std::vector<Statement> read(Session& session, const cases::Kind& kind, const cases::Named& named,
                            const ProblemOptions& options, bool all) {
  const std::string stem = std::filesystem::path(named.word()).stem().string();
  if (!kind.has_inputs) require_no_inputs(named.word(), options);
  cases::ReadProblem read = kind.read(
      named, {report::file_stem(stem), overrides_of(options.sets), options.span, options.inputs});
  for (const std::string& warning : read.warnings) remark(warning + " (warning)");
  if (!all) keep_chosen(named.word(), options.chosen, read.statements);
  for (Statement& statement : read.statements) statement.id = unused_id(statement.id, kind.suffix);
  session.content += " " + read.content;
  return std::move(read.statements);
}

}  // namespace

std::string struct_of(const Case& c, const SolverInfo& solver) {
  try {
    return c.text ? cases::CaseText(*c.text).as_struct(solver.family == "taylor") : "";
  } catch (const std::exception& error) {
    throw UsageError("--code: {}", error.what());
  }
}

void add_problem_options(CLI::App& command, ProblemOptions& options, bool words) {
  if (words)
    add_option(command, "problem CASE|SCENE.yaml|PROBLEM.yaml|MODEL.fmu", options.words,
               "cases, with * and ?, scenes, and files of your own problems and FMUs");
  else
    add_option(command, "--case ID", options.chosen,
               "of a problem's file that has several cases: the one that is meant");
  add_option(command, "--set NAME=VALUE", options.sets,
             "another value of a parameter, see odeum list cases --parameters: --set B=2.5")
      ->allow_extra_args(false);
  add_option(command, "--inputs FILE.csv", options.inputs,
             "of an FMU over time, time,name,...: continuous ones piecewise linear, others held");
}

void require_no_choice(const std::string& what, const std::string& chosen) {
  if (!chosen.empty())
    throw UsageError("--case: chooses a case of a problem's file; got {}, expected no --case",
                     shown(what));
}

Case case_before_truth(Session& session, const cases::Named& what, const ProblemOptions& options) {
  if (const cases::Kind* const kind = cases::kind_of(what))
    return with_usage_errors(what, [&] {
      return odeum::case_before_truth(read(session, *kind, what, options, false).front());
    });
  require_no_choice(what.word(), options.chosen);
  require_no_inputs(what.word(), options);
  const Case c = with_sets(find_case(what.word()), options.sets, session.truth_bounds);
  return options.span.given() ? cases::with_span(c, options.span, session.truth_bounds) : c;
}

Case case_of(Session& session, const std::string& what, const ProblemOptions& options,
             const std::function<void(Case&)>& before_truth) {
  const cases::Named named(what);
  return with_usage_errors(named, [&] {
    Case c = case_before_truth(session, named, options);
    if (before_truth) before_truth(c);
    complete(c, session.truth_bounds);
    return c;
  });
}

std::vector<std::string> load_problems(Session& session, const ProblemOptions& options,
                                       const std::vector<std::string>& case_globs) {
  std::vector<std::string> globs, words = options.words;
  words.insert(words.end(), case_globs.begin(), case_globs.end());
  bool loaded = false;
  for (const std::string& word : words) {
    const cases::Named named(word);
    const cases::Kind* const kind = cases::kind_of(named);
    if (!kind) {
      globs.push_back(word);
      continue;
    }
    std::vector<Statement> statements =
        with_usage_errors(named, [&] { return read(session, *kind, named, options, true); });
    for (Statement& statement : statements) {
      const Case& c = with_usage_errors(
          named, [&]() -> const Case& { return add_user_case(std::move(statement)); });
      remark("{:<9}  {} ({})", kind->name, c.title, c.source);
      for (const auto& [name, fact] : c.facts) remark("{:<9}  {}", name, fact);
      std::string& name = session.words[c.id] = shell_word(word);
      for (const std::string& set : options.sets) name += " --set " + shell_word(set);
      if (!options.inputs.empty()) name += " --inputs " + shell_word(options.inputs);
      globs.push_back(c.id);
    }
    loaded = true;
  }
  if (!loaded) require_no_inputs(words.empty() ? "no problem" : words.front(), options);
  if (!loaded && !options.sets.empty())
    throw UsageError("--set: parameters are those of a problem file or an FMU, and none was given");
  return globs;
}

void require_no_events(const Case& c, const std::string& command) {
  if (c.problem.events)
    throw UsageError(
        "{}: {} has events, across which it does not look yet; run, converge, "
        "precision and sweep do",
        command, c.id);
}

report::Facts facts_for(const Session& session, const std::vector<const Case*>& cases,
                        unsigned jobs) {
  report::Facts facts = report::describe(cases, all_libraries(), jobs);
  for (report::CaseFacts& each : facts.cases)
    if (const auto loaded = session.words.find(each.id); loaded != session.words.end())
      each.words = loaded->second;
  return facts;
}

}  // namespace odeum::cli
