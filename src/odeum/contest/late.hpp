// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "odeum/contest/case.hpp"

namespace odeum {

/// A library that is known only when the program runs: a plug-in, or a stepper that is tested from
/// another project. Its solvers are enrolled on every case after those of the libraries that are
/// built in, its cases follow those of the project.
struct LateLibrary {
  LibraryInfo info;
  std::string mark;  ///< what identifies its code: results of another one are not used
  /// Adds its solvers as entrants of a contest; empty: it has none.
  std::function<void(const ErasedContest&, std::vector<Entrant>&)> enroll = {};
  /// Its cases, without entrants; empty: it has none.
  std::function<std::vector<Case>()> cases = {};
  /// Called with each of its cases once all solvers are enrolled; may be empty.
  std::function<void(Case&)> finish = {};
};

/// A library that cannot be added: the message says why.
class LateError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Adds the plug-in in a shared object (adapters/plugin/plugin.h). Throws LateError where it cannot
/// be used, or has the name of a library that is there.
void add_plugin(const std::string& file);

/// Throws LateError where a library of that name is there. To be called before the first call of
/// all_cases() or all_libraries(), which are built once; throws std::logic_error afterwards.
void add_late_library(LateLibrary library);
/// Those that this program was built with, or without (generated).
const std::vector<LibraryInfo>& built_in_libraries();
/// In the order of their addition. Nothing can be added afterwards.
const std::vector<LateLibrary>& late_libraries();

}  // namespace odeum
