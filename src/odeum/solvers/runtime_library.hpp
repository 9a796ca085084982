// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "odeum/solvers/case.hpp"
#include "odeum/solvers/foreign_problem.hpp"

namespace odeum {

/// A library that is known only when the program runs: a plug-in, or a stepper that is tested from
/// another project. Its solvers are enrolled on every case after those of the libraries that are
/// built in, its cases follow those of the project. It is added before the cases are built, since
/// each case has all solvers; a problem file is given to a command afterwards (add_user_case).
struct RuntimeLibrary {
  LibraryInfo info;
  std::string mark;  ///< what identifies its code: results of another one are not used
  /// Adds its solvers as entrants of a contest; empty: it has none.
  std::function<void(const ErasedContest&, std::vector<Entrant>&)> enroll = {};
  /// Its problems; empty: it has none.
  std::function<std::vector<foreign::ProblemCallbacks>()> problems = {};
};

/// A library or a problem that cannot be loaded: the message says why.
class LoadError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Adds the plug-in in a shared object (api/plugin.h). Throws LoadError where it cannot
/// be used, or has the name of a library that is there.
void add_plugin(const std::string& file);

/// The problem in an FMU (adapters/fmi), with other values of parameters as NAME=VALUE. Its code
/// was tried in a process of its own. Throws LoadError where it cannot be used.
foreign::ProblemCallbacks open_fmu(const std::string& file,
                                   const std::map<std::string, std::string>& values = {});

/// What is read of FMI and by which libraries; empty: nothing.
std::string fmi_support();

/// Throws LoadError where a library of that name is there. To be called before the first call of
/// all_cases() or all_libraries(), which are built once; throws std::logic_error afterwards.
void add_runtime_library(RuntimeLibrary library);
/// Those that this program was built with, or without (generated).
const std::vector<LibraryInfo>& built_in_libraries();
/// In the order of their addition. Nothing can be added afterwards.
const std::vector<RuntimeLibrary>& runtime_libraries();

/// Cases of problems that a user gave to this run of the program. They are added before a study
/// begins, by one thread, once all_cases() and their solvers are known, and run only where they are
/// named.
std::vector<const Case*> user_cases();
/// The case stays where it is until the program ends. Throws std::invalid_argument where one of
/// that id was given before.
const Case& add_user_case(Case c);
/// all_cases(), then those of the user.
std::vector<const Case*> known_cases();

}  // namespace odeum
