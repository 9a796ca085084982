// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <string_view>
#include <vector>

#include "odeum/input/mapping.hpp"
#include "odeum/scene/read/reader.hpp"

/// The parts of the scene reader.
namespace odeum::scene::reading {

using input::Mapping;
using input::Sign;
using input::Value;

/// Keys for drawing that scene files of courses and viewers have; nothing physical is named so.
inline constexpr std::string_view viewer_keys[] = {
    "author", "background",   "camera", "color", "colour", "comment",        "description",
    "fps",    "ground_color", "label",  "light", "lights", "material_color", "opacity",
    "render", "resolution",   "show",   "title", "view",   "viewer",         "window"};

/// The state of reading: file, limits, warnings.
struct Context : input::Reading {
  explicit Context(const std::string& name, const ReadOptions& limits)
      : Reading{.file = name, .format = "scene", .unused = viewer_keys}, options(limits) {}

  ReadOptions options;
  Scene scene;
  std::vector<Place> spring_places;  ///< of each spring of the scene
  std::vector<Value> surfaces;       ///< where each surface of the scene stands
  bool allow_negative_damping = false;
  bool duration_given = true;
  bool damping_model_given = true;
};
inline Context& context_of(const Value& value) { return static_cast<Context&>(value.reading()); }

/// A damping: not negative, or a warning where the scene allows it.
double damping_of(const Mapping& mapping);
/// Whether the damping model is `axial`, the default, and not `full`; notes a damping without one.
bool is_axial(const Mapping& mapping);

void read_particles(const Value& list);
void read_springs(const Value& list);
void read_gravitational(const Value& list);
void read_cloths(const Value& list);
void read_forces(const Value& list);
void read_contacts(const Value& list);
void read_emitters(const Value& list);
void read_surfaces(const Value& list);
SelfContact read_self_contact(const Value& value);
void add_surface(const Value& at, Surface surface);
/// Fails for a surface that starts inside a body, or in contact with another.
void require_apart(Context& context);
/// The id of a particle read before.
std::size_t particle_id(const Value& value);
void read_plot(const Value& value);
/// Checks the ends and appends a spring; a `rest_length` below 0 means the distance.
void add_spring(const Value& at, Spring spring, bool rest_length_given);
/// A mass within the limit of particles, for `more` of them; fails where there are too many.
void make_room(const Value& at, std::uint64_t more);

}  // namespace odeum::scene::reading
