// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "odeum/shards/assignment.hpp"
#include "odeum/solvers/case.hpp"

namespace odeum::study {
class Study;
}

namespace odeum::cli {

/// One command line while it runs: what was loaded for it, and what this process does of it where
/// it is that of a plan. Not thread-safe.
struct Session {
  std::string content;                       ///< tells the files that were loaded from others
  std::map<std::string, std::string> words;  ///< by case of these files, those that name it
  shards::Assignment assignment;
  TruthBounds truth_bounds;  ///< of the truths that the command asks for
};

/// The exit codes of the command-line contract.
enum ExitCode {
  success = 0,
  check_failed = 1,
  usage = 2,
  solver_failed = 3,
  file_failed = 4,
  interrupted_code = 130
};

/// Bad input: the message is printed and the exit code is 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  template <class First, class... More>
  explicit UsageError(fmt::format_string<First, More...> format, First&& first, More&&... more)
      : UsageError(fmt::format(format, std::forward<First>(first), std::forward<More>(more)...)) {}
};

/// The work was interrupted; what() says how to continue.
class Stopped : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Prints data to stdout, as a terminal may have it (for_terminal): JSON stays the same data.
/// Output to a closed pipe is dropped; a full disk is a FileError.
void print(const std::string& text);
/// Prints a remark for people to stderr.
void remark(const std::string& text);
/// Unless `written` (report::Report::write), warns that the folder holds data without a page.
void remark_on_page(bool written);
template <class First, class... More>
void print(fmt::format_string<First, More...> format, First&& first, More&&... more) {
  print(fmt::format(format, std::forward<First>(first), std::forward<More>(more)...));
}
template <class First, class... More>
void remark(fmt::format_string<First, More...> format, First&& first, More&&... more) {
  remark(fmt::format(format, std::forward<First>(first), std::forward<More>(more)...));
}

/// Throws UsageError where a glob matches no case (no solver), with the nearest name, or for a
/// library that is not in this build with the option that builds it.
void check_case_globs(const std::vector<std::string>& globs);
void check_solver_globs(const std::vector<std::string>& globs);
/// A glob on solvers; a name without a library is that of an own solver, as in `odeum run`, and so
/// is a glob that matches no id as it is written.
std::string with_library(const std::string& glob);

/// The case (the solver among those on a case or a scene) of that name. A solver id without a
/// library is Odeum's own. Throws UsageError.
const Case& find_case(const std::string& id);
const Entrant& find_entrant(const Entrants& entrants, const std::string& on, const std::string& id);
/// Throws UsageError: problems of the study `elements` where one with a time is asked for.
[[noreturn]] void refuse_in_space(const std::string& problems);
/// "; did you mean X?", or "one of X, Y" where several begin with the word; nothing where no
/// candidate is near.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& candidates);

/// Adds an option with the name of its value behind its own: "--step H". A brace pair in `help` is
/// the value where the option is not given.
template <class Value>
CLI::Option* add_option(CLI::App& command, const std::string& name, Value& value,
                        std::string help) {
  if constexpr (std::is_arithmetic_v<Value> || std::is_same_v<Value, std::string>)
    help = fmt::format(fmt::runtime(help), value);
  const std::size_t space = name.find(' ');
  CLI::Option* const option = command.add_option(name.substr(0, space), value, help);
  return space == std::string::npos ? option : option->type_name(name.substr(space + 1));
}

/// The options of every study.
struct StudyOptions {
  std::vector<std::string> solvers;
  std::string out = "reports/out";
  unsigned jobs = 0;      ///< 0: the number of cores
  bool resume = false;    ///< said by the user; results are kept in any case
  bool no_cache = false;  ///< neither take nor keep results
  std::string format = "table";
  unsigned jobs_or_cores() const;
};
void add_study_options(CLI::App& command, StudyOptions& options);
/// Adds --format: table (`text` is another word for it), csv or json.
void add_format(CLI::App& command, std::string& format);

/// Each adds its subcommand, which works with the session; `result` receives the exit code where
/// that can be another one than `success` without an error.
void add_list(CLI::App& app, Session& session);
void add_run(CLI::App& app, Session& session, int& result);
void add_advise(CLI::App& app, Session& session, int& result);
void add_why(CLI::App& app, Session& session, int& result);
void add_judge(CLI::App& app, Session& session, int& result);
void add_compare(CLI::App& app, int& result);
void add_sweep(CLI::App& app, Session& session, int& result);
void add_report(CLI::App& app, Session& session);
void add_verify(CLI::App& app, Session& session, int& result);
void add_classify(CLI::App& app, Session& session);
void add_poisson(CLI::App& app);
void add_doctor(CLI::App& app);
/// Runs a command line of Odeum, without the program's name; returns its exit code.
using RunCommandLine = std::function<int(const std::vector<std::string>& words, Session& session)>;
/// Adds plan, shard, merge and status.
void add_plan(CLI::App& app, Session& session, int& result, const RunCommandLine& run);
/// The command that a study declares.
void add_study(CLI::App& app, Session& session, study::Study& study);

}  // namespace odeum::cli
