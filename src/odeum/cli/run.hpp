// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <string>

#include "odeum/cli/request.hpp"
#include "odeum/cli/session.hpp"
#include "odeum/scene/read/reader.hpp"

namespace odeum::cli {

struct RunOptions {
  std::string what;  ///< a case or a scene
  std::string solver, out;
  RunSettings settings;
  scene::ReadOptions limits;
  std::size_t megabytes = 64;
};

/// Where a scene comes from: a file, or a text that is built in.
struct SceneSource {
  std::string file;                 ///< what errors call it
  std::optional<std::string> text;  ///< empty: read the file
};

/// The scene of that name: what ends as a scene's file, else one that is built in and shares its
/// name with no case, else what exists as a file; nothing where it is none of these.
std::optional<SceneSource> find_scene(const std::string& what);

/// Runs a scene, prints the model and what came of it, writes the files. Returns the exit code.
int run_scene(const SceneSource& source, const RunOptions& options);

}  // namespace odeum::cli
