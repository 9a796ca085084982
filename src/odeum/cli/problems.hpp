// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "odeum/cases/catalogue.hpp"
#include "odeum/cases/span.hpp"
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
  cases::Span span = {};           ///< of case_of() and load_problem()
};
/// Adds `--set`, and the problems themselves, or where `words` is false `--case`, which chooses a
/// case of the file that a command takes.
void add_problem_options(CLI::App& command, ProblemOptions& options, bool words = true);

/// Whether that is a file whose text is that of a problem, with states or equations, or an FMU by
/// its name.
bool is_problem_file(const std::string& path);

/// The source of a scene: a file, or a built-in text.
struct SceneSource {
  std::string file;                 ///< the name in errors
  std::optional<std::string> text;  ///< empty: read the file

  /// Throws InputError; `raise` is the option that allows a larger file.
  std::string read(std::size_t most_bytes, const std::string& raise = "") const;
};

/// The scene of that name: a file name with a scene's extension, else a built-in scene unless a
/// case has its name, else an existing file; nothing otherwise.
std::optional<SceneSource> find_scene(const std::string& what);

/// Looks at the start and the end of a problem before its truth is computed, which may take long.
using SpanCheck = std::function<void(double t0, double end)>;

/// Makes the cases of a problem file, one at least, or of an FMU. Throws UsageError for a file that
/// is no problem, and for a value that is none.
using Cases = std::vector<const Case*>;
Cases load_problems_of(const std::string& path, const std::vector<std::string>& sets);
/// Makes the one that is chosen. Throws as above, what `check` throws, and UsageError where a file
/// has several cases and none of them is chosen.
const Case& load_problem(const std::string& path, const ProblemOptions& options,
                         const SpanCheck& check = {});

/// The case of a problem file without its truth, where that has to be computed; none also where
/// something is wrong with the file.
std::optional<Case> load_before_truth(const std::string& path, const ProblemOptions& options);
/// The same of a scene; none where it is no scene.
std::optional<Case> scene_before_truth(const std::string& what);

/// Makes the case of a scene. Throws UsageError for a text that is wrong, and for `sets`, since a
/// scene has no parameters.
const Case& load_scene(const SceneSource& source, const std::vector<std::string>& sets,
                       const cases::Span& span = {});

/// Throws UsageError where a case was chosen of what is no problem file.
void require_no_choice(const std::string& what, const std::string& chosen);

/// The case of a command that takes one problem: a case, a scene, or the one of a problem's file.
/// Throws UsageError.
Case case_of(const std::string& what, const ProblemOptions& options, const SpanCheck& check = {});

/// The equations of a case as a struct `Problem` of C++ for a solver, where a text states them:
/// `what` and the options are what the case was made of. Empty where none does. Throws UsageError
/// for what is not printed.
std::string struct_of(const std::string& what, const ProblemOptions& options, const Case& c,
                      const SolverInfo& solver);

/// The values that words after --set give, by name. Throws UsageError for what is no NAME=VALUE,
/// and for a name that is given twice.
formula::Overrides overrides_of(const std::vector<std::string>& sets);
/// Leaves the statement of the case that `chosen` names, or the only one. Throws UsageError.
void keep_chosen(const std::string& path, const std::string& chosen,
                 std::vector<Statement>& statements);
/// The words that say `sets`, the chosen case and the plug-ins of `command`, each after a space.
std::string words_of(const std::vector<std::string>& sets, const CLI::App& command);

/// The globs on cases that words and `case_globs` come to, with the problem files and scenes among
/// them loaded.
std::vector<std::string> load_problems(const ProblemOptions& options,
                                       const std::vector<std::string>& case_globs);

/// What a report says of cases; each with the words that name it on a command line.
report::Facts facts_for(const std::vector<const Case*>& cases, unsigned jobs);

/// A text that identifies the content of all that was loaded; empty: nothing was.
std::string mark_of_loaded();

}  // namespace odeum::cli
