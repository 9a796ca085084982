// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/kinds/kind.hpp"

#include <algorithm>
#include <stdexcept>

#include "odeum/cases/scene_case.hpp"
#include "odeum/formula/cache.hpp"
#include "odeum/scene/read/reader.hpp"

namespace odeum::cases {
namespace {

const std::string* built_in_scene(const std::string& name) {
  static const std::vector<std::pair<std::string, std::string>> all = [] {
    std::vector<std::pair<std::string, std::string>> texts;
    for (const SceneText& scene : all_scenes()) texts.emplace_back(scene.name, scene.text);
    return texts;
  }();
  const auto found = std::ranges::find(all, name, [](const auto& each) { return each.first; });
  return found == all.end() ? nullptr : &found->second;
}

bool is_scene(const Named& named) {
  if (named.word().ends_with(".fmu") || is_problem_text(named)) return false;
  if (named.has_yaml_name()) return named.exists();
  return !knows_case(named.word()) && (built_in_scene(named.word()) || named.exists());
}

ReadProblem read_scene(const Named& named, const Given& given) {
  if (!given.set.empty()) throw std::invalid_argument("a scene has no parameters; change its file");
  const scene::ReadOptions options{.need_solver = false};
  const std::string& text = scene_text(named, options.most_bytes);
  scene::ReadScene read = scene::read_scene(named.word(), text, options);
  return {{scene_statement(given.id, named.word(), text, std::move(read.scene), given.span)},
          formula::content_key(text),
          std::move(read.warnings)};
}

}  // namespace

const std::string& scene_text(const Named& named, std::size_t most_bytes,
                              const std::string& raise) {
  const std::string* const built_in =
      named.has_yaml_name() ? nullptr : built_in_scene(named.word());
  return built_in ? *built_in : named.text("scene", most_bytes, raise);
}

Kind scene_kind() { return {"scene", "_scene", true, is_scene, read_scene}; }

}  // namespace odeum::cases
