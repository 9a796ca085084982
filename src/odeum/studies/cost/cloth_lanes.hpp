// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <memory>

#include "odeum/scene/springs/grid_cloth.hpp"

/// Methods' steps on a cloth in the grid's layout, for timed runs: compiled for speed in every
/// build type, see CMakeLists.txt.
namespace odeum::study {

/// The largest stable steps on cloths with springs to all neighbours one and two away, measured: of
/// the springs times sqrt(m/k), and of velocity Verlet with their dampers times m/d.
inline constexpr double cloth_spring_limit = 0.566, cloth_damping_limit = 0.046;

/// Any method's steps of a cloth.
template <class Real>
class ClothSteps {
 public:
  virtual ~ClothSteps() = default;
  /// `steps` steps of h seconds from the present state; false where a step failed.
  virtual bool run(double h, std::uint64_t steps) = 0;
  /// All positions x y z (m), then all velocities (m/s).
  std::vector<double> state() const { return cloth_->gathered(y_); }

 protected:
  ClothSteps(const scene::Scene& scene, std::size_t threads)
      : cloth_(std::make_unique<const scene::GridCloth<Real>>(scene, threads)),
        y_(cloth_->scattered(start_of(scene))) {}
  std::unique_ptr<const scene::GridCloth<Real>> cloth_;
  std::vector<Real> y_;
};

/// Linear systems, that of the dampers for imex_verlet and that of the step for
/// predicted_implicit_euler, are solved to `relative`.
template <class Real>
std::unique_ptr<ClothSteps<Real>> velocity_verlet_steps(const scene::Scene& scene,
                                                        std::size_t threads = 1);
std::unique_ptr<ClothSteps<double>> rk4_steps(const scene::Scene& scene);
std::unique_ptr<ClothSteps<float>> imex_verlet_steps(const scene::Scene& scene, double relative,
                                                     std::size_t threads = 1);
std::unique_ptr<ClothSteps<double>> predicted_implicit_euler_steps(const scene::Scene& scene,
                                                                   double relative);

}  // namespace odeum::study
