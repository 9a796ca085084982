// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "odeum/scene/model/scene.hpp"

/// The terms of a scene's model: each a small object that is there only where the scene declares
/// it. Positions q, velocities v and forces are x y z of every particle, fixed ones too.
namespace odeum::scene {

/// What the terms need of the particles.
struct Bodies {
  std::vector<double> mass, inverse_mass, radius;  ///< an inverse mass of 0: fixed

  std::size_t size() const { return mass.size(); }
  bool free(std::size_t i) const { return inverse_mass[i] != 0; }
  std::size_t fixed() const {
    return static_cast<std::size_t>(std::ranges::count(inverse_mass, 0.0));
  }
};

/// Receives the derivatives of forces: of the force on particle i by the position of j (N/m) and by
/// its velocity (N s/m).
class BlockSink {
 public:
  virtual ~BlockSink() = default;
  virtual void add(std::size_t i, std::size_t j, const Mat3& by_position,
                   const Mat3& by_velocity) = 0;
  /// The four blocks of a force on a, and its opposite on b, that depends on the differences of
  /// their positions and velocities: from the derivatives of the force on a by those of b.
  void add_pair(std::size_t a, std::size_t b, const Mat3& by_position, const Mat3& by_velocity) {
    Mat3 x, v;
    for (std::size_t k = 0; k < 9; ++k) x[k] = -by_position[k], v[k] = -by_velocity[k];
    add(a, b, by_position, by_velocity);
    add(b, a, by_position, by_velocity);
    add(a, a, x, v);
    add(b, b, x, v);
  }
};

/// All derivatives of a force exist where the motion goes.
inline constexpr int any_order = 1000;
inline constexpr int order_at_kinks = 2, order_at_surfaces = 4;

/// What a term is, for the description of a model and the analysis of its structure.
struct TermInfo {
  std::string name;
  std::string law;
  std::size_t count = 0;  ///< of what it acts on
  std::string unit;       ///< "springs", "particles", "surfaces"
  bool velocity_dependent = false;
  bool linear = false;  ///< in positions and velocities
  /// The highest order that a method keeps: with k continuous derivatives of the force, k + 2.
  int order_kept = any_order;
};

class Term {
 public:
  virtual ~Term() = default;
  virtual TermInfo info(const Bodies& bodies) const = 0;
  /// Adds forces, N.
  virtual void add(const Bodies& bodies, const double* q, const double* v, double* force) const = 0;
  virtual void add_blocks(const Bodies& bodies, const double* q, const double* v,
                          BlockSink& sink) const = 0;
  /// J; 0 for a force that has none.
  virtual double potential(const Bodies& /*bodies*/, const double* /*q*/) const { return 0; }
};

/// Springs as a list of edges, sorted by their first ends.
class EdgeSprings final : public Term {
 public:
  EdgeSprings(const char* name, std::vector<Spring> springs);

  const std::vector<Spring>& springs() const { return springs_; }
  TermInfo info(const Bodies& bodies) const override;
  void add(const Bodies& bodies, const double* q, const double* v, double* force) const override;
  void add_blocks(const Bodies& bodies, const double* q, const double* v,
                  BlockSink& sink) const override;
  double potential(const Bodies& bodies, const double* q) const override;

 private:
  const char* name_;
  std::vector<Spring> springs_;
};

/// Gravitation between pairs, and drag of particles that have one; null where a scene has none. The
/// first throws std::invalid_argument for an end that is not a particle.
std::unique_ptr<Term> make_gravitation(const Scene& scene);
std::unique_ptr<Term> make_particle_drag(const Scene& scene);
/// The terms of `forces` and of `contacts`.
std::unique_ptr<Term> make_uniform_force(const UniformForce& force);
std::unique_ptr<Term> make_contact(const Contact& contact);

/// Friction is regularised: mu N u / sqrt(|u|^2 + s^2) at the sliding velocity u, with s this
/// speed in m/s. Static friction becomes creep, slower than s.
inline constexpr double friction_speed = 0.01;

/// The pairs (i, j), i < j, that may touch, ascending: a uniform grid whose cells are as wide as
/// the widest particle.
void possible_contacts(const Bodies& bodies, const double* q,
                       std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs);

}  // namespace odeum::scene
