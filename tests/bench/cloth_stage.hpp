// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "odeum/scene/model/scene.hpp"
#include "odeum/solvers/case.hpp"
#include "odeum/solvers/variants.hpp"

namespace odeum::bench {

/// The right-hand side given to the solvers: Odeum's grid kernel, or the plain loop of a library's
/// user over an array of particles and a list of springs.
enum class Forces { grid, plain };

/// The plain loop over springs.
struct PlainCloth {
  struct Particle {
    double x[3], v[3], f[3];
  };
  std::vector<Particle> particles;
  std::vector<scene::Spring> springs;

  explicit PlainCloth(const scene::Scene& scene);
  /// Fills f from x and v.
  void forces();
};

/// The cloth of cases/cloth.cpp at any size, with every solver enrolled on it.
class ClothStage {
 public:
  ClothStage(std::size_t n, double stiffness, Forces forces = Forces::grid);

  const scene::Scene& scene() const { return *scene_; }
  /// A solver by its id; throws std::runtime_error where this build has none of that name.
  const Entrant& solver(const std::string& id) const;
  /// A run to time t at a fixed step, or to a tolerance; throws std::runtime_error where it fails.
  std::vector<double> fixed(const std::string& id, double t, std::uint64_t steps,
                            const Variant& options = {}) const;
  std::vector<double> adaptive(const std::string& id, double t, double tolerance) const;
  /// The state at time t to some 1e-10, by two methods of different families that agree to 1e-9.
  std::vector<double> truth(double t) const;
  /// RMS distance of the positions of two states (m).
  double distance(const std::vector<double>& a, const std::vector<double>& b) const;

 private:
  std::vector<double> run(const std::string& id, Request request) const;
  std::shared_ptr<const scene::Scene> scene_;
  Case case_;
};

}  // namespace odeum::bench
