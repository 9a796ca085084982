// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "odeum/cli/problems.hpp"
#include "odeum/cli/request.hpp"
#include "odeum/cli/session.hpp"
#include "odeum/scene/read/reader.hpp"

namespace odeum::cli {

struct RunOptions {
  std::string what;  ///< a case or a scene
  std::vector<std::string> solvers;
  std::string out;
  bool verbose = false;
  bool code = false;  ///< print a program instead of running
  RunSettings settings;
  ProblemOptions problems;  ///< values of parameters, of a case or a problem file
  scene::ReadOptions limits;
  std::size_t megabytes = 64;
};

/// The source of a scene: a file, or a built-in text.
struct SceneSource {
  std::string file;                 ///< the name in errors
  std::optional<std::string> text;  ///< empty: read the file
};

/// The scene of that name: a file name with a scene's extension, else a built-in scene unless a
/// case has its name, else an existing file; nothing otherwise.
std::optional<SceneSource> find_scene(const std::string& what);

/// The number of solvers that fit, by library and family, and of the others by reason, in lines;
/// `verbose` adds their ids.
std::vector<std::string> describe_fits(const std::vector<Entrant>& entrants, bool verbose);

/// Runs a scene with each solver, prints the model and the results, writes the files. Returns the
/// exit code.
int run_scene(const SceneSource& source, const RunOptions& options);

/// The same for a case.
int run_case(const RunOptions& options);

/// Prints what was found in a problem file; the same for its case where a solver is given.
int run_problem(const RunOptions& options);

}  // namespace odeum::cli
