// SPDX-License-Identifier: BSD-3-Clause
// Bodies of a scene: particles, springs, cloths.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "odeum/scene/read/reader_fields.hpp"

namespace odeum::scene::reading {
namespace {

constexpr std::uint64_t most_whole = std::uint64_t{1} << 53;

// The end of a spring: the id of a particle read before.
std::size_t particle_id(const Value& value) {
  const std::size_t count = value.context().scene.particles.size();
  const std::uint64_t id = value.whole(0, most_whole);
  if (id >= count)
    value.fail("no such particle", count == 0 ? "a scene with particles"
                                              : fmt::format("an id from 0 to {}", count - 1));
  return static_cast<std::size_t>(id);
}

Vec3 velocity_of(const Value& value, bool fixed) {
  const Vec3 velocity = value.vector();
  if (!fixed || velocity == Vec3{}) return velocity;
  value.warn("the velocity of a fixed particle is not used");
  return {};
}

/// The springs of one kind in a cloth.
struct ClothLinks {
  bool wanted = false;
  Spring like;
};

ClothLinks read_links(const Mapping& cloth, std::string_view key, bool axial, bool tension_only) {
  ClothLinks links;
  cloth.with(key, [&](const Value& value) {
    const Mapping mapping(value, {"stiffness", "damping"});
    links.wanted = true;
    links.like.stiffness = mapping.at("stiffness").number(Sign::not_negative);
    links.like.damping = mapping.damping();
    links.like.axial = axial;
    links.like.tension_only = tension_only;
  });
  return links;
}

struct Range {
  std::size_t first, last;
};

Range read_range(const Mapping& mapping, std::string_view key, std::size_t count) {
  if (!mapping.has(key)) return {0, count - 1};
  const auto ends = mapping.at(key).list_of(2, "the first and the last of a range, [3, 7]");
  const Range range{static_cast<std::size_t>(ends[0].whole(0, count - 1)),
                    static_cast<std::size_t>(ends[1].whole(0, count - 1))};
  if (range.last < range.first)
    mapping.at(key).fail("a descending range", fmt::format("[{}, {}]", range.first, range.last),
                         "first <= last");
  return range;
}

void read_cloth(const Value& value) {
  const Mapping cloth(
      value, {"rows", "columns", "origin", "row_edge", "column_edge", "mass", "structural", "shear",
              "bend", "damping_model", "tension_only", "fixed", "velocity"});
  Scene& scene = value.context().scene;
  ClothPatch patch;
  patch.first = scene.particles.size();
  patch.rows = cloth.at("rows").whole(2, 1'000'000);
  patch.columns = cloth.at("columns").whole(2, 1'000'000);
  const std::size_t count = patch.rows * patch.columns;
  make_room(value, count);

  const Vec3 origin = cloth.has("origin") ? cloth.at("origin").vector() : Vec3{};
  const Vec3 row_edge = cloth.at("row_edge").vector(), edge = cloth.at("column_edge").vector();
  Particle particle;
  particle.mass = cloth.at("mass").number(Sign::positive) / static_cast<double>(count);
  if (!(particle.mass > 0))
    cloth.at("mass").fail("too small for its particles", "a mass that can be divided among them");
  for (std::size_t i = 0; i < patch.rows; ++i)
    for (std::size_t j = 0; j < patch.columns; ++j) {
      const double down = static_cast<double>(i) / static_cast<double>(patch.rows - 1);
      const double along = static_cast<double>(j) / static_cast<double>(patch.columns - 1);
      for (std::size_t d = 0; d < 3; ++d)
        particle.position[d] = origin[d] + down * row_edge[d] + along * edge[d];
      scene.particles.push_back(particle);
    }
  scene.cloths.push_back(patch);
  const auto at = [&](std::size_t i, std::size_t j) -> Particle& {
    return scene.particles[patch.first + i * patch.columns + j];
  };

  cloth.with("fixed", [&](const Value& list) {
    for (const Value& entry : list.list()) {
      const Mapping which(entry, {"row", "column"});
      if (!which.has("row") && !which.has("column"))
        entry.fail("nothing chosen", "row, column, or both");
      Range rows{0, patch.rows - 1}, columns{0, patch.columns - 1};
      which.with("row", [&](const Value& v) { rows.first = rows.last = v.whole(0, rows.last); });
      which.with("column",
                 [&](const Value& v) { columns.first = columns.last = v.whole(0, columns.last); });
      for (std::size_t i = rows.first; i <= rows.last; ++i)
        for (std::size_t j = columns.first; j <= columns.last; ++j) at(i, j).fixed = true;
    }
  });
  cloth.with("velocity", [&](const Value& list) {
    for (const Value& entry : list.list()) {
      const Mapping which(entry, {"rows", "columns", "value"});
      const Range rows = read_range(which, "rows", patch.rows);
      const Range columns = read_range(which, "columns", patch.columns);
      const Vec3 velocity = which.at("value").vector();
      for (std::size_t i = rows.first; i <= rows.last; ++i)
        for (std::size_t j = columns.first; j <= columns.last; ++j)
          if (!at(i, j).fixed) at(i, j).velocity = velocity;
    }
  });

  const bool axial = cloth.axial_or(true), tension_only = cloth.boolean_or("tension_only", false);
  const ClothLinks structural = read_links(cloth, "structural", axial, tension_only);
  const ClothLinks shear = read_links(cloth, "shear", axial, tension_only);
  const ClothLinks bend = read_links(cloth, "bend", axial, tension_only);
  const auto join = [&](const ClothLinks& links, std::size_t i, std::size_t j, std::size_t down,
                        std::ptrdiff_t along) {
    const auto column = static_cast<std::ptrdiff_t>(j) + along;
    if (!links.wanted || i + down >= patch.rows || column < 0 ||
        column >= static_cast<std::ptrdiff_t>(patch.columns))
      return;
    Spring spring = links.like;
    spring.a = patch.first + i * patch.columns + j;
    spring.b = patch.first + (i + down) * patch.columns + static_cast<std::size_t>(column);
    add_spring(value, spring, false);
  };
  for (std::size_t i = 0; i < patch.rows; ++i)
    for (std::size_t j = 0; j < patch.columns; ++j)
      for (const std::size_t reach :
           {1U, 2U}) {  // half of the neighbours, so that each pair is added once
        const auto steps = static_cast<std::ptrdiff_t>(reach);
        join(reach == 1 ? structural : bend, i, j, 0, steps);
        join(reach == 1 ? shear : bend, i, j, reach, -steps);
        join(reach == 1 ? structural : bend, i, j, reach, 0);
        join(reach == 1 ? shear : bend, i, j, reach, steps);
      }
}

}  // namespace

void make_room(const Value& at, std::uint64_t more) {
  const std::uint64_t most = at.context().options.most_particles;
  const std::uint64_t count = at.context().scene.particles.size() + more;
  if (count > most)
    at.fail("too many particles", std::to_string(count),
            fmt::format("at most {} (--max-particles raises it)", most));
}

void add_spring(const Value& at, Spring spring, bool rest_length_given) {
  Scene& scene = at.context().scene;
  const Vec3 &a = scene.particles[spring.a].position, &b = scene.particles[spring.b].position;
  const double length = std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
  if (a == b)
    at.fail(
        "a spring between particles at the same place, which has no direction",
        fmt::format("particles {} and {} at ({}, {}, {})", spring.a, spring.b, a[0], a[1], a[2]),
        "a distance");
  if (!std::isfinite(length))
    at.fail("particles too far apart for a spring", fmt::format("{}", length), "a finite length");
  if (!rest_length_given) spring.rest_length = length;
  scene.springs.push_back(spring);
  at.context().spring_places.push_back(at.place());
}

void read_particles(const Value& list) {
  for (const Value& entry : list.list()) {
    make_room(entry, 1);
    const Mapping mapping(entry, {"pos", "vel", "mass", "fixed", "radius"});
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
    list.context().scene.particles.push_back(particle);
  }
}

void read_springs(const Value& list) {
  for (const Value& entry : list.list()) {
    const Mapping mapping(entry, {"particle_ids", "stiffness", "damping", "damping_model",
                                  "rest_length", "tension_only"});
    const Value ids = mapping.at("particle_ids");
    const auto ends = ids.list_of(2, "two particle ids [a, b]");
    Spring spring;
    spring.a = particle_id(ends[0]);
    spring.b = particle_id(ends[1]);
    if (spring.a == spring.b)
      ids.fail("a spring from a particle to itself", fmt::format("[{}, {}]", spring.a, spring.b),
               "two different ids");
    spring.stiffness = mapping.at("stiffness").number(Sign::not_negative);
    spring.damping = mapping.damping();
    spring.axial = mapping.axial_or(true);
    spring.rest_length = mapping.number_or("rest_length", Sign::not_negative, 0);
    spring.tension_only = mapping.boolean_or("tension_only", false);
    add_spring(entry, spring, mapping.has("rest_length"));
  }
}

void read_cloths(const Value& list) {
  if (!list.is_list() && list.node().kind == YamlNode::Kind::mapping) return read_cloth(list);
  for (const Value& entry : list.list()) read_cloth(entry);
}

}  // namespace odeum::scene::reading
