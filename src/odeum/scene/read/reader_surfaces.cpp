// SPDX-License-Identifier: BSD-3-Clause
// Surfaces of a scene: those of cloths, and those listed by their faces.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

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

/// Whether each edge belongs to two faces.
bool is_closed(const Surface& surface) {
  std::map<std::pair<std::size_t, std::size_t>, int> faces_of;
  for (const auto& x : surface.faces)
    for (std::size_t k = 0; k < 3; ++k) ++faces_of[std::minmax(x[k], x[(k + 1) % 3])];
  return std::ranges::all_of(faces_of, [](const auto& edge) { return edge.second == 2; });
}

/// Whether a point is inside of a closed surface: the solid angles of its faces add to 4 pi then,
/// else to 0 (van Oosterom, Strackee 1983). Faces that are listed in mixed directions hide it.
bool is_around(const Scene& scene, const Surface& surface, const Vec3& x) {
  double angle = 0;
  for (const auto& face : surface.faces) {
    Vec3 r[3];
    double l[3];
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t d = 0; d < 3; ++d) r[k][d] = scene.particles[face[k]].position[d] - x[d];
      l[k] = std::sqrt(dot(r[k], r[k]));
    }
    const double volume = r[0][0] * (r[1][1] * r[2][2] - r[1][2] * r[2][1]) +
                          r[0][1] * (r[1][2] * r[2][0] - r[1][0] * r[2][2]) +
                          r[0][2] * (r[1][0] * r[2][1] - r[1][1] * r[2][0]);
    angle += 2 * std::atan2(volume, l[0] * l[1] * l[2] + dot(r[0], r[1]) * l[2] +
                                        dot(r[1], r[2]) * l[0] + dot(r[2], r[0]) * l[1]);
  }
  return std::abs(angle) > 2 * std::numbers::pi;
}

/// Refuses an edge that goes through a triangle, and a surface within another that is closed.
void require_outside(Context& context, const Surfaces& surfaces, const double* q) {
  const Scene& scene = context.scene;
  if (const auto pierced = surfaces.pierced(q)) {
    const auto [a, b] = pierced->edge;
    const auto [c, d, e] = pierced->triangle;
    context.surfaces[pierced->surface].fail(
        "starts through a surface",
        fmt::format("the edge of particles {} and {}, which goes through the triangle of {}, {} "
                    "and {}",
                    a, b, c, d, e),
        "surfaces that do not go through each other");
  }
  for (std::size_t body = 0; body < scene.surfaces.size(); ++body) {
    if (!is_closed(scene.surfaces[body])) continue;
    for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
      // No edge goes through: all of a connected surface is on the side of its first corner.
      const std::size_t corner = scene.surfaces[s].faces.front()[0];
      const Vec3& x = scene.particles[corner].position;
      if (s != body && is_around(scene, scene.surfaces[body], x))
        context.surfaces[s].fail("starts inside a body",
                                 fmt::format("particle {} at ({}, {}, {}) in a closed surface",
                                             corner, x[0], x[1], x[2]),
                                 "a start outside of all bodies");
    }
  }
}

/// The parts of a surface whose edges are shorter than the thickness touch each other at rest.
void warn_of_short_edges(Context& context) {
  const Scene& scene = context.scene;
  for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
    const Surface& surface = scene.surfaces[s];
    double shortest = std::numeric_limits<double>::max();
    for (const auto& x : surface.faces)
      for (std::size_t k = 0; k < 3; ++k)
        shortest = std::min(shortest, length(scene.particles[x[k]].position,
                                             scene.particles[x[(k + 1) % 3]].position));
    if (surface.thickness > shortest)
      context.surfaces[s].warn(
          fmt::format("the thickness, {:g} m, is above the shortest edge, {:.3g} m: parts of the "
                      "surface that are not next to each other are in contact at rest",
                      surface.thickness, shortest));
  }
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
  require_outside(context, surfaces, start.data());
  warn_of_short_edges(context);
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
