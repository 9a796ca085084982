// SPDX-License-Identifier: BSD-3-Clause
// Forces, contacts and emitters of a scene.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "odeum/input/text_file.hpp"
#include "odeum/scene/read/reader_fields.hpp"

namespace odeum::scene::reading {
namespace {

// An entry of a list of kinds, `- drag: {...}`: its kind and what follows.
std::pair<std::string, Value> read_choice(const Value& entry,
                                          std::initializer_list<std::string_view> known) {
  const Mapping mapping(entry, known);
  if (entry.node().items.size() != 2)
    entry.fail("not one key", fmt::format("{} keys", entry.node().items.size() / 2), "one key");
  const std::string& kind = entry.node().items.front()->text;
  return {kind, mapping.at(kind)};
}

UniformForce read_force(const std::string& kind, const Value& value) {
  if (kind == "wind") {
    const Mapping mapping(value, {"velocity", "coefficient"});
    return Wind{mapping.at("velocity").vector(),
                mapping.at("coefficient").number(Sign::not_negative)};
  }
  if (kind == "magnetic") {
    const Mapping mapping(value, {"field", "charge"});
    return MagneticField{mapping.at("field").vector(), mapping.at("charge").number()};
  }
  const Mapping mapping(value, {"coefficient"});
  const double coefficient = mapping.at("coefficient").number(Sign::not_negative);
  if (kind == "drag") return Drag{coefficient};
  return QuadraticDrag{coefficient};
}

void read_pushback(const Mapping& mapping, Penalty& back) {
  back.stiffness = mapping.at("stiffness").number(Sign::positive);
  back.damping = mapping.number_or("damping", Sign::not_negative, 0);
  back.friction = mapping.number_or("friction", Sign::not_negative, 0);
}

Contact read_contact(const std::string& kind, const Value& value) {
  if (kind == "plane") {
    const Mapping mapping(value, {"point", "normal", "stiffness", "damping", "friction"});
    PlaneContact plane;
    plane.point = mapping.at("point").vector();
    plane.normal = mapping.at("normal").vector();
    const double length = std::hypot(plane.normal[0], plane.normal[1], plane.normal[2]);
    if (!(length > 0) || !std::isfinite(length))
      mapping.at("normal").fail("zero vector", "a vector that is not zero");
    for (double& component : plane.normal) component /= length;
    read_pushback(mapping, plane);
    return plane;
  }
  if (kind == "sphere") {
    const Mapping mapping(value, {"center", "radius", "stiffness", "damping", "friction"});
    SphereContact sphere;
    sphere.center = mapping.at("center").vector();
    sphere.radius = mapping.at("radius").number(Sign::positive);
    read_pushback(mapping, sphere);
    return sphere;
  }
  ParticleContact particles;
  read_pushback(Mapping(value, {"stiffness", "damping", "friction"}), particles);
  return particles;
}

std::array<double, 2> from_to(const Value& value, double most) {
  const auto ends = value.list_of(2, "two numbers, at birth and at death");
  std::array<double, 2> numbers{};
  for (std::size_t k = 0; k < 2; ++k) {
    numbers[k] = ends[k].number(Sign::not_negative);
    if (numbers[k] > most) ends[k].fail("too large", fmt::format("a number from 0 to {}", most));
  }
  return numbers;
}

Vec3 read_colour(const Value& value) {
  const Vec3 colour = value.vector();
  for (const double part : colour)
    if (!(part >= 0 && part <= 1))
      value.fail("no colour", fmt::format("{}", part), "red, green and blue from 0 to 1");
  return colour;
}

// The bytes of a PNG file beside the scene's file.
std::string read_texture(const Value& value) {
  const std::filesystem::path file(value.text());
  const auto path = std::filesystem::path(context_of(value).file).parent_path() / file;
  std::string bytes;
  try {
    bytes = read_text_file(path.string(), "texture", 4'000'000);
  } catch (const InputError& error) {
    value.fail("a texture that cannot be read", error.what(), "a PNG file of at most 4 MB");
  }
  if (!bytes.starts_with("\x89PNG\r\n\x1a\n"))
    value.fail("no PNG file", path.string(), "a PNG file of at most 4 MB");
  return bytes;
}

Look read_look(const Value& value) {
  const Mapping mapping(value, {"colour", "size", "opacity", "blend", "texture"});
  Look look;
  mapping.with("colour", [&](const Value& v) {
    const auto ends = v.list_of(2, "two colours [red, green, blue], at birth and at death");
    look.colour = {read_colour(ends[0]), read_colour(ends[1])};
  });
  mapping.with("size", [&](const Value& v) { look.size = from_to(v, 1e9); });
  mapping.with("opacity", [&](const Value& v) { look.opacity = from_to(v, 1); });
  mapping.with("blend", [&](const Value& v) {
    const std::string blend = v.text();
    if (blend != "over" && blend != "add") v.fail("an unknown blend", "over or add");
    look.additive = blend == "add";
  });
  mapping.with("texture", [&](const Value& v) { look.texture = read_texture(v); });
  return look;
}

}  // namespace

void read_forces(const Value& list) {
  for (const Value& entry : list.list()) {
    const auto [kind, value] = read_choice(entry, {"drag", "quadratic_drag", "wind", "magnetic"});
    context_of(list).scene.forces.push_back(read_force(kind, value));
  }
}

void read_contacts(const Value& list) {
  for (const Value& entry : list.list()) {
    const auto [kind, value] = read_choice(entry, {"plane", "sphere", "particles"});
    context_of(list).scene.contacts.push_back(read_contact(kind, value));
  }
}

void read_emitters(const Value& list) {
  for (const Value& entry : list.list()) {
    const Mapping mapping(
        entry, {"position", "velocity", "spread", "rate", "lifetime", "mass", "seed", "look"});
    Emitter emitter;
    emitter.position = mapping.at("position").vector();
    emitter.velocity = mapping.at("velocity").vector();
    emitter.spread = mapping.number_or("spread", Sign::not_negative, 0);
    if (emitter.spread > 3.1415926535897936)
      mapping.at("spread").fail("an angle beyond pi", "radians, at most pi");
    emitter.rate = mapping.at("rate").number(Sign::positive);
    emitter.lifetime = mapping.number_or("lifetime", Sign::positive, emitter.lifetime);
    emitter.mass = mapping.at("mass").number(Sign::positive);
    mapping.with("seed",
                 [&](const Value& v) { emitter.seed = v.whole(0, std::uint64_t{1} << 53); });
    mapping.with("look", [&](const Value& v) { emitter.look = read_look(v); });
    context_of(list).scene.emitters.push_back(emitter);
  }
}

}  // namespace odeum::scene::reading
