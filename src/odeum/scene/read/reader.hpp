// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "odeum/input/yaml_tree.hpp"
#include "odeum/scene/model/scene.hpp"

namespace odeum::scene {

struct ReadOptions {
  std::size_t most_bytes = 64'000'000;
  std::size_t most_particles = 1'000'000;
  bool need_solver = true;  ///< false: the caller provides solver and setting
};

/// The duration of a scene that gives none, as in the courses that use this format, s.
inline constexpr double default_duration = 10;

struct ReadScene {
  Scene scene;
  std::vector<std::string> warnings;  ///< `file:line:column: key: message`
  bool duration_given = true;         ///< false: the duration is the default
  bool damping_model_given = true;    ///< false: some spring has the default
};

/// Which damping the springs have, and whether the scene names it; empty: none.
std::string describe_damping(const ReadScene& read);

/// Reads a scene file; cases/scenes/README.md describes its format. Throws InputError for
/// everything that is wrong with the path, the text or the numbers.
ReadScene read_scene_file(const std::string& path, const ReadOptions& options = {});
/// The same from a text; `file` is its name in errors.
ReadScene read_scene(const std::string& file, const std::string& text,
                     const ReadOptions& options = {});

}  // namespace odeum::scene
