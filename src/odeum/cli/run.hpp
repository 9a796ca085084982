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

/// The source of a scene: a file, or a built-in text.
struct SceneSource {
  std::string file;                 ///< the name in errors
  std::optional<std::string> text;  ///< empty: read the file
};

/// The scene of that name: a file name with a scene's extension, else a built-in scene unless a
/// case has its name, else an existing file; nothing otherwise.
std::optional<SceneSource> find_scene(const std::string& what);

/// Runs a scene, prints the model and the result, writes the files. Returns the exit code.
int run_scene(const SceneSource& source, const RunOptions& options);

}  // namespace odeum::cli
