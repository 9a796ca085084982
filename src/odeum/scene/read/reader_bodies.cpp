// SPDX-License-Identifier: BSD-3-Clause
// Bodies of a scene: particles and springs.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "odeum/scene/read/reader_fields.hpp"

namespace odeum::scene::reading {
namespace {

constexpr std::uint64_t most_whole = std::uint64_t{1} << 53;

Vec3 velocity_of(const Value& value, bool fixed) {
  const Vec3 velocity = value.vector();
  if (!fixed || velocity == Vec3{}) return velocity;
  value.warn("the velocity of a fixed particle is not used");
  return {};
}

}  // namespace

std::size_t particle_id(const Value& value) {
  const std::size_t count = context_of(value).scene.particles.size();
  const std::uint64_t id = value.whole(0, most_whole);
  if (id >= count)
    value.fail("no such particle", count == 0 ? "a scene with particles"
                                              : fmt::format("an id from 0 to {}", count - 1));
  return static_cast<std::size_t>(id);
}

void make_room(const Value& at, std::uint64_t more) {
  const std::uint64_t most = context_of(at).options.most_particles;
  const std::uint64_t count = context_of(at).scene.particles.size() + more;
  if (count > most)
    at.fail("too many particles", std::to_string(count),
            fmt::format("at most {} (--max-particles raises it)", most));
}

namespace {

/// Two different particles of `particle_ids`, that `of` acts between.
std::array<std::size_t, 2> pair_of(const Mapping& mapping, const char* of) {
  const Value ids = mapping.at("particle_ids");
  const auto ends = ids.list_of(2, "two particle ids [a, b]");
  const std::array<std::size_t, 2> pair{particle_id(ends[0]), particle_id(ends[1])};
  if (pair[0] == pair[1])
    ids.fail(fmt::format("{} from a particle to itself", of),
             fmt::format("[{}, {}]", pair[0], pair[1]), "two different ids");
  return pair;
}

/// The distance of two particles; fails where they are at the same place or too far apart.
double distance_of(const Value& at, const char* of, std::size_t first, std::size_t second) {
  const Scene& scene = context_of(at).scene;
  const Vec3 &a = scene.particles[first].position, &b = scene.particles[second].position;
  const double length = std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
  if (a == b)
    at.fail(fmt::format("{} between particles at the same place, which has no direction", of),
            fmt::format("particles {} and {} at ({}, {}, {})", first, second, a[0], a[1], a[2]),
            "a distance");
  if (!std::isfinite(length))
    at.fail(fmt::format("particles too far apart for {}", of), fmt::format("{}", length),
            "a finite length");
  return length;
}

}  // namespace

void add_spring(const Value& at, Spring spring, bool rest_length_given) {
  const double length = distance_of(at, "a spring", spring.a, spring.b);
  if (!rest_length_given) spring.rest_length = length;
  context_of(at).scene.springs.push_back(spring);
  context_of(at).spring_places.push_back(at.place());
}

void read_particles(const Value& list) {
  for (const Value& entry : list.list()) {
    make_room(entry, 1);
    const Mapping mapping(entry, {"pos", "vel", "mass", "fixed", "radius", "drag"});
    Particle particle;
    particle.fixed = mapping.boolean_or("fixed", false);
    particle.position = mapping.at("pos").vector();
    mapping.with("vel",
                 [&](const Value& v) { particle.velocity = velocity_of(v, particle.fixed); });
    if (!particle.fixed)
      particle.mass = mapping.at("mass").number(Sign::positive);
    else
      particle.mass = mapping.number_or("mass", Sign::not_negative, 1);
    particle.radius = mapping.number_or("radius", Sign::not_negative, 0);
    particle.drag = mapping.number_or("drag", Sign::not_negative, 0);
    context_of(list).scene.particles.push_back(particle);
  }
}

void read_springs(const Value& list) {
  for (const Value& entry : list.list()) {
    const Mapping mapping(entry, {"particle_ids", "stiffness", "damping", "damping_model",
                                  "rest_length", "tension_only"});
    Spring spring;
    const auto [a, b] = pair_of(mapping, "a spring");
    spring.a = a;
    spring.b = b;
    spring.stiffness = mapping.at("stiffness").number(Sign::not_negative);
    spring.damping = damping_of(mapping);
    spring.axial = is_axial(mapping);
    spring.rest_length = mapping.number_or("rest_length", Sign::not_negative, 0);
    spring.tension_only = mapping.boolean_or("tension_only", false);
    add_spring(entry, spring, mapping.has("rest_length"));
  }
}

void read_gravitational(const Value& list) {
  for (const Value& entry : list.list()) {
    const Mapping mapping(entry, {"particle_ids", "G"});
    const auto [a, b] = pair_of(mapping, "gravitation");
    distance_of(entry, "gravitation", a, b);
    context_of(list).scene.gravitations.push_back({a, b, mapping.at("G").number()});
  }
}

void read_plot(const Value& value) {
  const Mapping mapping(value, {"particle_id", "dof", "y_range"});
  Plot plot;
  plot.particle = particle_id(mapping.at("particle_id"));
  plot.coordinate = static_cast<std::size_t>(mapping.at("dof").whole(0, 2));
  mapping.with("y_range", [&](const Value& v) {
    const auto ends = v.list_of(2, "the lower and the upper end, [0.7, 1.2]");
    plot.y_range = {ends[0].number(), ends[1].number()};
    if (!((*plot.y_range)[0] < (*plot.y_range)[1]))
      v.fail("an empty range", fmt::format("[{}, {}]", (*plot.y_range)[0], (*plot.y_range)[1]),
             "the lower end first");
  });
  context_of(value).scene.plot = plot;
}

}  // namespace odeum::scene::reading
