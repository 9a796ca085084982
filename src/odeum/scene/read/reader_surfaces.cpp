// SPDX-License-Identifier: BSD-3-Clause
// Surfaces of a scene: those of cloths, and those listed by their faces.
#include <fmt/format.h>

#include <cmath>

#include "odeum/scene/read/reader_fields.hpp"
#include "odeum/scene/surface/surfaces.hpp"

namespace odeum::scene::reading {
namespace {

double length(const Vec3& a, const Vec3& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// What a point is inside of, in words; empty: of nothing.
std::string body_around(const Scene& scene, const Surfaces& surfaces, const Vec3& x) {
  for (const std::uint32_t ball : surfaces.balls())
    if (const Particle& one = scene.particles[ball]; !(length(x, one.position) > one.radius))
      return fmt::format("the ball of particle {}", ball);
  for (const Contact& contact : scene.contacts) {
    if (const auto* const sphere = std::get_if<SphereContact>(&contact))
      if (length(x, sphere->center) < sphere->radius) return "a sphere of contacts";
    if (const auto* const plane = std::get_if<PlaneContact>(&contact)) {
      Vec3 from{};
      for (std::size_t d = 0; d < 3; ++d) from[d] = x[d] - plane->point[d];
      if (dot(from, plane->normal) < 0) return "a plane of contacts";
    }
  }
  return {};
}

}  // namespace

SelfContact read_self_contact(const Value& value) {
  const Mapping mapping(value, {"thickness", "stiffness", "friction"});
  SelfContact law;
  law.thickness = mapping.at("thickness").number(Sign::positive);
  law.stiffness = mapping.at("stiffness").number(Sign::positive);
  law.friction = mapping.number_or("friction", Sign::not_negative, 0);
  return law;
}

void add_surface(const Value& at, Surface surface) {
  context_of(at).scene.surfaces.push_back(std::move(surface));
  context_of(at).surfaces.push_back(at);
}

void read_surfaces(const Value& list) {
  for (const Value& entry : list.list()) {
    const Mapping mapping(entry, {"faces", "self_contact"});
    Surface surface{read_self_contact(mapping.at("self_contact")), {}};
    for (const Value& face : mapping.at("faces").list()) {
      const auto corners = face.list_of(3, "three particle ids, [0, 1, 2]");
      std::array<std::size_t, 3> x{};
      for (std::size_t k = 0; k < 3; ++k) x[k] = particle_id(corners[k]);
      if (x[0] == x[1] || x[1] == x[2] || x[2] == x[0])
        face.fail("a face with a corner twice", fmt::format("[{}, {}, {}]", x[0], x[1], x[2]),
                  "three different ids");
      surface.faces.push_back(x);
    }
    if (surface.faces.empty()) mapping.at("faces").fail("no face", "[]", "one face at least");
    add_surface(entry, std::move(surface));
  }
}

void require_apart(Context& context) {
  if (context.surfaces.empty()) return;
  const Scene& scene = context.scene;
  const Surfaces surfaces(scene);
  for (std::size_t s = 0; s < scene.surfaces.size(); ++s)
    for (const auto& face : scene.surfaces[s].faces)
      for (const std::size_t corner : face) {
        const Vec3& x = scene.particles[corner].position;
        if (const std::string body = body_around(scene, surfaces, x); !body.empty())
          context.surfaces[s].fail(
              "starts inside a body",
              fmt::format("particle {} at ({}, {}, {}) in {}", corner, x[0], x[1], x[2], body),
              "a start outside of all bodies");
      }
  const std::vector<double> start = start_of(scene);
  std::vector<SurfacePair> near;
  surfaces.find_near(start.data(), 0, near);
  for (const SurfacePair& pair : near) {
    Vec<double> e1, e2, r;
    Apart<double> apart;
    differences_of(pair, start.data(), e1, e2, r);
    const SelfContact& law = surfaces.law(pair.law);
    constexpr double tenth = 0.1;
    if (!meet(pair, law, e1, e2, r, apart) || apart.distance > tenth * law.thickness) continue;
    const auto [a, b, c, d] = pair.x;
    context.surfaces[pair.law % scene.surfaces.size()].fail(
        "starts in contact",
        fmt::format("{:.3g} m between parts at particles {}, {} and {}, {}", apart.distance, a, b,
                    c, d),
        fmt::format("a tenth of the thickness, {:.3g} m, or more", tenth * law.thickness));
  }
}

}  // namespace odeum::scene::reading
