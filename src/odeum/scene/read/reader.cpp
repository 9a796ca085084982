// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/scene/read/reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "odeum/input/text_file.hpp"
#include "odeum/scene/read/reader_fields.hpp"

namespace odeum::scene {
namespace {

using namespace reading;

Vec3 read_gravity(const Value& value, char up) {
  if (value.is_list()) return value.vector();
  Vec3 gravity{};
  gravity[static_cast<std::size_t>(up - 'x')] = -value.number();
  for (double& component : gravity) component += 0.0;  // no -0
  return gravity;
}

/// Other names of solvers, in scene files of courses.
std::string solver_known_as(const std::string& name) {
  for (const char* const other : {"linearized_implicit", "linearised_implicit",
                                  "linearized_implicit_euler", "implicit_euler_linearized"})
    if (name == other) return "implicit_euler_linearised";
  return name;
}

SolverChoice read_solver(const Value& value) {
  const Mapping mapping(value, {"type", "timestep", "tolerance", "gravity"});
  SolverChoice choice;
  const Value type = mapping.at("type");
  choice.type = solver_known_as(type.text());
  choice.where = fmt::format("{}:{}:{}: {}", context_of(value).file, type.place().line,
                             type.place().column, type.key());
  mapping.with("timestep", [&](const Value& v) { choice.step = v.quotient(Sign::positive); });
  mapping.with("tolerance", [&](const Value& v) {
    if (v.node().kind != YamlNode::Kind::mapping)
      return void(choice.tolerance = v.number(Sign::positive));
    const Mapping both(v, {"relative", "absolute"});
    const double relative = both.at("relative").number(Sign::positive);
    choice.tolerance = Tolerance(relative, both.at("absolute").number(Sign::positive));
  });
  if (choice.step.has_value() == choice.tolerance.has_value())
    value.fail(choice.step ? "both settings" : "no setting",
               choice.step ? "timestep and tolerance" : "neither timestep nor tolerance",
               "one of timestep and tolerance");
  return choice;
}

// Two springs between the same particles are allowed, but usually a mistake.
void warn_of_duplicates(Context& context) {
  struct Pair {
    std::size_t low, high, spring;
    auto operator<=>(const Pair&) const = default;
  };
  std::vector<Pair> pairs;
  const auto& springs = context.scene.springs;
  for (std::size_t s = 0; s < springs.size(); ++s)
    pairs.push_back(
        {std::min(springs[s].a, springs[s].b), std::max(springs[s].a, springs[s].b), s});
  std::ranges::sort(pairs);
  constexpr std::size_t most_told = 5;
  std::size_t count = 0;
  for (std::size_t i = 1; i < pairs.size(); ++i) {
    if (pairs[i].low != pairs[i - 1].low || pairs[i].high != pairs[i - 1].high) continue;
    if (++count <= most_told)
      context.warn(context.spring_places[pairs[i].spring],
                   fmt::format("springs: duplicate spring between particles {} and {}; both act",
                               pairs[i].low, pairs[i].high));
  }
  if (count > most_told)
    context.warn({}, fmt::format("springs: {} more duplicate springs", count - most_told));
}

constexpr std::array keys_of_scenes = std::to_array<std::string_view>(
    {"name", "up", "gravity", "duration", "solver", "particles", "springs", "gravitational",
     "cloth", "forces", "contacts", "surfaces", "emitters", "output", "plot",
     "allow_negative_damping"});

/// A file none of whose keys is one of scenes may be meant as another kind.
void require_a_key_of_scenes(Context& context, const YamlNode& root) {
  if (root.kind != YamlNode::Kind::mapping || root.items.empty()) return;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < root.items.size(); i += 2) {
    if (std::ranges::find(keys_of_scenes, root.items[i]->text) != keys_of_scenes.end()) return;
    if (names.size() < 8) names.push_back(shown(root.items[i]->text));
  }
  Value(context, root, "")
      .fail("neither a scene nor a problem", fmt::format("the keys {}", fmt::join(names, ", ")),
            "particles, or a cloth or an emitter, of a scene; states and equations of a problem");
}

void read_all(Context& context, const YamlNode& root) {
  require_a_key_of_scenes(context, root);
  const Mapping mapping({context, root, ""}, keys_of_scenes);
  Scene& scene = context.scene;
  mapping.with("name", [&](const Value& v) { scene.name = v.text(); });
  mapping.with("up", [&](const Value& v) {
    const std::string axis = v.text();
    if (axis != "x" && axis != "y" && axis != "z") v.fail("an unknown axis", "x, y or z");
    scene.up = axis[0];
  });
  scene.gravity = {};
  scene.gravity[static_cast<std::size_t>(scene.up - 'x')] = -9.81;
  mapping.with("gravity", [&](const Value& v) { scene.gravity = read_gravity(v, scene.up); });
  // The same key below `solver`, where some courses have it.
  mapping.with("solver", [&](const Value& solver) {
    if (solver.node().kind != YamlNode::Kind::mapping || !solver.node().find("gravity")) return;
    const Value gravity(context, *solver.node().find("gravity"), solver.path_of("gravity"));
    if (mapping.has("gravity"))
      gravity.fail("gravity given twice", "it here too",
                   "one gravity, of the scene or of its solver");
    scene.gravity = read_gravity(gravity, scene.up);
  });
  scene.duration = mapping.number_or("duration", Sign::positive, default_duration);
  context.duration_given = mapping.has("duration");
  if (mapping.has("solver") || context.options.need_solver)
    scene.solver = read_solver(mapping.at("solver"));
  context.allow_negative_damping = mapping.boolean_or("allow_negative_damping", false);

  mapping.with("particles", read_particles);
  // The ids of springs may name the particles of cloths, which come after those listed.
  mapping.with("cloth", read_cloths);
  mapping.with("springs", read_springs);
  mapping.with("gravitational", read_gravitational);
  mapping.with("forces", read_forces);
  mapping.with("contacts", read_contacts);
  mapping.with("surfaces", read_surfaces);
  mapping.with("emitters", read_emitters);
  if (scene.particles.empty() && scene.emitters.empty())
    Value(context, root, "particles")
        .fail("no particles", "none", "particles, a cloth or an emitter");
  mapping.with("output", [&](const Value& v) {
    const Mapping output(v, {"every"});
    output.with("every",
                [&](const Value& e) { scene.frame_interval = e.quotient(Sign::positive); });
  });
  mapping.with("plot", read_plot);
  warn_of_duplicates(context);
  require_apart(context);
}

}  // namespace

std::string describe_damping(const ReadScene& read) {
  const auto damped = [&](bool axial) {
    return std::ranges::any_of(read.scene.springs, [axial](const Spring& spring) {
      return spring.damping != 0 && spring.axial == axial;
    });
  };
  const bool axial = damped(true), full = damped(false);
  if (!axial && !full) return {};
  if (!axial) return "full: of the whole relative velocity";
  const std::string text = full ? "axial of some springs, full of others"
                                : "axial: of the relative velocity along a spring";
  return read.damping_model_given
             ? text
             : text +
                   "; the scene names no damping_model, and full damps the whole relative "
                   "velocity";
}

ReadScene read_scene_file(const std::string& path, const ReadOptions& options) {
  return read_scene(path,
                    read_text_file(path, "scene", options.most_bytes, "--max-megabytes raises it"),
                    options);
}

ReadScene read_scene(const std::string& file, const std::string& text, const ReadOptions& options) {
  Context context(file, options);
  const auto root = parse_yaml(file, text, {.name = "scene"});
  read_all(context, *root);
  return {std::move(context.scene), std::move(context.warnings), context.duration_given,
          context.damping_model_given};
}

}  // namespace odeum::scene
