// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "odeum/cli/problems.hpp"
#include "odeum/cli/session.hpp"
#include "odeum/report/text.hpp"
#include "odeum/scene/read/reader.hpp"
#include "odeum/scene/run/run.hpp"

namespace odeum::cli {

/// The settings of one run.
struct RunSettings {
  /// One of them.
  std::optional<double> step;
  std::optional<std::uint64_t> steps;
  std::optional<Tolerance> tolerance;
  bool absolute_given = false;  ///< by --atol: a case's own thresholds do not hold
  /// Absolute tolerances of components by their names, from --atol NAME=A.
  std::vector<std::pair<std::string, double>> named_absolute;
  std::optional<double> until;
  std::optional<double> every;  ///< between outputs
};

/// A number with what may follow it: `4ms`, `1/60`. Throws UsageError.
double number_of(const char* option, const std::string& text,
                 const std::map<std::string, double>& units);
/// Throws UsageError for a value of an option that is not positive and finite.
void require_positive(const char* option, double value);
/// Adds --step, --tol, --rtol and --atol.
void add_step_and_tolerances(CLI::App& command, RunSettings& settings);
/// Whether a step or a tolerance is given.
bool has_setting(const RunSettings& settings);
/// The settings for a case: without one the tolerance that its author asks for, and a tolerance
/// alone with the absolute ones of its thresholds.
RunSettings settings_for(const Case& c, RunSettings settings);
/// `rtol R, atol A`, or `R` where it is one number, for people.
std::string text_of_tolerance(const Request& request);

/// Throws UsageError where no run from t0 to `until` or `horizon` can have the settings.
void check_span(const RunSettings& settings, double t0, double horizon);

/// The case of a command with such settings; the span is checked before the truth is computed.
/// Throws UsageError.
Case case_within(Session& session, const std::string& what, const ProblemOptions& options,
                 const RunSettings& settings);

/// The request for a solver over [t0, until or `horizon`], with the only stop at the end;
/// `numbers`: the size of a state. A step that does not divide it is reduced, with a remark. Throws
/// UsageError for an invalid setting or one that the solver does not support.
Request make_request(const RunSettings& settings, double t0, double horizon, std::size_t numbers,
                     const SolverInfo& info);

/// Makes the request ask for states at times `every` apart too (by default at some 500), which do
/// not limit the steps of own adaptive solvers; at a fixed step at the nearest whole steps, with a
/// remark where that is another interval. `numbers`: the size of a state. Throws UsageError for an
/// invalid interval, and where the states are too many to keep.
void ask_for_output(Request& request, const RunSettings& settings, double t0, std::size_t numbers);

struct RunOptions {
  std::string what;  ///< a case, a scene, a problem's file or an FMU
  std::vector<std::string> solvers;
  std::string out;
  std::string format = "table";
  bool verbose = false;
  bool code = false;  ///< print a program instead of running
  std::string stops;  ///< speed or orders: the study at whose stops the run ends steps; empty: none
  std::vector<std::string> library_options;  ///< NAME=NUMBER, see Request::options
  bool truth = true;  ///< compare with one that is computed where none is known
  RunSettings settings;
  ProblemOptions problems;  ///< values of parameters, of a case or a problem file
  std::string more;         ///< the words of --set and --plugin, each after a space
  scene::ReadOptions limits;
  std::size_t megabytes = 64;
  std::size_t frames = 0;  ///< pictures of a scene's run; 0: none
};

/// The number of solvers that fit, in a line; `verbose` adds their ids, and those of the others by
/// reason.
std::vector<std::string> describe_fits(const Entrants& entrants, bool verbose);

/// The solvers that fit the problem and the setting, with a remark for each other unless `say` is
/// false; all of them where none does.
std::vector<std::string> those_that_fit(const Entrants& entrants, const RunOptions& options,
                                        bool say = true);

/// Runs a scene with each solver, prints the model and the results, writes the files. Returns the
/// exit code.
int run_scene(const cases::Named& source, const RunOptions& options);

using Assignments = std::vector<std::pair<std::string, double>>;
/// The values of an option NAME=NUMBER, in their order. Throws UsageError for what is none, a
/// number that is not finite, and a name that is given twice.
Assignments assignments(const char* option, const std::vector<std::string>& texts);

/// The values of --option, of options that the solver's library has. Throws UsageError.
std::map<std::string, double> library_options(const RunOptions& options, const SolverInfo& info);

/// The case with the values of --set, and its truth within the bounds. Throws UsageError.
Case with_sets(const Case& c, const std::vector<std::string>& sets, const TruthBounds& bounds);

/// The same for a case. Of a file, prints what was found in it, also where no solver is given.
int run_case(Session& session, const cases::Named& what, const RunOptions& given);

/// A C++ program that makes one run and prints the state at its end, by an own method or the
/// library's own interface. `problem`: the struct of struct_of(); without it the case comes from
/// the installed laboratory, for own methods. Throws UsageError for a solver that has no program.
std::string code_of(const Case& c, const std::string& problem, const Entrant& entrant,
                    const Request& request);

}  // namespace odeum::cli
