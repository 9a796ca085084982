// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <string>

#include "odeum/scene/model/scene.hpp"

/// Which scenes each of Bullet's models of a body can represent.
namespace odeum::adapters::bullet {

/// The rate b >= 0 (1/s) of a medium that slows every free particle down by the force -m b v;
/// nothing where the scene's velocity matrix has another effect on the motion. Only the velocities
/// that occur count: if they and gravity are eigenvectors of one eigenvalue -b, and no spring
/// changes the direction of motion, it is such a medium. 0 without a matrix.
std::optional<double> medium_damping(const scene::Scene& scene);

/// The rate b (1/s) at which spring dampers slow down every free particle, where all of them are
/// tied to fixed particles (relative velocity is absolute velocity then); nothing where a damper
/// joins free particles, or the rates differ.
std::optional<double> anchored_damping(const scene::Scene& scene);

/// The radius of all free particles, m; nothing where they differ.
std::optional<double> common_radius(const scene::Scene& scene);

/// Whether every number of the scene is finite. Bullet does not check: for example a NaN damping
/// leaves a deformable body undamped.
bool finite(const scene::Scene& scene);

/// Each returns, as a sentence, why the model cannot represent this scene; empty where it can.
std::string objection_of_bodies(const scene::Scene& scene);  ///< any body at all
std::string objection_of_forces(const scene::Scene& scene);
std::string objection_of_collision(const scene::Scene& scene);
std::string objection_of_links(const scene::Scene& scene);
std::string objection_of_stock_links(const scene::Scene& scene);
std::string objection_of_deformable(const scene::Scene& scene);
std::string objection_of_self_collision(const scene::Scene& scene);

}  // namespace odeum::adapters::bullet
