// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "odeum/cases/kinds/kind.hpp"
#include "odeum/cases/span.hpp"
#include "odeum/cli/session.hpp"
#include "odeum/core/shell_word.hpp"
#include "odeum/formula/problem.hpp"
#include "odeum/report/facts.hpp"
#include "odeum/solvers/case.hpp"

namespace odeum::cli {

/// Cases, problem files and scenes that a command was given, and values for parameters.
struct ProblemOptions {
  std::vector<std::string> words;  ///< cases and files
  std::vector<std::string> sets;   ///< name=value
  std::string chosen;              ///< the case of a file with several; empty: none was named
  std::string inputs;              ///< a file of inputs over time; empty: none
  cases::Span span = {};           ///< of case_of()
};
/// Adds `--set`, and the problems themselves, or where `words` is false `--case`, which chooses a
/// case of the file that a command takes.
void add_problem_options(CLI::App& command, ProblemOptions& options, bool words = true);

/// The case of a command that takes one problem, before its truth is computed where that takes
/// long: a case, or the one of a file. Throws UsageError, also for a file with several cases of
/// which none is chosen.
Case case_before_truth(Session& session, const cases::Named& what, const ProblemOptions& options);
/// The same with its truth; `before_truth` may change it before that is computed.
Case case_of(Session& session, const std::string& what, const ProblemOptions& options,
             const std::function<void(Case&)>& before_truth = {});

/// Throws UsageError where the case has events, across which that command does not look.
void require_no_events(const Case& c, const std::string& command);

/// Throws UsageError where a case was chosen of what is not a problem's file.
void require_no_choice(const std::string& what, const std::string& chosen);

/// The equations of a case as a struct `Problem` of C++ for a solver, where a text states them.
/// Empty where none does. Throws UsageError for equations that are not printed.
std::string struct_of(const Case& c, const SolverInfo& solver);

/// The values that words after --set give, by name. Throws UsageError for a word other than
/// NAME=VALUE, and for a name that is given twice.
formula::Overrides overrides_of(const std::vector<std::string>& sets);
/// The words that say `sets`, the chosen case, the inputs and the plug-ins of `command`, each after
/// a space.
std::string words_of(const std::vector<std::string>& sets, const CLI::App& command);

/// The globs on cases that words and `case_globs` come to, with the problem files and scenes among
/// them loaded.
std::vector<std::string> load_problems(Session& session, const ProblemOptions& options,
                                       const std::vector<std::string>& case_globs);

/// What a report says of cases; each with the words that name it on a command line.
report::Facts facts_for(const Session& session, const std::vector<const Case*>& cases,
                        unsigned jobs);

}  // namespace odeum::cli
