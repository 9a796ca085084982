// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "odeum/core/tolerance.hpp"

/// A mechanical scene: particles, springs, forces and contacts, in SI units. It is what a scene
/// file is read into, what cases make, what a SceneProblem is compiled from, and what a physics
/// engine, which takes bodies instead of a right-hand side, builds from.
namespace odeum::scene {

using Vec3 = std::array<double, 3>;
using Mat3 = std::array<double, 9>;  ///< row-major

struct Particle {
  Vec3 position{};
  Vec3 velocity{};  ///< zero where fixed
  double mass = 1;  ///< kg; not used where fixed
  bool fixed = false;
  double radius = 0;  ///< m, for drawing and contact
  double drag = 0;    ///< c in -c v on this particle, kg/s
};

/// See spring_law.hpp for the force.
struct Spring {
  std::size_t a = 0, b = 0;
  double stiffness = 0;       ///< N/m
  double damping = 0;         ///< N s/m
  double rest_length = 0;     ///< m
  bool tension_only = false;  ///< the elastic force acts only while stretched; damping always acts
  bool axial = false;         ///< damping of the relative velocity along the spring only
};

/// Attraction G m_a m_b / r^2 along the line between two particles.
struct Gravitation {
  std::size_t a = 0, b = 0;
  double constant = 0;  ///< G, N m^2/kg^2; repulsion where it is negative
};

/// Particles that form a cloth: rows * columns of them from `first`, row-major. For drawing.
struct ClothPatch {
  std::size_t first = 0, rows = 0, columns = 0;
};

struct Drag {
  double coefficient = 0;  ///< c in -c v, kg/s
};
struct QuadraticDrag {
  double coefficient = 0;  ///< c in -c |v| v, kg/m
};
struct Wind {
  Vec3 velocity{};         ///< w, m/s
  double coefficient = 0;  ///< c in c (w - v), kg/s
};
struct MagneticField {
  Vec3 field{};       ///< B, T
  double charge = 0;  ///< q in q v x B, C
};
using UniformForce = std::variant<Drag, QuadraticDrag, Wind, MagneticField>;

/// A penalty contact: stiffness * penetration - damping * its rate along the normal, never
/// attractive, and Coulomb friction across it.
struct Penalty {
  double stiffness = 0;  ///< N/m
  double damping = 0;    ///< N s/m
  double friction = 0;   ///< coefficient
};
struct PlaneContact : Penalty {
  Vec3 point{};
  Vec3 normal{0, 0, 1};  ///< a unit vector, away from the solid half space
};
struct SphereContact : Penalty {
  Vec3 center{};
  double radius = 0;
};
struct ParticleContact : Penalty {};
using Contact = std::variant<PlaneContact, SphereContact, ParticleContact>;

/// What keeps surfaces apart, see surface_law.hpp. Two of them meet with the mean of each number.
struct SelfContact {
  double thickness = 0;  ///< the distance at which the force begins, m
  double stiffness = 0;  ///< N/m: at half the thickness, the force of a spring of it
  double friction = 0;   ///< coefficient
};
/// Triangles of particles that meet themselves, other surfaces, and particles with a radius that
/// are on none.
struct Surface : SelfContact {
  std::vector<std::array<std::size_t, 3>> faces;
};

/// How a viewer draws emitted particles: soft sprites, between two looks from birth to death.
struct Look {
  std::array<Vec3, 2> colour{Vec3{1, 1, 1}, Vec3{1, 1, 1}};  ///< red, green, blue, 0 to 1
  std::array<double, 2> size{0.05, 0.05};                    ///< radius, m
  std::array<double, 2> opacity{1, 1};                       ///< 0 to 1
  bool additive = false;  ///< light is added, as of sparks; else the nearer covers the farther
  std::string texture;    ///< a PNG file's bytes; empty: a soft disc
};

/// Particles that appear during the run: number k at time k / rate.
struct Emitter {
  Vec3 position{};
  Vec3 velocity{};
  double spread = 0;  ///< half the angle of the cone around `velocity`, rad
  double rate = 0;    ///< particles per second
  double lifetime = std::numeric_limits<double>::infinity();  ///< s
  double mass = 1;
  std::uint64_t seed = 1;
  std::optional<Look> look = {};
};

struct SolverChoice {
  std::string type;   ///< a solver's id
  std::string where;  ///< `file:line:column: solver.type`, for messages
  /// One of them.
  std::optional<double> step;
  std::optional<Tolerance> tolerance;
};

/// A coordinate that is drawn over time.
struct Plot {
  std::size_t particle = 0;
  std::size_t coordinate = 0;                    ///< 0, 1, 2: x, y, z
  std::optional<std::array<double, 2>> y_range;  ///< m; empty: what the curve takes
};

struct Scene {
  std::string name;
  char up = 'z';
  Vec3 gravity{};  ///< m/s^2
  std::optional<double> duration;
  std::optional<SolverChoice> solver;
  std::vector<Particle> particles;
  std::vector<Spring> springs;
  std::vector<Gravitation> gravitations;
  std::vector<ClothPatch> cloths;
  std::vector<UniformForce> forces;
  std::vector<Contact> contacts;
  std::vector<Surface> surfaces;
  std::vector<Emitter> emitters;
  std::optional<double> frame_interval;  ///< s
  std::optional<Plot> plot;

  /// A force m * B v on every free particle, B row-major 3 x 3 (1/s). It expresses y' = lambda y as
  /// the motion of a particle for physics engines; a SceneProblem has no such term.
  Mat3 velocity_matrix{};
  /// How the state of the case follows from the scene's: component i of y is entry `select[i]` of
  /// [all positions x y z, all velocities x y z] (6 entries a particle). Empty: all of it.
  std::vector<std::size_t> select;

  std::size_t size() const { return particles.size(); }
};

/// The initial state: all positions, then all velocities.
inline std::vector<double> start_of(const Scene& scene) {
  std::vector<double> y;
  y.reserve(6 * scene.size());
  for (const Particle& p : scene.particles) y.insert(y.end(), p.position.begin(), p.position.end());
  for (const Particle& p : scene.particles) y.insert(y.end(), p.velocity.begin(), p.velocity.end());
  return y;
}

}  // namespace odeum::scene
