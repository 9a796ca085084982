// SPDX-License-Identifier: BSD-3-Clause
// A scene's cloths: a grid of particles, and springs to the neighbours.
#include <fmt/format.h>

#include "odeum/scene/read/reader_fields.hpp"

namespace odeum::scene::reading {
namespace {

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

/// Calls `change` with each particle of some rows and columns.
template <class Change>
void for_each_of(Scene& scene, const ClothPatch& patch, Range rows, Range columns,
                 const Change& change) {
  for (std::size_t i = rows.first; i <= rows.last; ++i)
    for (std::size_t j = columns.first; j <= columns.last; ++j)
      change(scene.particles[patch.first + i * patch.columns + j]);
}

void read_particles_of(const Mapping& cloth, const ClothPatch& patch) {
  Scene& scene = context_of(cloth.value()).scene;
  const Vec3 origin = cloth.has("origin") ? cloth.at("origin").vector() : Vec3{};
  const Vec3 row_edge = cloth.at("row_edge").vector(), edge = cloth.at("column_edge").vector();
  Particle particle;
  particle.mass =
      cloth.at("mass").number(Sign::positive) / static_cast<double>(patch.rows * patch.columns);
  particle.radius = cloth.number_or("radius", Sign::not_negative, 0);
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
}

void read_fixed(const Mapping& cloth, const ClothPatch& patch) {
  cloth.with("fixed", [&](const Value& list) {
    for (const Value& entry : list.list()) {
      const Mapping which(entry, {"row", "column"});
      if (!which.has("row") && !which.has("column"))
        entry.fail("nothing chosen", "row, column, or both");
      Range rows{0, patch.rows - 1}, columns{0, patch.columns - 1};
      which.with("row", [&](const Value& v) { rows.first = rows.last = v.whole(0, rows.last); });
      which.with("column",
                 [&](const Value& v) { columns.first = columns.last = v.whole(0, columns.last); });
      for_each_of(context_of(cloth.value()).scene, patch, rows, columns,
                  [](Particle& particle) { particle.fixed = true; });
    }
  });
}

void read_velocity(const Mapping& cloth, const ClothPatch& patch) {
  cloth.with("velocity", [&](const Value& list) {
    for (const Value& entry : list.list()) {
      const Mapping which(entry, {"rows", "columns", "value"});
      const Range rows = read_range(which, "rows", patch.rows);
      const Range columns = read_range(which, "columns", patch.columns);
      const Vec3 velocity = which.at("value").vector();
      for_each_of(context_of(cloth.value()).scene, patch, rows, columns, [&](Particle& particle) {
        if (!particle.fixed) particle.velocity = velocity;
      });
    }
  });
}

/// What all springs of one kind in a cloth are like, if it has any.
std::optional<Spring> read_links(const Mapping& cloth, std::string_view key, Spring like) {
  if (!cloth.has(key)) return std::nullopt;
  const Mapping mapping(cloth.at(key), {"stiffness", "damping"});
  like.stiffness = mapping.at("stiffness").number(Sign::not_negative);
  like.damping = damping_of(mapping);
  return like;
}

void read_springs_of(const Mapping& cloth, const ClothPatch& patch) {
  Spring like;
  like.axial = is_axial(cloth);
  like.tension_only = cloth.boolean_or("tension_only", false);
  const auto structural = read_links(cloth, "structural", like);
  const auto shear = read_links(cloth, "shear", like), bend = read_links(cloth, "bend", like);
  const auto join = [&](const std::optional<Spring>& links, std::size_t i, std::size_t j,
                        std::size_t down, std::ptrdiff_t along) {
    const auto column = static_cast<std::ptrdiff_t>(j) + along;
    if (!links || i + down >= patch.rows || column < 0 ||
        column >= static_cast<std::ptrdiff_t>(patch.columns))
      return;
    Spring spring = *links;
    spring.a = patch.first + i * patch.columns + j;
    spring.b = patch.first + (i + down) * patch.columns + static_cast<std::size_t>(column);
    add_spring(cloth.value(), spring, false);
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

/// Two triangles a cell.
std::vector<std::array<std::size_t, 3>> faces_of(const ClothPatch& patch) {
  std::vector<std::array<std::size_t, 3>> faces;
  for (std::size_t i = 0; i + 1 < patch.rows; ++i)
    for (std::size_t j = 0; j + 1 < patch.columns; ++j) {
      const std::size_t here = patch.first + i * patch.columns + j, below = here + patch.columns;
      faces.push_back({here, below, here + 1});
      faces.push_back({here + 1, below, below + 1});
    }
  return faces;
}

void read_cloth(const Value& value) {
  const Mapping cloth(value, {"rows", "columns", "origin", "row_edge", "column_edge", "mass",
                              "structural", "shear", "bend", "damping_model", "tension_only",
                              "radius", "fixed", "velocity", "self_contact"});
  Scene& scene = context_of(value).scene;
  const ClothPatch patch{.first = scene.particles.size(),
                         .rows = cloth.at("rows").whole(2, 1'000'000),
                         .columns = cloth.at("columns").whole(2, 1'000'000)};
  make_room(value, patch.rows * patch.columns);
  read_particles_of(cloth, patch);
  scene.cloths.push_back(patch);
  read_fixed(cloth, patch);
  read_velocity(cloth, patch);
  read_springs_of(cloth, patch);
  cloth.with("self_contact", [&](const Value& v) {
    add_surface(v, {read_self_contact(v), faces_of(patch)});
  });
}

}  // namespace

void read_cloths(const Value& list) {
  if (!list.is_list() && list.node().kind == YamlNode::Kind::mapping) return read_cloth(list);
  for (const Value& entry : list.list()) read_cloth(entry);
}

}  // namespace odeum::scene::reading
