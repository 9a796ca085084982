// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "odeum/scene/model/scene.hpp"

/// A scene as its file says it, checked and in SI units: what `read_scene` returns and what a
/// `SceneProblem` is compiled from. Cloths are already spread out into particles and springs.
namespace odeum::scene {

struct DescribedParticle {
  Vec3 position{};
  Vec3 velocity{};
  double mass = 1;  ///< kg; of no meaning where fixed
  bool fixed = false;
  double radius = 0;  ///< m, for drawing and contact
};

struct DescribedSpring {
  std::size_t a = 0, b = 0;
  double stiffness = 0;       ///< N/m
  double damping = 0;         ///< N s/m
  bool axial = true;          ///< damping on the relative velocity along the spring, not the whole
  double rest_length = 0;     ///< m
  bool tension_only = false;  ///< the elastic force acts only while stretched
};

/// Which particles are a cloth: rows * columns of them from `first`, row-major. For drawing.
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

/// How a contact pushes back: along the normal stiffness * penetration - damping * its rate, never
/// pulling, and Coulomb friction across it.
struct Pushback {
  double stiffness = 0;  ///< N/m
  double damping = 0;    ///< N s/m
  double friction = 0;   ///< coefficient
};
struct PlaneContact : Pushback {
  Vec3 point{};
  Vec3 normal{0, 0, 1};  ///< a unit vector, away from the solid half space
};
struct SphereContact : Pushback {
  Vec3 center{};
  double radius = 0;
};
struct ParticleContact : Pushback {};
using Contact = std::variant<PlaneContact, SphereContact, ParticleContact>;

/// Particles born during the run: number k at time k / rate.
struct Emitter {
  Vec3 position{};
  Vec3 velocity{};
  double spread = 0;  ///< half the angle of the cone around `velocity`, rad
  double rate = 0;    ///< births a second
  double lifetime = std::numeric_limits<double>::infinity();  ///< s
  double mass = 1;
  std::uint64_t seed = 1;
};

struct SolverChoice {
  std::string type;   ///< a solver's id
  std::string where;  ///< `file:line:column: solver.type`, for who finds that there is none
  std::optional<double> step, tolerance;
};

struct Description {
  std::string name;
  char up = 'z';
  Vec3 gravity{0, 0, -9.81};  ///< m/s^2
  std::optional<double> duration;
  std::optional<SolverChoice> solver;
  std::vector<DescribedParticle> particles;
  std::vector<DescribedSpring> springs;
  std::vector<ClothPatch> cloths;
  std::vector<UniformForce> forces;
  std::vector<Contact> contacts;
  std::vector<Emitter> emitters;
  std::optional<double> frame_interval;  ///< s
};

}  // namespace odeum::scene
