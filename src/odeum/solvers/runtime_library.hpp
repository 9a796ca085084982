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
/// another project. Its solvers follow those of the libraries that are built in, its cases those of
/// the project. It is added before solvers and cases are listed; a problem file is given to a
/// command afterwards (add_user_case).
struct RuntimeLibrary {
  LibraryInfo info;
  std::string mark;  ///< what identifies its code: results of another one are not used
  std::vector<Solver> solvers = {};
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

/// The problem in an FMU (adapters/fmi), with other values of parameters as NAME=VALUE, and inputs
/// over time from a file; empty: they are held. Its code was tried in a process of its own. Throws
/// LoadError where it cannot be used, and InputError for a wrong file of inputs.
foreign::ProblemCallbacks open_fmu(const std::string& file,
                                   const std::map<std::string, std::string>& values = {},
                                   const std::string& inputs = {});

/// What is read of FMI and by which libraries; empty: nothing.
std::string fmi_support();

/// Throws LoadError where a library of that name is there. To be called before the first call of
/// all_solvers(), all_libraries() or known_ids(), which are built once; throws std::logic_error
/// afterwards.
void add_runtime_library(RuntimeLibrary library);
/// The libraries that this program was built with, or without (generated).
const std::vector<LibraryInfo>& built_in_libraries();
/// The libraries in the order of their addition. Nothing can be added afterwards.
const std::vector<RuntimeLibrary>& runtime_libraries();

}  // namespace odeum
