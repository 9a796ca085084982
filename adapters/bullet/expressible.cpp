// SPDX-License-Identifier: BSD-3-Clause
#include "expressible.hpp"

#include <BulletCollision/CollisionDispatch/btUnionFind.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace odeum::adapters::bullet {
namespace {

using scene::Particle;
using scene::Scene;
using scene::Spring;
using scene::Vec3;

bool zero(const Vec3& v) { return v == Vec3{}; }

double dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

bool has_medium(const Scene& scene) {
  return std::ranges::any_of(scene.velocity_matrix, [](double entry) { return entry != 0; });
}

bool has_tension_only(const Scene& scene) {
  return std::ranges::any_of(scene.springs,
                             [](const Spring& spring) { return spring.tension_only; });
}

/// The eigenvalue of the velocity matrix that belongs to the direction w, if w has one.
std::optional<double> eigenvalue(const std::array<double, 9>& b, const Vec3& w) {
  Vec3 image{};
  for (std::size_t i = 0; i < 3; ++i)
    image[i] = b[3 * i] * w[0] + b[3 * i + 1] * w[1] + b[3 * i + 2] * w[2];
  const double value = dot(image, w) / dot(w, w);
  const double rounding = 1e-14 * std::sqrt(dot(image, image));
  for (std::size_t i = 0; i < 3; ++i)
    if (!(std::abs(image[i] - value * w[i]) <= rounding)) return std::nullopt;
  return value;
}

/// Whether the parts that were joined are one.
bool is_one(btUnionFind& parts) {
  for (int i = 1; i < parts.getNumElements(); ++i)
    if (parts.find(0, i) == 0) return false;
  return true;
}

/// Whether springs join all particles, and common edges all faces.
bool is_one_piece(const Scene& scene) {
  btUnionFind particles, faces;
  particles.reset(static_cast<int>(scene.size()));
  for (const Spring& spring : scene.springs)
    particles.unite(static_cast<int>(spring.a), static_cast<int>(spring.b));
  std::size_t count = 0;
  for (const scene::Surface& surface : scene.surfaces) count += surface.faces.size();
  faces.reset(static_cast<int>(count));
  std::map<std::pair<std::size_t, std::size_t>, int> face_of;
  int face = 0;
  for (const scene::Surface& surface : scene.surfaces)
    for (const auto& x : surface.faces) {
      for (std::size_t k = 0; k < 3; ++k)
        faces.unite(face, face_of.emplace(std::minmax(x[k], x[(k + 1) % 3]), face).first->second);
      ++face;
    }
  return is_one(particles) && is_one(faces);
}

constexpr const char* medium_sentence =
    "needs a velocity force that is damping only; this one turns or drives the motion";

}  // namespace

std::optional<double> medium_damping(const Scene& scene) {
  if (!has_medium(scene)) return 0;
  if (!scene.springs.empty()) return std::nullopt;
  std::vector<Vec3> directions{scene.gravity};
  for (const Particle& particle : scene.particles)
    if (!particle.fixed) directions.push_back(particle.velocity);
  std::optional<double> common;
  for (const Vec3& direction : directions) {
    if (zero(direction)) continue;
    const auto value = eigenvalue(scene.velocity_matrix, direction);
    if (!value || *value > 0 || (common && *common != *value)) return std::nullopt;
    common = value;
  }
  return -common.value_or(0);
}

std::optional<double> anchored_damping(const Scene& scene) {
  std::vector<double> coefficient(scene.size(), 0);
  for (const Spring& spring : scene.springs) {
    if (spring.damping == 0) continue;
    if (!scene.particles[spring.a].fixed && !scene.particles[spring.b].fixed) return std::nullopt;
    coefficient[spring.a] += spring.damping;
    coefficient[spring.b] += spring.damping;
  }
  std::optional<double> common;
  for (std::size_t i = 0; i < scene.size(); ++i) {
    if (scene.particles[i].fixed) continue;
    const double rate = coefficient[i] / scene.particles[i].mass;
    if (common && *common != rate) return std::nullopt;
    common = rate;
  }
  return common.value_or(0);
}

std::optional<double> common_radius(const Scene& scene) {
  std::optional<double> common;
  for (const Particle& particle : scene.particles) {
    if (particle.fixed) continue;
    if (common && *common != particle.radius) return std::nullopt;
    common = particle.radius;
  }
  return common.value_or(0);
}

bool finite(const Scene& scene) {
  double sum = 0;  // NaN when any is not finite
  const auto look = [&sum](const auto& values) {
    for (const double value : values) sum += value * 0.0;
  };
  look(scene.gravity);
  look(scene.velocity_matrix);
  for (const Particle& particle : scene.particles) {
    look(particle.position);
    look(particle.velocity);
    look(std::array{particle.mass});
  }
  for (const Spring& spring : scene.springs)
    look(std::array{spring.stiffness, spring.damping, spring.rest_length});
  return sum == 0.0;
}

std::string objection_of_bodies(const Scene& scene) {
  for (const Particle& particle : scene.particles)
    if (!particle.fixed && !(particle.mass > 0))
      return "needs positive masses: Bullet takes any other for a fixed node";
  for (const Spring& spring : scene.springs)
    if (spring.a >= scene.size() || spring.b >= scene.size() || spring.a == spring.b)
      return "needs springs between two of the scene's particles";
  return {};
}

std::string objection_of_forces(const Scene&) { return {}; }

std::string objection_of_collision(const Scene& scene) {
  if (scene.contacts.empty())
    return "needs contacts: without them it is the same as bullet/soft_body_force";
  for (const scene::Contact& contact : scene.contacts)
    if (std::holds_alternative<scene::ParticleContact>(contact))
      return "needs contacts with planes and spheres: the nodes of a btSoftBody do not collide "
             "with "
             "each other";
  if (!common_radius(scene)) return "needs particles of one radius, the margin of a btSoftBody";
  return {};
}

std::string objection_of_links(const Scene& scene) {
  if (has_tension_only(scene))
    return "needs two-way springs: Bullet's links have no tension-only kind";
  if (!medium_damping(scene)) return medium_sentence;
  return {};
}

std::string objection_of_stock_links(const Scene& scene) {
  if (scene.springs.empty())
    return "needs springs: without links it is the same as bullet/soft_body_links";
  return objection_of_links(scene);
}

std::string objection_of_deformable(const Scene& scene) {
  if (has_tension_only(scene))
    return "needs two-way springs: btDeformableMassSpringForce has no tension-only kind";
  if (!medium_damping(scene)) return medium_sentence;
  return {};
}

std::string objection_of_self_collision(const Scene& scene) {
  if (scene.surfaces.empty())
    return "needs surfaces: without them it is the same as bullet/deformable_explicit";
  std::vector<bool> on_surface(scene.size());
  for (const scene::Surface& surface : scene.surfaces) {
    const scene::Surface& first = scene.surfaces.front();
    if (surface.thickness != first.thickness || surface.stiffness != first.stiffness ||
        surface.friction != first.friction)
      return "needs surfaces of one thickness, stiffness and friction: they are those of a "
             "btSoftBody";
    for (const auto& face : surface.faces)
      for (const std::size_t corner : face) on_surface[corner] = true;
  }
  for (std::size_t i = 0; i < scene.size(); ++i)
    if (scene.particles[i].radius > 0 && !on_surface[i])
      return "needs surfaces that meet surfaces alone: the nodes of a btSoftBody have no radius, "
             "so that none is a ball";
  if (!is_one_piece(scene))
    return "needs one piece: btSoftBody::initializeFaceTree joins faces by their edges and nodes "
           "by links, and does not end where some have no way to the others";
  return objection_of_deformable(scene);
}

}  // namespace odeum::adapters::bullet
