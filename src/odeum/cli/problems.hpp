// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "odeum/solvers/case.hpp"

namespace odeum::cli {

/// Cases and problem files that a command was given, and values for the parameters of the latter.
struct ProblemOptions {
  std::vector<std::string> words;  ///< cases and files
  std::vector<std::string> sets;   ///< name=value
};
/// Adds `--set`, and unless `words` is false the problems themselves.
void add_problem_options(CLI::App& command, ProblemOptions& options, bool words = true);

/// Whether that is a file whose text is that of a problem, with states or equations, or an FMU by
/// its name.
bool is_problem_file(const std::string& path);

/// Makes the cases of a problem file, one at least, or of an FMU. Throws UsageError for a file that
/// is no problem, and for a value that is none.
using Cases = std::vector<const Case*>;
Cases load_problem(const std::string& path, const std::vector<std::string>& sets);

/// The globs on cases that words and `case_globs` come to, with the problem files among them
/// loaded.
std::vector<std::string> load_problems(const ProblemOptions& options,
                                       const std::vector<std::string>& case_globs);

/// A text that identifies the content of all that was loaded; empty: nothing was.
std::string mark_of_loaded();

}  // namespace odeum::cli
