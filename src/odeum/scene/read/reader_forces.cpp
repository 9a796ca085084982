// SPDX-License-Identifier: BSD-3-Clause
// Forces, contacts and emitters of a scene.
#include <fmt/format.h>

#include <cmath>

#include "odeum/scene/read/reader_fields.hpp"

namespace odeum::scene::reading {
namespace {

// An entry of a list of kinds, `- drag: {...}`: a mapping of one key.
Mapping read_choice(const Value& entry, std::initializer_list<std::string_view> known) {
  Mapping mapping(entry, known);
  if (entry.node().items.size() != 2)
    entry.fail("not one key", fmt::format("{} keys", entry.node().items.size() / 2), "one key");
  return mapping;
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

}  // namespace

void read_forces(const Value& list) {
  for (const Value& entry : list.list()) {
    const Mapping choice = read_choice(entry, {"drag", "quadratic_drag", "wind", "magnetic"});
    list.context().scene.forces.push_back(
        read_force(choice.only_key(), choice.at(choice.only_key())));
  }
}

void read_contacts(const Value& list) {
  for (const Value& entry : list.list()) {
    const Mapping choice = read_choice(entry, {"plane", "sphere", "particles"});
    list.context().scene.contacts.push_back(
        read_contact(choice.only_key(), choice.at(choice.only_key())));
  }
}

void read_emitters(const Value& list) {
  for (const Value& entry : list.list()) {
    const Mapping mapping(entry,
                          {"position", "velocity", "spread", "rate", "lifetime", "mass", "seed"});
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
    list.context().scene.emitters.push_back(emitter);
  }
}

}  // namespace odeum::scene::reading
